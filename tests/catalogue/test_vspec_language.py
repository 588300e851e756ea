"""The whole vspec language, with exactly the meaning that vss-tools gives it.

Each folder of `cases/` has a tree, perhaps overlays and options of `vspec export json`, and the expected export.
The expectation is held against real vss-tools as well, so that it cannot drift from the judge.
"""

import contextlib
import json
from functools import cache
from pathlib import Path

import pytest

from scripts.cases import LANGUAGE, options
from tests.catalogue.judging import Job, verdicts
from tests.judges import judged_by

CASES = Path(__file__).parent / "cases"


def job(name: str) -> Job:
    with contextlib.chdir(CASES / name):
        return Job("json", CASES / name, ["-s", "tree.vspec", *options()])


@cache
def judged() -> dict[str, str | None]:
    return verdicts({name: job(name) for name in LANGUAGE.names})


@pytest.mark.parametrize("name", LANGUAGE.names)
def test_the_export_is_as_expected(name):
    assert LANGUAGE.made(name) == LANGUAGE.text(name), "If that is meant, run `make generate`."


@judged_by("vss-tools", "Every construct of the vspec language means the same")
@pytest.mark.parametrize("name", LANGUAGE.names)
def test_vss_tools_gives_the_same(name):
    verdict = judged()[name]
    assert verdict is not None
    assert json.loads(verdict) == json.loads(LANGUAGE.text(name))
