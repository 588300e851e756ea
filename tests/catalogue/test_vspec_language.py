"""The whole vspec language, with exactly the meaning that vss-tools gives it.

Each folder of `cases/` has a tree, perhaps overlays and options of `vspec export json`, and the expected export.
The expectation is held against real vss-tools as well, so that it cannot drift from the judge.
"""

import json
from functools import cache
from pathlib import Path

import pytest

from sigcat.cli import main
from tests.catalogue.judging import Job, verdicts

CASES = Path(__file__).parent / "cases"
NAMES = sorted(folder.name for folder in CASES.iterdir())


def arguments(name: str) -> list[str]:
    options = CASES / name / "options"
    return ["-s", "tree.vspec", *(options.read_text().split() if options.exists() else [])]


@cache
def judged() -> dict[str, str | None]:
    return verdicts({name: Job("json", CASES / name, arguments(name)) for name in NAMES})


@pytest.mark.parametrize("name", NAMES)
def test_the_export_is_as_expected(name, monkeypatch, capsys):
    monkeypatch.chdir(CASES / name)
    assert main(["export", "json", *arguments(name)]) == 0
    assert json.loads(capsys.readouterr().out) == json.loads(Path("expected.json").read_text())


@pytest.mark.xdist_group("judge of the language")
@pytest.mark.parametrize("name", NAMES)
def test_vss_tools_gives_the_same(name):
    verdict = judged()[name]
    assert verdict is not None
    assert json.loads(verdict) == json.loads((CASES / name / "expected.json").read_text())
