"""CoreAcc drives: it holds speeds and distances, slows down for curves, and leaves the car to its driver when it must."""

import math
from collections.abc import Iterable, Sequence
from itertools import pairwise

import pytest

from tests.examples.car import Car, Leader, Moment, drive
from tests.examples.compiled import Running
from tests.examples.signals import (
    ACTIVE,
    FAULT,
    MI_PER_HOUR,
    NOT_IN_MAP,
    OFF,
    STANDBY,
    AccInputs,
    AccOutputs,
    Status,
)
from tests.needs import c_compiler

pytestmark = c_compiler

DRIVING = AccInputs()
RATIO, WHEELBASE, CHARACTERISTIC_SPEED = 15.0, 3.0, 28.0


def run(steps: Iterable[AccInputs]) -> Sequence[AccOutputs]:
    """The outputs of steps with given inputs, the last of which is after termination."""
    with Running("core_acc") as acc:
        outputs = [AccOutputs(*acc.step(inputs)) for inputs in steps]
        return [*outputs, AccOutputs(*acc.end())]


def free_road(duration: float, speed: float, **inputs: float) -> Sequence[Moment]:
    return list(drive(duration, Car(0.0, speed), lambda _time, _car: DRIVING._replace(**inputs)))


def behind(leader: Leader, duration: float, speed: float, **inputs: float) -> Sequence[Moment]:
    def around(time: float, car: Car) -> AccInputs:
        return DRIVING._replace(distance=leader.gap(time, car), **inputs)

    return list(drive(duration, Car(0.0, speed), around))


def angle(curvature: float, speed: float) -> float:
    """Angle of the steering wheel in a curve."""
    slip = speed / CHARACTERISTIC_SPEED
    return RATIO * WHEELBASE * curvature * (1.0 + slip * slip)


def in_curve(duration: float, speed: float, curvature: float, **inputs: float) -> Sequence[Moment]:
    def around(_time: float, car: Car) -> AccInputs:
        return DRIVING._replace(steering_angle=angle(curvature, car.speed), **inputs)

    return list(drive(duration, Car(0.0, speed), around))


@pytest.mark.parametrize(
    ("start", "unit", "held"), [(20.0, 0, 108 / 3.6), (36.0, 0, 108 / 3.6), (25.0, 1, 67 * 0.44704)]
)
def test_it_reaches_the_set_speed_in_whole_units_of_the_dashboard_and_holds_it(start, unit, held):
    drove = free_road(60, start, set_speed=29.9, unit=unit)
    assert all(moment.car.speed == pytest.approx(held, abs=0.02) for moment in drove if moment.time > 45)
    assert drove[-1].outputs.status == Status.SPEED


def test_the_unit_stays_where_the_map_does_not_know_it():
    speeds = [MI_PER_HOUR, NOT_IN_MAP]
    first, second, _ = run(DRIVING._replace(unit=unit, set_speed=29.9) for unit in speeds)
    assert (first.request, second.request) != (0.0, 0.0)
    (kilometers, *_) = run([DRIVING._replace(unit=NOT_IN_MAP, set_speed=29.9)])
    assert math.copysign(1, kilometers.request) != math.copysign(1, second.request)


def test_it_keeps_a_time_gap_behind_a_slower_vehicle():
    drove = behind(Leader(150.0, lambda _: 20.0), 60, 30.0)
    last = drove[-1]
    assert last.car.speed == pytest.approx(20.0, abs=0.1)
    assert last.inputs.distance == pytest.approx(4.0 + 1.8 * 20.0, abs=0.5)
    assert last.outputs.status == Status.FOLLOW
    assert min(moment.outputs.request for moment in drove) > -2.0


def test_it_stops_behind_a_vehicle_that_brakes_hard_and_drives_off_after_it():
    leader = Leader(46.0, lambda time: max(0.0, 25.0 - 4.0 * max(0.0, time - 5)) if time < 30 else min(15.0, time - 30))
    drove = behind(leader, 60, 25.0)
    stands = [moment for moment in drove if moment.outputs.status == Status.STANDSTILL]
    assert 2.0 < min(moment.inputs.distance for moment in drove) < 6.0
    assert {moment.car.speed for moment in stands if moment.time > 25} == {0.0}
    assert drove[-1].car.speed > 12.0


def test_it_makes_room_for_a_vehicle_that_cuts_in():
    leader = Leader(100.0, lambda _: 26.0)

    def around(time: float, car: Car) -> AccInputs:
        gap = leader.gap(time, car)
        return DRIVING._replace(distance=gap if time > 16.0 else 0.0)

    drove = list(drive(60, Car(0.0, 30.0), around))
    seen = [moment for moment in drove if moment.inputs.distance]
    assert 34.0 < seen[0].inputs.distance < 37.0
    assert min(moment.inputs.distance for moment in seen) > 30.0
    assert min(moment.outputs.request for moment in seen) > -3.3
    assert seen[-1].inputs.distance == pytest.approx(4.0 + 1.8 * 26.0, abs=1.0)


def test_a_vehicle_that_is_not_seen_for_a_moment_is_still_there():
    leader = Leader(40.0, lambda _: 20.0)

    def around(time: float, car: Car) -> AccInputs:
        gap = leader.gap(time, car)
        return DRIVING._replace(distance=math.nan if 20.0 < time < 20.4 else 0.0 if time > 22.0 else gap)

    drove = list(drive(24, Car(0.0, 20.0), around))
    assert all(moment.outputs.status == Status.FOLLOW for moment in drove if 20.0 < moment.time < 21.9)
    assert drove[-1].outputs.status == Status.SPEED


@pytest.mark.parametrize("curvature", [1 / 100, -1 / 150])
@pytest.mark.parametrize("limit", [2.0, 3.0])
def test_the_lateral_acceleration_in_curves_is_limited(curvature, limit):
    drove = in_curve(20, 30.0, curvature, largest_lateral_acceleration=limit)
    assert drove[-1].car.speed ** 2 * abs(curvature) == pytest.approx(limit, rel=0.01)
    assert drove[-1].outputs.status == Status.CURVE


@pytest.mark.parametrize("missing", [{"angle_missing": 1}, {"steering_angle": -16.0}, {"steering_angle": math.nan}])
def test_without_a_steering_angle_curves_do_not_count_and_the_driver_is_warned(missing):
    inputs = {"steering_angle": 2.0} | missing
    drove = free_road(20, 30.0, **inputs)
    assert drove[-1].car.speed == pytest.approx(30.0, abs=0.1)
    assert drove[-1].outputs.status == Status.SPEED + Status.NO_CURVE_LIMIT


def test_a_proposal_stands_in_for_the_set_speed():
    *_, last, _ = run([DRIVING._replace(proposal=-0.4)] * 20)
    assert tuple(last) == pytest.approx((-0.4, ACTIVE, Status.ECO))


@pytest.mark.parametrize("proposal", [-2.0, 2.0])
def test_a_proposal_does_not_lead_far_from_the_set_speed(proposal):
    with Running("core_acc") as acc:
        car = Car(0.0, 30.0)
        for _ in range(1200):
            inputs = DRIVING._replace(proposal=proposal, acceleration=car.acceleration, speed=car.speed)
            car = car.driven(AccOutputs(*acc.step(inputs)).request, 0.0)
    assert car.speed == pytest.approx(30.0 * (0.88 if proposal < 0 else 1.06), rel=0.001)


@pytest.mark.parametrize(
    "none", [{"proposal": -20.0}, {"proposal": 0.5, "proposal_missing": 1}, {"proposal": math.nan}]
)
def test_without_a_proposal_the_set_speed_is_held(none):
    *_, last, _ = run([DRIVING._replace(**none)] * 20)
    assert last == (0.0, ACTIVE, Status.SPEED)


def test_a_vehicle_ahead_and_a_curve_win_over_the_proposal():
    *_, close, _ = run([DRIVING._replace(proposal=0.5, distance=30.0)] * 20)
    *_, bent, _ = run([DRIVING._replace(proposal=0.5, steering_angle=2.0)] * 20)
    assert (close.status, bent.status) == (Status.FOLLOW, Status.CURVE)
    assert close.request < 0 > bent.request


def test_the_driver_brakes_and_has_to_switch_it_on_again():
    brakes, off = DRIVING._replace(brake_pressure=12.0), DRIVING._replace(is_enabled=0)
    outputs = run([DRIVING, brakes, DRIVING, off, DRIVING])
    assert [output.status for output in outputs[:-1]] == [
        Status.SPEED,
        Status.RELEASED,
        Status.RELEASED,
        Status.STANDBY,
        Status.SPEED,
    ]
    assert [output.mode for output in outputs] == [ACTIVE, STANDBY, STANDBY, STANDBY, ACTIVE, OFF]
    assert outputs[1].request == outputs[2].request == 0.0


@pytest.mark.parametrize("fault", ["invalid", "brake_missing"])
def test_a_fault_hands_over_to_the_driver(fault):
    slower = DRIVING._replace(set_speed=25.0)
    outputs = run([slower, slower._replace(**{fault: 1}), slower])
    assert [(output.mode, output.status) for output in outputs[:-1]] == [
        (ACTIVE, Status.SPEED),
        (FAULT, Status.FAULT),
        (STANDBY, Status.RELEASED),
    ]
    assert outputs[0].request < 0.0
    assert outputs[1].request == 0.0


@pytest.mark.parametrize("inputs", [{"mode": OFF}, {"mode": STANDBY}, {"is_enabled": 0}, {"set_speed": 0.0}])
def test_it_requests_nothing_unless_it_is_active_switched_on_and_has_a_set_speed(inputs):
    (output, _) = run([DRIVING._replace(speed=20.0, **inputs)])
    assert output == (0.0, OFF if inputs == {"mode": OFF} else STANDBY, Status.STANDBY)


def test_a_speed_that_is_missing_for_half_a_second_ends_it():
    outputs = run([DRIVING, *[DRIVING._replace(speed=math.nan)] * 10, DRIVING])
    assert [output.status for output in outputs[1:-1]] == [Status.SPEED] * 9 + [Status.RELEASED] * 2


def test_the_jerk_is_limited_and_a_request_begins_at_the_own_acceleration():
    outputs = run([DRIVING._replace(speed=10.0, acceleration=0.4)] * 20)
    requests = [0.4, *(output.request for output in outputs[:-1])]
    changes = [after - before for before, after in pairwise(requests)]
    assert max(changes) == pytest.approx(0.05 * (5.0 - 2.5 / 3), rel=1e-5)
    assert requests[-1] == pytest.approx(2.0 - 0.8 / 3, rel=1e-5)


def test_a_heavy_vehicle_accelerates_no_harder_than_its_power_allows():
    outputs = run([DRIVING._replace(speed=25.0, set_speed=40.0, mass=10_000.0)] * 40)
    assert outputs[-2].request == pytest.approx(150_000 / (10_000 * 25.0))


def test_nothing_is_requested_before_and_after():
    with Running("core_acc") as acc:
        assert tuple(acc.initial) == (0.0, OFF, Status.NOT_STARTED)
        acc.step(DRIVING._replace(set_speed=20.0))
        assert tuple(acc.end()[:2]) == (0.0, OFF)
