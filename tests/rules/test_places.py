"""Place and fix of a finding: at the wrong item, and with advice that can be followed."""

from pathlib import Path

import pytest

from sigcat.catalogue.reading.layers import layer_from_text
from sigcat.rules.linting.lint import lint_paths
from sigcat.rules.linting.options import LintOptions, LintResult
from tests.rules.own_rule import OWN_RULE

SENSOR = "  type: sensor\n  datatype: {}\n  description: A value.\n"
STRING, NUMBER = (f"Vehicle.Value:\n{SENSOR.format(datatype)}" for datatype in ("string", "uint8"))
SEATS = "Vehicle.Seat:\n  type: branch\n  description: Seats.\n"
BRANCH = "Vehicle.{}: {{type: branch, description: A.}}\n"
STEP = """\
Vehicle.Function.F.Scheduling.Step:
  type: branch
  description: A step.
"""


def linted(folder: Path, text: str, *select: str) -> LintResult:
    path = folder / "more.vspec"
    path.write_text(text, encoding="utf-8")
    return lint_paths([path], LintOptions(select=select, root=folder))


def told(result: LintResult) -> list[tuple[int, int, str]]:
    return [(f.line, f.column, f.rule) for f in result.findings]


@pytest.mark.parametrize(
    ("code", "text", "places"),
    [
        ("V109", STRING + "  allowed: [ON_1, UNKNOWN]\n", [(5, 19)]),
        ("V109", STRING + "  allowed:\n  - ON_1\n  - 'UNDEFINED'\n", [(7, 5)]),
        ("V110", NUMBER + "  enum: {ECO: 1, UNKNOWN: 2}\n", [(5, 18)]),
        ("V108", NUMBER + "  enum:\n    ECO: 1\n    EcoPlus: 2\n", [(7, 5)]),
        ("V111", STRING + "  allowed: [PARK, drive]\n", [(5, 19)]),
        ("V012", STRING + "  allowed: [PARK, NO]\n", [(5, 19)]),
        ("V014", NUMBER + "  enum: {A: 1, ON: 2, b: 3, C: 300}\n", [(5, 16), (5, 23), (5, 29)]),
        ("V018", SEATS + "  instances: ['Row[2,1]', [Left]]\n", [(4, 15)]),
        ("V114", SEATS + "  instances:\n  - Row[2,3]\n", [(5, 5)]),
        ("V115", SEATS + "  instances: ['Row[1,2]', [Left, right side]]\n", [(4, 34)]),
        ("V116", SEATS + "  instances: ['Row[1,2]', [Left, Left]]\n", [(4, 34)]),
        ("I505", STEP + "  supervisionType: [Alive, Bogus]\n", [(4, 28)]),
        ("I505", STEP + "  aliveSupervision: {minIndications: 1, max: 2}\n", [(4, 41)]),
        ("I513", STEP + "  supervisionType:\n  - Alive\n  - Logical\n", [(6, 5)]),
        ("I517", STEP + "  aliveSupervision:\n    minIndications: 5\n    maxIndications: 2\n", [(6, 21)]),
        ("I519", STEP + "  aliveSupervision: {minIndications: 1, error: Nope}\n", [(4, 48)]),
        ("I509", STEP + "  previousRunnable: [F_Step, Nope]\n", [(4, 30)]),
    ],
)
def test_a_finding_about_an_item_stands_at_the_item(tmp_path, code, text, places):
    assert told(linted(tmp_path, text, code)) == [(line, column, code) for line, column in places]


def test_an_item_that_a_merge_brought_is_found_at_its_attribute(tmp_path):
    text = f"Vehicle.One: &one\n{SENSOR.format('string')}  allowed: [UNKNOWN]\nVehicle.Two: {{<<: *one}}\n"
    assert told(linted(tmp_path, text, "V109")) == [(5, 13, "V109")] * 2


def test_items_keep_their_places_below_a_prefix():
    layer = layer_from_text(f"{STRING}  allowed: [A]\n".encode(), "part", is_overlay=False)
    placed = layer.statements[0].placed("Vehicle.Cabin")
    assert placed.origin_within("allowed", (0,)) == ("part", 5, 13, "")
    assert placed.origin_within("allowed", (1,)) is None
    assert placed.origin_within("datatype", (0,)) is None


@pytest.mark.parametrize(
    ("attribute", "steps", "place"),
    [
        ("limits", ("low", "value"), (7, 27)),
        ("limits", (1, 0), (8, 12)),
        ("limits", ("high", 1), (8, 20)),
        ("names", (1,), (9, 15)),
        ("names", (2,), None),
        ("twice", ("A",), None),
        ("last", (0, 0), (11, 11)),
    ],
)
def test_items_within_items_have_their_places(attribute, steps, place):
    more = (
        "  allowed: [A]\n  limits:\n    low: {unit: V, value: 3}\n    high: [{a: 1}, 5]\n"
        "  names: [{}, []]\n  twice: {A: 1, A: 2}\n  last: [[x]]\n"
    )
    (statement,) = layer_from_text(f"{STRING}{more}".encode(), "part").statements
    found = statement.origin_within(attribute, steps)
    assert (found and found[1:3]) == place


@pytest.mark.parametrize(
    ("code", "text", "proposal"),
    [
        ("V101", "Vehicle.Tür: {type: branch, description: A door.}\n", "Use a name such as 'Tuer'."),
        ("V101", "Vehicle.Ж: {type: branch, description: A door.}\n", ""),
        ("V102", "Vehicle.Is_Lit:\n" + SENSOR.format("boolean"), "Use a name such as 'IsLit'."),
        ("V102", "Vehicle.Island:\n" + SENSOR.format("boolean"), "Use a name such as 'IsIsland'."),
        ("V102", "Vehicle.DoorIsOpen:\n" + SENSOR.format("boolean"), "Use a name such as 'IsDoorOpen'."),
        ("V102", "Vehicle.ThisOpen:\n" + SENSOR.format("boolean"), "Use a name such as 'IsThisOpen'."),
        ("V108", NUMBER + "  enum: {EcoPlus: 1}\n", "Write 'ECO_PLUS'."),
        ("V111", STRING + "  allowed: ['1']\n", ""),
        ("V020", "Vehicle.Bdy.Weight:\n" + SENSOR.format("float"), "Did you mean 'Body'?"),
        ("V011", STRING + "  allowed: [A, B]\n  default: Z\n", "Use one of 'A', 'B'."),
        ("V009", NUMBER + "  enum: {ECO: 1}\n  default: ECO\n", "Write the number, 1."),
        ("V018", SEATS + "  instances: Row[2,1]\n", "Write [1,2]."),
        ("O101", "Vehicle.Sped: {max: 5}\n", "Did you mean 'Vehicle.Speed'? Give it a `type` if it is a new node."),
        ("O102", "Vehicle.Nothing: {delete: true}\n", "Remove it."),
        (
            "I502",
            "Vehicle.Function.CoreAcc.Scheduling.step: {type: branch, description: S.}\n",
            "Use a name such as 'Step'.",
        ),
        ("I505", STEP + "  ASILlevel: ASIL-B\n", "Write B."),
        ("I505", STEP + "  scheduling: Pre-emptive\n", "Write Preemptive."),
        ("I517", STEP + "  aliveSupervision: {minIndications: 5, maxIndications: 2}\n", "Raise `aliveSupervision.max"),
        ("P005", "Vehicle.int: {type: branch, description: A.}\n", "Use a name such as 'Int'."),
    ],
)
def test_a_finding_proposes_what_to_write(tmp_path, code, text, proposal):
    fixes = [f.fix for f in linted(tmp_path, text, code).findings]
    assert fixes
    assert all(fix.startswith(proposal) and bool(fix) == bool(proposal) for fix in fixes)


def test_the_message_names_the_prefixes_that_the_configuration_allows(tmp_path):
    path = tmp_path / "more.vspec"
    path.write_text("Vehicle.Lit:\n" + SENSOR.format("boolean"))
    options = LintOptions(select=("V102",), rule_options={"V102": {"prefixes": ["Is", "Has"]}})
    (finding,) = lint_paths([path], options).findings
    assert "`Is` or `Has`" in finding.message


# -- one cause, one finding --------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "select", "codes"),
    [
        ("Vehicle.A:\n" + SENSOR.format("float").replace("A value.", "''"), "V10", ["V104"]),
        (SEATS + "  instances: Row[2,1]\n", "V", ["V018"]),
        ("Vehicle.Cabin.: {type: branch, description: A.}\n", "V", ["V024"]),
        ("".join(map(BRANCH.format, ("Ab", "AB", "Ab.C", "AB.C"))), "V103", ["V103"]),
        ("".join(map(BRANCH.format, ("XyZ", "XyZ.A", "Xy", "Xy.Z", "Xy.Z.A"))), "P010", ["P010"]),
    ],
    ids=["no description", "a range that descends", "an empty name", "branches differ in case", "branches meet"],
)
def test_one_cause_gives_one_finding(tmp_path, text, select, codes):
    result = linted(tmp_path, text, select)
    assert [f.rule for f in result.findings] == codes


def test_a_step_is_compared_with_the_highest_asil_alone(tmp_path):
    branches = "".join(f"{path}: {{type: branch, description: B.}}\n" for path in ("Vehicle.Function.F", "Vehicle.Function.F.Error"))  # fmt: skip
    errors = "".join(
        f"Vehicle.Function.F.Error.{name}: {{type: sensor, datatype: boolean, ASILlevel: {name}, description: E.}}\n"
        for name in "BD"
    )
    (finding,) = linted(tmp_path, f"{branches}{errors}{STEP}  ASILlevel: QM\n", "I522").findings
    assert finding.fix == "Raise `ASILlevel` to D."


def test_a_file_that_is_no_text_is_one_finding(tmp_path):
    path = tmp_path / "more.vspec"
    path.write_bytes(b"\xff" + b"x " * 500)
    assert told(lint_paths([path])) == [(1, 1, "R002")]


def test_a_field_of_a_unit_that_nobody_knows_is_told(tmp_path):
    (tmp_path / "quantities.yaml").write_text("length: {definition: Length.}\n")
    (tmp_path / "units.yaml").write_text(
        "ell:\n  definition: L.\n  unit: ell\n  quantity: length\n  allowed_datatypes: [numeric]\n"
    )
    (finding,) = lint_paths([tmp_path / "units.yaml"]).findings
    assert (finding.rule, finding.line, finding.column) == ("U006", 5, 3)
    assert finding.fix == "Did you mean 'allowed-datatypes'?"


def test_a_field_of_a_quantity_that_nobody_knows_is_told_beside_the_one_that_it_was_meant_to_be(tmp_path):
    file = tmp_path / "quantities.yaml"
    file.write_text(
        "length:\n  definition: Length.\n  defintion: Extent in space.\n  comment: Long.\n  remark: Longer.\n"
    )
    (finding,) = lint_paths([file]).findings
    assert (finding.rule, finding.line, finding.column) == ("U006", 3, 3)


def test_keys_of_units_that_differ_in_case_only_are_told_with_both(tmp_path):
    (tmp_path / "quantities.yaml").write_text("power: {definition: Power.}\n")
    unit = "{key}: {{definition: P., unit: {name}, quantity: power, allowed-datatypes: [numeric]}}\n"
    units = unit.format(key="mW", name="milliwatt") + unit.format(key="MW", name="megawatt")
    (tmp_path / "units.yaml").write_text(units)
    (finding,) = lint_paths([tmp_path / "units.yaml"]).findings
    assert (finding.rule, finding.line) == ("U004", 2)
    assert "'MW' replaces 'mW'" in finding.message


@pytest.mark.parametrize(
    ("instances", "fix"),
    [
        ("[1-3]", "Write Seat[1,3] for each number from 1 to 3."),
        ("Row1..4", "Write Seat[1,4] for each number from 1 to 4."),
        ("[Left Right]", "Write [Left, Right] for 2 instances, or one name such as 'LeftRight'."),
        ("[left right]", "Use a name such as 'LeftRight'."),
    ],
)
def test_a_label_that_is_several_says_how_to_write_them(tmp_path, instances, fix):
    (finding,) = linted(tmp_path, f"{SEATS}  instances: {instances}\n", "V115").findings
    assert finding.fix == fix


@pytest.mark.parametrize(
    ("is_overlay", "found"),
    [("true", ["Vehicle.Cabin.A.Own"]), ("false", ["Vehicle.Cabin.A.B", "Vehicle.Cabin.A.Own"])],
)
def test_a_rule_can_be_about_what_overlays_add(tmp_path, is_overlay, found):
    texts = {
        "Tree.vspec": "".join(map(BRANCH.format, ("Cabin", "Cabin.A", "Cabin.A.B"))),
        "own.vspec": "Vehicle.Cabin.A.B: {comment: Changed.}\n" + BRANCH.format("Cabin.A.Own"),
        "rules.yaml": f"{OWN_RULE}  nodes: {{overlay: {is_overlay}}}\n",
    }
    for name, text in texts.items():
        (tmp_path / name).write_text(text)
    options = LintOptions(
        select=("ACME",), base=tmp_path / "Tree.vspec", rule_files=(tmp_path / "rules.yaml",), root=tmp_path
    )
    result = lint_paths([tmp_path / "Tree.vspec", tmp_path / "own.vspec"], options)
    assert sorted({finding.path for finding in result.findings}) == found
