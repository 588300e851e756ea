"""Outputs of one platform, compared with those of another one: in lock step every bit, in free run by time."""

import pytest

from sigcat.comparison.behaviour import Change, at_points, bits_of, changes, in_free_run, in_lock_step
from sigcat.comparison.report.model import Difference

MS = 1_000_000
SPEED = "Vehicle.Speed"


def sent(*values, name=SPEED, every=50 * MS):
    return {name: [(index * every, value) for index, value in enumerate(values)]}


def test_the_same_is_equal_and_counted():
    found = in_lock_step(sent("1.5", "2"), sent("1.5", "2"))
    assert found.is_equal
    assert found.values == 2


def test_nothing_that_was_sent_is_not_equal():
    assert not in_lock_step({}, {}).is_equal


@pytest.mark.parametrize(
    ("other", "first"),
    [
        (("1.5", "2.0000001"), Difference(time=50 * MS, kind="other", expected="2", found="2.0000001")),
        (("1.5",), Difference(time=50 * MS, kind="missing", expected="2", found="")),
        (("1.5", "2", "3"), Difference(time=100 * MS, kind="extra", expected="", found="3")),
    ],
)
def test_one_value_that_is_other_missing_or_too_much_is_told_with_its_time(other, first):
    (output,) = in_lock_step(sent("1.5", "2"), sent(*other)).outputs
    assert (output.wrong, output.first) == (1, first)


def test_a_value_in_another_step_is_missing_in_one_and_too_much_in_the_other():
    late = {SPEED: [(0, "1.5"), (60 * MS, "2")]}
    (output,) = in_lock_step(sent("1.5", "2"), late).outputs
    assert output.wrong == 2


def test_two_values_of_one_time_stay_in_their_order():
    both, turned = {SPEED: [(0, "1"), (0, "2")]}, {SPEED: [(0, "2"), (0, "1")]}
    assert in_lock_step(both, turned).wrong == 2


def test_a_name_that_only_one_sends_differs_unless_it_is_not_carried():
    extra = {**sent("1"), "A_SftyCondSts": [(0, "ACTIVE")]}
    assert in_lock_step(extra, sent("1")).wrong == 1
    assert in_lock_step(extra, sent("1"), ("A_SftyCondSts",)).is_equal


def test_the_first_value_of_a_field_may_be_there_earlier_and_no_other_one():
    status, name = {"A_ErrorSts": [(100, "PASSED"), (200, "FAILED")]}, ("A_ErrorSts",)
    earlier = {"A_ErrorSts": [(50, "PASSED"), (200, "FAILED")]}
    (output,) = in_lock_step(status, earlier, fields=name).outputs
    assert (output.wrong, output.early) == (0, 1)
    assert in_lock_step(status, earlier).wrong == 2
    for wrong in (
        [(150, "PASSED"), (200, "FAILED")],
        [(50, "FAILED"), (200, "FAILED")],
        [(50, "PASSED"), (150, "FAILED")],
        [(50, "PASSED")],
    ):
        assert in_lock_step(status, {"A_ErrorSts": wrong}, fields=name).wrong


@pytest.mark.parametrize("status", [[], [(0, "FAILED")], [(100, "FAILED"), (200, "PASSED")]])
def test_a_field_that_is_sent_before_its_first_verdict_has_the_same_verdicts(status):
    found = {"A_ErrorSts": [(0, "PASSED"), *status]}
    (output,) = in_lock_step({"A_ErrorSts": status}, found, fields=("A_ErrorSts",)).outputs
    assert (output.wrong, output.early) == (0, 1)
    assert in_lock_step({"A_ErrorSts": status}, found).wrong


@pytest.mark.parametrize(("one", "other"), [("1", "1.0"), ("1e3", "1000"), ("[1, 2.5]", "[1.0,2.5]"), ("nan", "NaN")])
def test_spellings_of_the_same_bits_are_equal(one, other):
    assert bits_of(one) == bits_of(other)


@pytest.mark.parametrize(
    ("one", "other"), [("0.0", "-0.0"), ("0.1", "0.10000000000000002"), ("true", "1"), ("ON", "OFF"), ("[1]", "1")]
)
def test_values_of_other_bits_are_not(one, other):
    assert bits_of(one) != bits_of(other)


def test_large_integers_are_not_rounded_before_they_are_held_against_each_other():
    assert bits_of("9007199254740993") != bits_of("9007199254740992")


# -- free run -----------------------------------------------------------------------------------------------------


def aligned(expected, found):
    (row,) = in_free_run(expected, {SPEED: found}, 50 * MS)
    return row


def test_values_that_come_a_little_late_are_equal_and_their_delay_is_told():
    row = aligned(sent("1", "2", "3"), [(2 * MS, "1"), (53 * MS, "2"), (101 * MS, "3")])
    assert (row.same, row.shifted, row.other, row.lost) == (3, 0, 0, 0)
    assert (row.p50_late, row.worst_late) == (2 * MS, 3 * MS)


def test_a_value_of_the_call_before_is_told_apart_from_one_that_never_was():
    row = aligned(sent("1", "2", "3"), [(0, "1"), (50 * MS, "1"), (100 * MS, "7")])
    assert (row.same, row.shifted, row.other) == (1, 1, 1)


def test_steps_that_did_not_come_are_counted():
    row = aligned(sent("1", "2", "3"), [(0, "1"), (100 * MS, "3")])
    assert (row.same, row.lost) == (2, 1)


# -- changes ------------------------------------------------------------------------------------------------------


def test_a_status_that_stays_is_no_change():
    error = {"A_ErrorSts": [(0, "PASSED"), (5, "PASSED"), (9, "FAILED")]}
    assert changes(error, ["A_ErrorSts"]) == (Change(0, "A_ErrorSts", "PASSED"), Change(9, "A_ErrorSts", "FAILED"))


# -- points of an importer ----------------------------------------------------------------------------------------

POINTS = [1 * MS, 50 * MS, 100 * MS, 150 * MS, 200 * MS]


def at(*values):
    return {SPEED: [(time * MS, value) for time, value in values]}


def test_a_value_is_seen_at_the_first_point_after_it_was_sent():
    sent_, seen = at_points(sent("1", "1", "2"), at((1, "1"), (150, "2")), POINTS)
    assert sent_ == seen == at((1, "1"), (150, "2"))
    assert in_lock_step(sent_, seen).values == 2


def test_an_output_has_its_start_value_until_the_reference_has_sent():
    found = at_points(at((60, "1")), at((1, "0"), (100, "1")), POINTS)
    assert found == (at((100, "1")), at((100, "1")))


@pytest.mark.parametrize(
    "seen", [at((1, "1"), (150, "3")), at((1, "1"), (200, "2")), at((1, "1")), at((1, "1"), (100, "2"))]
)
def test_a_value_that_is_other_or_at_another_point_differs(seen):
    assert in_lock_step(*at_points(sent("1", "1", "2"), seen, POINTS)).wrong


def test_an_output_that_is_never_seen_is_missing():
    assert in_lock_step(*at_points(sent("1"), {}, POINTS)).wrong == 1
