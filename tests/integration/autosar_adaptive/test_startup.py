"""A process has the scheduling of its most urgent call, unless the deployment says it."""

import pytest

from sigcat.integration.autosar_adaptive.startup import Wish, startup
from tests.integration.autosar_adaptive.sets import at, deployed, derive, function


def started(calls, run_types=(), **stated):
    """Policy and priority of a component with calls of these schedulings and priorities, and what is found."""
    one = function(signals=[at("Vehicle.A.B")])
    call = one.components[0].runnables[0]
    types = run_types or ["Cyclic"] * len(calls)
    made = tuple(
        call.model_copy(update={"name": f"Call{n}", "run_type": kind, "scheduling": scheduling, "priority": priority})
        for n, (kind, (scheduling, priority)) in enumerate(zip(types, calls, strict=True))
    )
    component = one.components[0].model_copy(update={"runnables": made})
    settings = {"components": {"Demo": {"startup": stated}}}
    derived = derive([one.model_copy(update={"components": (component,)})], deployed(autosarAdaptive=settings))
    chosen = derived.model.components[0].startup
    return (chosen.policy, chosen.priority), [f.path for f in derived.findings if f.rule == "A017"]


@pytest.mark.parametrize(
    ("calls", "expected"),
    [
        ([("Preemptive", "10")], ("SCHED_FIFO", 10)),
        ([("NonPreemptive", "10")], ("SCHED_FIFO", 10)),
        ([("FIFO", "12")], ("SCHED_FIFO", 12)),
        ([("RR", "12"), ("FIFO", "11")], ("SCHED_RR", 12)),
        ([("RR", "12"), ("Preemptive", "13")], ("SCHED_FIFO", 13)),
        ([("Preemptive", "9"), ("Preemptive", "10")], ("SCHED_FIFO", 10)),
        ([("Preemptive", None)], ("SCHED_OTHER", 0)),
        ([("Preemptive", " +7 ")], ("SCHED_FIFO", 7)),
    ],
)
def test_the_most_urgent_call_decides(calls, expected):
    assert started(calls) == (expected, [])


@pytest.mark.parametrize(
    ("priority", "written"),
    [
        ("100", ("SCHED_FIFO", 99)),
        ("high", ("SCHED_OTHER", 0)),
        ("0", ("SCHED_OTHER", 0)),
        ("-3", ("SCHED_OTHER", 0)),
        ("1.5", ("SCHED_OTHER", 0)),
    ],
)
def test_a_priority_that_no_process_has_is_told_unless_the_deployment_states_one(priority, written):
    assert started([("Preemptive", priority)]) == (written, ["Call0"])
    assert started([("Preemptive", priority)], priority=5) == (("SCHED_FIFO", 5), [])


@pytest.mark.parametrize(
    ("stated", "expected"),
    [
        ({"policy": "SCHED_OTHER"}, ("SCHED_OTHER", 0)),
        ({"policy": "SCHED_RR"}, ("SCHED_RR", 10)),
        ({"priority": 0}, ("SCHED_OTHER", 0)),
        ({"priority": 20}, ("SCHED_FIFO", 20)),
        ({"policy": "SCHED_FIFO", "priority": 3}, ("SCHED_FIFO", 3)),
    ],
)
def test_the_deployment_states_policy_priority_or_both(stated, expected):
    assert started([("Preemptive", "10")], **stated) == (expected, [])


def test_calls_that_run_once_do_not_decide_where_others_run_in_cycles():
    calls = [("Preemptive", "90"), ("Preemptive", "20"), ("Preemptive", "high")]
    assert started(calls, run_types=("Init", "Cyclic", "Shutdown")) == (("SCHED_FIFO", 20), [])
    assert started(calls[:1], run_types=("Init",)) == (("SCHED_FIFO", 90), [])


def test_a_policy_without_any_priority_has_its_lowest():
    stated = deployed(autosarAdaptive={"components": {"Demo": {"startup": {"policy": "SCHED_RR"}}}})
    chosen = startup(stated.autosar_adaptive.components["Demo"].startup, [Wish("Step", "Preemptive", None)])
    assert (chosen.policy, chosen.priority) == ("SCHED_RR", 1)
