"""Distributions of durations, lines of files, and what one process takes more than another."""

import pytest

from sigcat.comparison.effort import count_lines
from sigcat.comparison.load import Load, overhead
from sigcat.comparison.report.words import duration, memory, percent, seconds
from sigcat.comparison.timing import BINS_PER_DECADE, distribution


def test_a_distribution_has_median_99th_percentile_and_worst_by_nearest_rank():
    found = distribution(range(1000, 1100))
    assert found is not None
    assert (found.total, found.least, found.p50, found.p99, found.worst) == (100, 1000, 1049, 1098, 1099)


def test_every_duration_is_in_the_bin_that_its_logarithm_says():
    found = distribution([100, 100, 1000, 99_999])
    assert found is not None
    assert sum(found.bins) == 4
    assert found.first_bin == 2 * BINS_PER_DECADE
    assert (found.bins[0], found.bins[BINS_PER_DECADE], found.bins[-1]) == (2, 1, 1)


def test_of_no_durations_there_is_no_distribution():
    assert distribution([]) is None


@pytest.mark.parametrize(
    ("name", "text", "code"),
    [
        ("a.c", "/* one\n two */\nint a; // b\n\n// c\nint b;\n", 2),
        ("a.hpp", "int a; /* b */\n/* c */ int d;\n", 2),
        ("a.py", "# no\n\na = 1  # yes\n", 1),
        ("function.yaml", "# EcoControl\nname: A\n\n", 1),
        ("a.xml", "<a>\n<!-- <b/>\n<c/> -->\n</a>\n", 2),
        ("a.arxml", "<AUTOSAR>\n</AUTOSAR>\n", 2),
        ("README", "# text\n", 1),
    ],
)
def test_lines_of_code_have_something_left_without_comments_and_blanks(name, text, code):
    counted = count_lines([(name, text)])
    assert (counted.files, counted.code, counted.total) == (1, code, len(text.splitlines()))


def test_overhead_is_told_as_a_share_of_what_was_written_by_hand():
    more = overhead(Load("a", 1.05, 60, 42, 0), Load("b", 1.0, 60, 40, 0))
    assert more.cpu == pytest.approx(0.05)
    assert more.memory == pytest.approx(0.05)


def test_the_share_of_a_core_is_that_of_a_drive_in_real_time():
    assert Load("a", 3.0, 60.0, 0, 0).share == 0.05


@pytest.mark.parametrize(
    ("nanoseconds", "text"),
    [
        (12, "12 ns"),
        (999.6, "1 µs"),
        (1234, "1.23 µs"),
        (300_000, "300 µs"),
        (2_500_000, "2.5 ms"),
        (-1500, "−1.5 µs"),
        (3e9, "3 s"),
    ],
)
def test_durations_have_three_digits_and_the_unit_that_fits(nanoseconds, text):
    assert duration(nanoseconds) == text


def test_other_figures_are_read_by_people_too():
    assert (memory(41_000_000), memory(12_000)) == ("41.0 MB", "12 kB")
    assert (percent(0.05), percent(0.154), percent(0.0123)) == ("5 %", "15 %", "1.2 %")
    assert (seconds(1_500_000_000), seconds(0)) == ("1.5 s", "0 s")
