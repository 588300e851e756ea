"""Section 7: safety reactions."""

import pytest

from tests.adapter.model.driven import Driven
from tests.adapter.written import enumeration, error, function, reaction, step


def seen(run, *times):
    """Return the values that calls at these times see."""
    run.steps(*times)
    return [each["stop"] for each in run.seen[-len(times) :]]


@pytest.mark.parametrize(
    ("initial", "errors", "expected"),
    [(None, [], 0), ("ACTIVE", [], 1), ("INACTIVE", [], 0), ("ACTIVE", ["Other"], 0)],
    ids=["nothing", "active until the outside speaks", "inactive", "active until the first evaluation"],
)
def test_initial(initial, errors, expected):
    fields = {"Initial": initial} if initial else {}
    run = Driven(function(step(reaction("Stop", *errors, **fields)))).start()
    assert run.variables["stop"] == int(initial == "ACTIVE")
    assert seen(run, 0) == [expected]


def test_two_errors_and_one_heals():
    run = Driven(function(step(reaction("Stop", "A", "B")))).start()
    run.receive("A", 1, 0)
    run.receive("B", 1, 0)
    assert seen(run, 0) == [1]
    run.receive("A", 0, 5)
    assert seen(run, 10) == [1]
    run.receive("B", 0, 15)
    assert seen(run, 20) == [0]


def test_an_error_that_is_known_after_the_call_reaches_the_next_one():
    run = Driven(function(step(error("E", Variable="e"), reaction("Stop", "E")))).start()
    run.variables["e"] = 1
    assert seen(run, 0, 10) == [0, 1]


def test_healing_is_active():
    run = Driven(function(step(error("E", Variable="e", ResetTime=15), reaction("Stop", "E")))).start()
    run.variables["e"] = 1
    run.steps(0)
    run.variables["e"] = 0
    assert seen(run, 10, 20, 30, 40) == [1, 1, 1, 0]


def test_the_outside_is_heard_and_a_number_without_a_name_says_nothing():
    numbers = enumeration("DT_SftyCondSts", INACTIVE=3, ACTIVE=4)
    run = Driven(function(step(reaction("Stop")), datatypes=(numbers,))).start()
    for t, (value, expected) in enumerate(((4, 4), (9, 4), (3, 3))):
        run.receive("Stop", value, t * 10)
        assert seen(run, t * 10) == [expected]


def test_it_is_published_on_change_alone():
    run = Driven(function(step(reaction("Stop", "E")))).start()
    run.published()
    run.receive("E", 1, 0)
    published = []
    for t in (0, 10):
        run.steps(t)
        published.append(run.published())
    assert published == [{"Stop"}, set()]


def test_a_source_that_dies():
    run = Driven(function(step(reaction("Stop", Timeout="15")))).start()
    run.receive("Stop", 0, 0)
    assert seen(run, 0, 10, 20) == [0, 0, 1]
