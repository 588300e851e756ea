"""Section 15: messages that are not accepted."""

import pytest

from tests.adapter.model.driven import Driven
from tests.adapter.written import error, function, on_event, queue, signal, step

BROKEN = error("Broken")


def checked(**more):
    return Driven(function(step(signal("A", E2eError="Broken", **more), BROKEN))).start()


def sent(run, t):
    """Return the sent value of the error after a call at this time; None before its first verdict."""
    run.steps(t)
    return run.adapter.out["Broken"] if "Broken" in run.adapter.running.diagnosis.sent else None


def test_it_is_present_from_the_next_snapshot_until_a_message_passes():
    run = checked()
    run.adapter.reject("A", 0)
    assert (sent(run, 0), sent(run, 10)) == (1, 1)
    run.receive("A", 1.0, 15)
    assert sent(run, 20) == 0


def test_one_that_was_followed_by_a_good_one_is_present_in_one_snapshot():
    run = checked()
    run.adapter.reject("A", 0)
    run.receive("A", 1.0, 0)
    assert (sent(run, 0), sent(run, 10)) == (1, 0)


def test_before_the_first_message_it_is_not_tested():
    assert sent(checked(), 0) is None


def test_a_rejected_message_is_no_value():
    run = checked(InitValue=7)
    run.adapter.reject("A", 0)
    run.steps(0)
    assert run.seen[-1]["a"] == 7.0
    run.receive("A", 1.0, 5)
    run.adapter.reject("A", 6)
    run.steps(10)
    assert run.seen[-1]["a"] == 1.0


def test_the_time_out_goes_on():
    document = function(step(signal("A", E2eError="Broken", Timeout="15", TimeoutError="Late"), BROKEN, error("Late")))
    run = Driven(document).start()
    run.receive("A", 1.0, 0)
    run.adapter.reject("A", 9_000_000)
    run.steps(0, 10)
    assert run.adapter.out["Late"] == 0
    run.steps(20)
    assert run.adapter.out["Late"] == 1


def test_no_call_is_due_by_it_and_the_next_good_one_tells():
    run = Driven(function(on_event(queue("A", 2, E2eError="Broken"), BROKEN, name="Event"))).start()
    run.adapter.reject("A", 0)
    assert run.step(0) is None
    run.receive("A", 1.0, 1)
    assert sent(run, 1) == 1


@pytest.mark.parametrize("errors", [("Broken", "Other"), ("Other", "Broken")])
def test_each_call_decides_by_itself(errors):
    first, second = errors
    document = function(
        step(signal("A", VssPath="Vehicle.A", E2eError=first), error(first)),
        step(signal("A", VssPath="Vehicle.A", Variable="b", E2eError=second), error(second), name="Second", cycle=20),
    )
    run = Driven(document).start()
    run.receive("A", 1.0, 0)
    run.steps(0, 0)
    run.adapter.reject("A", 5_000_000)
    run.receive("A", 2.0, 6)
    run.steps(10)
    assert (run.adapter.out[first], run.adapter.out[second]) == (1, 0)
    run.steps(20, 20)
    assert (run.adapter.out[first], run.adapter.out[second]) == (0, 1)
