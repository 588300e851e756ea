"""Effect of each fault on a trace, row by row."""

from sigcat.comparison.faults.scenario import Slow, Spoilt
from sigcat.comparison.faults.spoiling import TextRow, TextTrace, spoil

TRACE = TextTrace(
    ("A", "B"), (TextRow(0, ("1", "x")), TextRow(10, ("2", "")), TextRow(20, ("3", "y")), TextRow(30, ("4", "")))
)


def rows(*faults: Spoilt, slow: tuple[Slow, ...] = ()) -> list[tuple[int, tuple[str, ...]]]:
    return [(row.time, row.cells) for row in spoil(TRACE, faults, slow).rows]


def test_without_a_fault_a_trace_is_what_it_was():
    assert spoil(TRACE, (), ()) == TRACE


def test_another_value_comes_from_one_time_on_and_before_another():
    assert rows(Spoilt("value", "A", 10, 30, "nan")) == [
        (0, ("1", "x")),
        (10, ("nan", "")),
        (20, ("nan", "y")),
        (30, ("4", "")),
    ]


def test_nothing_comes_where_nothing_came():
    assert rows(Spoilt("value", "B", 5, 15, "z")) == [(row.time, row.cells) for row in TRACE.rows]


def test_what_is_dropped_does_not_come_and_what_came_with_it_does():
    assert rows(Spoilt("dropped", "A", 10, 30)) == [(0, ("1", "x")), (20, ("", "y")), (30, ("4", ""))]


def test_what_is_delayed_comes_after_what_is_there_at_its_new_time():
    assert rows(Spoilt("delayed", "A", 10, 20, by=10)) == [
        (0, ("1", "x")),
        (20, ("3", "y")),
        (20, ("2", "")),
        (30, ("4", "")),
    ]


def test_what_is_doubled_comes_twice_at_its_time():
    assert rows(Spoilt("doubled", "A", 20, 30))[2:4] == [(20, ("3", "y")), (20, ("3", ""))]


def test_what_is_sent_comes_too():
    assert rows(Spoilt("sent", "B", 15, 15, "z"))[2] == (15, ("", "z"))


def test_faults_come_one_after_the_other():
    twice = (Spoilt("value", "A", 10, 20, "9"), Spoilt("doubled", "A", 10, 20))
    assert rows(*twice)[1:3] == [(10, ("9", "")), (10, ("9", ""))]


def test_a_slow_call_is_a_column_that_holds_until_it_ends():
    spoilt = spoil(TRACE, (), (Slow("F_Step", 5, 25, 70_000_000),))
    assert spoilt.columns == ("A", "B", "F_Step")
    assert [(row.time, row.cells[2]) for row in spoilt.rows if row.cells[2]] == [(5, "0.070000000"), (25, "0")]
