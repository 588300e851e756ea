"""Fixes change the bytes that are wrong and no others."""

from pathlib import Path
from typing import Any

import pytest

from sigcat.rules.linting.fixes import fixed_files
from sigcat.rules.linting.lint import lint_paths
from sigcat.rules.report import sources_of
from tests.rules.linting.conftest import CABIN


def fixed(tree: Path, *, unsafe: bool = False) -> Any:
    result = lint_paths([tree / "vspec"])
    return fixed_files(result.findings, result.repairs, sources_of(result.findings), unsafe=unsafe)


def test_a_repair_changes_the_bytes_that_are_wrong_and_no_others(tree):
    cabin = CABIN.replace("description: noise in the cabin\n", "description:   noise in the\n     cabin   # so it is\n")
    (tree / "vspec" / "Cabin.vspec").write_text(cabin)
    (result,) = fixed(tree)
    assert result.after == cabin.replace("noise in the", "Noise in the").replace("cabin   #", "cabin.   #")
    assert len(result.settled) == 2
    assert "+  description:   Noise in the\n" in result.diff


@pytest.mark.parametrize(("before", "after"), [('"noise"', '"Noise."'), ("'noise'", "'Noise.'"), ("noise", "Noise.")])
def test_quoted_texts_stay_quoted(tree, before, after):
    (tree / "vspec" / "Cabin.vspec").write_text(CABIN.replace("noise in the cabin", before))
    assert [result.after for result in fixed(tree)] == [CABIN.replace("noise in the cabin", after)]


def test_what_changes_the_meaning_is_repaired_on_demand_only(tree):
    cabin = CABIN.replace("noise in the cabin\n", "Noise.\n  maxx: 5\n")
    (tree / "vspec" / "Cabin.vspec").write_text(cabin)
    assert fixed(tree) == ()
    assert [result.after for result in fixed(tree, unsafe=True)] == [cabin.replace("maxx", "max")]
