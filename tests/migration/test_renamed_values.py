"""Values with another name in the new tree: by their number, or by a table. The numbers of the code stay."""

import csv
import json

import pytest

from tests.migration.test_functions import HEAD, TAIL

OVERLAY = """\
Vehicle.Profile: {default: SLOW, allowed: [SLOW, 'FAST 1']}  # ours
Vehicle.Gear:
  default: PARK
  vss2dbc:
    signal: Gear
    transform: {mapping: [{from: PARK, to: 7}, {from: DRIVE, to: 8}]}
"""
MIGRATED = """\
Vehicle.Drive.Profile: {default: ECO, allowed: [ECO, 'SPORT']}  # ours
Vehicle.Gear:
  default: P
  vss2dbc:
    signal: Gear
    transform: {mapping: [{from: P, to: 7}, {from: DRIVE, to: 8}]}
"""
ENTRY = """\
          - path: Vehicle.Profile
            role: consumed
            variable: p
            values: {SLOW: 0, 'FAST 1': 1}
            init: SLOW
          - {path: Vehicle.Gear, role: provided, variable: g, values: {PARK: 10, DRIVE: 11}}
"""
KEPT = """\
          - path: Vehicle.Drive.Profile
            role: consumed
            variable: p
            values: {ECO: 0, 'SPORT': 1}
            init: ECO
          - {path: Vehicle.Gear, role: provided, variable: g, values: {P: 10, DRIVE: 11}}
"""
FILES = {
    "overlay.vspec": (OVERLAY, MIGRATED),
    "function.yaml": (HEAD + ENTRY + TAIL, HEAD + KEPT + TAIL),
    "drive.csv": (
        'time,Vehicle.Profile,Vehicle.Gear\n0,SLOW,PARK\n1,"FAST 1",DRIVE\n2,"[""SLOW"",""FAST 1""]",\n',
        'time,Vehicle.Drive.Profile,Vehicle.Gear\n0,ECO,P\n1,"SPORT",DRIVE\n2,"[""ECO"",""SPORT""]",\n',
    ),
    "faults.yaml": (
        "faults:\n  - {signal: Vehicle.Gear, value: PARK}\n",
        "faults:\n  - {signal: Vehicle.Gear, value: P}\n",
    ),
}


@pytest.mark.parametrize("name", FILES)
def test_values_get_their_new_name_once(sides, name):
    before, after = FILES[name]
    sides.write(name, before)
    for _ in range(2):
        result = sides.run()
        assert (result.status, sides.text(name)) == (0, after), result.messages


GONE = {
    "overlay.vspec": ("Vehicle.Gear: {default: LOW}\n", "overlay.vspec:1:25:"),
    "function.yaml": (
        f"{HEAD}          - {{path: Vehicle.Gear, role: consumed, variable: g, init: LOW}}\n{TAIL}",
        "function.yaml:11:69:",
    ),
    "drive.csv": ("time,Vehicle.Gear\n0,DRIVE\n1,LOW\n2,LOW\n", "drive.csv:3:3:"),
    "faults.yaml": ("faults:\n  - {signal: Vehicle.Gear, value: LOW}\n", "faults.yaml:2:35:"),
}


@pytest.mark.parametrize("name", GONE)
def test_a_value_that_is_gone_is_reported_at_its_place(sides, name):
    before, place = GONE[name]
    sides.write(name, before)
    result = sides.run()
    assert (result.status, sides.text(name)) == (1, before)
    assert f"{place} error D004 Vehicle.Gear: the new tree does not have the value 'LOW'." in result.messages
    assert result.messages.count("D004") == 1


def test_what_is_left_is_reported_until_it_is_decided(sides):
    before = "time,Vehicle.Profile,Vehicle.Gear\n0,SLOW,DRIVE\n1,OLD,PARK\n"
    sides.write("drive.csv", before)
    for _ in range(2):
        result = sides.run()
        assert (result.status, result.messages.count("D004")) == (1, 1)
        assert sides.text("drive.csv") == "time,Vehicle.Profile,Vehicle.Gear\n0,SLOW,DRIVE\n1,OLD,P\n"
    sides.decide("values:\n  Vehicle.Profile: {SLOW: ECO", ", OLD: RACE")
    assert sides.run().status == 0
    assert sides.text("drive.csv") == "time,Vehicle.Drive.Profile,Vehicle.Gear\n0,ECO,DRIVE\n1,RACE,P\n"


@pytest.mark.parametrize("option", ["--write-table", "--report"])
@pytest.mark.parametrize("name", ["drive.csv", "overlay.vspec", "faults.yaml", ".sigcat-migrated"])
def test_no_file_of_the_project_is_lost_to_an_output(sides, option, name):
    before, _ = FILES.get(name, ("{}", ""))
    path = sides.write(name, before)
    result = sides.run(option, str(path))
    assert (result.status, sides.text(name)) == (2, before)
    assert f"{path} is read by this command and would be lost" in result.messages


def test_a_table_is_written_again(sides):
    for _ in range(2):
        assert sides.run("--write-table", str(sides.folder / "moves.yaml")).status == 0
    assert sides.text("moves.yaml").startswith("from:")


def test_a_name_with_special_signs_stays_one_cell(sides):
    sides.decide("SLOW: ECO", ", OLD: 'R, \"A\" or é'")
    sides.new(", RACE]", ", 'R, \"A\" or é']")
    sides.write("drive.csv", 'time,Vehicle.Profile,Other\n0,OLD,OLD\n1, SLOW ,"a,b"\n2,"[""OLD"", ""SLOW""]",\n')
    assert sides.run().status == 0
    rows = list(csv.reader(sides.text("drive.csv").splitlines()))
    assert rows[1:3] == [["0", 'R, "A" or é', "OLD"], ["1", "ECO", "a,b"]]
    assert json.loads(rows[3][1]) == ['R, "A" or é', "ECO"]


def test_comments_of_a_list_of_values_stay(sides):
    sides.new(", RACE]", "]")
    sides.old(", OLD]", "]")
    before = "Vehicle.Profile:\n  allowed:\n    - SLOW   # first\n    # for trucks\n    - 'FAST 1'  # second\n"
    sides.write("overlay.vspec", before)
    assert sides.run().status == 0
    after = before.replace("Profile", "Drive.Profile").replace("SLOW", "ECO").replace("FAST 1", "SPORT")
    assert sides.text("overlay.vspec") == after


def test_the_way_back_restores_names_of_the_same_numbers(sides):
    before, after = FILES["faults.yaml"]
    sides.write("faults.yaml", after)
    assert sides.run(back=True).status == 0
    assert sides.text("faults.yaml") == before


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ("[Vehicle.Gear]", "`values` must be a mapping."),
        ("{Vehicle.Gear: PARK}", "'Vehicle.Gear' must have the new name of each value by its old name, as texts."),
        ("{Vehicle.Gear: {PARK: 0}}", "'Vehicle.Gear' must have the new name of each value by its old name, as texts."),
        ("{Vehicle.Gear: {A: C, B: C}}", "'Vehicle.Gear' must not have one new name for two values."),
        ("{'Vehicle Gear': {A: C}}", "'Vehicle Gear' is not a path."),
    ],
)
def test_a_wrong_table_of_values_is_refused(sides, tmp_path, values, message):
    table = tmp_path / "values.yaml"
    table.write_text(f"from: '1'\nto: '2'\nvalues: {values}\n")
    result = sides.run("--table", str(table), back=True)
    assert result.status == 1
    assert f"D008 {message}" in result.messages
