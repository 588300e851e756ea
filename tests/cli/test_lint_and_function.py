"""`sigcat lint`, `sigcat rule` and `sigcat function`, as people type them."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

from sigcat.cli import main
from tests.catalogue.trees import ROOT

PROJECT = Path(__file__).parents[2]
SIGNAL = "Vehicle.Doors:\n  type: sensor\n  datatype: boolean\n  description: Whether a door is open.\n"


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_what_sigcat_ships_is_clean(monkeypatch, capsys):
    monkeypatch.chdir(PROJECT)
    assert main(["lint", "vspec", "overlays", "examples", "interface_rules"]) == 0
    assert capsys.readouterr().out == "No findings.\n"


def test_a_finding_shows_the_line_and_a_caret_and_the_status_is_1(capsys):
    Path("tree.vspec").write_text(ROOT + SIGNAL)
    assert main(["lint", "tree.vspec"]) == 1
    output = capsys.readouterr().out
    assert "tree.vspec:4:1: warning V102" in output
    assert "Vehicle.Doors:\n" in output
    assert output.endswith("in 1 file.\n")


def test_select_and_ignore_take_short_codes(capsys):
    Path("tree.vspec").write_text(ROOT + SIGNAL)
    assert main(["lint", "tree.vspec", "--ignore", "V1"]) == 0
    assert main(["lint", "tree.vspec", "--select", "V102"]) == 1
    assert main(["lint", "tree.vspec", "--select", "V9"]) == 2
    assert "No rule has the code 'V9'" in capsys.readouterr().err


def test_an_overlay_is_checked_over_the_shipped_tree(capsys):
    Path("overlay.vspec").write_text("Vehicle.Sped:\n  min: 0\n")
    assert main(["lint", "overlay.vspec"]) == 1
    assert "Vehicle.Speed" in capsys.readouterr().out


FUNCTION = """\
function: Noise
description: Watches the noise in the cabin.
responsible: Acoustics team
define:
  scheduling:
    Init: {asil: QM, description: Clears the mean.}
    Step: {cycleTime: 100, asil: QM, description: Adds a value to the mean.}
    Terminate: {asil: QM, description: Gives resources back.}
components:
  - name: Noise
    runnables:
      - Init
      - interface: Step
        data: [{path: Vehicle.Noise, role: consumed, variable: noise, asil: QM, provider: Microphone}]
      - Terminate
"""
NOISE = "Vehicle.Noise:\n  type: sensor\n  datatype: float\n  description: Noise in the cabin.\n"


def test_a_function_is_checked_over_the_overlays_of_the_configuration(capsys):
    Path("function.yaml").write_text(FUNCTION)
    assert main(["lint", "function.yaml"]) == 1
    assert "F010" in capsys.readouterr().out
    Path("overlay.vspec").write_text(NOISE)
    assert main(["lint", "function.yaml", "-l", "overlay.vspec"]) == 0
    Path("sigcat.toml").write_text('[lint]\noverlays = ["overlay.vspec"]\n')
    assert main(["lint", "function.yaml"]) == 0


@pytest.mark.parametrize(
    ("overlay", "rule"),
    [
        (NOISE.replace("  datatype", "   datatype"), "R001"),
        (NOISE.replace("  datatype", "\tdatatype"), "R001"),
        (NOISE.replace("  datatype: float\n", ""), "V002"),
        (NOISE.replace("  datatype: float\n", "  ? [a]\n  : b\n"), "R014"),
    ],
    ids=("indentation", "tab", "no datatype", "no value"),
)
@pytest.mark.parametrize("checked", ["function.yaml", "."])
def test_what_follows_from_an_error_of_an_overlay_is_not_reported(capsys, overlay, rule, checked):
    Path("function.yaml").write_text(FUNCTION)
    Path("overlay.vspec").write_text(overlay)
    Path("sigcat.toml").write_text('[lint]\noverlays = ["overlay.vspec"]\n')
    assert main(["lint", checked]) == 1
    output = capsys.readouterr().out
    assert f"error {rule}" in output
    assert "Found 1 error in 1 file." in output


def test_an_unknown_signal_is_reported_beside_an_error_of_another_node(capsys):
    Path("function.yaml").write_text(FUNCTION)
    Path("overlay.vspec").write_text(NOISE.replace("Noise", "Sound", 1).replace("float", "float\n  ? [a]\n  : b"))
    Path("sigcat.toml").write_text('[lint]\noverlays = ["overlay.vspec"]\n')
    assert main(["lint", "."]) == 1
    output = capsys.readouterr().out
    assert "error F010 The catalogue has no signal 'Vehicle.Noise'" in output
    assert "overlay.vspec" in output


def test_overlays_and_functions_are_checked_over_the_tree_that_is_named(capsys):
    Path("trees").mkdir()
    Path("trees/tree.vspec").write_text(ROOT + NOISE)
    Path("function.yaml").write_text(FUNCTION)
    Path("overlay.vspec").write_text("Vehicle.Noise:\n  comment: In dB.\n")
    assert main(["lint", "-s", "trees/tree.vspec", "function.yaml", "overlay.vspec"]) == 0
    assert main(["lint", "-s", "vss", "overlay.vspec"]) == 1
    assert main(["lint", "-s", "v0.0", "overlay.vspec"]) == 2
    assert "release v0.0 is not pulled" in capsys.readouterr().err


def test_a_finding_about_the_description_of_a_function_is_at_its_line(capsys):
    Path("overlay.vspec").write_text(NOISE)
    Path("function.yaml").write_text(FUNCTION.replace("in the cabin.", "in the cabin"))
    main(["lint", "function.yaml", "-l", "overlay.vspec"])
    assert "function.yaml:2:14: info V106" in capsys.readouterr().out


def test_a_can_database_that_is_named_replaces_that_of_the_project(capsys):
    Path("overlay.vspec").write_text(NOISE)
    Path("damaged.dbc").write_text("BO_ nothing")
    Path("good.dbc").write_text('VERSION ""\nBO_ 1 Motion: 8 Brake\n SG_ Speed : 0|8@1+ (1,0) [0|255] "km/h" Body\n')
    Path("sigcat.toml").write_text('dbc = ["damaged.dbc"]\n')
    assert main(["lint", "overlay.vspec"]) == 1
    assert "damaged.dbc" in capsys.readouterr().out
    assert main(["lint", "overlay.vspec", "--dbc", "good.dbc"]) == 0, capsys.readouterr().out


def test_json_goes_to_a_file(capsys):
    Path("tree.vspec").write_text(ROOT + SIGNAL)
    assert main(["lint", "tree.vspec", "--format", "json", "-o", "report.json"]) == 1
    assert "V102" in json.dumps(json.loads(Path("report.json").read_text()))
    assert capsys.readouterr().out == ""


def test_fix_changes_the_wrong_bytes_and_no_others():
    tree = (
        ROOT
        + "# A comment that stays.\nVehicle.Speed:   {type: sensor,   datatype: float, description: how fast it is}\n"
    )
    Path("tree.vspec").write_text(tree)
    assert main(["lint", "tree.vspec", "--diff"]) == 1
    assert Path("tree.vspec").read_text() == tree
    assert main(["lint", "tree.vspec", "--fix"]) == 0
    assert Path("tree.vspec").read_text() == tree.replace("how fast it is", "How fast it is.")


def test_a_baseline_tells_new_findings_only():
    Path("tree.vspec").write_text(ROOT + SIGNAL)
    assert main(["lint", "tree.vspec", "--write-baseline", "known.json"]) == 0
    assert main(["lint", "tree.vspec", "--baseline", "known.json"]) == 0
    Path("tree.vspec").write_text(ROOT + SIGNAL + SIGNAL.replace("Doors", "Windows"))
    assert main(["lint", "tree.vspec", "--baseline", "known.json"]) == 1


def test_the_configuration_is_found_upwards(monkeypatch):
    Path("sigcat.toml").write_text('[lint.severity]\nV102 = "off"\n')
    Path("deep/er").mkdir(parents=True)
    Path("deep/er/tree.vspec").write_text(ROOT + SIGNAL)
    assert main(["lint", "deep/er/tree.vspec"]) == 0


def test_the_linter_loads_neither_web_nor_models_nor_vss_tools():
    Path("tree.vspec").write_text(ROOT + SIGNAL)
    program = (
        "import sys; from sigcat.cli import main; main(['lint', 'tree.vspec']);"
        "print([name for name in ('fastapi', 'pydantic', 'vss_tools', 'sqlite3', 'jinja2') if name in sys.modules])"
    )
    result = subprocess.run(
        [sys.executable, "-c", program],
        capture_output=True,
        text=True,
        check=True,
        env={"PYTHONPATH": str(PROJECT / "app")},
    )
    assert result.stdout.endswith("[]\n")


def test_a_rule_explains_itself(capsys):
    assert main(["rule", "v101"]) == 0
    output = capsys.readouterr().out
    assert output.startswith("# V101 ")
    assert "Good:" in output
    assert "Bad:" in output


def test_an_unknown_rule_is_answered_with_near_ones(capsys):
    assert main(["rule", "V1010"]) == 2
    assert "V101" in capsys.readouterr().err


@pytest.mark.parametrize("example", ["core_acc", "eco_control_mpc", "wheel_speed_calculation"])
def test_an_example_is_built_and_what_is_built_is_valid(example, capsys):
    declaration = PROJECT / "examples" / example / "function.yaml"
    assert main(["function", "build", str(declaration), "-o", "function.json"]) == 0
    assert main(["function", "build", str(declaration), "-o", "again.json"]) == 0
    assert Path("function.json").read_bytes() == Path("again.json").read_bytes()
    assert main(["function", "validate", "function.json"]) == 0
    assert capsys.readouterr().out == "No findings.\n"


def test_a_function_with_errors_is_not_built(capsys):
    text = (PROJECT / "examples" / "core_acc" / "function.yaml").read_text()
    Path("function.yaml").write_text(text.replace("Vehicle.Mass\n", "Vehicle.Mas\n"))
    assert main(["function", "build", "function.yaml", "-o", "function.json"]) == 1
    assert "Vehicle.Mass" in capsys.readouterr().err
    assert not Path("function.json").exists()


@pytest.mark.parametrize(
    ("arguments", "command"), [([], "  lint "), (["function"], "  validate"), (["generate"], "  arxml")]
)
def test_without_a_command_all_of_them_are_listed(arguments, command, capsys):
    assert main(arguments) == 2
    printed = capsys.readouterr()
    assert printed.out == ""
    assert command in printed.err


@pytest.mark.parametrize(
    ("arguments", "usage", "error"),
    [
        (["lnt"], "usage: sigcat ", "not 'lnt'. Did you mean 'lint'?"),
        (["lint", "--formt", "json"], "usage: sigcat lint ", "unknown option --formt. Did you mean '--format'?"),
        (["lint", "--formt=json"], "usage: sigcat lint ", "unknown option --formt. Did you mean '--format'?"),
        (
            ["export", "json", "--untis", "u"],
            "usage: sigcat export json ",
            "unknown option --untis. Did you mean '--units'?",
        ),
        (["search", "--format", "jsn", "x"], "usage: sigcat search ", "not 'jsn'. Did you mean 'json'?"),
        (["rule", "V101", "more"], "usage: sigcat rule ", "unexpected argument 'more'"),
    ],
)
def test_what_no_command_knows_is_refused_by_the_one_that_was_asked(arguments, usage, error, capsys):
    with pytest.raises(SystemExit) as ended:
        main(arguments)
    printed = capsys.readouterr()
    assert (ended.value.code, printed.out) == (2, "")
    assert printed.err.startswith(usage)
    assert printed.err.endswith(f"{error}\n")


def test_a_folder_is_no_function_file(folder, capsys):
    assert main(["function", "build", str(folder)]) == 2
    assert capsys.readouterr().err == f"sigcat: {folder} must be a file, not a folder\n"


def test_an_internal_error_is_one_line_and_with_a_variable_its_traceback(monkeypatch, capsys):
    monkeypatch.setattr("sigcat.rules.pages.rule_page", lambda _: 1 // 0)
    assert main(["rule", "V101"]) == 2
    assert "internal error: ZeroDivisionError" in capsys.readouterr().err
    monkeypatch.setenv("SIGCAT_DEBUG", "1")
    with pytest.raises(ZeroDivisionError):
        main(["rule", "V101"])
