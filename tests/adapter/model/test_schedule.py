"""Section 9: schedule."""

import pytest

from tests.adapter.model.driven import MS, Driven
from tests.adapter.reference.parts.errors import Stage
from tests.adapter.reference.parts.schedule import NEVER
from tests.adapter.written import error, function, on_event, queue, signal, step


def counts(run, call="F_Step"):
    return run.adapter.running.calls[call].activations


def test_a_call_is_due_at_its_offset_and_every_cycle():
    run = Driven(function(step(ExecOffset="3"))).start(100)
    times = [t for t in range(100, 130) if run.step(t)]
    assert times == [103, 113, 123]


def test_two_and_a_half_cycles_late_it_runs_once_and_keeps_its_grid():
    run = Driven(function(step(error("Missed"), OverrunError="Missed"))).start()
    run.steps(25)
    assert run.step(25) is None
    assert (counts(run).missed, run.stage("Missed")) == (2, Stage.FAILED)
    assert run.step(29.999999) is None
    run.steps(30)
    assert (counts(run).missed, run.stage("Missed")) == (2, Stage.PASSED)


def test_a_call_that_runs_long_is_not_answered_before_it_has_ended():
    run = Driven(function(step())).start()
    name = run.due(0)
    assert run.adapter.next_call(15 * MS) is None
    run.make(name, 0, until=25)
    run.steps(25)
    assert counts(run).missed == 1


@pytest.mark.parametrize(
    ("steps", "order"),
    [
        ((step(name="A"), step(name="B")), "AB"),
        ((step(name="A"), step(name="B", Priority="5")), "BA"),
        ((step(name="A", PrevRunnable="F_B", Priority="9"), step(name="B")), "BA"),
        ((step(name="A", PrevRunnable="F_B"), step(name="B", PrevRunnable="F_C"), step(name="C"), step(name="D", Priority="1")), "DCBA"),
        ((step(name="A", PrevRunnable="F_Init"), step(name="B")), "AB"),
        ((step(name="A", Priority="high"), step(name="B", Priority="1")), "BA"),
    ],
    ids=["file", "priority", "previous", "chain", "init is not a step", "a priority as text is none"],
)  # fmt: skip
def test_the_order_of_what_is_due_at_the_same_time(steps, order):
    run = Driven(function(*steps)).start()
    found = ""
    while name := run.step(0):
        found += name.removeprefix("F_")
    assert found == order


def test_a_slower_previous_call_of_lower_priority_has_to_end_once():
    slow = step(name="Slow", cycle=40, ExecOffset="15")
    run = Driven(function(step(name="Fast", PrevRunnable="F_Slow", Priority="9"), slow)).start()
    assert run.step(0) is None
    assert run.step(10) is None
    assert run.adapter.next_time() == 15 * MS
    assert [run.step(15), run.step(15), run.step(15)] == ["F_Slow", "F_Fast", None]
    assert run.step(20) == "F_Fast"


@pytest.mark.parametrize("alone", ["Step", "Other"])
def test_a_call_that_is_not_parallel_has_the_function_for_itself(alone):
    step_, other = (step(name=name, ParallelProcessing=False if name == alone else None) for name in ("Step", "Other"))
    run = Driven(function(step_, other)).start()
    name = run.due(0)
    assert run.adapter.next_call(0) is None
    assert run.adapter.next_time() == NEVER
    run.make(name, 0, until=12)
    assert run.adapter.next_time() == 0
    assert [run.step(12), run.step(12), run.step(12)] == ["F_Step", "F_Other", None]
    assert counts(run, "F_Other").missed == 1


def test_calls_that_say_nothing_may_overlap():
    run = Driven(function(step(), step(name="Other"))).start()
    assert [run.due(0), run.due(0)] == ["F_Step", "F_Other"]


def test_the_debounce_time_is_between_two_starts():
    run = Driven(function(on_event(signal("A"), DebounceDelay="5"))).start()
    run.receive("A", 1.0, 0)
    assert run.step(0) is not None
    run.receive("A", 2.0, 1)
    run.receive("A", 3.0, 2)
    assert run.step(4.999999) is None
    assert run.adapter.next_time() == 5 * MS
    run.steps(5)
    assert run.step(20) is None


def test_events_merge_and_with_a_queue_there_is_a_call_for_each():
    for content, expected in ((signal("A"), 1), (queue("A", 5), 3), (queue("A", 2), 2)):
        run = Driven(function(on_event(content))).start()
        for value in (1, 2, 3):
            run.receive("A", value, 0)
        assert len([1 for _ in range(5) if run.step(0)]) == expected


def test_a_call_that_takes_several_values_at_once_stands_for_as_many_events():
    content = queue("A", 8, ValuesPerStep=3, CountVariable="n")
    run = Driven(function(on_event(content, queue("B", 4)))).start()
    for value in range(5):
        run.receive("A", value, 0)
    assert len([1 for _ in range(9) if run.step(0)]) == 5, "B takes one at once"
    run = Driven(function(on_event(content))).start()
    for value in range(5):
        run.receive("A", value, 0)
    assert [run.step(0), run.step(0), run.step(0)] == ["F_Step", "F_Step", None]
    assert [(seen["n"], seen["a"]) for seen in run.seen] == [(3, (0, 1, 2)), (2, (3, 4, 2))]


def test_only_the_signals_that_it_lists_trigger_a_call():
    run = Driven(function(on_event(signal("A", VssPath="Vehicle.A"), signal("B"), EventList="Vehicle.A"))).start()
    run.receive("B", 1.0, 0)
    assert run.step(0) is None
    run.receive("A", 1.0, 0)
    assert run.step(0) == "F_Step"


def test_a_value_that_comes_before_start_triggers_a_call_after_it():
    run = Driven(function(on_event(signal("A"))))
    run.adapter.init()
    run.receive("A", 1.0, 0)
    assert run.step(0) is None
    run.adapter.start(5)
    assert run.step(5) == "F_Step"


def test_when_to_ask_again():
    run = Driven(function(step(), on_event(signal("A"), name="Event"))).start()
    assert run.adapter.next_time() == 0
    run.steps(0)
    assert run.adapter.next_time() == 10 * MS
    run.receive("A", 1.0, 2)
    assert run.adapter.next_time() == 0
    run.steps(2)
    name = run.due(10)
    assert run.adapter.next_time() == NEVER
    run.make(name, 10, until=12)
    assert run.adapter.next_time() == 20 * MS
