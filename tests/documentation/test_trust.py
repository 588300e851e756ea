"""docs/explanation/trust.md says what judges of other projects said, and of nothing that no test asks them."""

import re
from pathlib import Path

import pytest

from scripts.trust import PAGE, page, verdicts_of
from tests.judges import JUDGES, judged_by

TESTS = Path(__file__).parents[1]
MARKED = {
    (judge, question)
    for file in TESTS.rglob("test_*.py")
    for judge, question in re.findall(r'^@judged_by\(\s*"([^"]+)",\s*"([^"]+)",?\s*\)', file.read_text(encoding="utf-8"), re.MULTILINE)
}  # fmt: skip


def test_the_page_has_what_tests_ask_and_nothing_else():
    rows = [line.split(" | ") for line in PAGE.read_text(encoding="utf-8").splitlines() if line.startswith("| ")][1:]
    assert {(row[0].removeprefix("| "), row[2]) for row in rows} == {
        (JUDGES[judge].name, question) for judge, question in MARKED
    }, "run `make trust`"


def test_every_judge_is_asked():
    assert {judge for judge, _ in MARKED} == JUDGES.keys()


def test_what_did_not_pass_is_on_the_page():
    verdict = {"judge": "axe", "question": "Pages are clean", "outcome": "passed", "count": 1200}
    text = page([verdict, {**verdict, "outcome": "failed", "count": 2}], "2026-01-02")
    assert "| Pages are clean | 1,200, 2 failed |" in text
    assert "Last run: 2026-01-02" in text
    assert "1,200 judgements" in text


def test_a_page_says_again_what_it_was_made_of():
    """So that some judges can be asked anew, and the others keep what they said."""
    text = PAGE.read_text(encoding="utf-8")
    (day,) = re.findall(r"Last run: ([0-9-]+)", text)
    assert page(verdicts_of(text), day) == text


def test_a_judge_that_is_not_in_the_table_is_refused():
    with pytest.raises(AssertionError, match="must be one of vss-tools, "):
        judged_by("somebody", "It works")
