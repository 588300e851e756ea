"""What docs/reference/linting.md shows works as it is shown."""

import re
import shlex
import shutil
import tomllib
from pathlib import Path

import pytest
import yaml

from sigcat.cli import main
from sigcat.rules.linting.configuration import read_configuration
from sigcat.rules.linting.selection import rules_for, selected
from sigcat.rules.record import parse_rules

PROJECT = Path(__file__).parents[2]
TEXT = (PROJECT / "docs" / "reference" / "linting.md").read_text(encoding="utf-8")
BLOCKS = [(m[1], m[2]) for m in re.finditer(r"^```(\w+)\n(.*?)^```$", TEXT, re.MULTILINE | re.DOTALL)]
COMMANDS = [line for kind, block in BLOCKS if kind == "sh" for line in block.splitlines()]


def block(kind: str, beginning: str) -> str:
    return next(text for name, text in BLOCKS if name == kind and text.startswith(beginning))


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    shutil.copytree(PROJECT / "vspec", "vspec")
    Path("overlays").mkdir()
    Path("overlays/seats.vspec").write_text("Vehicle.Speed:\n  comment: Of the vehicle.\n")
    return tmp_path


@pytest.mark.parametrize("command", COMMANDS)
def test_a_command_runs(folder, command, capsys):
    program, *arguments = shlex.split(command)
    assert program == "sigcat"
    if "--baseline" in arguments:
        assert main(["lint", "--write-baseline", "baseline.json", "vspec"]) == 0
    assert main(arguments) in (0, 1)
    assert "error" not in capsys.readouterr().err


def test_the_configuration_is_one(folder):
    Path("our-rules.yaml").write_text(block("yaml", "ACME001"))
    Path("generated").mkdir()
    Path("sigcat.toml").write_text(block("toml", "[lint]"))
    assert tomllib.loads(block("toml", "[lint]"))
    options = read_configuration(Path("sigcat.toml"))
    codes = {rule.id: rule for rule in selected(rules_for(options), options)}
    assert codes["ACME001"].options["pattern"] == "Acme[A-Za-z0-9]*"
    assert codes["V102"].severity == "error"
    assert main(["lint", "vspec"]) in (0, 1)


def test_the_rule_of_a_company_is_one():
    assert parse_rules(block("yaml", "ACME001").encode(), "our-rules.yaml", trusted=False).findings == ()


def test_the_suppression_suppresses(folder):
    text = block("yaml", "Vehicle.Cabin.noise")
    Path("overlays/seats.vspec").write_text(text)
    assert main(["lint", "overlays"]) == 0
    Path("overlays/seats.vspec").write_text(text.replace("  # sigcat: ignore[V101]", ""))
    assert main(["lint", "overlays"]) == 1


def test_hooks_and_pipelines_are_yaml_and_name_what_exists():
    hooks = {hook["id"] for hook in yaml.safe_load((PROJECT / ".pre-commit-hooks.yaml").read_text(encoding="utf-8"))}
    named = yaml.safe_load(block("yaml", "repos:"))["repos"][0]["hooks"]
    assert {hook["id"] for hook in named} == hooks
    steps = yaml.safe_load(block("yaml", "on:"))["jobs"]["lint"]["steps"]
    script = [
        *(step["run"] for step in steps if "run" in step),
        *yaml.safe_load(block("yaml", "lint:"))["lint"]["script"],
    ]
    for line in script:
        assert line.startswith(("sigcat lint --format ", "pip install sigcat"))
