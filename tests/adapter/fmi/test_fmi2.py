"""FMUs of FMI 2.0 in FMPy: the same values, over the same core, with four types of variables and without arrays."""

import json
import math
import shlex
from pathlib import Path

import pytest

from scripts.cases import ROOT, RUNS
from sigcat.adapter.fmi.fmu_files import generate
from sigcat.cli import main
from sigcat.data import EXAMPLES
from sigcat.integration.reading import read_functions
from sigcat.limits import DEFAULT_LIMITS
from sigcat.platforms.integrate import integrate
from sigcat.platforms.table import PLATFORMS
from tests.adapter.fmi.fmus import built, compare, sampled
from tests.adapter.hostile.payloads import EVIL, PAYLOADS
from tests.adapter.test_hostile_text import words_of_xml
from tests.function.shipped import interfaces
from tests.integration.autosar_adaptive.sets import deployed
from tests.needs import cmake

fmpy = pytest.importorskip("fmpy", reason="FMPy: pip install fmpy")
from fmpy.fmi1 import FMICallException  # noqa: E402 -- where it is there
from fmpy.fmi2 import FMU2Slave  # noqa: E402
from fmpy.validation import validate_fmu  # noqa: E402

pytestmark = cmake
MILLISECOND = 10**6
FOLDER = ROOT / RUNS.folder
AVERAGING = Path(__file__).with_name("averaging") / "function.yaml"
ECOCONTROL = [EXAMPLES / name / "function.yaml" for name in ("core_acc", "eco_control_mpc")]


@pytest.fixture(scope="module")
def ecocontrol(tmp_path_factory):
    return built(ECOCONTROL, tmp_path_factory.mktemp("fmu"), version="2.0")


def test_validation_finds_nothing(ecocontrol):
    assert not validate_fmu(str(ecocontrol.file))


@pytest.mark.parametrize("step", [10, 70])
def test_ecocontrol_sends_what_a_simulation_sends(ecocontrol, step, tmp_path):
    points = list(sampled(EXAMPLES / "ecocontrol/drive.csv", ecocontrol, step * MILLISECOND, 42 * 10**9))
    assert compare(ecocontrol, points, step * MILLISECOND, 42 * 10**9, tmp_path) > 1000


@pytest.mark.parametrize("name", ["structs_and_queues", "methods_that_the_trace_answers"])
def test_other_functions_send_what_a_simulation_sends(name, tmp_path):
    words = shlex.split((FOLDER / name / "options").read_text())
    files = [FOLDER / name / word for word in words[: words.index("--trace")]]
    made = built(files, tmp_path, version="2.0")
    assert not validate_fmu(str(made.file))
    for step in (1, 10):
        points = list(sampled(FOLDER / name / "trace.csv", made, step * MILLISECOND, 350 * MILLISECOND))
        assert compare(made, points, step * MILLISECOND, 350 * MILLISECOND, tmp_path)


def test_each_element_of_an_array_is_a_variable(ecocontrol):
    description = fmpy.read_model_description(str(ecocontrol.file))
    names = [each.name for each in description.modelVariables]
    altitudes = [f"Vehicle.ADAS.Map.Horizon.Altitude[{index}]" for index in range(1, 51)]
    assert [each for each in names if "Altitude" in each] == altitudes
    assert description.fmiVersion == "2.0"


def test_a_document_of_one_version_is_not_generated_as_the_other(tmp_path, capsys):
    document = tmp_path / "fmi.json"
    assert main(["integrate", "fmi", *map(str, ECOCONTROL), "-o", str(document)]) == 0
    document.write_text(json.dumps({**json.loads(document.read_text()), "FmiVersion": "2.0"}, indent=1))
    assert main(["generate", "fmi", str(document), "-o", str(tmp_path / "made")]) == 1
    assert "J002 EcoControlMpc must have" in capsys.readouterr().err


@pytest.mark.parametrize("payload", PAYLOADS, ids=ascii)
def test_no_text_becomes_markup_of_the_model_description(payload):
    deployment = deployed(name="Demo", fmi={"version": "2.0", "license": "Free", "copyright": "Us"})
    functions = read_functions([(AVERAGING.read_bytes(), "function.yaml")], interfaces()).functions
    document = json.loads(integrate(PLATFORMS["fmi"], functions, deployment).document)
    document |= {"License": payload, "Copyright": payload}
    for fmu in document["FmuList"]:
        for each in (fmu, *fmu["VariableList"]):
            each["Description"] = payload
    files = generate(json.dumps(document).encode(), "fmi.json", DEFAULT_LIMITS)
    (description,) = (each for each in files if each.name.endswith("/modelDescription.xml"))
    words = words_of_xml(description)
    assert "ScalarVariable" in words
    assert not [word for word in words if EVIL in word]


# -- the functions of FMI 2.0 -------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def unpacked(tmp_path_factory):
    """An FMU whose code has no global variables."""
    made = built([AVERAGING], tmp_path_factory.mktemp("fmu"), version="2.0")
    return fmpy.read_model_description(str(made.file)), fmpy.extract(str(made.file))


@pytest.fixture
def fmu(unpacked):
    one = instance(unpacked)
    yield one
    one.terminate()
    one.freeInstance()


def instance(unpacked):
    """An instance in step mode."""
    description, folder = unpacked
    one = FMU2Slave(
        guid=description.guid, modelIdentifier=description.coSimulation.modelIdentifier, unzipDirectory=folder, instanceName="one"
    )  # fmt: skip
    one.instantiate()
    one.setupExperiment(startTime=0.0)
    one.enterInitializationMode()
    one.exitInitializationMode()
    return one


def numbers(unpacked, causality, kind="Real"):
    return [each for each in unpacked[0].modelVariables if (each.causality, each.type) == (causality, kind)]


def stepped(one, unpacked, begin, count):
    """Outputs of steps of 10 ms, before each of which the inputs are set."""
    inputs = [each.valueReference for each in numbers(unpacked, "input")]
    outputs = [each.valueReference for each in numbers(unpacked, "output")]
    for number in range(begin, begin + count):
        one.setReal(inputs, [float(number % 7)] * len(inputs))
        one.doStep(currentCommunicationPoint=number / 100, communicationStepSize=0.01)
        yield one.getReal(outputs)


def test_a_restored_state_continues_as_before(fmu, unpacked):
    list(stepped(fmu, unpacked, 0, 20))
    state = fmu.getFMUState()
    data = fmu.serializeFMUState(state)
    expected = list(stepped(fmu, unpacked, 20, 20))
    fmu.setFMUState(state)
    assert list(stepped(fmu, unpacked, 20, 20)) == expected
    again = fmu.deserializeFMUState(data)
    fmu.setFMUState(again)
    assert list(stepped(fmu, unpacked, 20, 20)) == expected
    for each in (state, again):
        fmu.freeFMUState(each)


def test_misuse_is_refused(fmu, unpacked):
    real, other = numbers(unpacked, "input")[0].valueReference, numbers(unpacked, "output")[0].valueReference
    for misused in (
        lambda: fmu.setReal([4_000_000_000], [1.0]),
        lambda: fmu.setInteger([real], [1]),
        lambda: fmu.setReal([other], [1.0]),
        lambda: fmu.getBoolean([real]),
        lambda: fmu.getString([real]),
        lambda: fmu.doStep(currentCommunicationPoint=5.0, communicationStepSize=0.01),
    ):
        with pytest.raises(FMICallException):
            misused()


FITS = {
    "uint8": (0, 255), "int8": (-128, 127), "uint16": (0, 65535), "int16": (-32768, 32767), "int32": (-(2**31), 2**31 - 1),
    "uint32": (0, 2**32 - 1), "int64": (-(2**63), 2**53), "uint64": (0, 2**53), "float": (-3.4e38, 3.4e38), "double": (-1e300, 1e300),
}  # fmt: skip
BEYOND = {
    "uint8": (-1, 256), "int8": (-129, 128), "uint16": (-1, 65536), "int16": (-32769, 32768), "int32": (),
    "uint32": (-1.0, 2.0**32, 0.5, math.nan), "int64": (-(2.0**63) * 1.1, 2.0**63, 0.5, math.nan, math.inf),
    "uint64": (-1.0, 2.0**64, 0.5, math.nan), "float": (1e39, -1e39), "double": (),
}  # fmt: skip


def test_a_number_that_its_datatype_does_not_hold_is_refused(tmp_path):
    made = built([FOLDER / "every_datatype_with_all_its_digits" / "function.yaml"], tmp_path, version="2.0")
    description = fmpy.read_model_description(str(made.file))
    one = instance((description, fmpy.extract(str(made.file))))
    types = {each.name: each.type for each in description.modelVariables}
    inputs = [
        (index, each.number.datatype, types[each.name])
        for index, each in enumerate(made.variables)
        if each.causality == "input" and each.number.datatype in FITS and not each.number.symbols
    ]
    assert {datatype for _, datatype, _ in inputs} == FITS.keys()
    for reference, datatype, type_ in inputs:
        convert = float if type_ == "Real" else int
        for value in map(convert, FITS[datatype]):
            getattr(one, f"set{type_}")([reference], [value])
            (found,) = getattr(one, f"get{type_}")([reference])
            assert found == pytest.approx(value, rel=1e-7)
        for value in map(convert, BEYOND[datatype]):
            with pytest.raises(FMICallException):
                getattr(one, f"set{type_}")([reference], [value])
    one.freeInstance()
