"""Vehicles of sigcat.toml: what is read, and what is refused at which line."""

from pathlib import Path

import pytest

from sigcat.cli import main
from sigcat.errors import InputRefused
from sigcat.project.read_project import read_project
from sigcat.project.vehicles import each_composed, vehicle_findings

TREE = """\
Vehicle: {type: branch, description: A vehicle.}
Vehicle.Speed: {type: sensor, datatype: float, description: Speed.}
Vehicle.Side: {type: attribute, datatype: string, allowed: [LEFT, RIGHT], description: Side of the driver.}
Vehicle.Sunroof: {type: branch, description: A sunroof.}
Vehicle.Sunroof.Position: {type: sensor, datatype: uint8, description: Position.}
Vehicle.Seat: {type: branch, instances: ["Row[1,2]", [Left, Right]], description: A seat.}
Vehicle.Seat.IsBelted: {type: sensor, datatype: boolean, description: Whether the belt is fastened.}
Vehicle.Trunk: {type: branch, instances: [Front, Rear], description: A trunk.}
Vehicle.Trunk.IsOpen: {type: sensor, datatype: boolean, description: Whether it is open.}
"""
HEAD = '[[catalogue]]\nid = "base"\nspec = "tree.vspec"\n'
LINES = HEAD.count("\n")


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "tree.vspec").write_text(TREE)
    (tmp_path / "trailer.vspec").write_text("Vehicle.Trailer: {type: branch, description: A trailer.}\n")
    return tmp_path


def project(text: str):
    Path("sigcat.toml").write_text(HEAD + text)
    return read_project(Path("sigcat.toml"))


def findings(text: str):
    """Return the findings of a project, by line after the head and column."""
    try:
        found = tuple(vehicle_findings(project(text)))
    except InputRefused as error:
        found = error.findings
    return [(each.rule, each.line - LINES, each.column) for each in found]


def has(vehicle: str, path: str) -> bool:
    return main(["show", "-s", vehicle, path]) == 0


COUPE = """\
[[vehicle]]
id = "coupe"
title = "Coupé"
without = ["Vehicle.Sunroof"]
with = ["*ailer.vspec"]
attributes = {steering = "left", Vehicle.Side = "LEFT", doors = 2, hybrid = true}

[vehicle.instances]
Vehicle.Seat = 1

[[vehicle.state]]
id = "sop"
sop = 2027-03-01

[[vehicle.state]]
id = "ota2"
release = "OTA 2"
without = []
attributes = {steering = "right"}
instances = {"Vehicle.Seat" = 3}

[[vehicle]]
id = "truck"
"""


def test_each_state_is_a_vehicle_that_builds_on_the_state_before(folder):
    sop, ota2, truck = project(COUPE).vehicles
    assert [each.label for each in (sop, ota2, truck)] == ["vehicle:coupe@sop", "vehicle:coupe@ota2", "vehicle:truck"]
    facts = (("steering", "left"), ("doors", "2"), ("hybrid", "yes"), ("sop", "2027-03-01"))
    assert sorted(sop.labels) == sorted(facts)
    assert dict(ota2.labels) == dict(facts) | {"steering": "right", "release": "OTA 2"}
    assert [each.path for each in sop.without] == ["Vehicle.Sunroof"]
    assert ota2.without == ()
    assert (sop.instances[0].value, ota2.instances[0].value) == (1, 3)
    assert [(each.path, each.value) for each in ota2.defaults] == [("Vehicle.Side", "LEFT")]
    assert sop.overlays == ota2.overlays == (Path("trailer.vspec"),)
    assert (sop.shown, truck.shown, truck.catalogue) == ("Coupé, sop", "truck", "base")
    assert [each.line - LINES for each in (sop, ota2, truck)] == [11, 15, 22]


def test_settings_have_their_lines_however_the_tables_are_written(folder):
    sop, ota2, _ = project(COUPE).vehicles
    assert (sop.without[0].line - LINES, sop.without[0].column) == (4, 13)
    assert sop.instances[0].line - LINES == 9
    assert sop.defaults[0].line - LINES == 6
    assert ota2.instances[0].line - LINES == 20


def test_a_vehicle_without_a_state_is_the_last_one(folder, capsys):
    project(COUPE)
    assert has("vehicle:coupe", "Vehicle.Sunroof.Position")
    assert has("vehicle:coupe@ota2", "Vehicle.Seat.Row3.Left.IsBelted")
    assert not has("vehicle:coupe@sop", "Vehicle.Sunroof")
    assert capsys.readouterr().err == "sigcat: unknown node 'Vehicle.Sunroof': it is removed at sigcat.toml:7\n"
    assert has("vehicle:coupe@sop", "Vehicle.Seat.Row1.Right.IsBelted")
    assert not has("vehicle:coupe@sop", "Vehicle.Seat.Row2")
    assert has("vehicle:coupe@sop", "Vehicle.Trailer")
    assert not has("vehicle:truck", "Vehicle.Trailer")


def test_a_value_has_its_place_in_the_project_file(folder, capsys):
    project(COUPE)
    assert has("vehicle:coupe", "Vehicle.Side")
    assert "LEFT  [sigcat.toml:9 (vehicle:coupe@ota2)]" in capsys.readouterr().out


def test_vehicles_of_a_project_without_catalogues_are_of_the_shipped_one(folder, capsys):
    Path("sigcat.toml").write_text('[[vehicle]]\nid = "v"\nwithout = ["Vehicle.ADAS"]\n')
    assert not has("vehicle:v", "Vehicle.ADAS")
    assert has("vehicle:v", "Vehicle.Function")


VEHICLE = '[[vehicle]]\nid = "v"\n'
BAD = [
    ("[[vehicle]]\n", [("C004", 1, 1)]),
    ('[[vehicle]]\nid = "a/b"\n', [("C003", 2, 1)]),
    ('[[vehicle]]\nid = "all"\n', [("C003", 2, 1)]),
    (f'{VEHICLE}[[vehicle]]\nid = "v"\n', [("C006", 4, 1)]),
    (f'{VEHICLE}without = ["Vehicle.Sped"]\n', [("C007", 3, 13)]),
    (f'{VEHICLE}without = ["Vehicle.Speed",\n  "Vehicle.*.Sped"]\n', [("C007", 4, 4)]),
    (f'{VEHICLE}without = ["Vehicle"]\n', [("C003", 3, 13)]),
    (f'{VEHICLE}without = "Vehicle.Speed"\n', [("C003", 3, 1)]),
    (f"{VEHICLE}without = [3]\n", [("C003", 3, 1)]),
    (f'{VEHICLE}with = ["no.vspec"]\n', [("C005", 3, 10)]),
    (f'{VEHICLE}catalogue = "bse"\n', [("C007", 3, 14)]),
    (f"{VEHICLE}whithout = []\n", [("C002", 3, 1)]),
    (f'{VEHICLE}instances = {{"Vehicle.Seats" = 3}}\n', [("C007", 3, 1)]),
    (f'{VEHICLE}instances = {{"Vehicle.Speed" = 3}}\n', [("C003", 3, 1)]),
    (f'{VEHICLE}instances = {{"Vehicle.Trunk" = 3}}\n', [("C003", 3, 1)]),
    (f'{VEHICLE}instances = {{"Vehicle.Seat" = 0}}\n', [("C003", 3, 1)]),
    (f'{VEHICLE}instances = {{"Vehicle.Seat" = 1_000_000_000}}\n', [("C003", 3, 1)]),
    (f'{VEHICLE}instances = {{"Vehicle.Seat" = true}}\n', [("C003", 3, 1)]),
    (f'{VEHICLE}instances = {{"Vehicle.Seat" = [[["Row1"]]]}}\n', [("C003", 3, 1)]),
    (f"{VEHICLE}[vehicle.instances]\nVehicle.Seat = 1.5\n", [("C003", 4, 1)]),
    (f"{VEHICLE}instances = 3\n", [("C003", 3, 1)]),
    *(
        (f'{VEHICLE}instances = {{"Vehicle.Seat" = {names}}}\n', [("C003", 3, 1)])
        for names in (
            '["A", "A"]',
            '["A B"]',
            '["A.B"]',
            '["x\\n*/"]',
            '["<script>"]',
            '[["Row1"], ["A", "A"]]',
            '[""]',
        )
    ),
    (f'{VEHICLE}attributes = {{"Vehicle.Sid" = "LEFT"}}\n', [("C007", 3, 1)]),
    (f'{VEHICLE}attributes = {{"Vehicle.Speed" = 3}}\n', [("C003", 3, 1)]),
    (f"{VEHICLE}attributes = {{steering = [1]}}\n", [("C003", 3, 1)]),
    (f'{VEHICLE}attributes = {{"Vehicle.Side" = 2027-01-01}}\n', [("C003", 3, 1)]),
    (f"{VEHICLE}sop = []\n", [("C003", 3, 1)]),
    (f"{VEHICLE}state = 3\n", [("C003", 3, 1)]),
    (f"{VEHICLE}state = [3]\n", [("C003", 3, 1)]),
    (f"{VEHICLE}[[vehicle.state]]\n", [("C004", 3, 1)]),
    (f'{VEHICLE}[[vehicle.state]]\nid = "a"\n[[vehicle.state]]\nid = "a"\n', [("C006", 6, 1)]),
    (f'{VEHICLE}[[vehicle]]\nid = "w"\n[[vehicle.state]]\nid = "a"\nwithot = []\n', [("C002", 7, 1)]),
    (f'{VEHICLE}[[vehicle]]\nid = "w"\n[[vehicle.state]]\nid = "a"\nwithout = ["Vehicle.Sped"]\n', [("C007", 7, 13)]),
]


@pytest.mark.parametrize(("text", "expected"), BAD)
def test_what_does_not_fit_is_a_finding_at_its_line(text, expected, folder):
    assert findings(text) == expected


def test_a_value_that_an_attribute_cannot_have_is_a_finding_of_the_project_file(folder):
    assert findings(f'{VEHICLE}attributes = {{"Vehicle.Side" = "LEFTT"}}\n')[0][1:] == (3, 1)


def test_vehicles_that_are_no_tables_are_refused(folder):
    Path("sigcat.toml").write_text(f"vehicle = 3\n{HEAD}")
    with pytest.raises(InputRefused) as refused:
        read_project(Path("sigcat.toml"))
    assert [(each.rule, each.line) for each in refused.value.findings] == [("C003", 1)]
    Path("sigcat.toml").write_text(f"vehicle = [3]\n{HEAD}")
    with pytest.raises(InputRefused) as refused:
        read_project(Path("sigcat.toml"))
    assert [(each.rule, each.line) for each in refused.value.findings] == [("C003", 1)]


def test_one_table_instead_of_a_list_says_how_to_write_it(folder):
    Path("sigcat.toml").write_text(f'{HEAD}[vehicle]\nid = "v"\n')
    with pytest.raises(InputRefused) as refused:
        read_project(Path("sigcat.toml"))
    assert "Write `[[vehicle]]`." in [each.fix for each in refused.value.findings]


def test_thousands_of_vehicles_are_refused(folder):
    text = "".join(f'[[vehicle]]\nid = "v{n}"\n' for n in range(1_100))
    assert [rule for rule, *_ in findings(text)] == ["C003"]


def test_a_pyproject_has_vehicles_with_their_lines(folder):
    text = '[tool.sigcat]\nwatch = false\n[[tool.sigcat.vehicle]]\nid = "v"\n[[tool.sigcat.vehicle.state]]\nid = "s"\nwithout = ["X.Y"]\n'
    Path("pyproject.toml").write_text(text)
    (vehicle,) = read_project(Path("pyproject.toml")).vehicles
    assert (vehicle.name, vehicle.without[0].line, vehicle.without[0].column) == ("v@s", 7, 13)


def test_a_tree_that_cannot_be_read_has_its_own_findings_alone(folder, capsys):
    (folder / "tree.vspec").write_text("[")
    assert findings(f'{VEHICLE}without = ["Vehicle.Speed"]\n') == []
    for command in (["show", "-s", "vehicle:v", "Vehicle.Speed"], ["vehicles"], ["vehicles", "--matrix"], ["lint"]):
        assert main(command) == 1
        shown = capsys.readouterr()
        assert "tree.vspec:" in shown.out + shown.err
        assert "C007" not in shown.out + shown.err


def test_vehicles_share_the_nodes_that_they_do_not_change(folder):
    text = "".join(f'[[vehicle]]\nid = "v{n}"\ninstances = {{Vehicle.Seat = {n % 3 + 2}}}\n' for n in range(30))
    composed = list(each_composed(made := project(text), made.vehicles))
    kept = {id(each.catalogue.get("Vehicle.Sunroof")) for each in composed}
    assert kept == {id(composed[0].below.get("Vehicle.Sunroof"))}
    rows = {id(each.catalogue.get(f"Vehicle.Seat.Row{n}.Left.IsBelted")) for each in composed for n in (1, 2)}
    assert len(rows) == 2
