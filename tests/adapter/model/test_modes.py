"""Section 8: modes."""

import pytest

from tests.adapter.model.driven import Driven
from tests.adapter.reference.parts.errors import Stage
from tests.adapter.written import error, function, mode_interface, on_event, queue, signal, step, symbols, watchdog

OFF, ON, OTHER, UNKNOWN = 10, 11, 12, 99


def with_modes(*contents, active=None, modes=("OFF", "ON"), make=step, steps=(), call=None, **fields):
    """A function that runs in ON."""
    active = {"ON": ["Step"], "OFF": []} if active is None else active
    document = function(
        make(*contents, **(call or {})), *steps, active=active, modes=(mode_interface("In", *modes, **fields),)
    )
    return Driven(document).start()


def receive(run, mode, t):
    run.receive("F_Mode_In", mode, t)


def test_the_first_mode_is_the_initial_one_or_the_first_of_the_list():
    assert with_modes().step(0) is None
    assert with_modes(Initial="ON").step(0) == "F_Step"
    assert with_modes(modes=("ON", "OFF")).step(0) == "F_Step"


def test_without_modes_and_in_a_mode_that_is_not_described_all_run():
    assert Driven(function(step())).start().step(0) == "F_Step"
    assert with_modes(active={"ON": []}, modes=("OTHER", "ON")).step(0) == "F_Step"


def test_it_is_taken_when_the_call_is_asked_for_and_stays_for_it():
    run = with_modes(Initial="ON")
    name = run.due(0)
    receive(run, OFF, 0)
    run.make(name, 0)
    assert run.seen[-1]["mode_in"] == ON
    assert run.step(10) is None


def test_the_code_has_numbers_of_its_own():
    run = with_modes(Values=symbols(OFF=0, ON=1), Initial="ON")
    assert run.variables["mode_in"] == 1


@pytest.mark.parametrize(
    ("fields", "runs"), [({}, True), ({"UnknownAction": "Keep"}, True), ({"UnknownAction": "Initial"}, False)]
)
def test_an_unknown_mode_keeps_the_mode_or_leads_to_the_initial_one(fields, runs):
    run = with_modes(**fields)
    receive(run, ON, 0)
    run.steps(0)
    receive(run, UNKNOWN, 5)
    assert (run.step(10) is not None) is runs


def test_an_unknown_mode_is_an_error_until_a_known_one_is_taken():
    run = with_modes(error("E"), Initial="ON", UnknownError="E")
    run.steps(0)
    assert run.stage("E") is Stage.NOT_TESTED
    receive(run, UNKNOWN, 5)
    run.steps(10, 20)
    assert run.stage("E") is Stage.FAILED
    receive(run, ON, 25)
    run.steps(30)
    assert run.stage("E") is Stage.PASSED


def test_an_excluded_call_drops_what_is_due_and_keeps_its_grid():
    run = with_modes()
    for t in (0, 10, 25):
        assert run.step(t) is None
    assert run.adapter.running.calls["F_Step"].activations.dropped == 3
    receive(run, ON, 26)
    assert run.step(26) is None
    run.steps(30)
    assert run.adapter.running.calls["F_Step"].activations.missed == 0


def test_events_of_an_excluded_call_are_dropped_with_the_values_of_their_queues():
    run = with_modes(queue("A", 5), make=on_event)
    for value in (1, 2):
        run.receive("A", value, 0)
    assert run.step(0) is None
    assert run.adapter.running.calls["F_Step"].activations.dropped == 2
    receive(run, ON, 5)
    run.receive("A", 3, 6)
    run.steps(6)
    assert run.seen[-1]["a"] == 3


def test_time_outs_begin_anew_with_the_mode():
    run = with_modes(signal("A", Timeout="20", TimeoutError="E"), error("E"))
    for t in range(0, 100, 10):
        run.step(t)
    receive(run, ON, 100)
    run.steps(100, 120)
    assert run.stage("E") is Stage.NOT_TESTED
    run.steps(130)
    assert run.stage("E") is Stage.FAILED


def test_values_and_failed_errors_stay():
    run = with_modes(signal("A"), error("E", Variable="e"), Initial="ON")
    run.receive("A", 5.0, 0)
    run.variables["e"] = 1
    run.steps(0)
    receive(run, OFF, 5)
    assert run.step(10) is None
    receive(run, ON, 15)
    assert run.stage("E") is Stage.FAILED
    run.steps(20)
    assert run.seen[-1]["a"] == 5.0


def test_windows_of_an_excluded_call_are_dropped_and_begin_anew():
    fields = {"call": {"Watchdog": watchdog(alive=(2, 3, 3, "E"))}}
    run = with_modes(error("E"), **fields, Initial="ON")
    receive(run, OFF, 5)
    for t in (10, 20, 30, 40):
        run.step(t)
    receive(run, ON, 45)
    for t in (45, 50, 60, 70):
        run.step(t)
    assert run.stage("E") is Stage.NOT_TESTED
    run.step(80)
    assert run.stage("E") is Stage.PASSED


def test_mode_out_is_read_after_each_call_and_sent_on_change_if_it_has_a_name():
    run = Driven(function(step(), modes=(mode_interface("Out", "OFF", "ON", Values=symbols(OFF=0, ON=1)),))).start()
    found = []
    run.published()
    for t, value in enumerate((0, 1, 7, 1, 0)):
        run.variables["mode_out"] = value
        run.steps(t * 10)
        found.append((run.adapter.out["F_Mode_Out"], "F_Mode_Out" in run.published()))
    assert found == [(10, False), (11, True), (11, False), (11, False), (10, True)]
