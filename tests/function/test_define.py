"""Interfaces that a function.yaml defines itself: used at once, checked by the catalogue's rules, written as an overlay."""

import json
import subprocess
import sys
from pathlib import Path

import pytest
import yaml

from sigcat.catalogue.composing.compose import read_catalogue
from sigcat.cli import main
from sigcat.data import ROOT_FILE
from sigcat.errors import InputRefused, UsageError
from sigcat.function.declaration.declaration import declaration_schema, read_declaration
from sigcat.function.declaration.scaffold import SCHEMA_FILE, scaffold
from sigcat.function.document.text import Text
from sigcat.function.extension.overlay import overlay_of
from sigcat.function.function_file import build_function, check_function, check_function_json
from sigcat.function.function_json.model import to_json
from sigcat.rules.linting.lint import lint_paths
from tests.function.shipped import interfaces
from tests.function.test_build import declared
from tests.growth import LINEAR, growth
from tests.overlays.test_overlays import EXTENDED, UNITS
from tests.reference_tools import checked_with

LANES = (Path(__file__).parent / "lane_keeping.function.yaml").read_bytes()


def found(text: bytes) -> list[tuple[str, str, int]]:
    return [(f.rule, f.pointer, f.line) for f in check_function(text, "f.yaml", interfaces())]


def changed(old: str, new: str) -> bytes:
    text = LANES.decode()
    assert old in text
    return text.replace(old, new).encode()


def test_what_a_file_defines_it_can_use_without_any_overlay():
    function, findings = build_function(LANES, "f.yaml", interfaces())
    assert findings == ()
    call = next(call for call in function.components[0].runnables if call.name == "LaneKeeping_Step")
    assert call.previous_runnable == "LaneKeeping_Init"
    assert call.watchdog is not None
    assert call.watchdog.alive is not None
    assert call.watchdog.alive.error_name == "LaneKeeping_AliveError_ErrorSts"
    contract = (call.contracts or ())[0]
    assert [error.name for error in contract.errors or ()] == ["LaneKeeping_AliveError_ErrorSts"]
    assert [(queue.name, queue.queue_length) for queue in contract.queues or ()] == [("Lane", 4)]
    assert [method.name for method in contract.methods or ()] == ["ResetLane"]
    structs = {datatype.reference: datatype for datatype in function.datatypes if datatype.kind == "struct"}
    assert [field.name for field in structs["DT_Lane"].fields or ()] == ["Width", "Curvature"]


def test_several_steps_in_one_component_keep_their_order_and_their_fields():
    function, _ = build_function(LANES, "f.yaml", interfaces())
    calls = [
        (call.name, call.run_type, call.cycle_time, call.previous_runnable) for call in function.components[0].runnables
    ]
    assert calls == [
        ("LaneKeeping_Init", "Init", None, None),
        ("LaneKeeping_DetectStep", "Cyclic", 20, "LaneKeeping_Init"),
        ("LaneKeeping_Step", "Cyclic", 20, "LaneKeeping_Init"),
        ("LaneKeeping_Terminate", "Shutdown", None, None),
    ]


def test_the_document_remembers_the_file_that_defines_and_validates_with_its_overlay(tmp_path):
    function, _ = build_function(LANES, "f.yaml", interfaces())
    assert function.provenance is not None
    names = [layer.name for layer in function.provenance.layers]
    assert names[0] == Text("VehicleSignalSpecification.vspec")
    assert names.count(Text("f.yaml")) == 1
    overlay, types = tmp_path / "lanes.vspec", tmp_path / "types.vspec"
    made = overlay_of(LANES, "f.yaml", interfaces())
    overlay.write_text(made.text)
    types.write_text(made.types)
    catalogue = read_catalogue(ROOT_FILE, [overlay], units=UNITS, types=[types])
    assert catalogue.findings == ()
    assert check_function_json(to_json(function), "f.json", catalogue).findings == ()


def test_the_overlay_says_what_the_file_says(tmp_path):
    made = overlay_of(LANES, "f.yaml", interfaces())
    nodes = yaml.safe_load(made.text)
    own = "Vehicle.Function.LaneKeeping"
    assert nodes[f"{own}.Error.AliveError"]["ASILlevel"] == "B"
    assert nodes[f"{own}.SafetyReaction.TorqueInvalid"]["errorList"] == ["LaneKeeping_AliveError_ErrorSts"]
    assert nodes[f"{own}.Mode.Out"]["type"] == "actuator"
    assert nodes[f"{own}.Scheduling.Terminate"]["runType"] == "Shutdown"
    assert nodes[f"{own}.Scheduling.DetectStep"]["supervisionType"] == "None"
    assert list(yaml.safe_load(made.types)) == ["Types", "Types.Lane", "Types.Lane.Width", "Types.Lane.Curvature"]


def test_a_build_with_the_overlay_gives_the_same_interfaces_as_one_with_define(tmp_path):
    own, _ = build_function(LANES, "f.yaml", interfaces())
    made = overlay_of(LANES, "f.yaml", interfaces())
    (tmp_path / "o.vspec").write_text(made.text)
    (tmp_path / "t.vspec").write_text(made.types)
    catalogue = read_catalogue(ROOT_FILE, [tmp_path / "o.vspec"], units=UNITS, types=[tmp_path / "t.vspec"])
    values = yaml.safe_load(LANES)
    del values["define"]
    other, _ = build_function(yaml.safe_dump(values).encode(), "f.yaml", catalogue)
    assert own.model_copy(update={"provenance": None}) == other.model_copy(update={"provenance": None})


@pytest.mark.parametrize(("path", "kind"), [("Types.Lane", "a struct"), ("Types.Lane.Width", "a property of a struct")])
def test_a_struct_and_its_properties_are_no_signals(path, kind, tmp_path):
    types = tmp_path / "types.vspec"
    types.write_text(overlay_of(LANES, "f.yaml", interfaces()).types)
    catalogue = read_catalogue(ROOT_FILE, units=UNITS, types=[types])
    findings = check_function(declared(f"{{path: {path}, role: consumed}}"), "f.yaml", catalogue)
    (found,) = (each for each in findings if each.rule == "F011")
    assert found.message == f"{path!r} must be a data interface, not {kind}."
    assert found.fix == "Define a signal with the datatype 'Types.Lane', and name that."
    findings = check_function(declared("{path: Types.Lane.Widht, role: consumed}"), "f.yaml", catalogue)
    assert not any("Types.Lane.Width" in each.fix for each in findings)


def test_the_overlay_lints_clean(tmp_path):
    made = overlay_of(LANES, "f.yaml", interfaces())
    (tmp_path / "overlays").mkdir()
    (tmp_path / "overlays" / "lanes.vspec").write_text(made.text)
    (tmp_path / "types.vspec").write_text(made.types)
    from sigcat.rules.linting.options import LintOptions

    options = LintOptions(types=(tmp_path / "types.vspec",), base=ROOT_FILE, units=UNITS[1:])
    assert lint_paths([tmp_path / "overlays" / "lanes.vspec"], options).findings == ()


@checked_with("vss-tools", "Definitions of a function are accepted as an overlay with `--strict`")
def test_vss_tools_takes_the_overlay_and_the_types_strictly(tmp_path):
    made = overlay_of(LANES, "f.yaml", interfaces())
    (tmp_path / "o.vspec").write_text(made.text)
    (tmp_path / "t.vspec").write_text(made.types)
    command = [sys.executable, "-c", "from vss_tools.cli import cli; cli()", "export", "json", "--strict"]
    command += ["-s", str(ROOT_FILE), "-o", str(tmp_path / "tree.json"), "-l", str(tmp_path / "o.vspec")]
    command += ["-t", str(tmp_path / "t.vspec"), "--types-output", str(tmp_path / "types.json")]
    command += [part for unit in UNITS for part in ("-u", str(unit))]
    command += [part for name in EXTENDED for part in ("-e", name)]
    done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=120)
    assert done.returncode == 0, done.stdout + done.stderr
    tree = json.loads((tmp_path / "tree.json").read_text())
    step = tree["Vehicle"]["children"]["Function"]["children"]["LaneKeeping"]["children"]["Scheduling"]["children"][
        "Step"
    ]
    assert step["cycleTime"] == 20


# -- findings -----------------------------------------------------------------------------------------------------

ALIVE = "/define/scheduling/Step/aliveSupervision"


@pytest.mark.parametrize(
    ("old", "new", "rule", "pointer"),
    [
        ("unit: Nm", "unit: Nmm", "V006", "/define/data/Vehicle.ADAS.LaneKeeping.Torque/unit"),
        ("min: -5", "min: 50", "I103", "/define/data/Vehicle.ADAS.LaneKeeping.Torque/max"),
        ("severity: The function is off.", "resetTime: 1", "I201", "/define/errors/AliveError"),
        ("errorList: [AliveError]", "errorList: [AlifeError]", "I304", "/define/safetyReactions/TorqueInvalid/errorList"),
        ("    Terminate:", "    Terminat:", "I502", "/define/scheduling/Terminat"),
        ("    AliveError:", "    alive_error:", "I203", "/define/errors/alive_error"),
        ("minIndications: 1", "minIndications: 7", "I517", ALIVE),
        ("previousRunnable: Init", "previousRunnable: Inti", "I509", "/define/scheduling/DetectStep/previousRunnable"),
    ],
)  # fmt: skip
def test_a_wrong_definition_is_told_where_it_stands(old, new, rule, pointer):
    told = [(code, at) for code, at, line in found(changed(old, new)) if line]
    assert any(code == rule and at.startswith(pointer) for code, at in told), told


@pytest.mark.parametrize(
    ("old", "new", "rule"),
    [("minIndications: 1", "minIndications: 7", "I517"), ("min: -5", "min: 50", "I103"), ("previousRunnable: Init", "previousRunnable: Inti", "I509")],
)  # fmt: skip
def test_one_problem_of_a_defined_interface_is_one_finding(old, new, rule):
    text = LANES.decode().replace(old, new, 1).encode()
    assert [rule for rule, _, _ in found(text)] == [rule]


@pytest.mark.parametrize(
    ("old", "new", "pointer"),
    [
        ("    AliveError:\n", "    Alive Error:\n", "/define/errors/Alive Error"),
        ("  types:\n    Types.Lane:", "  types:\n    '*/ #include <x>':", "/define/types/*~1 #include <x>"),
        ("maturationTime: 0", "maturationTime: -1", "/define/errors/AliveError/maturationTime"),
        ("maturationTime: 0", "maturationTim: 0", "/define/errors/AliveError/maturationTim"),
    ],
)
def test_a_definition_of_another_shape_is_refused_at_its_place(old, new, pointer):
    told = found(changed(old, new))
    assert [(rule in ("F003", "F004"), at) for rule, at, _ in told] == [(True, pointer)]


def test_a_definition_that_contradicts_the_catalogue_is_a_warning():
    text = changed(
        "    Vehicle.ADAS.LaneKeeping.Torque:", "    Vehicle.ADAS.EcoControl.Status: {datatype: uint8, max: 7, description: A status.}\n    Vehicle.ADAS.LaneKeeping.Torque:"
    )  # fmt: skip
    assert {"O105"} <= {rule for rule, _, _ in found(text)}


def test_a_file_that_defines_nothing_makes_no_overlay():
    values = yaml.safe_load(LANES)
    del values["define"]
    with pytest.raises(InputRefused, match="defines no interfaces"):
        overlay_of(yaml.safe_dump(values).encode(), "f.yaml", interfaces())


@pytest.mark.parametrize(
    "text", ["#include other.vspec", "A.\n#include x\nB", "x " * 80 + "#include <x> */", '"><script>', "a: b # c", "\u2028#include x", "\x85#include x", "'", "*x"]
)  # fmt: skip
def test_no_text_of_a_definition_becomes_anything_but_a_text(text):
    values = yaml.safe_load(LANES)
    values["define"]["errors"]["AliveError"]["severity"] = text
    made = overlay_of(yaml.safe_dump(values, allow_unicode=False).encode(), "f.yaml", interfaces())
    assert not [
        line
        for line in made.text.splitlines()
        if line.lstrip().startswith("#") and "Made by" not in line and len(line) > 30
    ]
    assert yaml.safe_load(made.text)["Vehicle.Function.LaneKeeping.Error.AliveError"]["severity"] == text
    assert not any("#include" in line.split('"')[0].split("'")[0][:12] for line in made.text.splitlines())


def test_ten_times_the_definitions_take_about_ten_times_as_long():
    def building(count):
        values = yaml.safe_load(LANES)
        signal = {"datatype": "float", "asil": "QM", "description": "A signal."}
        values["define"]["data"] |= {f"Vehicle.ADAS.LaneKeeping.S{i}": signal for i in range(count)}
        data = yaml.dump(values, Dumper=getattr(yaml, "CSafeDumper", yaml.SafeDumper)).encode()
        return lambda: build_function(data, "f.yaml", interfaces())

    interfaces()
    assert growth(building, 200) < LINEAR


# -- the scaffold -------------------------------------------------------------------------------------------------


def test_the_scaffold_names_its_schema_and_builds_without_a_finding():
    text = scaffold("LaneKeeping")
    assert text.startswith(f"# yaml-language-server: $schema={SCHEMA_FILE}\n")
    assert check_function(text.encode(), "function.yaml", interfaces()) == ()


def test_the_scaffold_for_a_tree_of_another_root_defines_its_signal(tmp_path, capsys):
    machine = "Machine: {type: branch, description: A machine.}\n"
    (tmp_path / "machine.vspec").write_text(machine)
    tree, folder = ["-s", str(tmp_path / "machine.vspec")], str(tmp_path / "filter")
    assert main(["function", "new", "Filter", *tree, "-o", folder]) == 0
    assert main(["lint", *tree, folder]) == 0
    assert "path: Machine.Filter.Speed\n" in (tmp_path / "filter" / "function.yaml").read_text()
    assert capsys.readouterr().out == "No findings.\n"


def test_the_scaffold_and_the_examples_are_valid_under_the_schema_of_the_file():
    import jsonschema

    schema = jsonschema.Draft202012Validator(declaration_schema(), format_checker=None)
    for text in (scaffold("LaneKeeping"), LANES.decode()):
        schema.validate(yaml.safe_load(text))


@pytest.mark.parametrize("name", ["lane_keeping", "", "A.B", "*/ #include <x>", "Ünder", "a" * 300, "A\nb: 1"])
def test_a_name_that_is_none_makes_no_scaffold(name):
    with pytest.raises(UsageError):
        scaffold(name)


def test_every_key_of_the_declaration_says_what_it_is():
    models = declaration_schema()["$defs"]
    keys = {f"{name}.{key}": field for name, one in models.items() for key, field in one.get("properties", {}).items()}
    assert len(keys) > 50
    assert [key for key, field in keys.items() if not field.get("description", "").endswith(".")] == []


def test_an_example_with_definitions_reads_back():
    assert read_declaration(LANES, "f").declaration is not None


# -- one finding for a cause, where the cause stands ------------------------------------------------------------------


@pytest.mark.parametrize(
    ("old", "new", "rule", "pointer", "fix"),
    [
        (
            "errorList: [AliveError]",
            "errorList: [AliveErrr]",
            "I304",
            "/define/safetyReactions/TorqueInvalid/errorList/0",
            "Did you mean 'LaneKeeping_AliveError_ErrorSts'?",
        ),
        (
            "maxIndications: 3, error: AliveError",
            "maxIndications: 3, error: AliveErrr",
            "I519",
            "/define/scheduling/Step/aliveSupervision/error",
            "Did you mean 'LaneKeeping_AliveError_ErrorSts'?",
        ),
        (
            "errors: [LaneKeeping_AliveError_ErrorSts]",
            "errors: [AliveErrr]",
            "F013",
            "/components/0/runnables/2/errors/0",
            "Did you mean 'AliveError'?",
        ),
        (
            "LaneKeeping_DetectStep, LaneKeeping_Step]",
            "LaneKeeping_DetectStep, Stap]",
            "F070",
            "/modes/active/1/runnables/1",
            "Did you mean 'Step'?",
        ),
        (
            "interface: LaneKeeping_DetectStep",
            "interface: LaneKeeping_DetectStap",
            "F013",
            "/components/0/runnables/1/interface",
            "Did you mean 'LaneKeeping_DetectStep'?",
        ),
        (
            "default: 0.5",
            "default: 1.5",
            "V010",
            "/define/parameters/Gain/default",
            "Change the default, or the range.",
        ),
    ],
)
def test_a_mistyped_name_is_one_finding_at_the_name_with_what_was_meant(old, new, rule, pointer, fix):
    told = check_function(changed(old, new), "f.yaml", interfaces())
    assert [(finding.rule, finding.pointer, finding.fix) for finding in told] == [(rule, pointer, fix)]


def test_what_does_not_follow_from_a_mistyped_name_is_told_beside_it():
    text = changed("interface: LaneKeeping_DetectStep", "interface: LaneKeeping_DetectStap")
    told = found(text.replace(b"LaneKeeping_DetectStep, LaneKeeping_Step]", b"LaneKeeping_DetectStep, Nonsense]"))
    assert sorted(rule for rule, _, _ in told) == ["F013", "F070"]


@pytest.mark.parametrize(
    "declared",
    ["[AliveError]", "[{interface: AliveError}]", "[{interface: LaneKeeping_AliveError_ErrorSts}]", "[AliveErrr]"],
)
def test_errors_of_a_call_that_was_not_found_are_looked_for_in_every_form(declared):
    text = changed("interface: LaneKeeping_DetectStep", f"interface: Nowhere\n        errors: {declared}")
    told = {rule for rule, _, _ in found(text)}
    assert {"F013"} <= told <= {"F013", "F070"}


def test_a_circle_of_calls_is_told_once():
    circular = changed(
        "priority: 12\n      asil: B\n      previousRunnable: Init", "asil: B\n      previousRunnable: Step"
    )
    told = found(
        circular.replace(b"asil: B\n      previousRunnable: Init", b"asil: B\n      previousRunnable: DetectStep")
    )
    assert [rule for rule, _, _ in told] == ["I510"]


def test_a_struct_keeps_its_words_and_the_limits_of_its_members():
    text = changed("{datatype: float, unit: m, desc", "{datatype: float, unit: m, min: 2, max: 5.5, desc")
    function, _ = build_function(text, "f.yaml", interfaces())
    lane = next(datatype for datatype in function.datatypes if datatype.reference == "DT_Lane")
    assert lane.description == Text("A lane.")
    assert [(f.name, f.description, f.min, f.max) for f in lane.fields or ()] == [
        ("Width", Text("Width of the lane."), 2, 5.5),
        ("Curvature", Text("Curvature of its middle."), None, None),
    ]


def test_what_is_written_as_an_overlay_is_clean_where_nothing_stands_beside_it(tmp_path):
    long = changed(
        "errorList: [AliveError]",
        "errorList: [AliveError, CoreAcc_AliveError_ErrorSts, WheelSpeedCalculation_AliveError_ErrorSts]",
    )
    made = overlay_of(long.replace(b"unit: m,", b"unit: radians,"), "f.yaml", interfaces())
    (tmp_path / "types.vspec").write_text(made.types)
    assert lint_paths([tmp_path]).findings == ()
    assert max(map(len, made.text.splitlines())) <= 120


def test_of_a_parameter_that_the_file_defines_the_last_name_is_enough():
    whole, last = "path: Vehicle.Function.LaneKeeping.Parameter.Gain", "path: Gain"
    function, findings = build_function(changed(whole, last), "f.yaml", interfaces())
    assert findings == ()
    parameters = (function.components[0].runnables[2].contracts or ())[0].parameters or ()
    assert [(each.name, each.vss_path) for each in parameters] == [("Gain", whole.removeprefix("path: "))]


def test_a_parameter_that_is_misspelled_may_have_been_meant():
    found = check_function(changed("Vehicle.Function.LaneKeeping.Parameter.Gain", "Gian"), "f.yaml", interfaces())
    assert [f.fix for f in found if f.rule == "F010"] == ["Did you mean 'Gain'?"]


def test_a_signal_that_the_file_defines_is_named_by_its_path():
    found = check_function(changed("{path: Vehicle.ADAS.LaneKeeping.Torque,", "{path: Torque,"), "f.yaml", interfaces())
    assert [(f.rule, f.fix) for f in found if f.rule == "F010"] == [
        ("F010", "Name it by its path, 'Vehicle.ADAS.LaneKeeping.Torque'.")
    ]


def test_a_function_may_define_a_step_alone():
    text = b"""
function: Acc
description: Controls the speed.
responsible: Cruise control team
code: {signature: globals, headers: [acc.h]}
components:
  - name: Acc
    runnables:
      - {interface: Step, data: [{path: Vehicle.Speed, role: consumed, variable: speed, asil: QM}]}
define:
  scheduling:
    Step: {cycleTime: 50, description: Controls the speed., priority: 10, scheduling: Preemptive, asil: QM}
"""
    assert found(text) == []
    assert found(text.replace(b"code:", b"#")) == []
    without = text.replace(b"interface: Step", b"interface: Init").replace(b"    Step:", b"    Init:")
    assert {"F050", "I501"} <= {rule for rule, _, _ in found(without)}
