"""Output of `sigcat diff`: each folder of `cases/` has an old tree, a new tree, and the expected text."""

import json
from pathlib import Path

import pytest

from scripts.cases import CHANGES, sides
from tests.catalogue.comparing.running import sigcat

CASES = Path(__file__).parent / "cases"


@pytest.mark.parametrize("name", CHANGES.names)
def test_the_text_is_as_expected(name):
    assert CHANGES.made(name) == CHANGES.text(name), "If that is meant, run `make generate`."


@pytest.mark.parametrize("name", CHANGES.names)
def test_a_tree_does_not_differ_from_itself(name, monkeypatch, capsys):
    monkeypatch.chdir(CASES / name)
    assert sigcat("diff", "new.vspec", "new.vspec") == 0
    assert capsys.readouterr().out == "No differences.\n"


# The evidence of a move is only on one side.
@pytest.mark.parametrize("name", [name for name in CHANGES.names if "moved" not in name and "former" not in name])
def test_the_other_way_round_as_many_leaves_come_as_went(name, monkeypatch, capsys):
    monkeypatch.chdir(CASES / name)

    def leaves(*sides: str) -> dict[str, int]:
        assert sigcat("diff", *sides, "--format", "json") == 0
        counts: dict[str, int] = {"added": 0, "removed": 0}
        for change in json.loads(capsys.readouterr().out)["changes"]:
            if change["evidence"] == "same definition":
                continue
            counts[change["kind"]] = counts.get(change["kind"], 0) + change["signal_count"]
        return counts

    old, new = sides()
    there, back = leaves(old, new), leaves(new, old)
    assert (there["added"], there["removed"]) == (back["removed"], back["added"])
