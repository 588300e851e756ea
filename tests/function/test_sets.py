"""Functions together: who provides what to whom, in which order, and what does not fit."""

import json
from pathlib import Path
from typing import Any

import pytest

from sigcat.cli import main
from sigcat.function.function_file import build_function
from sigcat.function.function_json.model import to_json
from sigcat.function.sets.check_set import check_functions, check_set, read_set
from tests.function.shipped import FUNCTIONS, interfaces
from tests.growth import LINEAR, growth

LANES = (Path(__file__).parent / "lane_keeping.function.yaml").read_bytes()
FILES = [(path.read_bytes(), str(path)) for path in FUNCTIONS]


def found(*files: tuple[bytes, str], whole: bool = True) -> list[tuple[str, str, str]]:
    findings = check_functions(files, interfaces(), is_whole=whole)
    return [(f.rule, f.file, f.pointer) for f in findings if f.rule.startswith("F1")]


def document(name: str, *signals: dict[str, Any], **call: Any) -> tuple[bytes, str]:
    common = {"Description": "Speed.", "AsilLevel": "QM", "Datatype": "DT_Float32", "Units": "m/s"}
    contract = {"SignalList": [{**common, **s} for s in signals], "DataQList": None, "MethodList": None, "ParameterList": None, "ErrorList": None, "SafetyReactionList": None}  # fmt: skip
    runnable = {"Name": f"{name}_Step", "Description": "Runs.", "Runtype": "Cyclic", "Cycletime": 50, "AsilLevel": "QM", "Watchdog": None, "Scheduling": "Preemptive", "Priority": "10", "funcContractList": [contract], **call}  # fmt: skip
    value = {
        "MetaInfo": {}, "FunctionInfo": {"FunctionName": name, "FunctionResponsible": "A team", "Description": "A."},
        "ComponentList": [{"Name": name, "functionList": [runnable]}], "ModesList": None,
        "Datatypes": [{"typeRef": "DT_Float32", "category": "primitive", "cDef": "float"}, {"typeRef": "DT_UInt8", "category": "primitive", "cDef": "uint8_t"}],
    }  # fmt: skip
    return json.dumps(value, indent=1).encode(), f"{name}.json"


SPEED = "Vehicle.ADAS.EcoControl.AccelerationProposal"
CATALOGUE = {"VssPath": SPEED, "VssDatatype": "float", "VssUnit": "m/s^2", "Units": "m/s^2"}
GIVE = {"Name": "Spd", "Role": "Provider"}
TAKE = {"Name": "Spd", "Role": "Consumer"}
AT = "/ComponentList/0/functionList/0/funcContractList/0/SignalList/0"


def test_the_shipped_examples_fit_together():
    assert check_functions(FILES, interfaces()) == ()


def test_the_published_figures_of_both_forms_of_a_function_count_once():
    made = [(to_json(build_function(data, name, interfaces())[0]), f"{name}.json") for data, name in FILES]
    assert found(*FILES, *made) == []
    assert found(*made) == []


@pytest.mark.parametrize(
    ("give", "take", "expected"),
    [
        ({}, {}, []),
        ({}, {"Datatype": "DT_UInt8"}, [("F100", f"{AT}/Datatype")]),
        ({}, {"Units": "km/h"}, [("F101", f"{AT}/Units")]),
        ({}, {"Units": None}, [("F101", f"{AT}/Units")]),
        ({"Max": 50}, {"Max": 40}, [("F102", f"{AT}/Max")]),
        ({"Max": 50}, {"Max": 40, "RangeErrorAction": "Init"}, []),
        ({"Max": 40}, {"Max": 50}, []),
        ({"Min": -1}, {"Min": 0}, [("F102", f"{AT}/Min")]),
        ({}, {"Timeout": "40"}, [("F109", f"{AT}/Timeout")]),
        ({}, {"Timeout": "50"}, []),
        ({}, {"AsilLevel": "B"}, [("F110", AT)]),
        ({"AsilLevel": "D"}, {"AsilLevel": "B"}, []),
        ({**CATALOGUE}, {**CATALOGUE, "VssDatatype": "double"}, [("F100", f"{AT}/Datatype")]),
        ({**CATALOGUE}, {**CATALOGUE, "VssUnit": "cm/s^2"}, [("F101", f"{AT}/Units")]),
    ],
)
def test_both_ends_of_a_signal_agree(give, take, expected):
    told = found(document("Give", {**GIVE, **give}), document("Take", {**TAKE, **take}))
    assert [(rule, pointer) for rule, _, pointer in told] == expected
    assert {file for _, file, _ in told} <= {"Take.json"}


def test_ranges_are_compared_in_the_unit_of_the_catalogue():
    own = {**CATALOGUE, "Units": "cm/s^2", "ConversionFactor": "0.01", "ConversionOffset": "0"}
    give, take = {**GIVE, **CATALOGUE, "Max": 5}, {**TAKE, **own, "Max": 500}
    assert found(document("Give", give), document("Take", take)) == []
    assert [r for r, _, _ in found(document("Give", give), document("Take", {**take, "Max": 499}))] == ["F102"]


def test_a_signal_that_nobody_provides_is_told_unless_someone_outside_is_named():
    take = {**TAKE, **CATALOGUE}
    assert [r for r, _, _ in found(document("Take", take))] == ["F103"]
    assert found(document("Take", take), whole=False) == []
    assert found(document("Take", {**take, "ExternalProvider": "Brake control unit"})) == []
    assert found(document("Give", {**GIVE, **CATALOGUE}), document("Take", take)) == []


def test_sensors_of_the_standard_need_no_provider():
    assert found(document("Take", {**TAKE, "VssPath": "Vehicle.Speed", "Units": "km/h"})) == []


def test_one_function_provides_a_signal():
    told = found(document("Give", GIVE), document("Also", GIVE), document("Take", TAKE))
    assert told == [("F104", "Also.json", AT)]


ORDER = "/ComponentList/0/functionList/0/PrevRunnable"


@pytest.mark.parametrize(
    ("give", "take", "rules"),
    [
        ({}, {"PrevRunnable": "Give_Step"}, []),
        ({}, {"PrevRunnable": "Give_Step", "Priority": "20"}, ["F105"]),
        ({"ExecOffset": "10"}, {"PrevRunnable": "Give_Step"}, ["F105"]),
        ({}, {"PrevRunnable": "Give_Step", "ExecOffset": "10", "Priority": "20"}, []),
        ({"Cycletime": 10}, {"PrevRunnable": "Give_Step", "Priority": "20"}, []),
        ({"Runtype": "Shutdown"}, {"PrevRunnable": "Give_Step"}, ["F105"]),
        ({"PrevRunnable": "Take_Step"}, {"PrevRunnable": "Give_Step"}, ["F106", "F106"]),
        ({}, {"PrevRunnable": "Give_Stop"}, ["F107"]),
        ({}, {"PrevRunnable": "Elsewhere_Step"}, []),
    ],
)
def test_priorities_and_previous_calls_of_several_functions_agree(give, take, rules):
    told = found(document("Give", **give), document("Take", **take))
    assert [rule for rule, _, _ in told] == rules
    assert {pointer for _, _, pointer in told} <= {ORDER}


def test_two_functions_have_two_names():
    assert [r for r, _, _ in found(document("Give", GIVE), document("Give", TAKE))] == ["F108"]
    assert found(document("Give", GIVE), document("Give", GIVE)) == []


def test_what_one_function_defines_another_one_may_use():
    consumer = (
        b"function: Display\ndescription: Shows the torque.\nresponsible: Display team\n"
        b"define: {scheduling: {Init: {description: Starts.}, Step: {cycleTime: 100, asil: B, description: Shows.}, "
        b"Terminate: {description: Stops.}}}\n"
        b"components: [{name: Display, runnables: [Display_Init, {interface: Display_Step, data: [\n"
        b"  {path: Vehicle.ADAS.LaneKeeping.Torque, role: consumed}]}, Display_Terminate]}]\n"
    )
    assert check_functions([(consumer, "display.yaml"), (LANES, "lanes.yaml")], interfaces()) == ()
    alone = check_functions([(consumer, "display.yaml")], interfaces())
    assert [(f.rule, f.line, f.pointer) for f in alone] == [("F010", 6, "/components/0/runnables/1/data/0/path")]


def test_a_finding_about_a_declaration_points_into_it():
    path = next(path for path in FUNCTIONS if path.parent.name == "core_acc")
    text = path.read_text().replace("timeout: 1500", "timeout: 100")
    told = check_functions([(text.encode(), "acc.yaml"), *(f for f in FILES if "mpc" in f[1])], interfaces())
    assert [(f.rule, f.file, f.pointer) for f in told] == [
        ("F109", "acc.yaml", "/components/0/runnables/1/data/9/timeout")
    ]
    assert "timeout: 100" in text.splitlines()[told[0].line - 1]


@pytest.mark.parametrize("data", [b"", b"{}", b"function: 5", b"\xff", b"{" * 9999])
def test_a_file_that_cannot_be_read_is_told_and_the_others_are_still_checked(data):
    told = check_functions([(data, "bad.yaml"), *FILES], interfaces())
    assert told
    assert {finding.file for finding in told} == {"bad.yaml"}


def test_a_set_without_a_catalogue_is_checked_by_itself():
    members, _ = read_set([document("Give", GIVE), document("Also", GIVE)], interfaces())
    assert [finding.rule for finding in check_set(members)] == ["F104"]


def test_ten_times_the_functions_take_about_ten_times_as_long():
    def checking(count):
        files = [document(f"F{i}", *({"Name": f"s{i}_{n}", "Role": "Provider"} for n in range(50)), *({"Name": f"s{i - 1}_{n}", "Role": "Consumer"} for n in range(50))) for i in range(count)]  # fmt: skip
        return lambda: results.append(found(*files))

    results: list[Any] = []
    interfaces()
    assert growth(checking, 5) < LINEAR
    assert [each for each in results if each] == []


# -- the command line ---------------------------------------------------------------------------------------------


def test_the_commands_take_a_new_function_all_the_way(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert main(["function", "new", "LaneKeeping"]) == 0
    assert main(["function", "new", "LaneKeeping"]) == 2
    assert "is there already" in capsys.readouterr().err
    assert main(["function", "new", "Acc", "-o", "c1/acc.yaml"]) == 0
    assert main(["function", "new", "Acc", "-o", "c2/function.yaml"]) == 0
    assert all(Path(each).is_file() for each in ("c1/acc.yaml", "c1/function.schema.json", "c2/function.yaml"))
    assert main(["function", "new", "Acc", "-o", "c1/function.schema.json"]) == 2
    assert "must be a folder, or a file to write that ends with .yaml" in capsys.readouterr().err
    assert main(["function", "build", "LaneKeeping/function.yaml", "-o", "LaneKeeping.json"]) == 0
    assert main(["function", "validate", "LaneKeeping/function.yaml", "LaneKeeping.json"]) == 0
    assert main(["function", "overlay", "LaneKeeping/function.yaml", "-o", "overlay.vspec"]) == 0
    assert main(["lint", "."]) == 0
    assert (tmp_path / "LaneKeeping/function.schema.json").is_file()
    assert main(["function", "new", "Other", "--schema", "http://localhost:8000/s.json", "-o", "x"]) == 0
    assert (
        Path("x/function.yaml").read_text().startswith("# yaml-language-server: $schema=http://localhost:8000/s.json\n")
    )


def test_struct_types_need_a_file_of_their_own(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    Path("f.yaml").write_bytes(LANES)
    assert main(["function", "overlay", "f.yaml", "-o", "o.vspec"]) == 2
    assert "--types-output" in capsys.readouterr().err
    assert main(["function", "overlay", "f.yaml", "-o", "o.vspec", "--types-output", "t.vspec"]) == 0
    assert Path("t.vspec").read_text().count("type: struct") == 1


def test_lint_checks_the_functions_of_a_folder_as_one_set(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    for data, name in (document("Give", GIVE), document("Also", GIVE)):
        Path(name).write_bytes(data)
    assert main(["lint", "."]) == 1
    assert "F104" in capsys.readouterr().out
    assert main(["function", "validate", "Give.json", "Also.json"]) == 1
    assert main(["function", "validate", "Give.json"]) == 0


@pytest.mark.parametrize(
    ("taken", "expected"),
    [
        ({"OFF": 0, "ON": 1}, []),
        ({"OFF": 7, "ON": 6}, []),
        ({"OFF": 0, "ON": 1, "AUTO": 2}, [("F100", "Take.json", f"{AT}/Datatype")]),
    ],
)
def test_both_ends_of_an_enumeration_have_the_same_values_and_each_its_own_numbers(taken, expected):
    def with_values(role: str, **numbers: int) -> tuple[bytes, str]:
        state = {
            "VssPath": "Vehicle.State",
            "VssDatatype": "string",
            "Datatype": "DT_State",
            "Min": min(numbers.values()),
        }
        data, name = document("Give" if role == "Provider" else "Take", {"Name": "State", "Role": role, **state})
        value = json.loads(data)
        symbols = [{"Symbol": symbol, "Value": number} for symbol, number in numbers.items()]
        datatype = {"typeRef": "DT_State", "category": "userdefined", "cDef": "uint8_t", "Kind": "enumeration"}
        value["Datatypes"].append(datatype | {"Symbols": symbols})
        return json.dumps(value, indent=1).encode(), name

    assert found(with_values("Provider", OFF=0, ON=1), with_values("Consumer", **taken)) == expected


def door(name: str, errors: str = "[Stuck]") -> str:
    return (
        f"function: {name}\ndescription: A door.\nresponsible: A team\ncomponents:\n  - name: {name}\n    runnables:\n"
        f"      - {{interface: Step, errors: {errors}, safetyReactions: [Shut]}}\ndefine:\n  errors:\n"
        "    Stuck: {description: Stuck., asil: QM, maturationTime: 10, resetCondition: Absent., resetTime: 10, severity: Low.}\n"
        "  safetyReactions:\n    Shut: {description: Shut., asil: QM, errorList: [Stuck]}\n  scheduling:\n"
        "    Step: {description: Works., asil: QM, cycleTime: 20, priority: 1}\n"
    )


def test_the_short_name_of_a_safety_reaction_is_that_of_the_function_itself(tmp_path, capsys):
    for name in ("Left", "Right"):
        (tmp_path / f"{name}.yaml").write_text(door(name))
    assert main(["lint", str(tmp_path / "Left.yaml"), str(tmp_path / "Right.yaml")]) == 0, capsys.readouterr().out


def test_an_own_error_that_sets_a_safety_reaction_must_be_reported_by_a_call(tmp_path, capsys):
    (tmp_path / "Left.yaml").write_text(door("Left", "[]"))
    assert main(["lint", str(tmp_path / "Left.yaml")]) == 1
    out = capsys.readouterr().out
    assert "F060 Shut_SftyCondSts must react to an error that a call reports, not to 'Left_Stuck_ErrorSts'." in out
    assert "Add it to the errors of a call." in out
