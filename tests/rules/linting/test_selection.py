"""Selection of rules, and their severity."""

from typing import Any

import pytest

from sigcat.errors import UsageError
from sigcat.rules.linting.lint import lint_paths
from sigcat.rules.linting.options import LintOptions, PerFile


def test_select_replaces_the_default_set_and_extend_select_adds_to_it(tree):
    def codes(**options: Any) -> set[str]:
        return {f.rule for f in lint_paths([tree / "vspec"], LintOptions(**options)).findings}

    assert codes(select=("V106",)) == {"V106"}
    assert codes(ignore=("V105",)) == {"V106"}
    assert codes(extend_select=("I104",)) == {"V105", "V106", "I104"}
    assert codes(severities={"V1": "off"}) == set()


def test_an_unknown_code_is_refused_with_the_nearest_one(tree):
    with pytest.raises(UsageError, match="X999"):
        lint_paths([tree], LintOptions(select=("X999",)))


def test_a_severity_may_hold_for_a_folder_only(tree):
    entry = PerFile("vspec/**", {"V105": "error", "V106": "off"})
    result = lint_paths([tree / "vspec"], LintOptions(per_file=(entry,), root=tree))
    assert [(f.rule, f.severity) for f in result.findings] == [("V105", "error")]


def test_notes_do_not_fail_a_lint(tree):
    severities = {"V105": "info", "V106": "info"}
    assert not lint_paths([tree / "vspec"], LintOptions(severities=severities)).fails
    assert lint_paths([tree / "vspec"]).fails
