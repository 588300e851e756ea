"""Section 10: supervision."""

import pytest

from tests.adapter.model.driven import MS, Driven
from tests.adapter.reference.parts.errors import Stage
from tests.adapter.written import call, error, function, step, watchdog

NOT_TESTED, PASSED, FAILED = Stage.NOT_TESTED, Stage.PASSED, Stage.FAILED


def alive(low, high, reference=3, **fields):
    """A function whose call has to end from `low` to `high` times in 30 ms."""
    document = function(step(error("E"), Watchdog=watchdog(alive=(low, high, reference, "E")), **fields))
    return Driven(document).start()


@pytest.mark.parametrize(
    ("low", "high", "expected"), [(3, 3, PASSED), (4, 5, FAILED), (1, 2, FAILED), (2, 3, PASSED), (3, 4, PASSED)]
)
def test_a_window_is_good_if_the_count_is_within_the_limits(low, high, expected):
    run = alive(low, high)
    run.steps(0, 10, 20)
    assert run.stage("E") is NOT_TESTED
    run.adapter.supervise(30 * MS)
    assert run.stage("E") is expected


def test_the_end_of_a_window_is_the_beginning_of_the_next():
    run = alive(2, 2)
    run.step(0)
    run.step(10, until=29.999999)
    run.adapter.supervise(30 * MS)
    assert run.stage("E") is PASSED
    run = alive(2, 2)
    run.step(0)
    run.step(10, until=30)
    run.adapter.supervise(30 * MS)
    assert run.stage("E") is FAILED


def test_windows_begin_with_the_first_release():
    run = alive(3, 3, ExecOffset="5")
    run.steps(5, 15, 25)
    run.adapter.supervise(35 * MS - 1)
    assert run.stage("E") is NOT_TESTED
    run.adapter.supervise(35 * MS)
    assert run.stage("E") is PASSED


def test_empty_windows_count_and_a_bad_one_among_several_makes_the_error():
    run = alive(0, 3)
    run.adapter.supervise(90 * MS)
    assert run.stage("E") is PASSED
    run = alive(1, 3)
    run.steps(0)
    run.adapter.supervise(90 * MS)
    assert run.stage("E") is FAILED


def test_until_the_next_window_closes_the_verdict_stays():
    run = alive(1, 3)
    run.adapter.supervise(30 * MS)
    run.steps(30, 40, 50)
    assert run.stage("E") is FAILED
    run.steps(60)
    assert run.stage("E") is PASSED


def test_the_end_of_a_window_is_a_time_to_ask():
    run = alive(1, 3, 1)
    name = run.due(0)
    assert run.adapter.next_time() == 10 * MS
    run.make(name, 0)


@pytest.mark.parametrize(
    ("duration", "expected"),
    [(1.999999, FAILED), (2, PASSED), (5, PASSED), (5.000001, FAILED)],
)
def test_a_deadline_has_inclusive_limits(duration, expected):
    run = Driven(function(step(error("E"), Watchdog=watchdog(deadline=(2, 5, "E"))))).start()
    run.step(0, until=duration)
    assert run.stage("E") is expected


def test_supervise_finds_a_call_that_hangs():
    run = Driven(function(step(error("E"), Watchdog=watchdog(deadline=(0, 5, "E"))))).start()
    name = run.due(0)
    run.adapter.set_input(name, 0)
    run.adapter.supervise(100 * MS)
    assert run.stage("E") is NOT_TESTED
    run.adapter.begin(name, 100 * MS)
    run.adapter.supervise(105 * MS)
    assert run.stage("E") is NOT_TESTED
    run.adapter.supervise(105 * MS + 1)
    assert run.stage("E") is FAILED


# -- logical ------------------------------------------------------------------------------------------------------


def graph(*letters):
    """A function whose calls A, B, C must come in this order; after C, A may follow."""
    calls = [
        on_order("A", {"BeginsSequence": True, "Next": ["F_B"]}),
        on_order("B", {"Next": ["F_B", "F_C"]}),
        on_order("C", {"EndsSequence": True}),
    ]
    run = Driven(function(*calls)).start()
    found = []
    for letter in letters:
        run.make(f"F_{letter}", 0)
        found.append(run.stage(f"E{letter}"))
    return found


def on_order(name, checkpoint):
    return step(error(f"E{name}"), name=name, Checkpoint=checkpoint, Watchdog=watchdog(logical_error=f"E{name}"))


@pytest.mark.parametrize(
    ("letters", "wrong"),
    [("ABC", ""), ("ABBBCAB", ""), ("BA", "0"), ("ACB", "1"), ("AAB", "1"), ("ABCC", "3"), ("ABCBA", "3")],
)
def test_a_call_is_right_where_the_graph_says_so(letters, wrong):
    assert graph(*letters) == [FAILED if str(place) in wrong else PASSED for place in range(len(letters))]


def test_a_right_checkpoint_makes_all_errors_of_the_order_absent():
    run = Driven(
        function(on_order("A", {"BeginsSequence": True, "Next": ["F_B"]}), on_order("B", {"EndsSequence": True}))
    ).start()
    run.make("F_B", 0)
    run.make("F_A", 0)
    run.make("F_B", 0)
    assert [run.stage("EA"), run.stage("EB")] == [PASSED, PASSED]


def test_init_and_terminate_are_checkpoints_too():
    init = call("Init", "Init", Checkpoint={"BeginsSequence": True, "Next": ["F_Step"]})
    document = function(init, step(error("E"), Checkpoint={"EndsSequence": True}, Watchdog=watchdog(logical_error="E")))
    run = Driven(document).start()
    run.steps(0)
    assert run.stage("E") is PASSED
    run.steps(10)
    assert run.stage("E") is FAILED
