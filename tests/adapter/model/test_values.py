"""Section 2: values, and queues of them."""

import pytest

from tests.adapter.model.driven import Driven
from tests.adapter.written import U8, array, error, function, output, queue, signal, step

WATCHED = error("Lost")


def seen(run, variable, *times):
    """Return the values that calls at these times see."""
    found = []
    for t in times:
        run.steps(t)
        found.append(run.seen[-1][variable])
    return found


@pytest.mark.parametrize(
    ("given", "first"),
    [({"InitValue": 2, "Default": 3}, 2.0), ({"Default": 3}, 3.0), ({}, 0.0)],
    ids=["init", "default", "nothing"],
)
def test_an_input_that_has_received_nothing_has_its(given, first):
    assert seen(Driven(function(step(signal("A", **given)))).start(), "a", 0) == [first]


def test_a_value_stays_until_the_next_one_and_is_written_all_the_same():
    run = Driven(function(step(signal("A"))), F_Step=lambda variables: variables.update(a=-1.0)).start()
    run.receive("A", 7.0, 0)
    assert seen(run, "a", 0, 10) == [7.0, 7.0]


def test_two_calls_have_their_own_inputs_of_a_signal():
    other = signal("Same", Variable="b", VssPath="Vehicle.A", Datatype=U8)
    document = function(step(signal("A", VssPath="Vehicle.A")), step(other, name="Other"))
    run = Driven(document).start()
    run.receive("A", 3, 0)
    run.steps(0, 0)
    assert (run.variables["a"], run.variables["b"]) == (3, 3)


def test_buffered_values_are_those_of_the_snapshot_and_immediate_ones_those_of_the_beginning():
    run = Driven(function(step(signal("A"), signal("B", Access="Immediate"), signal("C", Access="Buffered")))).start()
    name = run.due(0)
    run.adapter.set_input(name, 0)
    for port in "ABC":
        run.receive(port, 9.0, 0)
    run.adapter.begin(name, 0)
    run.adapter.run(name)
    assert run.seen[-1] == {"a": 0.0, "b": 9.0, "c": 0.0}


@pytest.mark.parametrize(
    ("overflow", "values"), [("DropOldest", [2, 3, 4]), ("DropNewest", [1, 2, 3])], ids=["drop oldest", "drop newest"]
)
def test_a_full_queue_discards(overflow, values):
    run = Driven(function(step(queue("A", 3, Overflow=overflow, OverflowError="Lost"), WATCHED))).start()
    for value in (1, 2, 3, 4):
        run.receive("A", value, 0)
    assert seen(run, "a", 0, 10, 20, 30) == [*values, values[-1]]


def test_an_overflow_is_an_error_in_the_next_snapshot_alone():
    run = Driven(function(step(queue("A", 1, OverflowError="Lost"), WATCHED))).start()
    run.receive("A", 1, 0)
    run.receive("A", 2, 0)
    run.steps(0)
    assert run.adapter.out["Lost"] == 1
    run.steps(10)
    assert run.adapter.out["Lost"] == 0


def test_an_array_gets_as_many_values_as_there_are_and_keeps_the_others():
    run = Driven(function(step(queue("A", 5, ValuesPerStep=3, CountVariable="n", InitValue=9)))).start()
    assert seen(run, "a", 0) == [(9, 9, 9)]
    for value in (1, 2, 3, 4):
        run.receive("A", value, 1)
    assert seen(run, "a", 10, 20, 30) == [(1, 2, 3), (4, 2, 3), (4, 2, 3)]
    assert [each["n"] for each in run.seen] == [0, 3, 1, 0]


def test_values_of_a_queue_may_be_arrays():
    rows = array("DT_Row", U8, 2)
    run = Driven(function(step(queue("A", 5, "DT_Row", ValuesPerStep=2)), datatypes=(rows,))).start()
    run.receive("A", (1, 2), 0)
    run.receive("A", (3, 4), 0)
    assert seen(run, "a", 0) == [(1, 2, 3, 4)]


def test_outputs_are_sent_with_every_call():
    run = Driven(function(step(output("A")))).start()
    run.steps(0)
    assert run.published() == {"A"}
    run.steps(10)
    assert run.published() == {"A"}


def given(run, t, *values):
    """Return the sent values for the outputs of a call."""
    run.variables.update(a=(*values[:3], *[0] * (3 - len(values))), n=len(values))
    run.steps(t)
    return run.adapter.out["A"], "A" in run.published()


def test_of_a_provided_queue_as_many_values_are_sent_as_the_call_says_but_no_more_than_there_is_room_for():
    document = function(step(queue("A", 3, role="Provider", CountVariable="n", OverflowError="Lost"), WATCHED))
    run = Driven(document).start()
    assert given(run, 0, 5) == ((5,), True)
    assert given(run, 10) == ((), False)
    assert given(run, 20, 1, 2, 3, 4) == ((1, 2, 3), True)
    assert run.adapter.out["Lost"] == 1
    assert given(run, 30, 1, 2, 3) == ((1, 2, 3), True)
    assert run.adapter.out["Lost"] == 0


def test_without_a_count_each_call_gives_one_value_of_a_queue():
    run = Driven(function(step(queue("A", 3, role="Provider"))), F_Step=lambda variables: variables.update(a=7)).start()
    run.steps(0)
    assert run.adapter.out["A"] == (7,)
