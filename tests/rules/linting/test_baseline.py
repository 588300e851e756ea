"""A baseline hides the findings that stood already."""

import pytest

from sigcat.errors import InputRefused
from sigcat.rules.linting.baseline import baseline_text
from sigcat.rules.linting.lint import lint_paths
from sigcat.rules.linting.options import LintOptions
from tests.rules.linting.conftest import CABIN


def test_a_baseline_hides_what_stands_already_wherever_it_moves(tree):
    baseline = tree / "baseline.json"
    baseline.write_text(baseline_text(lint_paths([tree / "vspec"]).findings, tree))
    (tree / "vspec" / "Cabin.vspec").write_text("\n\n\n" + CABIN + "cabin2: {type: branch, description: Two.}\n")
    result = lint_paths([tree / "vspec"], LintOptions(baseline=baseline, root=tree))
    assert [f.rule for f in result.findings] == ["V101"]


def test_an_entry_without_a_finding_is_stale(tree):
    baseline = tree / "baseline.json"
    baseline.write_text(baseline_text(lint_paths([tree / "vspec"]).findings, tree))
    (tree / "vspec" / "Cabin.vspec").write_text(CABIN.replace("noise in", "Noise in"))
    result = lint_paths([tree / "vspec"], LintOptions(baseline=baseline, root=tree))
    assert [(f.rule, f.path) for f in result.findings] == [("L003", "Vehicle.Cabin.Noise")]


@pytest.mark.parametrize("text", ["", "[]", "{}", '{"findings": 5}', '{"findings": [{"rule": 1}]}', "[" * 100_000])
def test_what_is_no_baseline_is_refused(tree, text):
    (tree / "baseline.json").write_text(text)
    with pytest.raises(InputRefused, match="baseline"):
        lint_paths([tree / "vspec"], LintOptions(baseline=tree / "baseline.json"))


def test_a_baseline_of_all_is_not_stale_where_a_part_is_linted(tree):
    baseline = tree / "baseline.json"
    overlay = tree / "overlays" / "own.vspec"
    overlay.parent.mkdir(exist_ok=True)
    overlay.write_text("Vehicle.own: {type: branch, description: Ours.}\n")
    baseline.write_text(baseline_text(lint_paths([tree]).findings, tree, [tree]))
    options = LintOptions(baseline=baseline, root=tree)
    assert lint_paths([tree / "vspec"], options).findings == lint_paths([tree], options).findings == ()
    overlay.write_text("Vehicle.Own: {type: branch, description: Ours.}\n")
    assert lint_paths([tree / "vspec"], options).findings == ()
    assert [f.rule for f in lint_paths([tree], options).findings] == ["L003"]
