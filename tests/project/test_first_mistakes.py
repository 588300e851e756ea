"""Mistakes in a new project: the first finding is at the place to change, and says the fix."""

import json

import pytest

from sigcat.cli import main

OVERLAY, FUNCTION = "overlays/cabin.vspec", "functions/cabin_air/function.yaml"
RULES, PROJECT = "rules.yaml", "sigcat.toml"
SYNTAX = [
    (OVERLAY, "type: sensor", "type:sensor", "4:8 R001", "Write a space behind the colon."),
    (OVERLAY, "description: Rel", 'description: "Rel', "10:16 R001", "Close the quotation mark that opens here."),
    (OVERLAY, "unit: percent", "unit percent", "6:3 R001", "Write a colon and a space behind the name."),
    (OVERLAY, "  unit: percent", "<<<<<<< HEAD\n  unit: percent", "6:1 R001", "Resolve it, and remove the lines that git wrote."),
    (PROJECT, 'id = "proj"', 'id = "proj', "9:11 C001", "Close the quotation mark."),
    (PROJECT, 'id = "proj"', "id = proj", "9:6 C001", "Put quotation marks around the text."),
    (PROJECT, 'id = "proj"', 'id: "proj"', "9:3 C001", "Write `=` for the colon."),
    (PROJECT, 'id = "proj"', 'id = "proj",', "9:12 C001", "Remove the comma."),
    (PROJECT, '["functions"]', '["functions" "more"]', "2:26 C001", "Write a comma between the values."),
    (PROJECT, '["functions"]', '["functions"', "3:1 C001", "Close the bracket that is open above this line."),
    (PROJECT, '["overlays/*.vspec"]', '["overlays/*.vspec"', "12:12 C001", "Close the bracket."),
    (PROJECT, 'id = "proj"', "shipped = True", "9:11 C001", "Write `true`."),
    (PROJECT, 'title = "proj"', 'title = "C:\\x"', "10:14 C001", "Write the backslash twice, or use single quotation marks."),
    (PROJECT, "[lint]", "<<<<<<< HEAD\n[lint]", "5:1 C001", "Resolve it, and remove the lines that git wrote."),
]  # fmt: skip
PATHS = [
    (PROJECT, "overlays/*.vspec", "overlay/*.vspec", "12:14 C005", "There is no folder 'overlay'. Did you mean 'overlays'?"),
    (PROJECT, '["functions"]', '["function"]', "2:15 C005", "There is no folder 'function'. Did you mean 'functions'?"),
    (PROJECT, '"rules.yaml"', '"rule.yaml"', "3:11 C005", "There is no file 'rule.yaml'. Did you mean 'rules.yaml'?"),
]  # fmt: skip
SIGNALS = [
    (OVERLAY, "Vehicle.Cabin.Humidity:", "Vehicle/Cabin/Humidity:", "3:1 V021", "Write 'Vehicle.Cabin.Humidity'."),
    (OVERLAY, "Vehicle.Cabin.Humidity:", "Vehicle.Speed.Humidity:", "3:1 V019", "Write 'Vehicle.Humidity', or place it below another branch."),
    (OVERLAY, "Vehicle.Cabin.Humidity:", "Vehicle.Cabin.Door.Row9.DriverSide.Humidity:", "3:1 V020",
     "The instances of 'Vehicle.Cabin.Door' are Row1, Row2. Define 'Vehicle.Cabin.Door.Row9' with `type: branch` and a description."),
    (OVERLAY, "  description:", "  desciption:", "3:1 V104", "Write it for `desciption`."),
    (OVERLAY, "Vehicle.Cabin.Humidity:", "Vehicle.Rows:\n  type: branch\n  instances: Row[2]\n  description: Rows.\nVehicle.Cabin.Humidity:", "5:14 V115", "Write Row[1,2] for each number from 1 to 2."),
    (OVERLAY, "Vehicle.Cabin.Humidity:", "Vehicle.Rows:\n  type: branch\n  instances: Row[1,]\n  description: Rows.\nVehicle.Cabin.Humidity:", "5:14 V115", "Write Row[1,2] for each number from 1 to 2."),
]  # fmt: skip
FUNCTIONS = [
    (FUNCTION, "      - CabinAir_Init\n", "", "16:5 F018", "List it under `runnables` of a component, or remove the definition."),
    (FUNCTION, "  signature: globals\n", "", "8:1 F002", "Write signature: globals, pointers or class."),
    (FUNCTION, "            role: consumed\n", "", "26:13 F002", "Write role: consumed or provided."),
]  # fmt: skip
OF_RULES = [
    (RULES, "check: required", "checks: required", "8:3 L010", "Did you mean 'check'?"),
    (RULES, "attributes: [owner]", "attribute: [owner]", "10:13 L010", "Did you mean 'attributes'? Its options are attributes."),
    (PROJECT, "[[catalogue]]", "[lint.options.V101]\nmost = 3\n\n[[catalogue]]", "9:1 L012", "Its options are pattern, prefixes, exempt, endings, case."),
    (PROJECT, "[[catalogue]]", "[lint.options.V1012]\nmost = 3\n\n[[catalogue]]", "8:1 L012", "Did you mean 'V012' or 'V101' or 'V102'?"),
    (PROJECT, "[[catalogue]]", "[lint.options.F001]\nmost = 3\n\n[[catalogue]]", "8:1 L012", "Rule F001 has no options."),
]  # fmt: skip


@pytest.fixture
def project(tmp_path, monkeypatch, capsys):
    assert main(["init", str(tmp_path / "proj")]) == 0
    capsys.readouterr()
    monkeypatch.chdir(tmp_path / "proj")
    return tmp_path / "proj"


def change(file, old, new):
    text = file.read_text()
    assert old in text
    file.write_text(text.replace(old, new, 1))


@pytest.mark.parametrize(
    ("name", "old", "new", "place", "fix"),
    [*SYNTAX, *PATHS, *SIGNALS, *FUNCTIONS, *OF_RULES],
    ids=lambda value: value.partition("\n")[0][:30],
)
def test_the_first_finding_of_lint_leads_to_the_mistake(project, name, old, new, place, fix, capsys):
    change(project / name, old, new)
    assert main(["lint", "--color", "never"]) != 0
    first = next(line for line in "".join(capsys.readouterr()).splitlines() if line)
    where, severity, rule, _ = first.split(" ", 3)
    assert severity in ("error:", "error", "warning")
    assert (f"{where.removesuffix(':')} {rule}", first.endswith(fix)) == (f"{name}:{place}", True), first


def findings(capsys, *options):
    main(["lint", "--format", "json", *options])
    return [(each["file"], each["rule"]) for each in json.loads(capsys.readouterr().out)["findings"]]


def test_what_follows_from_an_overlay_comes_after_it(project, capsys):
    change(project / OVERLAY, "Vehicle.Cabin.Humidity:", "Vehicle.Cabin.Humidty:")
    change(project / OVERLAY, "datatype: float", "datatype: flot")
    assert findings(capsys) == [(OVERLAY, "V003"), (FUNCTION, "F010")]


def test_a_mistake_in_a_rule_comes_before_its_findings(project, capsys):
    change(project / RULES, "attributes: [owner]", "attributes: [team]")
    assert [rule for _, rule in findings(capsys)] == ["L013", "OWN001"]


@pytest.mark.parametrize("text", ["Vehicle.X: {type: sensor\n", "a,b\n1,2\n"])
def test_an_overlay_below_that_cannot_be_read_is_reported(project, text, capsys):
    (project / "below.txt").write_text(text)
    ((file, rule),) = findings(capsys, "-l", "below.txt", OVERLAY)
    assert (file, rule) in {("below.txt", "R001"), ("below.txt", "R007")}


@pytest.mark.parametrize(("name", "key"), [("turns/units.yaml", "units"), ("turns/quantities.yaml", "quantities")])
def test_units_that_no_catalogue_lists_are_reported(project, name, key, capsys):
    (project / "turns").mkdir()
    unit = "turns: {definition: Turns., unit: turns, quantity: angle, allowed-datatypes: [numeric]}\n"
    (project / name).write_text(unit if key == "units" else "spin: {definition: Turns.}\n")
    assert findings(capsys) == [(name, "U010")]
    change(project / PROJECT, "functions =", f'{key} = ["{name}"]\nfunctions =')
    assert findings(capsys) == []


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["lint", "--unsafe-fixes"], "--unsafe-fixes belongs to --fix or --diff: add one of them"),
        (
            ["lint", "functions/cabin_air/CabinAir.h"],
            "functions/cabin_air/CabinAir.h is no file that lint checks (.vspec, .yaml, .yml, .json). Name a function file: its lint reads its headers.",
        ),
        (["simulate"], "there are no inputs: name a trace with --trace FILE, or run without inputs for --duration SECONDS"),
    ],
)  # fmt: skip
def test_a_command_that_was_meant_otherwise_says_so(project, arguments, message, capsys):
    assert main(arguments) == 2
    assert capsys.readouterr().err == f"sigcat: {message}\n"


def test_a_function_file_is_integrated_before_it_is_generated(project, capsys):
    assert main(["generate", "ros2", FUNCTION, "-o", "out"]) == 1
    fix = "Run `sigcat integrate ros2` with it, and name the document that it writes."
    assert f"{FUNCTION}:1:1: error F001 The file is a function file, not Integration JSON. {fix}\n" in "".join(
        capsys.readouterr()
    )


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"", "The trace has no header."),
        (b"PK\x03\x04\x01", "Save the table as CSV: this file is not a text."),
    ],
)
def test_a_trace_that_is_none_says_so(project, content, message, capsys):
    (project / "trace.csv").write_bytes(content)
    assert main(["simulate", "--trace", "trace.csv"]) == 1
    assert message in "".join(capsys.readouterr())


def test_a_name_with_a_space_is_reported_at_the_name(project, capsys):
    change(project / FUNCTION, "function: CabinAir", "function: Cabin Air")
    assert findings(capsys) == [(FUNCTION, "F015"), (FUNCTION, "F113"), (FUNCTION, "V101")]
