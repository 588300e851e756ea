"""Times between calls of `Supervise`, from records of a platform that calls it too seldom, and of one that does not."""

from pathlib import Path

import pytest

from sigcat.adapter.core.plan.call import Deadline
from sigcat.comparison.recording import Built, Recording, Supervised
from sigcat.comparison.report import model
from sigcat.comparison.running.supervised import Moment, supervised_periods
from sigcat.comparison.telling.figures import supervisions
from sigcat.comparison.telling.material import Material, Played
from sigcat.comparison.telling.targets import targets
from tests.comparison.ecocontrol import subject

MS = 1_000_000
CYCLE, DEADLINE = 50 * MS, 20 * MS


@pytest.fixture(scope="module")
def plan():
    found = next(each.plan for each in subject().prepared.connections.members if each.plan.function == "CoreAcc")
    return found._replace(steps=(found.steps[0]._replace(cycle=CYCLE, deadline=Deadline(0, DEADLINE, "")),))


def gaps(plan, *moments):
    return {each.call: (each.period_ns, each.gaps_ns) for each in supervised_periods(plan, [moments])}


def test_the_shortest_cycle_is_the_longest_period_while_no_call_runs(plan):
    found = gaps(
        plan,
        Moment(1, 0, 1 * MS),
        Moment(0, 50 * MS, 50 * MS),
        Moment(0, 170 * MS, 170 * MS),
        Moment(1, 200 * MS, 201 * MS),
    )
    assert found[""] == (CYCLE, (50 * MS, 120 * MS, 30 * MS))


def test_a_call_beyond_its_deadline_is_supervised_within_its_longest_duration(plan):
    found = gaps(plan, Moment(1, 0, 60 * MS), Moment(0, 20 * MS, 20 * MS))
    assert found["CoreAcc_Step"] == (DEADLINE, (20 * MS, 40 * MS))


def test_a_platform_that_never_calls_supervise_has_one_time_as_long_as_the_run(plan):
    assert gaps(plan, Moment(1, 0, MS), Moment(1, 900 * MS, 901 * MS))[""] == (CYCLE, (900 * MS,))


def test_a_function_without_alive_and_deadline_supervision_is_not_measured(plan):
    plan = plan._replace(steps=(plan.steps[0]._replace(alive=None, deadline=None),))
    assert not gaps(plan, Moment(1, 0, MS))


@pytest.mark.parametrize(("over", "passes"), [(0, True), (1, True), (2, False)])
def test_one_time_of_a_hundred_may_be_longer(over, passes):
    row = model.Supervision(
        platform="ros2-cpp", mode="free run", function="CoreAcc", period=CYCLE, gaps=100, over=over, longest=CYCLE
    )
    platforms = tuple(model.Platform(name=name, title=name) for name in ("simulation", "ros2-cpp"))
    told = model.Report(
        sigcat="1", name="x", functions=(), trace="", machine=(), reference="simulation",
        platforms=platforms, seconds=1.0, supervision=(row,),
    )  # fmt: skip
    found = [each for each in targets(told) if "Supervise" in each.what]
    assert [each.holds for each in found] == [passes]


def test_a_time_is_longer_beyond_the_period_and_a_millisecond():
    gaps_ns = (CYCLE, CYCLE + MS, CYCLE + MS + 1)
    built = Built("ros2-cpp", Path(), (), 0.0, 0.0)
    recording = Recording("ros2-cpp", "free run", built, {}, supervised=(Supervised("F", "", CYCLE, gaps_ns),))
    material = Material("x", (), "", 0, {}, CYCLE, (Played("ros2-cpp", "ROS 2", free_run=recording),))
    (row,) = supervisions(material)
    assert (row.gaps, row.over, row.longest) == (3, 1, CYCLE + MS + 1)
