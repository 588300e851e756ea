"""What `sigcat diff` tells: each folder of `cases/` has an old tree, a new tree, and the expected text."""

import json
from pathlib import Path

import pytest

from tests.catalogue.comparing.running import sigcat

CASES = Path(__file__).parent / "cases"
NAMES = sorted(folder.name for folder in CASES.iterdir())


def arguments() -> list[str]:
    new = "new.vspec+overlay.vspec" if Path("overlay.vspec").exists() else "new.vspec"
    return ["diff", "old.vspec", new]


@pytest.mark.parametrize("name", NAMES)
def test_the_text_is_as_expected(name, monkeypatch, capsys):
    monkeypatch.chdir(CASES / name)
    assert sigcat(*arguments()) == 0
    assert capsys.readouterr().out == Path("expected.txt").read_text()


@pytest.mark.parametrize("name", NAMES)
def test_a_tree_does_not_differ_from_itself(name, monkeypatch, capsys):
    monkeypatch.chdir(CASES / name)
    assert sigcat("diff", "new.vspec", "new.vspec") == 0
    assert capsys.readouterr().out == "No differences.\n"


@pytest.mark.parametrize("name", NAMES)
def test_the_other_way_round_as_many_leaves_come_as_went(name, monkeypatch, capsys):
    monkeypatch.chdir(CASES / name)

    def leaves(*sides: str) -> dict[str, int]:
        assert sigcat("diff", *sides, "--format", "json") == 0
        counts: dict[str, int] = {"added": 0, "removed": 0}
        for change in json.loads(capsys.readouterr().out)["changes"]:
            if change["evidence"] == "same definition":
                continue
            counts[change["kind"]] = counts.get(change["kind"], 0) + change["leaves"]
        return counts

    if "moved" in name or "former" in name:
        pytest.skip("what says that a node moved stands on one side only")
    _, old, new = arguments()
    there, back = leaves(old, new), leaves(new, old)
    assert (there["added"], there["removed"]) == (back["removed"], back["added"])
