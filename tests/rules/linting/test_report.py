"""Contents of a report of a lint."""

import json
from typing import Any

import pytest

from sigcat.data import INTERFACE_RULES
from sigcat.errors import UsageError
from sigcat.rules.linting.counted import counted
from sigcat.rules.linting.lint import lint_paths
from sigcat.rules.linting.options import LintOptions
from sigcat.rules.record import load_rules
from sigcat.rules.report import report, sources_of
from tests.rules.linting.conftest import CABIN


def test_the_text_report_shows_the_line_with_a_caret_and_ends_with_a_count(tree):
    result = lint_paths([tree / "vspec"], LintOptions(select=("V105",)))
    lines = report(result.findings, "text", sources_of(result.findings)).splitlines()
    assert lines[0].endswith("Cabin.vspec:8:16: warning V105 The description must start with a capital letter. Capitalize "
                             "its first letter.")  # fmt: skip
    assert lines[1:] == [
        "    8 |   description: noise in the cabin",
        "                       ^^^^^",
        "Found 1 warning in 1 file.",
    ]


def test_control_characters_of_a_file_do_not_reach_the_terminal(tmp_path):
    path = tmp_path / "x.vspec"
    path.write_text('"Vehicle.\\x1b[2J": {max: 1}\n', encoding="utf-8")
    result = lint_paths([path])
    assert "\x1b" not in report(result.findings, "text", sources_of(result.findings))


def test_fingerprints_do_not_depend_on_lines(tree):
    def fingerprints() -> Any:
        findings = lint_paths([tree / "vspec"]).findings
        sarif = json.loads(report(findings, "sarif", rules=load_rules(INTERFACE_RULES)))
        return [result["partialFingerprints"] for result in sarif["runs"][0]["results"]]

    before = fingerprints()
    (tree / "vspec" / "Cabin.vspec").write_text("\n\n" + CABIN)
    assert fingerprints() == before


def test_a_format_that_does_not_exist_is_refused():
    with pytest.raises(UsageError, match="junit"):
        report((), "junti")


def test_an_attribute_that_a_file_writes_everywhere_is_one_finding_with_a_count(tmp_path):
    node = "Vehicle.A{}: {{type: sensor, datatype: uint8, description: Number {}., acme: 1}}\n"
    path = tmp_path / "own.vspec"
    path.write_text("".join(node.format(n, n) for n in range(40)))
    result = lint_paths([path])
    (finding,) = counted(result.findings, result.counted)
    assert (finding.line, finding.message) == (1, "Unknown attribute `acme`, 40 times in this file.")
    assert len(result.findings) == 40, "a suppression, a baseline and a repair are about each place"
