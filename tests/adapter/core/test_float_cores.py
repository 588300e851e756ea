"""Whole cores with float arithmetic: what they refuse, and that they differ from others in conversions alone."""

import re
import shutil
import subprocess
from pathlib import Path

import pytest

from bench.cortex_m4 import Memory, memory
from bench.rows import Missing
from sigcat.adapter.core.core_files import RUNTIME_SOURCE, runtime_files
from sigcat.adapter.core.cores import cores
from sigcat.adapter.core.numbers import DOUBLE, FLOAT, NumberType
from sigcat.adapter.toolchain import EXACT, toolchain
from sigcat.errors import InputRefused
from sigcat.function.function_json.model import FunctionJson, to_json
from tests.adapter.core import core_side
from tests.adapter.core.compared import disagreement
from tests.adapter.core.compilers import STRICT, compilers
from tests.adapter.core.fixed import FIXED
from tests.adapter.core.subject import subject
from tests.adapter.core.test_examples import ROOT
from tests.adapter.core.test_strict import undocumented
from tests.adapter.written import DOUBLE as DOUBLE_VARIABLE
from tests.adapter.written import FLOAT as FLOAT_VARIABLE
from tests.adapter.written import function, output, parameter, signal, step
from tests.function.shipped import resolved
from tests.reference_tools import checked_with

EXAMPLE = ROOT / "examples/wheel_speed_calculation"
CORE = EXAMPLE / "expected/core_float"
SAME = ("queues", "time_outs", "rejections", "optional", "errors", "schedules", "supervision", "classes")
"""Functions whose values have the same scale on both sides."""
IS_SLOW = re.compile(r"__aeabi_(?:c?d\w+|u?ldiv\w*|\w+2d)$")
"""Functions of the library that compute with doubles, or divide 64 bits."""
KMH = {"ConversionFactor": "18/5", "ConversionOffset": "0"}
IN_CODE, IN_CATALOGUE = "The variable of A must not be a double", "A must not be a double in the catalogue"
REFUSED = {
    "a variable": (step(signal("A", DOUBLE_VARIABLE, VssDatatype="float")), IN_CODE),
    "a variable that is sent": (step(output("A", DOUBLE_VARIABLE, VssDatatype="float")), IN_CODE),
    "a signal": (step(signal("A", FLOAT_VARIABLE, VssDatatype="double")), IN_CATALOGUE),
    "a signal that is sent": (step(output("A", FLOAT_VARIABLE, VssDatatype="double", **KMH)), IN_CATALOGUE),
    "a signal of the same scale": (step(signal("A", DOUBLE_VARIABLE)), IN_CODE),
    "a parameter": (step(parameter("A", DOUBLE_VARIABLE)), IN_CODE),
}


FACTOR = {"Factor": "1e-30", "Offset": "0"}


@pytest.mark.parametrize(("call", "message"), REFUSED.values(), ids=REFUSED)
def test_a_double_is_refused(call, message):
    (finding,) = refused(call)
    assert (finding.rule, finding.line is not None) == ("G006", True)
    assert message in finding.message
    assert finding.fix.endswith(", or generate the core with `--arithmetic double`.")


def test_a_factor_that_loses_digits_is_refused():
    (finding,) = refused(step(signal("A", FLOAT_VARIABLE, VssDatatype="float", **FACTOR)))
    assert finding.message == "Factor and offset of A must be between 2⁻⁶⁴ and 2⁶⁴ in a core with float arithmetic."


def refused(call):
    with pytest.raises(InputRefused) as found:
        cores([resolved(function(call))], FLOAT)
    return found.value.findings


def test_a_core_with_double_arithmetic_takes_what_is_refused():
    for call in (
        *(call for call, _ in REFUSED.values()),
        step(signal("A", FLOAT_VARIABLE, VssDatatype="float", **FACTOR)),
    ):
        assert cores([resolved(function(call))], DOUBLE).findings == ()


@pytest.mark.parametrize("name", SAME)
def test_without_a_conversion_every_bit_is_that_of_the_model(name, tmp_path):
    assert disagreement(FIXED[name](), 1, 500, tmp_path, ("-O0", "-w"), FLOAT) == ""


def in_float(name: str) -> FunctionJson:
    """A function with floats in place of doubles."""
    return FunctionJson.model_validate_json(to_json(FIXED[name]()).replace(b'"double', b'"float'))


@pytest.mark.parametrize("name", FIXED)
@pytest.mark.parametrize("vendor", compilers())
def test_no_compiler_warns_or_promotes_to_double(vendor, name, tmp_path):
    core_side.write(subject(in_float(name), FLOAT), tmp_path)
    core = next(tmp_path.glob("F_adapter.c*"))
    is_cpp = core.suffix == ".cpp"
    command, standard = compilers()[vendor].compiler(is_cpp=is_cpp), "c++17" if is_cpp else "c99"
    for source in (core.name, RUNTIME_SOURCE):
        flags = (f"-std={standard if source == core.name else 'c99'}", *STRICT, "-Wdouble-promotion", *EXACT)
        compiler = command if source == core.name else compilers()[vendor].c
        line = [*compiler, *flags, "-c", source, "-o", f"{source}.o"]
        done = subprocess.run(line, cwd=tmp_path, capture_output=True, text=True, check=False)
        assert (done.returncode, done.stderr) == (0, "")


@checked_with("cppcheck", "Generated cores have only documented deviations from MISRA C")
@pytest.mark.parametrize("source", ["WheelSpeedCalculation_adapter.c", RUNTIME_SOURCE])
def test_cppcheck_finds_documented_deviations(source):
    assert undocumented(CORE / source, EXAMPLE) == []


def test_the_files_of_the_other_arithmetic_do_not_compile(tmp_path):
    for arithmetic, other in ((FLOAT, DOUBLE), (DOUBLE, FLOAT)):
        core_side.write(subject(in_float("queues"), arithmetic), tmp_path)
        for file in runtime_files(other):
            (tmp_path / file.name).write_bytes(file.data)
        line = [*toolchain().c, "-c", "F_adapter.c", "-o", "core.o"]
        done = subprocess.run(line, cwd=tmp_path, capture_output=True, text=True, check=False)
        assert done.returncode != 0
        assert "sigcat_core_arithmetic.h is of another arithmetic" in done.stderr


def of_controller(name: str, folder: Path, arithmetic: NumberType) -> dict[str, Memory]:
    core_side.write(subject(in_float(name), arithmetic), folder)
    try:
        return {source: memory(folder / source, [folder]) for source in ("F_adapter.c", RUNTIME_SOURCE)}
    except Missing as missing:
        pytest.skip(str(missing))


@pytest.mark.parametrize("name", [name for name in FIXED if name != "classes"])
def test_a_controller_needs_no_double_and_no_division_of_64_bits_for_a_value(name, tmp_path):
    found = of_controller(name, tmp_path, FLOAT)
    assert [each for each in found["F_adapter.c"].library if IS_SLOW.match(each)] == []
    assert [each for each in found[RUNTIME_SOURCE].library if IS_SLOW.match(each)] == ["__aeabi_uldivmod"]  # schedule


def test_memory_on_a_controller_is_that_which_other_tools_find(tmp_path):
    found = of_controller("conversions", tmp_path, DOUBLE)["F_adapter.c"]
    assert "__aeabi_dmul" in found.library
    assert 0 < found.stack < 4096
    if shutil.which("size") is None:
        pytest.skip("GNU size: install binutils")
    printed = subprocess.run(
        ["size", "F_adapter.m4.o"], cwd=tmp_path, capture_output=True, text=True, check=True
    ).stdout
    assert printed.split()[6:9] == [str(found.text), str(found.data), str(found.bss)]
