"""Every command in a project works with its catalogue, its units and its functions, and finds the same, without an option."""

from pathlib import Path
from typing import Any

import pytest

from bench.editor import editor
from sigcat import cli
from sigcat.catalogue.hosting import library, source
from sigcat.cli import main
from sigcat.data import ROOT_FILE
from sigcat.errors import SigcatError
from tests.assistants.test_server import session
from tests.project.company import write_company

GAS = "Vehicle.Cabin.AcmeGas"
FINDING = "U006 Unit 'ppm' has the unknown field 'symbol', which is ignored."
COMMANDS = (
    ["lint"],
    ["show", GAS],
    ["search", "AcmeGas"],
    ["try", "overlays/acme.vspec"],
    ["export", "csv"],
    ["function", "build"],
    ["function", "overlay"],
    ["function", "validate"],
    ["function", "update", "--from-c", "functions"],
    ["function", "new", "Other", "--from-c", "functions"],
    ["integrate", "autosar-adaptive"],
    ["integrate", "autosar-classic"],
    ["integrate", "ros2"],
    ["generate", "core", "-o", "out"],
    ["simulate", "--trace", "trace.csv"],
    ["normalize", "--trace", "trace.csv"],
    ["compare", "--trace", "trace.csv"],
    ["gateway", "log.asc"],
    ["units"],
    ["serve"],
)
"""Every command that has one tree."""
OTHERS = {
    "diff": "several trees: below, and test_git_sides.py",
    "version-bump": "the same",
    "migrate": "the same: below, and tests/migration/test_project_files.py",
    "rule": "rules of the project, no tree: below",
    "config": "test_shown_project.py",
    "completion": "test_completion.py",
    "init": "writes a project: below",
    "lsp": "over standard input: below",
    "mcp": "the same",
    "schema": "no project",
    "pull": "no project",
    "releases": "no project",
    "vehicles": "vehicles of the project, no tree: tests/cli/test_vehicles.py",
    "publish": "tests/registry/test_commands.py",
    "check": "the same",
    "can-i-deploy": "the same; no tree",
    "users": "the same",
    "registry": "the same",
}
"""Tests of each other command, and the reason for the difference."""
READING = [
    command for command in COMMANDS if command[0] not in ("simulate", "normalize", "compare", "gateway", "serve")
]
READING = [command for command in READING if "--from-c" not in command]


class Loaded(SigcatError):
    """The source was asked for: the command has done enough."""


@pytest.fixture
def company(tmp_path, monkeypatch):
    monkeypatch.chdir(write_company(tmp_path))
    return tmp_path


@pytest.mark.parametrize("folder", [".", "functions/cabin_air"])
@pytest.mark.parametrize("command", COMMANDS, ids=" ".join)
def test_the_tree_is_that_of_the_project(company, monkeypatch, capsys, command, folder):
    loaded: list[source.Source] = []

    def load(wanted, *_arguments, **_options):
        loaded.append(wanted)
        raise Loaded

    monkeypatch.setattr(source, "load", load)
    monkeypatch.setattr(library, "load", load)
    arguments = [str(company / each) if (company / each).is_file() or each == "functions" else each for each in command]
    monkeypatch.chdir(company / folder)
    assert main(arguments) == 2
    first = loaded[0]
    assert (first.id, first.spec) == ("acme", ROOT_FILE)
    tried = command[0] == "try"  # an overlay of the project is tried over the tree without it
    assert [path.resolve() for path in first.overlays] == ([] if tried else [company / "overlays" / "acme.vspec"])
    assert [path.resolve() for path in first.units] == [company / "units.yaml"]


@pytest.mark.parametrize("command", READING, ids=" ".join)
def test_the_findings_are_the_same(company, capsys, command):
    status = main(command)
    output = capsys.readouterr()
    told = [line for line in (output.out + output.err).splitlines() if " U0" in line or " V0" in line]
    assert [line.partition("warning ")[2].partition(" Remove")[0] for line in told] == [FINDING]
    assert status == (1 if command == ["lint"] else 0)


def test_an_overlay_of_the_project_is_tried_over_the_tree_without_it(company, capsys):
    assert main(["try", "overlays/acme.vspec"]) == 0
    assert f"+ {GAS.rpartition('.')[2]}" in capsys.readouterr().out


@pytest.mark.parametrize("folder", ["functions/cabin_air", "empty"])
def test_a_lint_without_paths_checks_the_project_from_any_folder_of_it(company, monkeypatch, capsys, folder):
    (company / folder).mkdir(exist_ok=True)
    monkeypatch.chdir(company / folder)
    assert main(["lint"]) == 1
    assert FINDING in capsys.readouterr().out


def test_a_tree_that_cannot_be_read_is_one_finding_of_a_function(company, capsys):
    project = company / "sigcat.toml"
    project.write_text(project.read_text().replace('release = "shipped"', 'spec = "tree.vspec"'))
    (company / "tree.vspec").write_text("A: [\n")
    assert main(["lint", "functions"]) == 1
    out = capsys.readouterr().out
    assert "R001" in out
    assert "V022" not in out


def test_every_command_is_tested():
    assert sorted({command[0] for command in COMMANDS} | OTHERS.keys()) == sorted(cli.COMMANDS)
    parser: Any = cli.parser_of("function")
    (functions,) = (each for each in parser._subparsers._group_actions[0].choices["function"]._actions if each.choices)
    assert {command[1] for command in COMMANDS if command[0] == "function"} == set(functions.choices)


def test_an_editor_has_the_same_findings(company):
    pytest.importorskip("pygls")
    with editor(company) as client:
        found = client.open(company / "units.yaml")
        assert [f"{each['code']} {each['message'].partition(' Remove')[0]}" for each in found] == [FINDING]
        assert client.open(company / "overlays" / "acme.vspec") == []
        assert client.open(company / "functions" / "cabin_air" / "function.yaml") == []


@pytest.mark.parametrize("options", [("--isolated",), ("--config", "empty.toml")])
def test_an_editor_has_the_project_that_is_named(company, options):
    pytest.importorskip("pygls")
    Path("empty.toml").write_text("")
    with editor(company, *options) as client:
        found = client.open(company / "overlays" / "acme.vspec")
    assert any("ppm" in each["message"] for each in found)


def test_an_assistant_has_the_same_catalogue_and_rules(company):
    draft = (
        (company / "overlays" / "acme.vspec")
        .read_text()
        .replace("  owner: Air team\n", "")
        .replace("AcmeGas", "AcmeAir")
        .replace("Carbon", "Nitrogen")
    )
    _, (shown, linted) = session(company, ("show", {"path": GAS}), ("lint", {"text": draft, "name": "draft.vspec"}))
    assert shown.structured_content["attributes"]["unit"]["value"] == "ppm"
    assert [each["rule"] for each in linted.structured_content["findings"]] == ["ACME001"]


def test_a_rule_is_that_of_the_project(company, capsys):
    assert main(["rule", "ACME001"]) == 0
    assert main(["rule", "ACME001", "--isolated"]) == 2


def test_a_version_is_that_of_catalogues_of_the_project(company, capsys):
    assert main(["version-bump", "vss", "acme"]) == 0
    assert capsys.readouterr().out == "minor\n"


def test_a_project_file_for_what_is_there_gives_the_same_findings(company, capsys):
    Path("sigcat.toml").unlink()
    assert main(["init", "--from", "."]) == 0
    capsys.readouterr()
    main(["lint"])
    assert FINDING in capsys.readouterr().out
    assert main(["show", GAS]) == 0


def test_a_side_of_a_comparison_is_a_catalogue_of_the_project(company, capsys):
    assert main(["diff", "vss", "acme"]) == 0
    assert "+ AcmeGas" in capsys.readouterr().out


def test_a_side_of_a_migration_is_a_catalogue_of_the_project_and_so_are_its_files(company, capsys):
    assert main(["migrate", "acme", "acme", "--check"]) == 0
    assert main(["migrate", "acme", "vss", "--check"]) == 1
    assert f"{GAS} was removed" in capsys.readouterr().err


def test_options_come_before_the_project_and_no_project_before_it_is_found(company, capsys):
    assert main(["show", GAS, "-s", "vss"]) == 2
    assert main(["show", GAS, "-s", "acme"]) == 0
    assert main(["show", GAS, "--isolated"]) == 2
    Path("empty.toml").write_text("")
    assert main(["show", GAS, "--config", "empty.toml"]) == 2
    assert main(["show", GAS, "--isolated", "-l", "overlays/acme.vspec", "-u", "units.yaml"]) == 0


@pytest.mark.parametrize("platform", ["autosar-adaptive", "autosar-classic", "ros2"])
def test_the_deployment_is_that_of_the_project(company, capsys, platform):
    Path("deployment.yaml").write_text("unheard: 1\n")
    assert main(["integrate", platform]) == 1
    assert "deployment.yaml:1:1: error" in capsys.readouterr().err


def test_one_of_several_functions_has_to_be_named(company, capsys):
    text = Path("functions/cabin_air/function.yaml").read_text()
    other = company / "functions" / "other" / "function.yaml"
    other.parent.mkdir()
    other.write_text(text.replace("CabinAir", "Other"))
    assert main(["function", "build"]) == 2
    told = "name one of the functions of the project: functions/cabin_air/function.yaml, functions/other/function.yaml"
    assert told in capsys.readouterr().err
    assert main(["function", "build", str(other)]) == 0


def test_function_json_of_a_declared_function_is_not_a_second_one(company, capsys):
    assert main(["function", "build", "-o", "functions/cabin_air/CabinAir.json"]) == 0
    assert main(["function", "validate"]) == 0
    assert main(["function", "build"]) == 0


def test_a_command_without_functions_says_where_to_name_them(company, capsys):
    assert main(["function", "validate", "--isolated"]) == 2
    assert "name a function.yaml: there is no `functions` in a project file" in capsys.readouterr().err


def test_the_project_is_not_written_over(company, capsys):
    for file in ("sigcat.toml", "units.yaml", "functions/cabin_air/function.yaml", "overlays/acme.vspec"):
        before = Path(file).read_text()
        assert main(["function", "build", "-o", file]) == 2
        assert Path(file).read_text() == before
