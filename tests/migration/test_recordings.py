"""A recording in CSV for the new tree: paths in its header, values in new units, each converted once."""

import pytest

BEFORE = "time,Vehicle.Speed,Vehicle.Coolant,Other\r\n0,100,20,x\r\n0.5,,,\r\n1,36,21,y\r\n"
AFTER = "time,Vehicle.Speed,Vehicle.Engine.Coolant,Other\r\n0,27.7777777777777777778,20,x\r\n0.5,,,\r\n1,10,21,y\r\n"


def test_columns_and_values_change(sides):
    sides.write("drive.csv", BEFORE)
    assert sides.run().status == 0
    assert sides.text("drive.csv") == AFTER


def test_values_are_converted_once(sides):
    sides.write("drive.csv", BEFORE)
    for _ in range(3):
        assert sides.run().status == 0
    assert sides.text("drive.csv") == AFTER


def test_the_way_back_restores_values(sides):
    sides.write("drive.csv", BEFORE)
    sides.run()
    sides.run("--choose", "Vehicle.Engine.Coolant=Vehicle.Coolant", back=True)
    assert sides.text("drive.csv") == BEFORE
    sides.run()
    assert sides.text("drive.csv") == AFTER


def test_rounded_values_are_reported_once(sides):
    sides.write("drive.csv", "time,Vehicle.Trip\n0,12.5\n1,12.3456\n2,0.0001\n")
    result = sides.run()
    assert sides.text("drive.csv") == "time,Vehicle.Trip\n0,12500\n1,12346\n2,0\n"
    assert result.status == 1
    assert result.messages.count("D006") == 1
    assert "drive.csv:3:3:" in result.messages


def test_arrays_are_converted_number_by_number(sides):
    sides.write("drive.csv", 'time,Vehicle.Speed\n0,"[36,72, 3.6e1]"\n')
    assert sides.run().status == 0
    assert sides.text("drive.csv") == 'time,Vehicle.Speed\n0,"[10,20, 10]"\n'


def test_two_columns_do_not_become_one(sides):
    text = "time,Vehicle.Coolant,Vehicle.Engine.Coolant\n0,1,2\n"
    sides.write("drive.csv", text)
    result = sides.run()
    assert (result.status, sides.text("drive.csv")) == (1, text)
    assert "D002" in result.messages


def test_a_column_without_a_successor_stays(sides):
    sides.write("drive.csv", "time,Vehicle.Gone,Vehicle.Level\n0,1,2\n")
    result = sides.run()
    assert sides.text("drive.csv") == "time,Vehicle.Gone,Vehicle.Level\n0,1,2\n"
    assert "D003" in result.messages
    assert "D004" in result.messages


def test_other_tables_are_left_alone(sides):
    sides.write("other.csv", "Vehicle.Coolant,Vehicle.Speed\n1,2\n")
    assert sides.run().status == 0
    assert sides.text("other.csv") == "Vehicle.Coolant,Vehicle.Speed\n1,2\n"


@pytest.mark.parametrize(
    "damage", ["<<<<<<< HEAD\n", "{", "[]", "", '{"drive.csv": {"releases": [], "sha256": 1}}', "[" * 100_000]
)
def test_a_damaged_record_ends_the_migration(sides, damage):
    sides.write("drive.csv", BEFORE)
    assert sides.run().status == 0
    sides.write(".sigcat-migrated", damage)
    result = sides.run()
    assert (result.status, sides.text("drive.csv"), sides.text(".sigcat-migrated")) == (2, AFTER, damage)
    assert ".sigcat-migrated is damaged, and values would be converted twice without it" in result.messages


def test_a_renamed_recording_is_known_by_its_content(sides):
    sides.write("drive.csv", BEFORE)
    assert sides.run().status == 0
    (sides.folder / "drive.csv").rename(sides.folder / "first.csv")
    assert sides.run().status == 0
    assert sides.text("first.csv") == AFTER


@pytest.mark.parametrize("has_project", [True, False])
def test_the_record_is_that_of_the_files_from_any_folder(sides, tmp_path, monkeypatch, has_project):
    sides.write("project/drive.csv", BEFORE)
    if has_project:
        sides.write("project/sigcat.toml", "")
    for folder in (sides.folder, tmp_path, sides.folder / "project"):
        monkeypatch.chdir(folder)
        assert sides.run(str(sides.folder / "project")).status == 0
        assert sides.text("project/drive.csv") == AFTER
    assert [path.parent.name for path in sides.folder.rglob(".sigcat-migrated")] == ["project"]
