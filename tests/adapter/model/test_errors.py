"""Section 6: errors."""

import pytest

from tests.adapter.model.driven import Driven
from tests.adapter.reference.parts.errors import Counts, Error, Stage, is_confirmed
from tests.adapter.written import S8, call, enumeration, error, function, mode_interface, signal, step, watchdog

NOT_TESTED, PASSED, PREFAILED, FAILED, HEALING = Stage
SET, CLEAR = {"e": 1}, {"e": 0}


def with_error(*others, active=None, **fields):
    """A function whose variable `e` says whether the error E is present."""
    modes = (mode_interface("In", "ON", "OFF"),) if active else ()
    document = function(step(error("E", Variable="e", **fields), *others), active=active, modes=modes)
    return Driven(document).start()


def stages(run, *seen):
    """The states after calls at these times, in which the variable is set or not."""
    found = []
    for t, is_set in seen:
        run.variables["e"] = int(is_set)
        run.steps(t)
        found.append(run.stage("E"))
    return found


@pytest.mark.parametrize(
    ("fields", "seen", "expected"),
    [
        ({}, [(0, 0), (10, 1), (20, 0)], [PASSED, FAILED, PASSED]),
        ({"MaturationTime": 20}, [(0, 1), (10, 1), (19.999999, 1), (30, 1)], [PREFAILED, PREFAILED, None, FAILED]),
        ({"MaturationTime": 20}, [(0, 1), (10, 0), (20, 1)], [PREFAILED, PASSED, PREFAILED]),
        ({"ResetTime": 20}, [(0, 1), (10, 0), (20, 0), (30, 0)], [FAILED, HEALING, HEALING, PASSED]),
        ({"ResetTime": 20}, [(0, 1), (10, 0), (20, 1), (30, 0), (40, 0), (50, 0)],
         [FAILED, HEALING, FAILED, HEALING, HEALING, PASSED]),
        ({"Reset": "Restart"}, [(0, 1), (10, 0), (20, 0)], [FAILED, FAILED, FAILED]),
    ],
    ids=["no times", "maturation is inclusive", "a gap restarts", "reset is inclusive", "again while healing", "restart"],
)  # fmt: skip
def test_states(fields, seen, expected):
    times = [(t, is_set) for (t, is_set), stage in zip(seen, expected, strict=True) if stage]
    assert stages(with_error(**fields), *times) == [stage for stage in expected if stage]


def test_one_nanosecond_before_the_maturation_time_it_has_not_failed():
    run = with_error(MaturationTime=20)
    stages(run, (0, 1), (10, 1))
    name = run.due(20)
    for call_time, stage in ((20 * 10**6 - 1, PREFAILED), (20 * 10**6, FAILED)):
        run = with_error(MaturationTime=20)
        run.variables["e"] = 1
        run.make(name, 0)
        run.make(name, call_time / 10**6)
        assert run.stage("E") is stage


def test_the_reset_condition_may_be_a_signal():
    run = with_error(signal("Button"), Reset="Button", ResetTime=10)
    assert stages(run, (0, 1), (10, 0)) == [FAILED, FAILED]
    run.receive("Button", 1.0, 15)
    assert stages(run, (20, 0)) == [HEALING]
    run.receive("Button", 0.0, 25)
    assert stages(run, (30, 0)) == [FAILED]
    run.receive("Button", 1.0, 35)
    assert stages(run, (40, 1), (50, 0), (60, 0)) == [FAILED, HEALING, PASSED]


def test_excluded_by_the_mode_it_goes_back():
    run = with_error(active={"ON": ["Step"], "OFF": []}, MaturationTime=20, ResetTime=20)
    assert stages(run, (0, 1)) == [PREFAILED]
    run.receive("F_Mode_In", 11, 5)
    assert run.step(10) is None
    assert run.stage("E") is NOT_TESTED
    run.receive("F_Mode_In", 10, 15)
    assert stages(run, (20, 1), (40, 1), (50, 0)) == [PREFAILED, FAILED, HEALING]
    run.receive("F_Mode_In", 11, 55)
    assert run.step(60) is None
    assert run.stage("E") is FAILED


def test_what_is_sent_and_when():
    run = with_error(MaturationTime=10, ResetTime=10)
    found = []
    for t, is_set in ((0, 1), (10, 1), (20, 1), (30, 0), (40, 0), (50, 1), (60, 0), (70, 0)):
        stages(run, (t, is_set))
        found.append((run.adapter.out["E"], "E" in run.published()))
    assert found == [
        (0, False), (1, True), (1, False), (1, False), (0, True), (0, False), (0, False), (0, False)
    ]  # fmt: skip


def test_the_first_verdict_is_sent_even_if_it_has_passed():
    run = with_error()
    stages(run, (0, 0))
    assert "E" in run.published()


def test_the_status_variable_has_what_is_sent():
    numbers = enumeration("DT_ErrorSts", PASSED=5, FAILED=7)
    document = function(step(error("E", Variable="e", StatusVariable="s")), datatypes=(numbers,))
    run = Driven(document).start()
    assert run.variables["s"] == 5
    stages(run, (0, 1), (10, 0), (20, 0))
    assert [each["s"] for each in run.seen] == [5, 7, 5]


def test_any_cause_makes_it_present_and_those_that_are_not_tested_do_not_count():
    late = signal("A", Timeout="20", TimeoutError="E")
    other = signal("B", Min=0, Max=1, RangeError="E")
    run = Driven(function(step(late, other, error("E")))).start()
    run.steps(0)
    assert run.stage("E") is NOT_TESTED
    run.receive("B", 0.5, 5)
    run.steps(10)
    assert run.stage("E") is PASSED
    run.steps(30)
    assert run.stage("E") is FAILED


def test_an_error_belongs_to_the_first_step_that_lists_it():
    document = function(
        call("Init", "Init", error("E", Variable="e")),
        step(error("E", Variable="e"), name="First"),
        step(error("E", Variable="e", StatusVariable="other"), name="Second"),
    )
    run = Driven(document).start()
    run.variables["e"] = 1
    assert run.step(0) == "F_First"
    run.variables["e"] = 0
    assert run.step(0) == "F_Second"
    assert run.stage("E") is FAILED


def test_an_error_that_no_step_lists_is_never_evaluated():
    run = Driven(function(call("Init", "Init", error("E", Variable="e")), step())).start()
    assert stages(run, (0, 1)) == [NOT_TESTED]


@pytest.mark.parametrize("is_received", [True, False])
def test_a_dependency_makes_it_fail_at_once_and_keeps_it_there(is_received):
    others = () if is_received else (error("Other", Variable="other"),)
    run = Driven(function(step(error("E", "Other", Variable="e", MaturationTime=100), *others))).start()

    def other(value, t):
        run.variables["other"] = value
        if is_received:
            run.receive("Other", value, t)

    assert stages(run, (0, 0)) == [PASSED]
    other(1, 5)
    assert stages(run, (10, 0)) == [FAILED]
    other(0, 15)
    assert stages(run, (20, 0)) == [PASSED]
    assert run.adapter.stored.errors["E"].occurrences == 1


def test_errors_are_evaluated_after_those_that_they_depend_on():
    late = signal("A", Timeout="5", TimeoutError="First")
    run = Driven(function(step(error("E", "Middle"), error("Middle", "First"), late, error("First")))).start()
    run.steps(10)
    assert run.stage("E") is FAILED


def test_what_is_known_after_the_call_reaches_those_that_are_evaluated_before_it_with_the_next_step():
    run = Driven(function(step(error("E", "Other"), error("Other", Variable="e")))).start()
    assert stages(run, (0, 1), (10, 1)) == [NOT_TESTED, FAILED]


def test_an_error_with_dependencies_only_passes_and_heals_by_them():
    run = Driven(function(step(error("E", "Other")))).start()
    assert stages(run, (0, 0)) == [NOT_TESTED]
    run.receive("Other", 0, 5)
    assert stages(run, (10, 0)) == [PASSED]
    run.receive("Other", 9, 15)
    assert stages(run, (20, 0)) == [FAILED]
    run.receive("Other", 0, 25)
    assert stages(run, (30, 0)) == [PASSED]


def test_a_variable_may_have_any_type():
    run = Driven(function(step(error("E", Variable="e"), signal("S", S8)))).start()
    run.variables["e"] = -1
    run.steps(0)
    assert run.stage("E") is FAILED


# -- counts -------------------------------------------------------------------------------------------------------


def test_occurrences_are_counted_up_to_65535():
    run = with_error()
    run.adapter.stored.errors["E"] = Counts(occurrences=65534)
    stages(run, (0, 1), (10, 0), (20, 1), (30, 0), (40, 1))
    assert run.adapter.stored.errors["E"].occurrences == 65535


def in_cycles(*cycles):
    """Counts after runs of a function in these ignition cycles, in which the error is present, absent, or not tested."""
    stored, found = None, []
    for number, is_set in cycles:
        run = Driven(function(step(error("E", Variable="e")))).start(stored=stored, ignition_cycle=number)
        if is_set is not None:
            stages(run, (0, is_set))
        stored = run.adapter.stored
        found.append(run.adapter.stored.errors.get("E", Counts()).ignitions)
    return found


def test_ignition_cycles_are_counted_when_the_next_one_begins():
    assert in_cycles((1, 1), (2, 1), (3, 1)) == [0, 1, 2]
    assert in_cycles((1, 1), (2, 0), (3, 0)) == [0, 1, 0]
    assert in_cycles((1, 1), (2, None), (3, None)) == [0, 1, 1]


def test_a_crash_in_the_same_cycle_counts_once():
    assert in_cycles((1, 1), (1, 1), (1, 0), (2, 0)) == [0, 0, 0, 1]


@pytest.mark.parametrize(
    ("counts", "limits", "expected"),
    [
        (Counts(0, 0), (0, 0), False), (Counts(1, 0), (0, 0), True), (Counts(2, 0), (3, 0), False),
        (Counts(3, 0), (3, 0), True), (Counts(3, 1), (3, 2), False), (Counts(3, 2), (3, 2), True),
    ],
)  # fmt: skip
def test_confirmed_takes_a_failure_and_both_counts(counts, limits, expected):
    assert is_confirmed(counts, Error("E", occurrence_limit=limits[0], ignition_limit=limits[1])) is expected


def test_supervision_is_evaluated_by_supervise_too_with_the_variable_as_it_was_read():
    run = Driven(function(step(error("E", Variable="e"), Watchdog=watchdog(deadline=(0, 5, "E"))))).start()
    name = run.due(0)
    run.adapter.set_input(name, 0)
    run.adapter.begin(name, 0)
    run.variables["e"] = 1
    run.adapter.supervise(5 * 10**6)
    assert run.stage("E") is NOT_TESTED
    run.adapter.supervise(5 * 10**6 + 1)
    assert run.stage("E") is FAILED
