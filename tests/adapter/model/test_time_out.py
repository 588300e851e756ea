"""Section 3: time-outs."""

import pytest

from tests.adapter.model.driven import Driven
from tests.adapter.reference.parts.errors import Stage
from tests.adapter.written import Json, error, function, queue, reaction, signal, step

LATE = error("Late")


def late(**fields):
    """A function with an input that may be 20 ms old."""
    known = {"Timeout": "20", "TimeoutError": "Late", "InitValue": 1, "Default": 2}
    return Driven(function(step(signal("A", **{**known, **fields}), LATE))).start()


def test_a_value_as_old_as_the_time_out_is_in_time_and_one_nanosecond_more_is_late():
    run = late()
    run.receive("A", 5.0, 0)
    run.steps(20)
    assert run.adapter.out["Late"] == 0
    run.steps(30.000001)
    run = late()
    run.receive("A", 5.0, 0)
    run.steps(20.000001)
    assert run.adapter.out["Late"] == 1


def test_never_received_counts_from_start_and_is_not_tested_before_it_expires():
    run = late()
    run.steps(0, 20)
    assert run.stage("Late") is Stage.NOT_TESTED
    run.steps(30)
    assert run.stage("Late") is Stage.FAILED


def test_with_first_there_is_no_age_before_the_first_value():
    run = late(TimeoutStart="First")
    run.steps(0, 1000)
    assert run.stage("Late") is Stage.NOT_TESTED
    run.receive("A", 5.0, 1000)
    run.steps(1010, 1030)
    assert run.stage("Late") is Stage.FAILED


@pytest.mark.parametrize(
    ("value", "meanwhile"),
    [({}, 7.0), ({"TimeoutValue": "Last"}, 7.0), ({"TimeoutValue": "Default"}, 2.0), ({"TimeoutValue": "Init"}, 1.0)],
    ids=["nothing", "last", "default", "init"],
)
def test_the_value_meanwhile_with(value, meanwhile):
    run = late(**value)
    run.receive("A", 7.0, 0)
    run.steps(0, 21)
    assert [each["a"] for each in run.seen] == [7.0, meanwhile]
    run.receive("A", 8.0, 22)
    run.steps(30)
    assert run.seen[-1]["a"] == 8.0


def test_the_value_does_not_wait_for_the_error_to_mature():
    document = function(step(signal("A", Timeout="20", TimeoutError="Late", TimeoutValue="Default", Default=2),
                             error("Late", MaturationTime=100)))  # fmt: skip
    run = Driven(document).start()
    run.receive("A", 7.0, 0)
    run.steps(21)
    assert run.seen[-1]["a"] == 2.0
    assert run.stage("Late") is Stage.PREFAILED


def test_recovery_takes_so_many_values_and_starts_anew_when_it_is_late_again():
    run = late(TimeoutValue="Default", TimeoutRecovery=3)
    run.steps(21)
    run.receive("A", 7.0, 22)
    run.receive("A", 7.5, 23)
    run.steps(30)
    assert run.seen[-1]["a"] == 2.0
    run.steps(50)
    run.receive("A", 8.0, 51)
    run.receive("A", 8.5, 52)
    run.steps(60)
    assert run.seen[-1]["a"] == 2.0
    run.receive("A", 9.0, 61)
    run.steps(70)
    assert (run.seen[-1]["a"], run.stage("Late")) == (9.0, Stage.PASSED)


def test_a_value_that_is_out_of_range_counts():
    run = late(Min=0, Max=1, RangeErrorAction="Default")
    run.receive("A", 99.0, 15)
    run.steps(30)
    assert run.stage("Late") is Stage.PASSED


def test_a_value_between_the_snapshot_and_the_call_is_one_for_the_next_snapshot():
    run = late(TimeoutValue="Default")
    name = run.due(21)
    run.adapter.set_input(name, 21 * 10**6)
    run.receive("A", 7.0, 21)
    run.adapter.begin(name, 22 * 10**6)
    run.adapter.run(name)
    run.adapter.get_output(name, 22 * 10**6)
    assert run.seen[-1]["a"] == 2.0
    run.steps(30)
    assert run.seen[-1]["a"] == 7.0


def test_a_queue_that_is_late_hides_its_values_and_counts_none():
    fields: Json = {
        "Timeout": "20",
        "TimeoutValue": "Default",
        "Default": 9,
        "TimeoutRecovery": 2,
        "CountVariable": "n",
    }
    run = Driven(function(step(queue("A", 5, **fields)))).start()
    run.steps(21)
    run.receive("A", 1, 22)
    run.steps(30)
    assert (run.seen[-1]["a"], run.seen[-1]["n"]) == (9, 0)
    run.receive("A", 2, 31)
    run.steps(40)
    assert (run.seen[-1]["a"], run.seen[-1]["n"]) == (2, 1)


@pytest.mark.parametrize("t", [2**32 * 1000 + 5, 2**53 + 1, 2**63 + 3])
def test_times_do_not_wrap(t):
    run = Driven(function(step(signal("A", Timeout="20", TimeoutError="Late"), LATE)))
    run.adapter.init()
    run.adapter.start(t)
    run.adapter.receive("A", 1.0, t)
    for after, is_late in ((20 * 10**6, 0), (20 * 10**6 + 1, 1)):
        name = run.adapter.next_call(t + after) or "F_Step"
        run.adapter.set_input(name, t + after)
        assert run.adapter.out["Late"] == is_late


def test_a_time_before_the_last_one_counts_as_the_last_one():
    run = late()
    run.receive("A", 5.0, 10)
    run.receive("A", 6.0, 9.999999)
    run.steps(30)
    assert run.adapter.out["Late"] == 0


def test_an_outside_source_of_a_reaction_that_is_silent_makes_it_active_until_it_speaks():
    run = Driven(function(step(reaction("Stop", Timeout="20")))).start()
    run.steps(0, 20, 30)
    assert [each["stop"] for each in run.seen] == [0, 0, 1]
    run.receive("Stop", 0, 31)
    run.steps(40)
    assert run.seen[-1]["stop"] == 0
