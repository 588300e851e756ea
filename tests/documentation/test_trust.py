"""docs/explanation/trust.md has the results of the reference tools, and only requirements that tests check."""

import re
from pathlib import Path

import pytest

from scripts.trust import PAGE, page, results_of
from tests.reference_tools import REFERENCE_TOOLS, checked_with

TESTS = Path(__file__).parents[1]
MARKED = {
    (tool, requirement)
    for file in TESTS.rglob("test_*.py")
    for tool, requirement in re.findall(r'^@checked_with\(\s*"([^"]+)",\s*"([^"]+)",?\s*\)', file.read_text(encoding="utf-8"), re.MULTILINE)
}  # fmt: skip


def test_the_page_has_the_requirements_of_tests_and_nothing_else():
    rows = [line.split(" | ") for line in PAGE.read_text(encoding="utf-8").splitlines() if line.startswith("| ")][1:]
    assert {(row[0].removeprefix("| "), row[2]) for row in rows} == {
        (REFERENCE_TOOLS[tool].name, requirement) for tool, requirement in MARKED
    }, "run `make trust`"


def test_every_tool_is_used():
    assert {tool for tool, _ in MARKED} == REFERENCE_TOOLS.keys()


def test_failures_are_on_the_page():
    result = {"tool": "axe", "requirement": "Pages are clean", "outcome": "passed", "count": 1200}
    text = page([result, {**result, "outcome": "failed", "count": 2}], "2026-01-02")
    assert "| Pages are clean | 1,200, 2 failed |" in text
    assert "Last run: 2026-01-02" in text
    assert "1,200 checks passed" in text


def test_a_page_is_read_back():
    """So that some tools can run again, and the results of the others stay."""
    text = PAGE.read_text(encoding="utf-8")
    (day,) = re.findall(r"Last run: ([0-9-]+)", text)
    assert page(results_of(text), day) == text


def test_a_tool_that_is_not_in_the_table_is_refused():
    with pytest.raises(AssertionError, match="must be one of vss-tools, "):
        checked_with("another tool", "It works")
