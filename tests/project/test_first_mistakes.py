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
    (PROJECT, '["functions"]', '["functions"', "2:13 C001", "Close the bracket."),
    (PROJECT, '["overlays/*.vspec"]', '["overlays/*.vspec"', "12:12 C001", "Close the bracket."),
    (PROJECT, 'id = "proj"', "shipped = True", "9:11 C001", "Write `true`."),
    (PROJECT, 'title = "proj"', 'title = "C:\\x"', "10:14 C001", "Write the backslash twice, or use single quotation marks."),
    (PROJECT, "[lint]", "<<<<<<< HEAD\n[lint]", "5:1 C001", "Resolve it, and remove the lines that git wrote."),
]  # fmt: skip
SYNTAX_OF_TOML = [
    (PROJECT, '["overlays/*.vspec"]', "[\u201coverlays/*.vspec\u201d]", "12:13 C001", "Use straight quotation marks."),
    (PROJECT, '["owner"]', '["owner"', "6:23 C001", "Close the bracket."),
    (PROJECT, '["functions"]', '[\n  "functions"\n  "more"\n]', "4:3 C001", "Write a comma between the values."),
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
    (OVERLAY, "Vehicle.Cabin.Humidity:", "Vehcile.Cabin.Humidity:", "3:1 V022", "Write 'Vehicle.Cabin.Humidity'."),
    (OVERLAY, "unit: percent", "unit:", "6:8 V127", "Write one, or remove the line."),
    (OVERLAY, "  unit: percent", "  allowed:\n    -'A'\n    -'B'\n  #", "7:5 V004", "Write a space behind each hyphen."),
    (OVERLAY, "Vehicle.Cabin.Humidity:", "Vehicle.Rows:\n  type: branch\n  instances: Row[1-2]\n  description: Rows.\nVehicle.Cabin.Humidity:",
     "5:14 V115", "Write Rows[1,2] for each number from 1 to 2."),
    (OVERLAY, "Vehicle.Cabin.Humidity:", "Vehicle.Rows:\n  type: branch\n  instances: Left, Right\n  description: Rows.\nVehicle.Cabin.Humidity:",
     "5:14 V115", "Write [Left, Right] for 2 instances, or one name such as 'LeftRight'."),
]  # fmt: skip
FUNCTIONS = [
    (FUNCTION, "[CabinAir.h]", "[CabinAir.hpp]", "11:13 F201", "Did you mean 'CabinAir.h'? Correct the path, or add the file."),
    (FUNCTION, "[CabinAir.c]", "[Cabinair.c]", "10:13 F201", "Did you mean 'CabinAir.c'? Correct the path, or add the file."),
    (FUNCTION, "            provider: Climate control unit\n", "", "26:13 F103",
     "Add the function, or name the provider under `provider`. If this one provides it, write `role: provided`."),
    (FUNCTION, "signature: globals", "signature: pointers", "9:14 F202", "List the objects, or write `signature: globals`."),
    (FUNCTION, "            provider: Climate control unit\n            variable: CabinAir_in.humidity\n            init: 0.0\n            asil: QM\n          - path:",
     "            variable: CabinAir_in.humidity\n            init: 0.0\n            asil: QM\n            path:", "31:13 R006",
     "Remove one of the two; for another item of a list, write `- ` before the first key of the item."),
    (FUNCTION, "      - CabinAir_Init\n", "", "16:5 F018", "List it under `runnables` of a component, or remove the definition."),
    (FUNCTION, "  signature: globals\n", "", "8:1 F002", "Write signature: globals, pointers or class."),
    (FUNCTION, "            role: consumed\n", "", "26:13 F002", "Write role: consumed or provided."),
]  # fmt: skip
OF_RULES = [
    (PROJECT, "extended-attributes", 'ignore = ["V999"]\nextended-attributes', "6:12 L012", "No rule has the code 'V999'."),
    (PROJECT, "overlays =", 'extended-attributes = ["x"]\noverlays =', "12:1 C002", "Write `extended-attributes` in [lint]."),
    (RULES, "    overlay: |\n      Vehicle.Cabin.Humidity: {type: sensor, datatype: float, owner", "    overlay:\n      Vehicle.Cabin.Humidity: {type: sensor, datatype: float, owner",
     "12:3 L010", "Write `overlay: |`, and the text in the lines below it."),
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
    [*SYNTAX, *SYNTAX_OF_TOML, *PATHS, *SIGNALS, *FUNCTIONS, *OF_RULES],
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
            "functions/cabin_air/CabinAir.h is not a file that lint checks (.vspec, .yaml, .yml, .json). Name a function file: its lint reads its headers.",
        ),
        (["lint", "functions/cabin_air/trace.csv"], "functions/cabin_air/trace.csv is not a file that lint checks (.vspec, .yaml, .yml, .json). `sigcat simulate` checks the traces that --trace names."),
        (["simulate", "functions/cabin_air/trace.csv"], "functions/cabin_air/trace.csv is a table: name a trace with --trace"),
        (["simulate", "functions/cabin_air/CabinAir.c"], "functions/cabin_air/CabinAir.c is code: name the function file that lists it"),
        (["units", "convert", "km/h", "m/s", "100"], "'km/h' is not a number that a double holds: write one first, as in sigcat units convert 100 km/h m/s"),
        (["diff", "HEAD~1..HEAD"], "'HEAD~1..HEAD' is not a release name; for a revision, write git:HEAD~1..HEAD"),
        (["simulate"], "the run has no inputs: name a trace with --trace FILE, or run without inputs for --duration SECONDS"),
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


UNIT = "turns: {definition: Turns., unit: turns, quantity: angle, allowed-datatypes: [numeric]}\n"


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("[numeric]", "numeric", "`allowed-datatypes` of unit 'turns' must be a list, not 'numeric'. Write [numeric]."),
        ("[numeric]", "[integer]", "allows 'integer', which is not a datatype. Use numeric, or datatypes of VSS such as float."),
        ("quantity: angle, ", "", "Unit 'turns' must have a `quantity`. `sigcat units` lists quantities."),
    ],
)  # fmt: skip
def test_a_unit_that_is_incomplete_says_what_is_missing(project, old, new, message, capsys):
    (project / "units.yaml").write_text(UNIT.replace(old, new))
    assert main(["lint"]) == 1
    assert message in capsys.readouterr().out


def test_a_quantity_has_a_definition(project, capsys):
    (project / "quantities.yaml").write_text("spin: {remark: Turns.}\n")
    assert findings(capsys) == [("quantities.yaml", "U003")]


def test_an_overlay_that_no_catalogue_lists_is_a_note(project, capsys):
    other = (project / OVERLAY).read_text().replace("Humidity", "Haze").replace("humidity", "haze")
    (project / "overlays/haze.yaml").write_text(other)
    assert findings(capsys) == [("overlays/haze.yaml", "O109")]
    change(project / PROJECT, '"overlays/*.vspec"', '"overlays/*.vspec", "overlays/haze.yaml"')
    assert findings(capsys) == []


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"time\tVehicle.Cabin.Humidity\n", "Separate cells by commas."),
        (b"0.0,50\n", "Write the header above this row."),
        (b"time,Humidity\n0,1\n", "Did you mean 'Vehicle.Cabin.Humidity'"),
        (b"time,Vehicle.Cabin.Humidity\n0,1,\n", "Remove the comma at the end."),
        (b"time,Vehicle.Cabin.Humidity\n# rain\n", "Remove the line: a trace has no comments."),
        (b"time,Vehicle.Cabin.Humidity\n0,[1,2]\n", "Put a list in quotation marks."),
        (b"", "The trace has no header."),
        (b"PK\x03\x04\x01", "Save the table as CSV: this file is not a text."),
    ],
)
def test_a_trace_of_another_form_says_so(project, content, message, capsys):
    (project / "trace.csv").write_bytes(content)
    assert main(["simulate", "--trace", "trace.csv"]) == 1
    assert message in "".join(capsys.readouterr())


def test_a_name_with_a_space_is_reported_at_the_name(project, capsys):
    change(project / FUNCTION, "function: CabinAir", "function: Cabin Air")
    assert findings(capsys) == [(FUNCTION, "F015"), (FUNCTION, "F113"), (FUNCTION, "V101")]
