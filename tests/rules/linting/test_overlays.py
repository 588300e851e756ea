"""Errors that an overlay causes in the tree below it."""

import pytest

from sigcat.catalogue.composing.compose import read_catalogue
from sigcat.catalogue.exporting.static_id import static_id_of
from sigcat.data import INTERFACE_RULES, VSPEC
from sigcat.rules.compiled import compiled_rules
from sigcat.rules.linting.lint import lint_paths
from sigcat.rules.linting.options import LintOptions
from sigcat.rules.linting.posted import lint_text
from sigcat.rules.rule_set import RuleSet

EVERY_RULE = RuleSet(compiled_rules(INTERFACE_RULES))


BELOW = """\
Vehicle: {type: branch, description: A vehicle.}
Vehicle.A: {type: sensor, datatype: uint8, max: 200, default: 150, description: A thing.}
Vehicle.Mode: {type: actuator, datatype: string, allowed: [HIGH, LOW], default: HIGH, description: A mode.}
Vehicle.Row: {type: branch, instances: "Row[1,2]", description: Rows.}
Vehicle.Row.X: {type: sensor, datatype: uint8, unit: km/h, description: A thing.}
Vehicle.Row.Common: {type: sensor, datatype: uint8, instantiate: false, description: A thing.}
"""


@pytest.mark.parametrize(
    ("overlay", "told"),
    [
        ("Vehicle.A: {comment: Less., max: 100}\n", ("V010", 1, 34)),
        ("Vehicle.A: {min: 160}\n", ("V010", 1, 18)),
        ("Vehicle.A: {datatype: string}\n", ("V009", 1, 23)),
        ("Vehicle.Mode: {allowed: [LOW, HIGH]}\n", ("V121", 1, 25)),
        ("Vehicle.Row.Row1.X: {max: 100000}\n", ("V008", 1, 27)),
        ("Vehicle.Row.Row1.X: {unit: foo}\n", ("V006", 1, 28)),
        ("Vehicle.Row.Row1: {type: sensor, datatype: uint8, description: A row.}\n", ("V019", 1, 26)),
        ("Vehicle.Row.Row1.Common: {max: 3}\n", ("O101", 1, 1)),
        ("Vehicle.Row: {instances: ['Row[1,2]', [L, R]]}\nVehicle.Row.Row1.X: {max: 3}\n", ("O101", 2, 1)),
        ("Vehicle.Gone: {delete: true}\n", ("O102", 1, 16)),
        ("Vehicle.Row: {instances: ['A[1,1000]', 'B[1,1000]']}\n", ("V025", 1, 26)),
        ("Vehicle.B: {type: sensor, datatype: flaot, unit: foo, description: Two slips.}\n", ("V006", 1, 50)),
    ],
)
def test_what_an_overlay_makes_wrong_is_told_where_it_says_so(tmp_path, overlay, told):
    (tmp_path / "vspec").mkdir()
    (tmp_path / "overlays").mkdir()
    tree, file = tmp_path / "vspec" / "VehicleSignalSpecification.vspec", tmp_path / "overlays" / "own.vspec"
    tree.write_text(BELOW)
    file.write_text(overlay)
    (tree.parent / "units.yaml").write_bytes((VSPEC / "units.yaml").read_bytes())
    (tree.parent / "quantities.yaml").write_bytes((VSPEC / "quantities.yaml").read_bytes())
    alone = {(f.rule, f.line, f.column) for f in lint_paths([file]).findings}
    posted = lint_text(overlay.encode(), "posted", read_catalogue(tree), EVERY_RULE)
    assert told in alone
    assert told in {(f.rule, f.line, f.column) for f in posted}
    assert [f for f in lint_paths([tree]).findings if f.rule == told[0]] == []


@pytest.mark.parametrize(
    ("overlay", "told"),
    [
        ("Vehicle.Row.Row1.X: {type: sensor}\n", []),
        ("Vehicle.Row.Row1: {type: branch}\n", []),
        ("Vehicle.Row.Row2: {type: branch, delete: true}\n", []),
        ("Vehicle.Row.Row2.X: {delete: true}\n", []),
        ("Vehicle.Row.Row1.X: {type: sensor, max: 200}\n", ["O104"]),
        ("Vehicle.Row.Row1.X: {type: sensor, datatype: float}\n", ["O103"]),
        ("Vehicle.Row.Row1.X: {description: 'What it is'}\n", ["V106"]),
        ("Vehicle.Row.Row1.New: {type: sensor, datatype: float}\n", ["V104"]),
    ],
)
def test_what_is_written_for_an_instance_has_all_that_its_definition_has(tmp_path, overlay, told):
    tree, file = tmp_path / "VehicleSignalSpecification.vspec", tmp_path / "own.vspec"
    tree.write_text(BELOW)
    file.write_text(overlay)
    for name in ("units.yaml", "quantities.yaml"):
        (tmp_path / name).write_bytes((VSPEC / name).read_bytes())
    posted = lint_text(overlay.encode(), "posted", read_catalogue(tree), EVERY_RULE)
    assert [f.rule for f in lint_paths([file]).findings if f.file == str(file)] == told
    assert [f.rule for f in posted if f.rule[0] in "OV"] == told


def test_a_branch_that_becomes_a_signal_is_one_finding_however_much_is_below(tmp_path):
    tree, file = tmp_path / "VehicleSignalSpecification.vspec", tmp_path / "own.vspec"
    more = "".join(f"Vehicle.Row.Y{n}: {{type: sensor, datatype: uint8, description: Y{n}.}}\n" for n in range(5))
    tree.write_text(BELOW.replace(", unit: km/h", "") + more)
    file.write_text("Vehicle.Row: {type: sensor, datatype: uint8}\n")
    assert [f.rule for f in lint_paths([file]).findings].count("V019") == 1


def test_what_an_overlay_includes_is_a_part_of_it_wherever_it_stands(tmp_path):
    overlays = tmp_path / "overlays"
    (overlays / "inc").mkdir(parents=True)
    (overlays / "a.vspec").write_text(
        "Vehicle.Acme: {type: branch, description: Ours.}\n#include inc/shared.vspec Vehicle.Acme\n"
    )
    (overlays / "b.vspec").write_text("Vehicle.Other: {type: branch, description: Others.}\n")
    shared = overlays / "inc" / "shared.vspec"
    shared.write_text(
        "sig: {type: sensor, datatype: uint8, description: A signal.}\n*: {comment: Ours.}\n".replace("*", "'*'")
    )
    assert {f.rule for f in lint_paths([shared]).findings} == {"V101"}
    for path in (shared, overlays / "b.vspec", overlays / "inc" / ".." / "b.vspec"):
        assert [f.rule for f in lint_paths([path]).findings if f.severity == "error"] == []


def test_a_folder_above_the_repository_makes_no_overlay_of_a_tree(tmp_path):
    folder = tmp_path / "overlays" / "checkout"
    (folder / "vspec").mkdir(parents=True)
    (folder / ".git").mkdir()
    (folder / "vspec" / "VehicleSignalSpecification.vspec").write_text(
        "Vehicle: {type: branch, description: A vehicle.}\n#include Body.vspec Vehicle.Body\n"
    )
    body = folder / "vspec" / "Body.vspec"
    body.write_text("Is: {type: branch, description: A part.}\n")
    assert lint_paths([body]).findings == ()


def test_an_overlay_is_for_the_shipped_tree_where_only_an_include_shows_that_another_has_another_root(tmp_path):
    """Linted with a tree that it is not made for, or alone: it is the same overlay."""
    for folder in ("truck", "overlays"):
        (tmp_path / folder).mkdir()
    root, own = tmp_path / "truck" / "Truck.vspec", tmp_path / "overlays" / "own.vspec"
    root.write_text("#include Cabin.vspec\n")
    (root.parent / "Cabin.vspec").write_text("Truck: {type: branch, description: A truck.}\n")
    own.write_text("Vehicle.Bom: {type: sensor, datatype: float, description: A new signal.}\n")
    assert lint_paths([tmp_path / "overlays"]).findings == ()
    assert lint_paths([tmp_path]).findings == ()
    own.write_text("Truck.Bom: {type: sensor, datatype: flaot, description: A new signal.}\n")
    assert [f.rule for f in lint_paths([tmp_path]).findings] == ["V003"]


ID_OF_X = static_id_of("Vehicle.Seat.X", {"type": "sensor", "datatype": "uint8"})
"""The identifier that `vspec export id` gives the node without an overlay."""


@pytest.mark.parametrize(
    ("overlay", "told"),
    [
        ("Vehicle.Row: {instances: [Front, Rear]}\n", ["O107"]),
        ("Vehicle.Row: {instances: 'Row[1,3]'}\n", []),
        ("Vehicle.Row: {instances: 'Row[1,1]'}\n", ["O107"]),
        ("Vehicle.Row: {instances: ['Row[1,2]', [L, R]]}\n", ["O107"]),
        ("Vehicle.Row: {instances_relation: sibling}\n", ["O107"]),
        ("Vehicle.Row: {comment: Ours.}\n", []),
        ("Vehicle.Row.X: {instantiate: false}\n", ["O107"]),
        ("Vehicle.Row.Common: {instantiate: true}\n", ["O107"]),
        ("Vehicle.Row: {delete: true}\n", []),
        ("Vehicle.Seat: {instances: [L, R]}\n", ["O107"]),
        ("Vehicle.Empty: {instances: [L, R]}\n", []),
        ("Vehicle.Gear: {enum: {DRIVE: 2}}\n", ["O103"]),
        ("Vehicle.Gear: {enum: {REAR: 2}}\n", []),
        ("Vehicle.Seat.List: {arraysize: 4}\n", ["O103"]),
        ("Vehicle.Seat.X: {constUID: '0x12345678'}\n", ["O103"]),
        (f"Vehicle.Seat.X: {{constUID: '{ID_OF_X}'}}\n", []),
        ("Vehicle: {type: branch, delete: true}\n", ["O102"]),
        ("Vehicle.Seat: {delete: true}\nVehicle.Seat.N: {type: sensor, datatype: uint8, description: N.}\n", ["O108"]),
        ("Vehicle.Seat: {delete: true}\nVehicle.Seat.X: {max: 3}\n", ["O104", "O108"]),
        ("Vehicle.Seat: {delete: true}\nVehicle.Seat.X: {delete: true}\n", []),
        ("Vehicle.Seat: {delete: true}\nVehicle.Seats: {type: branch, description: Other seats.}\n", []),
    ],
)
def test_what_an_overlay_takes_from_those_who_know_the_tree(tmp_path, overlay, told):
    tree, file = tmp_path / "VehicleSignalSpecification.vspec", tmp_path / "own.vspec"
    seat = "Vehicle.Seat: {type: branch, description: Seats.}\nVehicle.Empty: {type: branch, description: None.}\n"
    gear = "Vehicle.Gear: {type: sensor, datatype: uint8, enum: {PARK: 0, DRIVE: 1}, description: Gear.}\n"
    signal = "Vehicle.Seat.X: {type: sensor, datatype: uint8, description: A thing.}\n"
    signal += "Vehicle.Seat.List: {type: sensor, datatype: 'uint8[]', description: Things.}\n"
    tree.write_text(BELOW.replace(", unit: km/h", "") + seat + signal + gear)
    file.write_text(overlay)
    posted = lint_text(overlay.encode(), "posted", read_catalogue(tree), EVERY_RULE)
    assert sorted(f.rule for f in lint_paths([file]).findings if f.rule[0] == "O") == told
    assert sorted(f.rule for f in posted if f.rule[0] == "O") == told


def test_an_overlay_may_delete_what_an_earlier_one_adds(tmp_path):
    (tmp_path / "VehicleSignalSpecification.vspec").write_text(BELOW.replace(", unit: km/h", ""))
    adds, deletes = tmp_path / "adds.vspec", tmp_path / "deletes.vspec"
    adds.write_text("Vehicle.Row.New: {type: sensor, datatype: uint8, description: A new thing.}\n")
    deletes.write_text("Vehicle.Row: {delete: true}\n")
    for order, told in [((adds, deletes), []), ((deletes, adds), ["O108"])]:
        found = lint_paths([adds, deletes], LintOptions(overlays=order)).findings
        assert [f.rule for f in found] == told


@pytest.mark.parametrize(
    ("path", "meant"),
    [
        ("Vehicle.Row.Row3.X", "Vehicle.Row.Row1.X"),
        ("Vehicle.Rows.Row1.X", "Vehicle.Row.Row1.X"),
        ("Vehicle.Row.Left.X", "Vehicle.Row.Row1.X"),
        ("Vehicle.Rows.X", "Vehicle.Row.X"),
    ],
)
def test_for_a_path_with_a_wrong_branch_that_with_the_right_one_is_proposed(tmp_path, path, meant):
    (tmp_path / "VehicleSignalSpecification.vspec").write_text(BELOW.replace(", unit: km/h", ""))
    file = tmp_path / "own.vspec"
    file.write_text(f"{path}: {{max: 3}}\n")
    (fix,) = [f.fix for f in lint_paths([file]).findings if f.rule == "O101"]
    assert fix.startswith(f"Did you mean {meant!r}")


OWN = (
    "Vehicle: {type: branch, description: Our vehicle.}\n"
    "Vehicle.Speed: {type: sensor, datatype: uint8, description: How fast it is.}\n"
)


@pytest.mark.parametrize(
    ("text", "may_be_a_tree"),
    [
        (OWN, True),
        (OWN + "Vehicle.Cabin.X: {type: sensor, datatype: uint8, description: X.}\n", False),
        (OWN.partition("\n")[2], False),
        (OWN.replace("type: sensor, ", ""), False),
    ],
)
def test_what_contradicts_the_shipped_tree_and_is_whole_may_be_a_tree_of_its_own(tmp_path, text, may_be_a_tree):
    file = tmp_path / "own.vspec"
    file.write_text(text)
    advice = [finding.fix for finding in lint_paths([file]).findings if finding.rule == "O103"]
    assert advice
    assert [f"`-s {file}`" in fix for fix in advice] == [may_be_a_tree] * len(advice)
    assert not [f for f in lint_paths([file], LintOptions(base=file)).findings if f.rule[0] == "O"]
