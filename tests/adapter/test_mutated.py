"""Whatever the linter lets through is generated: mistakes in documents are findings, never exceptions.

`make fuzz` tries many more documents (SIGCAT_FUZZ is their number), other ones each time. Cores are compiled and run, what is generated
for a platform is compiled, and runs on the test RTE of AUTOSAR Classic. What it finds is a case here.
"""

import copy
import json
import tempfile
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from sigcat.adapter.core.cores import cores
from sigcat.errors import InputRefused
from sigcat.findings import has_errors
from sigcat.function.function_file import check_function_json
from sigcat.function.function_json.model import FunctionJson, to_json
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.integration.reading import read_functions
from sigcat.limits import DEFAULT_LIMITS
from sigcat.platforms.integrate import integrate
from sigcat.platforms.platform import Generator, Options
from sigcat.platforms.table import PLATFORMS
from tests.adapter import mutated_platforms
from tests.adapter.core.compared import disagreement
from tests.adapter.core.fixed import FIXED
from tests.adapter.mutating import difference, mutated
from tests.function.shipped import interfaces, resolved
from tests.integration.autosar_adaptive.sets import examples
from tests.properties import FUZZ, seeds

HERE = "tests/adapter/test_mutated.py"
TRIES = FUZZ or 2
COMPILED = FUZZ // 10 or 2
"""Documents that are compiled for each platform: a second or two each."""
GENERATED = [(name, generator) for name, platform in PLATFORMS.items() for generator in platform.generators]


@cache
def example() -> Any:
    """The Function JSON of an example, which has most of the fields of a function."""
    (function,) = (each for each in examples() if each.info.function_name == "CoreAcc")
    return json.loads(to_json(function))


def read(document: Any) -> tuple[ResolvedFunction, ...]:
    """The functions of a document. Raises InputRefused with its errors."""
    return read_functions([(json.dumps(document, indent=1).encode(), "f.json")], interfaces()).functions


def generate_all(document: Any) -> None:
    """The core, and what each platform makes of the document."""
    functions = read(document)
    cores(functions)
    for platform in PLATFORMS.values():
        try:
            integration = integrate(platform, functions).document
        except InputRefused as refused:
            if not refused.findings:
                raise
            continue
        for generator in platform.generators:
            files_of(generator, integration)


def files_of(generator: Generator, integration: bytes) -> None:
    for is_bench in {False, generator.has_bench}:
        try:
            assert generator.generate(integration, "i.json", DEFAULT_LIMITS, Options(bench=is_bench))
        except InputRefused as refused:
            if not refused.findings:
                raise


def is_refused(document: Any, make: Callable[[Any], object]) -> bool:
    """Whether a document is refused with findings. Raises what else is raised."""
    try:
        make(document)
    except InputRefused as refused:
        if not refused.findings:
            raise
        return True
    return False


@pytest.mark.parametrize(
    "seed", seeds(f"{HERE}::test_a_function_is_generated_for_every_platform_or_refused_with_findings", 0, TRIES)
)
def test_a_function_is_generated_for_every_platform_or_refused_with_findings(seed):
    document = mutated(example(), seed)
    try:
        is_refused(document, generate_all)
    except Exception as error:
        error.add_note("\n".join(difference(example(), document)))
        raise


@cache
def integrated(name: str) -> Any:
    return json.loads(integrate(PLATFORMS[name], [resolved(each) for each in examples()]).document)


@pytest.mark.parametrize("seed", seeds(f"{HERE}::test_an_integration_is_generated_or_refused_with_findings", 0, TRIES))
@pytest.mark.parametrize(("name", "generator"), GENERATED, ids=[f"{name} {each.name}" for name, each in GENERATED])
def test_an_integration_is_generated_or_refused_with_findings(name, generator, seed):
    document = mutated(integrated(name), seed)
    try:
        files_of(generator, json.dumps(document, indent=1).encode())
    except Exception as error:
        error.add_note("\n".join(difference(integrated(name), document)))
        raise


def compiled_and_run(document: FunctionJson, seed: int, folder: Path) -> str:
    """Return the first difference of the core from its model; empty if the core is refused, or equal."""
    data = to_json(document)
    checked = check_function_json(data, "f.json")
    if has_errors(checked.findings) or checked.function is None or checked.resolved is None:
        return ""
    try:
        cores([checked.resolved])
    except InputRefused as refused:
        if not refused.findings:
            raise
        return ""
    return disagreement(checked.function, seed, 200, folder, ("-O0", "-w"))


@pytest.mark.parametrize(
    "seed", seeds(f"{HERE}::test_what_is_generated_of_a_changed_function_is_compiled", 0, COMPILED)
)
@pytest.mark.parametrize("name", mutated_platforms.NAMES)
@pytest.mark.parametrize("platform", PLATFORMS)
def test_what_is_generated_of_a_changed_function_is_compiled(platform, name, seed):
    document = mutated(mutated_platforms.documents()[name], seed)
    try:
        mutated_platforms.compile_function(platform, document)
    except Exception as error:
        error.add_note("\n".join(difference(mutated_platforms.documents()[name], document)))
        raise


@pytest.mark.parametrize(
    "seed", seeds(f"{HERE}::test_what_is_generated_of_a_changed_integration_is_compiled", 0, COMPILED)
)
@pytest.mark.parametrize("name", mutated_platforms.NAMES)
@pytest.mark.parametrize("platform", PLATFORMS)
def test_what_is_generated_of_a_changed_integration_is_compiled(platform, name, seed):
    before = mutated_platforms.integration_of(platform, name)
    document = mutated(before, seed)
    try:
        mutated_platforms.compile_integration(platform, document)
    except Exception as error:
        error.add_note("\n".join(difference(before, document)))
        raise


def without_time_out(document: Any) -> None:
    """A signal keeps the error of its time-out, and loses the time-out."""
    for each in list(_signals(document)):
        if each.get("TimeoutError"):
            each.pop("Timeout", None)


def with_priority(text: str) -> Callable[[Any], None]:
    """Each call has a priority that looks like a number."""

    def change(document: Any) -> None:
        for component in document["ComponentList"]:
            for call in component["functionList"]:
                call["Priority"] = text

    return change


def without_mode_variable(document: Any) -> None:
    """Modes are not in the code."""
    for each in document.get("ModeInterfaceList") or ():
        each.pop("Variable", None)


def _signals(document: Any) -> Any:
    for contract in _contracts(document):
        yield from contract.get("SignalList") or ()


def _contracts(document: Any) -> Any:
    for component in document["ComponentList"]:
        for call in component["functionList"]:
            yield from call.get("funcContractList") or ()


def with_large_symbols(document: Any) -> None:
    """The last value of each enumeration is beyond what its type in C holds."""
    for each in document["Datatypes"]:
        if each.get("Symbols"):
            each["Symbols"][-1]["Value"] = 10**400


def with_number_of_mode(number: int) -> Callable[[Any], None]:
    """The first mode that is received has this number."""

    def change(document: Any) -> None:
        modes = next(each for each in document["ModeInterfaceList"] if each["Direction"] == "In")
        datatype = next(each for each in document["Datatypes"] if each["typeRef"] == modes["Datatype"])
        datatype["Symbols"][0]["Value"] = number

    return change


def with_mode_twice(document: Any) -> None:
    """A mode is allowed twice."""
    for each in document["ModeInterfaceList"]:
        each["Modes"].append(each["Modes"][-1])


def with_mode_without_number(document: Any) -> None:
    """The datatype of the modes has no number for the last one."""
    for each in document["Datatypes"]:
        if each["typeRef"].startswith("DT_Mode"):
            each["Symbols"].pop()


def without_header(document: Any) -> None:
    """No header declares the variables, and modes have numbers that their datatype does not hold."""
    document["Code"]["Headers"] = []
    for each in document["ModeInterfaceList"]:
        each["Values"] = [{"Symbol": mode, "Value": 70000 + index} for index, mode in enumerate(each["Modes"])]


def with_counts(number: float) -> Callable[[Any], None]:
    """Errors are confirmed after this many ignition cycles."""

    def change(document: Any) -> None:
        for contract in _contracts(document):
            for each in contract.get("ErrorList") or ():
                each["IgnitionCountLimit"] = number

    return change


def with_signal(key: str, value: object) -> Callable[[Any], None]:
    """A field of the first signal has this value."""

    def change(document: Any) -> None:
        next(_signals(document))[key] = value

    return change


def with_header(name: str) -> Callable[[Any], None]:
    """The header has this name."""

    def change(document: Any) -> None:
        document["Code"]["Headers"] = [name]

    return change


def without_code(document: Any) -> None:
    """No header declares the variables."""
    del document["Code"]


def with_kind(document: Any) -> None:
    """Datatypes are of a kind that is not known."""
    for each in document["Datatypes"]:
        if each.get("Kind"):
            each["Kind"] = "²"


FOUND: dict[str, Callable[[Any], None]] = {
    "an error of a time-out that is not there": without_time_out,
    "a priority with two signs": with_priority("--5"),
    "a priority with both signs": with_priority("+-5"),
    "a priority that is a superscript": with_priority("²"),
    "modes without variables": without_mode_variable,
    "values of enumerations that no type holds": with_large_symbols,
}
"""Examples that fuzzing has found."""
MISCODED: dict[str, Callable[[Any], None]] = {
    "a mode with a number beyond its type": with_number_of_mode(2**64),
    "a mode with a number below its type": with_number_of_mode(-1),
    "a mode twice": with_mode_twice,
    "a mode without number": with_mode_without_number,
    "modes with numbers of the code beyond their type": without_header,
    "datatypes of an unknown kind": with_kind,
}
"""Generated code that no compiler accepts."""


UNEQUAL: dict[str, Callable[[Any], None]] = {
    "more ignition cycles than a core counts": with_counts(1e308),
    "a number of ignition cycles below 0": with_counts(-1),
    "an unknown replacement of values out of range": with_signal("RangeErrorAction", "STOP."),
    "a signal without a role": with_signal("Role", ""),
    "a signal that is named as the modes are": with_signal("Name", "F_Mode_In"),
    "a variable that is named as a type": with_signal("Variable", "int16_t"),
}
"""Values that a core and its model interpret differently."""


@pytest.mark.parametrize("name", UNEQUAL)
def test_what_core_and_model_understand_differently_is_refused(name):
    document = json.loads(to_json(FIXED["rejections"]()))
    UNEQUAL[name](document)
    assert is_refused(document, mutated_platforms.read)


@pytest.mark.parametrize("change", [with_header("²"), with_header("über.h"), without_code])
def test_headers_of_any_name_and_none_are_compiled(change, tmp_path):
    document = json.loads(to_json(FIXED["rejections"]()))
    change(document)
    cores(mutated_platforms.read(document))
    assert disagreement(FunctionJson.model_validate(document, by_name=False), 1, 200, tmp_path, ("-O0", "-w")) == ""


def with_service_field(document: Any) -> None:
    """The step of nodes in lock-step has no time."""
    services = document["InterfacePackageList"][0]["Services"]
    next(each for each in services if each["Name"] == "Step")["Request"][1]["Name"] = "other"


def without_step(document: Any) -> None:
    """Nodes have no step."""
    services = document["InterfacePackageList"][0]["Services"]
    services.remove(next(each for each in services if each["Name"] == "Step"))


def with_depth(document: Any) -> None:
    """A topic keeps more values than the middleware has numbers for."""
    document["CommunicationList"][0]["ROSTopicList"][0]["QualityOfService"]["Depth"] = 2**64


def test_a_list_of_services_that_is_given_twice_is_refused():
    document = copy.deepcopy(mutated_platforms.integration_of("autosar-adaptive", "rejections"))
    for each in document["ComponentList"][0]["ServiceInterfaceList"]:
        each["ServiceList"] *= 2
    assert not mutated_platforms.compile_integration("autosar-adaptive", document)


@pytest.mark.parametrize("change", [with_service_field, without_step, with_depth])
def test_what_nodes_cannot_be_compiled_with_is_refused(change):
    document = copy.deepcopy(mutated_platforms.integration_of("ros2", "time_outs"))
    change(document)
    assert not mutated_platforms.compile_integration("ros2", document)


@pytest.mark.parametrize("name", FOUND)
def test_what_was_found_is_generated_for_every_platform(name):
    document = json.loads(json.dumps(example()))
    FOUND[name](document)
    is_refused(document, generate_all)


@pytest.mark.parametrize("name", MISCODED)
def test_what_no_compiler_takes_is_refused(name):
    document = copy.deepcopy(mutated_platforms.documents()["schedules"])
    assert not is_refused(document, mutated_platforms.read)
    MISCODED[name](document)
    assert is_refused(document, mutated_platforms.read)


@pytest.mark.parametrize("name", ["time_outs", "errors"])
@pytest.mark.parametrize("found", ["an error of a time-out that is not there", "a priority that is a superscript"])
def test_what_was_found_is_compiled_and_run(name, found, tmp_path):
    document = json.loads(to_json(FIXED[name]()))
    FOUND[found](document)
    assert disagreement(FunctionJson.model_validate(document, by_name=False), 1, 200, tmp_path, ("-O0", "-w")) == ""


@pytest.mark.parametrize("seed", seeds(f"{HERE}::test_cores_of_changed_documents_do_what_their_models_do", 0, TRIES))
@pytest.mark.parametrize("name", ["conversions", "time_outs", "rejections", "errors", "schedules"])
def test_cores_of_changed_documents_do_what_their_models_do(name, seed):
    before = json.loads(to_json(FIXED[name]()))
    after = mutated(before, seed)
    try:
        document = FunctionJson.model_validate(after, by_name=False)
    except ValueError:
        return
    with tempfile.TemporaryDirectory() as folder:
        assert compiled_and_run(document, seed, Path(folder)) == "", "\n".join(difference(before, after))


def test_an_initial_value_with_an_element_that_is_null_is_refused():
    document = copy.deepcopy(mutated_platforms.integration_of("autosar-classic", "full"))
    ports = [each for each in document["Composition"]["Ports"] if isinstance(each.get("InitValue"), list)]
    ports[0]["InitValue"][0] = None
    assert not mutated_platforms.compile_integration("autosar-classic", document)
