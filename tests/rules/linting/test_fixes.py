"""Fixes change the bytes that are wrong and no others."""

from pathlib import Path
from typing import Any

import pytest
import yaml

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


@pytest.mark.parametrize(
    ("written", "form"),
    [
        ("v5.0 moved to Vehicle.Noise, for short", "V5.0 moved to Vehicle.Noise, for short"),
        ("'v5.0: moved to Vehicle.Noise'", "'V5.0 moved to Vehicle.Noise'"),
        ('"Version 5.0 - Was renamed to Vehicle.Noise"', '"V5.0 moved to Vehicle.Noise"'),
        ("V5.0 Moved To Vehicle.Noise", "V5.0 moved to Vehicle.Noise"),
        ("v5.0, has been removed,\n    since nobody heard it", "V5.0 removed,\n    since nobody heard it"),
        ("V5.0 deleted.", "V5.0 removed."),
        ("V5.0 use Vehicle.Noise", None),
        ("moved to Vehicle.Noise", None),
        ('"\\u00765.0 moved to Vehicle.Noise"', None),
    ],
)
def test_a_deprecation_gets_its_form_where_its_words_say_the_same(tree, written, form):
    cabin = CABIN.replace("noise in the cabin", f"Noise.\n  deprecation: {written}")
    (tree / "vspec" / "Cabin.vspec").write_text(cabin)
    assert [each.after for each in fixed(tree)] == ([] if form is None else [cabin.replace(written, form)])


def test_what_changes_the_meaning_is_repaired_on_demand_only(tree):
    cabin = CABIN.replace("noise in the cabin\n", "Noise.\n  maxx: 5\n")
    (tree / "vspec" / "Cabin.vspec").write_text(cabin)
    assert fixed(tree) == ()
    assert [result.after for result in fixed(tree, unsafe=True)] == [cabin.replace("maxx", "max")]


LONG = "Noise that is measured in the cabin by each of the microphones, (with the windows closed) and - when: told - again."


@pytest.mark.parametrize(
    ("value", "is_repaired"),
    [
        (LONG, True),
        (f"'{LONG}'", True),
        (f'"{LONG}"', True),
        (f">\n    {LONG}", True),
        (f">-\n    Noise.\n      {LONG} Further in.", False),
        (f"|\n    {LONG} Line by line.", False),
    ],
)
def test_a_long_line_is_broken_where_yaml_joins_it_again(tree, value, is_repaired):
    value = value.replace(LONG, LONG.replace("- when: told -", "- when told -") + " And once more, to be long enough.")
    cabin = CABIN.replace("noise in the cabin", value)
    (tree / "vspec" / "Cabin.vspec").write_text(cabin)
    after = next((result.after for result in fixed(tree)), cabin)
    assert yaml.safe_load(after) == yaml.safe_load(cabin)
    assert (max(map(len, after.splitlines())) <= 120) == is_repaired


def test_a_comment_and_a_line_of_braces_stay_long(tree):
    cabin = (
        CABIN.replace("noise in the cabin", "Noise.")
        + f"# {LONG} {LONG}\nCabin.A: {{type: branch, description: '{LONG}'}}\n"
    )
    (tree / "vspec" / "Cabin.vspec").write_text(cabin)
    assert fixed(tree) == ()
