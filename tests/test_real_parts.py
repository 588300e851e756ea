"""Tests that `make test` omits run in `make real`; each kind of them is represented."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

from tests import real_parts
from tests.real_parts import KINDS, REAL, TIMES, USUAL, Kind

ROOT = Path(__file__).parents[1]
PARTLY_REAL = ("tests/catalogue/hosting", "tests/rules/test_codes.py")
"""A folder with tests of both, and a file without a real part."""


def collected(*options: str) -> set[str]:
    """The tests that pytest would run of these places."""
    command = [sys.executable, "-m", "pytest", "--collect-only", "-p", "no:cacheprovider", *options, *PARTLY_REAL]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True)
    return set(re.findall(r"^tests/.*::.*$", done.stdout, re.MULTILINE))


def test_every_test_is_of_one_of_both_runs():
    usual, real = collected("-m", USUAL), collected("-m", REAL)
    assert usual
    assert real
    assert not usual & real
    assert usual | real == collected()


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: kind.title)
def test_a_kind_has_tests_that_stand_for_it(kind: Kind):
    assert all((ROOT / place.partition("::")[0]).exists() for place in kind.places)
    assert kind.representatives or kind.title == TIMES
    assert all(real_parts.is_at(each, kind.places) for each in kind.representatives)


def test_the_targets_ask_for_both():
    targets = (ROOT / "Makefile").read_text(encoding="utf-8")
    assert f'-m "{USUAL}"\n' in targets
    assert f"-m {REAL}\n" in targets
    assert "make test\nmake package\nmake real\n" in (ROOT / ".ci" / "run").read_text(encoding="utf-8")


def test_the_line_at_the_end_says_what_was_left_out():
    assert real_parts.left_out(USUAL).startswith(f"left out: {TIMES}, nodes in real ROS 2, ")
    assert real_parts.left_out(USUAL).endswith("; `make real` runs these")
    assert not real_parts.left_out(REAL)
    assert not real_parts.left_out("")
