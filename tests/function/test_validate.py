"""Function JSON of any tool is checked: structure, consistency, conventions."""

import json
from collections import Counter
from typing import Any

import pytest

from sigcat.function.function_file import build_function, check_function, check_function_json
from sigcat.function.function_json.duration import milliseconds
from sigcat.function.function_json.model import to_json
from tests.function.shipped import FUNCTIONS, interfaces
from tests.needs import published, published_files

PUBLISHED = "function_model_core_acc.json"
CALL = {
    "Name": "Acc_Step", "Description": "Controls the speed.", "Runtype": "Cyclic", "Cycletime": 50, "AsilLevel": "QM",
    "Watchdog": None, "Scheduling": "Preemptive", "Priority": "1",
}  # fmt: skip


def document(**changes: Any) -> bytes:
    function = {
        "MetaInfo": {},
        "FunctionInfo": {"FunctionName": "Acc", "FunctionResponsible": "Cruise team", "Description": "Cruise control."},
        "ComponentList": [{"Name": "Acc", "functionList": [CALL]}],
        "ModesList": None,
        "Datatypes": [],
    }
    return json.dumps({**function, **changes}, indent=1).encode()


def rules(data: bytes) -> list[str]:
    return [finding.rule for finding in check_function_json(data, "f.json").findings]


# -- what we write ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("path", FUNCTIONS, ids=lambda path: path.parent.name)
def test_what_sigcat_writes_has_nothing_to_be_said_about(path):
    function, _ = build_function(path.read_bytes(), str(path), interfaces())
    assert check_function_json(to_json(function), "f.json", interfaces()).findings == ()


@pytest.mark.parametrize("path", FUNCTIONS, ids=lambda path: path.parent.name)
def test_what_sigcat_writes_is_read_back_to_the_same_bytes(path):
    function, _ = build_function(path.read_bytes(), str(path), interfaces())
    again = check_function_json(to_json(function), "f.json").function
    assert again is not None
    assert to_json(again) == to_json(function)


# -- the published example ----------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def findings():
    return check_function_json(published(PUBLISHED), "core.json", interfaces()).findings


@published_files
def test_the_published_example_is_accepted(findings):
    assert {finding.severity for finding in findings} == {"warning", "info"}


@published_files
def test_each_of_its_findings_has_line_column_and_pointer(findings):
    assert len(findings) > 20
    assert all(finding.line and finding.column and finding.pointer for finding in findings)


@published_files
def test_its_departures_are_found(findings):
    assert Counter(finding.rule for finding in findings) == {
        "F034": 1,  # CoreACC_Init is meant to be CoreAcc_Init
        "F081": 1,  # Unsigned double
        "F082": 1,  # DT_SInt64 is a double
        "F083": 2,  # two datatypes that nothing uses
        "F090": 1,  # no ASIL on the step
        "F091": 7,  # qm
        "F092": 3,  # priorities as text
        "F093": 2,  # no unit on the brake pressure and the mass
        "F094": 2,  # rad, enum
        "F095": 7,  # no VSS path
        "F096": 11,  # descriptions that are not sentences
        "F099": 1,  # a person
    }


@published_files
@pytest.mark.parametrize(
    ("pointer", "expected"),
    [
        ("/Datatypes/3/cDef", ("F081", "warning", 222)),
        ("/Datatypes/2/cDef", ("F082", "warning", 217)),
        ("/ComponentList/0/functionList/1/AsilLevel", ("F090", "warning", 44)),
        ("/ComponentList/0/functionList/1/funcContractList/0/SignalList/0/Units", ("F093", "warning", 68)),
        ("/ComponentList/0/functionList/1/funcContractList/0/SignalList/4/Units", ("F094", "warning", 136)),
    ],
)
def test_they_are_found_where_they_stand(findings, pointer, expected):
    there = [f for f in findings if f.pointer == pointer and f.severity != "info"]
    assert [(f.rule, f.severity, f.line) for f in there] == [expected]


@published_files
def test_without_a_catalogue_it_is_checked_by_itself(findings):
    alone = check_function_json(published(PUBLISHED), "core.json").findings
    assert {f.rule for f in alone} == {f.rule for f in findings}
    assert not any("Vehicle." in f.message for f in alone)


@published_files
def test_it_keeps_its_content_when_written_again():
    function = check_function_json(published(PUBLISHED), "core.json").function
    assert function is not None
    original, again = json.loads(published(PUBLISHED)), json.loads(to_json(function))
    assert _without_null(again) == _without_null(original)


def _without_null(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _without_null(item) for key, item in value.items() if item is not None}
    return [_without_null(item) for item in value] if isinstance(value, list) else value


# -- structure ----------------------------------------------------------------------------------------------------


def test_defects_of_structure_are_findings_all_at_once():
    data = document(FunctionInfo={"FunctionName": 5}, Datatypes=[{"typeRef": "UInt8", "category": "primitive"}])
    found = check_function_json(data, "f.json").findings
    assert [(finding.rule, finding.pointer, finding.line) for finding in found] == [
        ("F002", "/FunctionInfo", 3),
        ("F002", "/FunctionInfo", 3),
        ("F004", "/FunctionInfo/FunctionName", 4),
        ("F002", "/Datatypes/0", 25),
        ("F004", "/Datatypes/0/typeRef", 26),
    ]


def test_python_names_are_no_names_of_the_wire_format():
    data = document(MetaInfo={"schema_version": 5})
    assert rules(data) == ["F003"]  # a stranger that looks like SchemaVersion, not a wrong version


def test_foreign_keys_are_allowed_and_kept():
    data = document(MetaInfo={"Ticket": {"id": 7}}, Extra=[1.5, None, "x"])
    assert rules(data) == []
    function = check_function_json(data, "f.json").function
    assert function is not None
    again = json.loads(to_json(function))
    assert (again["MetaInfo"], again["Extra"]) == ({"Ticket": {"id": 7}}, [1.5, None, "x"])


def test_a_misspelled_key_is_answered_with_the_right_one():
    call = {**CALL, "PrevRunable": "Acc_Init"}
    found = check_function_json(document(ComponentList=[{"Name": "Acc", "functionList": [call]}]), "f.json").findings
    fixes = [finding.fix for finding in found if finding.rule == "F003"]
    assert fixes == ["Did you mean 'PrevRunnable'?"]


def test_a_misspelled_key_beside_the_right_one_is_told_too():
    call = {**CALL, "CycleTimes": 50, "Cycletime": 20}
    found = check_function_json(document(ComponentList=[{"Name": "Acc", "functionList": [call]}]), "f.json").findings
    assert [finding.fix for finding in found if finding.rule == "F003"] == ["Remove it, or 'Cycletime'."]


@pytest.mark.parametrize("value", [1.0, 1, 50.0, 0.5])
def test_a_time_may_be_written_with_a_point(value):
    call = {**CALL, "Cycletime": value}
    assert rules(document(ComponentList=[{"Name": "Acc", "functionList": [call]}])) == []


@pytest.mark.parametrize("value", ["50", True, 0.0000005, [50], {}])
def test_what_is_no_number_is_refused(value):
    call = {**CALL, "Cycletime": value}
    assert rules(document(ComponentList=[{"Name": "Acc", "functionList": [call]}])) == ["F004"]


# -- with a catalogue ---------------------------------------------------------------------------------------------


def test_paths_units_and_ranges_are_compared_with_the_catalogue():
    function, _ = build_function(FUNCTIONS[0].read_bytes(), "f.yaml", interfaces())
    text = to_json(function).decode()
    text = text.replace('"Max": 276.9', '"Max": 300').replace("Vehicle.Mass", "Vehicle.Mas")
    text = text.replace('"Units": "radians"', '"Units": "rad"')
    found = check_function_json(text.encode(), "f.json", interfaces()).findings
    assert [finding.rule for finding in found] == ["F022", "F094", "F010"]


def test_a_function_file_is_taken_for_what_it_is():
    found = check_function(document(), "posted", interfaces())
    assert found == ()
    assert check_function(FUNCTIONS[0].read_bytes(), "posted", interfaces()) == ()


@pytest.mark.parametrize(
    ("text", "expected"),
    [("100", 100), ("100 ms", 100), ("0.1 s", 100), ("250us", 0.25), ("soon", None), ("", None), (None, None), ("-1", None)],
)  # fmt: skip
def test_durations_in_texts_are_understood(text, expected):
    assert milliseconds(text) == expected
