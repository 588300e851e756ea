"""The severity of a finding in a tree: that of its record or of the project, the same in every command."""

import pytest

from sigcat.cli import main

TREE = "A: {type: branch, description: A.}\nA.B.C: {type: sensor, datatype: float, description: C.}\n"
PROJECT = '[[catalogue]]\nid = "a"\nspec = "tree.vspec"\n'
COMMANDS = (["lint"], ["show", "A.B.C"], ["search", "C"], ["export", "json"], ["export", "json", "--strict"], ["diff", "a", "a"])  # fmt: skip


@pytest.fixture(autouse=True)
def _folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "tree.vspec").write_text(TREE)
    (tmp_path / "sigcat.toml").write_text(PROJECT)


def run(command, capsys):
    status = main(command)
    said = capsys.readouterr()
    return status, said.out + said.err


@pytest.mark.parametrize("command", COMMANDS, ids=" ".join)
def test_an_undefined_branch_is_the_error_of_its_record(command, capsys):
    status, said = run(command, capsys)
    assert "error V020" in said
    assert status == (0 if command == ["export", "json"] else 1)


@pytest.mark.parametrize("command", COMMANDS, ids=" ".join)
@pytest.mark.parametrize("table", ['[lint.severity]\nV02 = "info"\n', '[lint.per-file."*.vspec"]\nV020 = "info"\n'])
def test_the_project_sets_its_severity_in_every_command(command, table, tmp_path, capsys):
    (tmp_path / "sigcat.toml").write_text(PROJECT + table)
    status, said = run(command, capsys)
    assert status == 0
    assert "error" not in said
    assert ("info V020" in said) != (command[0] == "diff")


@pytest.mark.parametrize("command", COMMANDS, ids=" ".join)
@pytest.mark.parametrize("table", ['[lint.severity]\nV020 = "off"\n', '[lint]\nignore = ["V0"]\n'])
def test_a_rule_that_is_off_is_off_in_every_command(command, table, tmp_path, capsys):
    (tmp_path / "sigcat.toml").write_text(PROJECT + table)
    status, said = run(command, capsys)
    assert (status, "V020" in said) == (0, False)


def test_an_error_that_leaves_no_tree_stays_one(tmp_path, capsys):
    (tmp_path / "sigcat.toml").write_text(PROJECT + '[lint.severity]\nR001 = "info"\n')
    (tmp_path / "tree.vspec").write_text("A: [\n")
    status, said = run(["show", "A"], capsys)
    assert status == 1
    assert "error R001" in said
