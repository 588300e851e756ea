"""An overlay says about the new tree what it said about the old one. Everything else keeps its bytes."""

import pytest

CASES = {
    "a path": (
        "Vehicle.Coolant:\n  comment: ours # here\n",
        "Vehicle.Engine.Coolant:\n  comment: ours # here\n",
    ),
    "a path in quotes": ("'Vehicle.Coolant': {comment: x}\n", "'Vehicle.Engine.Coolant': {comment: x}\n"),
    "a node of a moved branch": ("Vehicle.Lamp.IsOn: {comment: x}\n", "Vehicle.Light.IsOn: {comment: x}\n"),
    "an own node below a moved branch": (
        "Vehicle.Lamp.Own: {type: sensor, datatype: float, description: Own.}\n",
        "Vehicle.Light.Own: {type: sensor, datatype: float, description: Own.}\n",
    ),
    "a label of an instance": (
        "Vehicle.Door.Row1.Right.IsOpen: {comment: x}\n",
        "Vehicle.Door.Row1.PassengerSide.IsOpen: {comment: x}\n",
    ),
    "a limit without a unit": (
        "Vehicle.Speed:\n  max: 100\n",
        "Vehicle.Speed:\n  unit: m/s\n  max: 27.78\n",
    ),
    "a limit with the old unit": (
        'Vehicle.Speed: {unit: "km/h", min: 0, max: 36}\n',
        'Vehicle.Speed: {unit: "m/s", min: 0, max: 10}\n',
    ),
    "a limit in a unit of its own": ("Vehicle.Speed: {unit: cm/s, max: 7}\n", "Vehicle.Speed: {unit: cm/s, max: 7}\n"),
    "a repeated datatype": (
        "Vehicle.Trip: {datatype: float, unit: km}\n",
        "Vehicle.Trip: {datatype: uint32, unit: m}\n",
    ),
    "a datatype of its own": ("Vehicle.Trip: {datatype: double}\n", "Vehicle.Trip: {datatype: double}\n"),
    "repeated allowed values": ("Vehicle.Mode: {allowed: [A, B]}\n", "Vehicle.Mode: {allowed: [A, B, C]}\n"),
    "allowed values of its own": ("Vehicle.Mode: {allowed: [B]}\n", "Vehicle.Mode: {allowed: [B]}\n"),
    "a deleted node": ("# a\nVehicle.Gone:\n  delete: true\n\n# b\n", "# a\n\n# b\n"),
    "windows": ("Vehicle.Speed:\r\n  max: 36\r\n", "Vehicle.Speed:\r\n  unit: m/s\r\n  max: 10\r\n"),
    "a byte order mark": ("\ufeffVehicle.Coolant: {comment: ü}\n", "\ufeffVehicle.Engine.Coolant: {comment: ü}\n"),
    "no line break at the end": ("Vehicle.Coolant: {comment: x}", "Vehicle.Engine.Coolant: {comment: x}"),
    "a former path": ("Vehicle.Speed: {fka: [Vehicle.Coolant]}\n", "Vehicle.Speed: {fka: [Vehicle.Coolant]}\n"),
    "text that names a path": (
        "Vehicle.Speed: {comment: Vehicle.Coolant}\n",
        "Vehicle.Speed: {comment: Vehicle.Coolant}\n",
    ),
    "a mapping without a formula": (
        "Vehicle.Trip:\n  dbc2vss:\n    signal: Trip\n",
        'Vehicle.Trip:\n  unit: m\n  dbc2vss:\n    signal: Trip\n    transform: {math: "x * 1000"}\n',
    ),
    "a formula from the network": (
        'Vehicle.Trip: {unit: km, dbc2vss: {signal: T, transform: {math: "x + 2"}}}\n',
        'Vehicle.Trip: {unit: m, dbc2vss: {signal: T, transform: {math: "(x + 2) * 1000"}}}\n',
    ),
    "a formula to the network": (
        'Vehicle.Trip: {unit: km, vss2dbc: {signal: T, transform: {math: "x * 10"}}}\n',
        'Vehicle.Trip: {unit: m, vss2dbc: {signal: T, transform: {math: "(x / 1000) * 10"}}}\n',
    ),
    "a list of values": (
        "Vehicle.Trip: {unit: km, dbc2vss: {signal: T, transform: {mapping: [{from: 1, to: 5}]}}}\n",
        "Vehicle.Trip: {unit: m, dbc2vss: {signal: T, transform: {mapping: [{from: 1, to: 5000}]}}}\n",
    ),
    "a wildcard over nodes that stay": ("Vehicle.Sp*: {comment: x}\n", "Vehicle.Sp*: {comment: x}\n"),
}


@pytest.mark.parametrize("case", CASES)
def test_certain_changes_are_made(sides, case):
    before, after = CASES[case]
    sides.write("ours.vspec", before)
    result = sides.run()
    assert (result.status, sides.text("ours.vspec")) == (0, after), result.messages
    assert sides.run().status == 0
    assert sides.text("ours.vspec") == after


def test_a_value_that_changes_for_two_reasons_is_written_once(sides):
    text = "Vehicle.Own: &own {type: sensor, datatype: float, errors: [Vehicle.Coolant], description: Own.}\n"
    sides.write("ours.vspec", f"{text}Vehicle.Other: *own\n")
    assert sides.run().status == 0
    assert sides.text("ours.vspec") == f"{text}Vehicle.Other: *own\n".replace("Coolant", "Engine.Coolant")


UNDECIDED = {
    "a guess of the table": ("Vehicle.Door.Row1.Left.IsOpen: {comment: x}\n", "D001", "(90%)"),
    "a guess by equal definition": ("Vehicle.Same: {comment: x}\n", "D001", "Vehicle.Renamed"),
    "a removed node": ("Vehicle.Gone: {comment: x}\n", "D003", "Nobody measures it."),
    "a removed node that the overlay defines": (
        "Vehicle.Gone: {type: sensor, datatype: uint8, description: Ours.}\n",
        "D005",
        "adds it again",
    ),
    "a unit without a conversion": ("Vehicle.Level: {max: 80}\n", "D004", "from percent to l"),
    "a number that does not fit": ("Vehicle.Trip: {datatype: float, max: 0.0005}\n", "D004", "uint32 does not hold"),
    "two nodes that become one": (
        "Vehicle.Coolant: {comment: x}\nVehicle.Engine.Coolant: {comment: y}\n",
        "D002",
        "both become Vehicle.Engine.Coolant",
    ),
    "a wildcard over nodes that move": ("Vehicle.Coo*: {comment: x}\n", "D002", "Vehicle.Coolant, which moved"),
}


@pytest.mark.parametrize("case", UNDECIDED)
def test_what_is_not_certain_is_a_finding_at_its_line(sides, case):
    text, rule, words = UNDECIDED[case]
    sides.write("ours.vspec", "# a comment\n" + text)
    result = sides.run()
    assert result.status == 1
    assert f" {rule} " in result.messages
    assert words in result.messages
    assert "ours.vspec:2:" in result.messages.replace("\\", "/")


def test_guesses_are_applied_on_demand(sides):
    sides.write("ours.vspec", "Vehicle.Door.Row1.Left.IsOpen: {comment: x}\nVehicle.Same: {comment: x}\n")
    assert sides.run("--accept-guesses").status == 0
    assert sides.text("ours.vspec") == (
        "Vehicle.Door.Row1.DriverSide.IsOpen: {comment: x}\nVehicle.Renamed: {comment: x}\n"
    )


def test_a_person_chooses(sides):
    sides.write("ours.vspec", "Vehicle.Door.Row1.Left.IsOpen: {comment: x}\n")
    assert sides.run("--choose", "Vehicle.Door.Row1.Left=Vehicle.Door.Row1.PassengerSide").status == 0
    assert sides.text("ours.vspec") == "Vehicle.Door.Row1.PassengerSide.IsOpen: {comment: x}\n"


def test_the_way_back_restores_the_meaning(sides):
    sides.write("ours.vspec", "Vehicle.Speed:\n  max: 100\nVehicle.Trip: {unit: km, max: 12.5}\n")
    sides.run()
    assert sides.run(back=True).status == 0
    assert sides.text("ours.vspec") == "Vehicle.Speed:\n  unit: km/h\n  max: 100\nVehicle.Trip: {unit: km, max: 12.5}\n"


def test_included_files_move_with_their_branch(sides):
    sides.write("ours.vspec", "#include lamps.vspec Vehicle.Lamp\n")
    sides.write("lamps.vspec", "IsOn:\n  comment: x\n")
    assert sides.run().status == 0
    assert sides.text("ours.vspec") == "#include lamps.vspec Vehicle.Light\n"
    assert sides.text("lamps.vspec") == "IsOn:\n  comment: x\n"


def test_a_file_that_is_not_yaml_stays_and_is_reported(sides):
    sides.write("ours.vspec", "Vehicle.Coolant: [\n")
    result = sides.run()
    assert (result.status, sides.text("ours.vspec")) == (1, "Vehicle.Coolant: [\n")
    assert "R0" in result.messages
