"""Priorities of calls: every platform and check reads the same number."""

import pytest

from sigcat.function.function_json.runnable import priority_number


@pytest.mark.parametrize(("text", "number"), [("7", 7), (" +7 ", 7), ("-3", -3), ("0", 0)])
def test_a_whole_number_is_a_priority(text, number):
    assert priority_number(text) == number


@pytest.mark.parametrize("text", ["", "high", "1.5", "1e3", "--5", "+-5", "²", "٣", "7 8", "9" * 400])
def test_other_texts_are_not(text):
    assert priority_number(text) is None
