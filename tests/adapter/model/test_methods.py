"""Section 12: methods."""

import pytest

from tests.adapter.model.driven import MS, Driven
from tests.adapter.reference.parts.methods import Reply
from tests.adapter.written import U8, U16, call, enumeration, function, method, mode_interface, step

GEAR = enumeration("DT_Gear", PARK=0, DRIVE=5)
IDLE, PENDING, DONE, FAILED, TIMEOUT = range(5)


def offering(**code):
    item = method("Shift", "Provider", {"Gear": "DT_Gear"}, {"Result": U16}, Symbol="shift")
    document = function(
        step(item), datatypes=(GEAR,), active={"ON": ["Step"], "OFF": []}, modes=(mode_interface("In", "ON", "OFF"),)
    )
    return Driven(document, **code)


def test_an_offered_method_writes_its_arguments_calls_and_reads_the_results():
    run = offering(shift=lambda variables: variables.update(result=variables["gear"] * 2)).start()
    assert run.adapter.method("Shift", (5,)) == (Reply.OK, (10,))


def test_it_calls_nothing_with_a_bad_argument_excluded_or_before_init():
    run = offering()
    assert run.adapter.method("Shift", (5,))[0] is Reply.EXCLUDED
    run.start()
    assert run.adapter.method("Shift", (3,))[0] is Reply.BAD_ARGUMENT
    run.receive("F_Mode_In", 11, 0)
    run.step(0)
    assert run.adapter.method("Shift", (5,))[0] is Reply.EXCLUDED
    assert run.called == []


def using(**fields):
    known = {"RequestVariable": "ask", "StatusVariable": "status", **fields}
    document = function(
        step(method("Fetch", "Consumer", {"Key": U8}, {"Value": "DT_Gear"}, **known)), datatypes=(GEAR,)
    )
    return Driven(document, F_Step=None).start()


def asked(run, t, key=7):
    """The function asks in a call."""
    run._code["F_Step"] = lambda variables: variables.update(ask=1, key=key)
    run.steps(t)
    run._code["F_Step"] = None


def status(run, t):
    run.steps(t)
    return run.seen[-1]["status"]


def test_a_request_is_sent_with_its_arguments_and_its_variable_is_cleared():
    run = using()
    assert run.variables["status"] == IDLE
    asked(run, 0)
    slot = run.adapter.running.slots["Fetch"]
    assert (run.published(), slot.number, slot.arguments) == ({"Fetch"}, 1, (7,))
    assert run.variables["ask"] == 0
    assert status(run, 10) == PENDING


def test_an_answer_is_taken_with_the_next_snapshot_the_first_of_two():
    run = using()
    asked(run, 0)
    run.adapter.answer("Fetch", 1, (5,), 1 * MS)
    run.adapter.answer("Fetch", 1, (0,), 2 * MS)
    assert run.variables["value"] == 0
    assert status(run, 10) == DONE
    assert run.seen[-1]["value"] == 5
    assert status(run, 20) == DONE


@pytest.mark.parametrize(("is_ok", "value"), [(False, 5), (True, 3)], ids=["not ok", "a number without a name"])
def test_an_answer_that_has_failed_leaves_the_results(is_ok, value):
    run = using()
    asked(run, 0)
    run.adapter.answer("Fetch", 1, (value,), 1 * MS, is_ok=is_ok)
    assert status(run, 10) == FAILED
    assert run.variables["value"] == 0


def test_another_request_waits_until_the_first_is_answered():
    run = using()
    asked(run, 0)
    asked(run, 10, key=8)
    slot = run.adapter.running.slots["Fetch"]
    assert (run.variables["ask"], slot.number) == (1, 1)
    run.adapter.answer("Fetch", 1, (5,), 15 * MS)
    run.steps(20)
    assert (run.variables["ask"], slot.number, slot.arguments) == (0, 2, (8,))


def test_the_timeout_is_checked_in_the_snapshot_and_a_late_answer_is_dropped():
    run = using(Timeout="20")
    asked(run, 0)
    assert [status(run, 10), status(run, 20)] == [PENDING, PENDING]
    assert status(run, 30) == TIMEOUT
    run.adapter.answer("Fetch", 1, (5,), 31 * MS)
    assert status(run, 40) == TIMEOUT
    asked(run, 50)
    run.adapter.answer("Fetch", 1, (5,), 51 * MS)
    assert status(run, 60) == PENDING
    run.adapter.answer("Fetch", 2, (5,), 61 * MS)
    assert status(run, 100) == DONE


def test_methods_of_init_are_offered_from_a_good_init_to_terminate():
    run = Driven(function(call("Init", "Init"), step(method("Ping", "Provider")))).start()
    assert run.adapter.method("Ping")[0] is Reply.OK
    run.adapter.terminate(0)
    assert run.adapter.method("Ping")[0] is Reply.EXCLUDED
