"""One function of a project uses what other functions of the project define, also where it is named alone."""

import pytest

from sigcat.cli import main

ALPHA = """\
function: Alpha
description: A first function.
responsible: Demo team
components:
  - name: Alpha
    runnables:
      - interface: Step
        data:
          - {path: Vehicle.Demo.Out, role: provided, variable: out_value}
        errors:
          - {interface: Broken, variable: broken}
define:
  data:
    Vehicle.Demo: {type: branch, description: Signals of the test.}
    Vehicle.Demo.Out: {datatype: float, asil: QM, description: A signal of the test.}
  errors:
    Broken:
      description: It is broken.
      asil: QM
      resetCondition: It works again.
      maturationTime: 10
      resetTime: 10
      severity: Low
  scheduling:
    Step: {description: Works., asil: QM, cycleTime: 20, priority: 1}
"""
BETA = """\
function: Beta
description: A second function.
responsible: Demo team
components:
  - name: Beta
    runnables:
      - interface: Step
        data:
          - {path: Vehicle.Demo.Out, role: consumed, variable: in_value}
        safetyReactions:
          - {interface: NoOutput, variable: no_output, initial: INACTIVE}
define:
  safetyReactions:
    NoOutput: {description: The output is invalid., asil: QM, errorList: [Alpha_Broken_ErrorSts]}
  scheduling:
    Step: {description: Works., asil: QM, cycleTime: 20, priority: 1}
"""


@pytest.fixture
def beta(tmp_path, monkeypatch):
    for name, text in (("alpha", ALPHA), ("beta", BETA)):
        (tmp_path / "functions" / name).mkdir(parents=True)
        (tmp_path / "functions" / name / "function.yaml").write_text(text)
    (tmp_path / "sigcat.toml").write_text('functions = ["functions"]\n')
    monkeypatch.chdir(tmp_path)
    return "functions/beta/function.yaml"


@pytest.mark.parametrize(
    "command",
    [
        ["lint"],
        ["function", "validate"],
        ["function", "build"],
        ["generate", "core", "-o", "out"],
        ["integrate", "ros2"],
    ],
    ids=" ".join,
)
def test_one_function_uses_what_another_one_defines(command, beta, capsys):
    assert main([*command, beta]) == 0
    assert "error" not in capsys.readouterr().err


@pytest.mark.parametrize("folder", [".", "functions", "functions/alpha", "functions/beta"])
def test_a_folder_of_a_project_has_the_findings_that_the_project_has(folder, beta, capsys):
    assert main(["lint", folder]) == 0
    assert capsys.readouterr().out == "No findings.\n"


def test_a_signal_that_no_function_of_the_project_provides_is_reported(beta, tmp_path, capsys):
    alpha = tmp_path / "functions" / "alpha" / "function.yaml"
    alpha.write_text(ALPHA.replace("role: provided", "role: consumed"))
    assert main(["lint", "functions/beta"]) == 1
    out = capsys.readouterr().out
    assert "F103" in out
    assert "alpha" not in out


def test_a_function_that_needs_no_other_is_built_of_its_own_layers(beta, capsys):
    assert main(["function", "build", "functions/alpha/function.yaml"]) == 0
    assert "functions/beta" not in capsys.readouterr().out


def test_a_function_without_a_project_does_not_know_it(beta, tmp_path, capsys):
    (tmp_path / "sigcat.toml").unlink()
    assert main(["lint", beta]) == 1
    assert "I304" in capsys.readouterr().out


def test_a_signal_that_was_renamed_is_found_by_its_former_name(beta, tmp_path, capsys):
    (tmp_path / "own.vspec").write_text(
        "Vehicle.Demo: {type: branch, description: Signals of the test.}\n"
        "Vehicle.Demo.Result: {type: sensor, datatype: float, fka: [Vehicle.Demo.Out], description: A signal.}\n"
    )
    project = '[[catalogue]]\nid = "own"\nrelease = "shipped"\noverlays = ["own.vspec"]\n'
    (tmp_path / "sigcat.toml").write_text(project)
    assert main(["lint", beta]) == 1
    said = "It is 'Vehicle.Demo.Result' now, as the `fka` there says. `sigcat migrate` renames it in all files."
    assert said in capsys.readouterr().out


@pytest.mark.parametrize("here", [".", "deeper"])
def test_a_new_function_is_where_the_project_finds_it(tmp_path, monkeypatch, capsys, here):
    (tmp_path / "deeper").mkdir()
    (tmp_path / "functions").mkdir()
    (tmp_path / "sigcat.toml").write_text('functions = ["functions"]\n')
    monkeypatch.chdir(tmp_path / here)
    assert main(["function", "new", "Gamma"]) == 0
    assert (tmp_path / "functions/Gamma/Gamma.c").is_file()
    assert main(["simulate", "--duration", "0.1"]) == 0
    assert "Gamma_Init" in capsys.readouterr().out
