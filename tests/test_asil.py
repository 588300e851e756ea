"""The scale of ASIL: its order, and the spellings that are read."""

import pytest

from sigcat.asil import LEVELS, is_above, level_of, rank


@pytest.mark.parametrize(
    ("text", "level"),
    [
        ("QM", "QM"), ("qm", "QM"), ("B", "B"), ("b", "B"), ("ASIL D", "D"), ("asil-c", "C"), ("ASIL_A", "A"),
        ("ASIL QM", "QM"), ("B(D)", "B"), ("ASIL B(D)", "B"), ("QM(D)", "QM"), ("C(C)", "C"),
    ],
)  # fmt: skip
def test_a_level_is_read_in_its_usual_spellings(text, level):
    assert level_of(text) == level


@pytest.mark.parametrize(
    "text", ["Dangerous", "A or B", "ASIL", "E", "Qm", "D(B)", "B(D", "AB", " B", "B (D)", "", None, 1, ["A"]]
)
def test_everything_else_is_refused(text):
    assert level_of(text) is None


def test_levels_are_ordered():
    assert [rank(level) for level in LEVELS] == [0, 1, 2, 3, 4]
    assert is_above("D", "C")
    assert not is_above("B", "B")


def test_a_level_that_is_not_stated_is_not_compared():
    assert not is_above(None, "QM")
    assert not is_above("D", None)
