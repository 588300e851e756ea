"""The whole vspec language, with exactly the meaning that vss-tools gives it.

Each folder of `cases/` has a tree, perhaps overlays and options of `vspec export json`, and the expected export.
The expectation is also compared with real vss-tools, so that it cannot differ from the reference.
"""

import contextlib
import json
from functools import cache
from pathlib import Path

import pytest

from scripts.cases import LANGUAGE, options
from tests.catalogue.vss_tools_output import Job, outputs
from tests.reference_tools import checked_with

CASES = Path(__file__).parent / "cases"


def job(name: str) -> Job:
    with contextlib.chdir(CASES / name):
        return Job("json", CASES / name, ["-s", "tree.vspec", *options()])


@cache
def expected_outputs() -> dict[str, str | None]:
    return outputs({name: job(name) for name in LANGUAGE.names})


@pytest.mark.parametrize("name", LANGUAGE.names)
def test_the_export_is_as_expected(name):
    assert LANGUAGE.made(name) == LANGUAGE.text(name), "If that is meant, run `make generate`."


@checked_with("vss-tools", "Every construct of the vspec language has the same meaning")
@pytest.mark.parametrize("name", LANGUAGE.names)
def test_vss_tools_gives_the_same(name):
    output = expected_outputs()[name]
    assert output is not None
    assert json.loads(output) == json.loads(LANGUAGE.text(name))
