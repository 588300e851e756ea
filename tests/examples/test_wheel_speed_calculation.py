"""WheelSpeedCalculation: speeds as the integers of its declaration, range errors, and a wheel that others replace."""

import math
from collections.abc import Iterable, Sequence

import pytest

from tests.examples.compiled import Running
from tests.examples.signals import DEGRADED, NORMAL, OFF, SERVICE, WheelInputs, WheelOutputs
from tests.needs import c_compiler

pytestmark = c_compiler

STILL = 10_000
"""0 km/h: 0.01 km/h a step, from -100 km/h on."""
PER_KMH = 1 / (0.0018 * 650)
"""rad/s of a wheel of 650 mm."""


def run(steps: Iterable[WheelInputs]) -> Sequence[WheelOutputs]:
    """The outputs of steps with given inputs, the last of which is after termination."""
    with Running("wheel_speed_calculation") as wheels:
        outputs = [WheelOutputs(*wheels.step(()))]
        outputs += [WheelOutputs(*wheels.step(inputs)) for inputs in steps]
        return [*outputs[1:], WheelOutputs(*wheels.end())]


def rolling(*speeds: float, **inputs: float) -> WheelInputs:
    """Wheels that turn so fast, in km/h: front left, front right, rear left, rear right."""
    return WheelInputs(*(PER_KMH * speed for speed in speeds))._replace(**inputs)


def kmh(output: float) -> float:
    return output * 0.01 - 100.0


def test_a_speed_is_half_the_diameter_times_the_angular_speed():
    (output, _) = run([WheelInputs(50.0, -50.0, 100.0, 20.0, front_diameter=600.0, rear_diameter=700.0)])
    assert [kmh(each) for each in output[:4]] == pytest.approx([54.0, -54.0, 126.0, 25.2], abs=0.005)
    assert (output.mode, output.range_error) == (NORMAL, 0)


@pytest.mark.parametrize(
    ("speed", "expected"),
    [(0.0, STILL), (0.004, STILL), (0.006, STILL + 1), (-100.0, 0), (-130.0, 0), (500.0, 60_000), (700.0, 65_535)],
)
def test_what_does_not_fit_the_integer_is_its_limit(speed, expected):
    (output, _) = run([rolling(speed, 0, 0, 0, largest_speed=1000.0)])
    assert output.front_left == expected


@pytest.mark.parametrize("wheel", range(4))
@pytest.mark.parametrize("speed", [361.0, -361.0, math.nan, math.inf])
def test_a_wheel_that_is_too_fast_or_no_number_is_a_range_error(wheel, speed):
    speeds = [100.0] * 4
    speeds[wheel] = speed
    wrong, right, _ = run([rolling(*speeds), rolling(*[100.0] * 4)])
    assert (wrong.range_error, wrong.mode) == (1, DEGRADED)
    assert (right.range_error, right.mode) == (0, NORMAL)
    if math.isnan(speed):
        assert wrong[wheel] == STILL


def test_how_often_a_wheel_came_to_be_out_of_range_is_kept_for_the_next_start():
    fast = rolling(400.0, 400.0, 0.0, 0.0)
    slow = rolling(0.0, 0.0, 0.0, 0.0)
    *steps, last = run([fast, fast, slow, fast, slow])
    assert {output.range_errors for output in steps} == {7}
    assert last.range_errors == 7 + 4


def test_the_other_wheels_stand_in_for_the_rear_left_one_also_in_curves():
    straight, curve, _ = run(
        [rolling(100, 100, 250, 100, rear_left_invalid=1), rolling(103, 97, -50, 96, rear_left_invalid=1)]
    )
    assert kmh(straight.rear_left) == pytest.approx(100.0, abs=0.01)
    assert kmh(curve.rear_left) == pytest.approx(102.0, abs=0.01)
    assert (straight.mode, straight.range_error) == (DEGRADED, 0)


@pytest.mark.parametrize(
    ("speeds", "expected"),
    [((400, 100, 0, 90), 95.0), ((math.nan, 400, 0, 90), 90.0), ((400, 400, 0, 400), 0.0)],
)
def test_only_wheels_that_are_in_range_stand_in(speeds, expected):
    (output, _) = run([rolling(*speeds, rear_left_invalid=1)])
    assert kmh(output.rear_left) == pytest.approx(expected, abs=0.01)


def test_on_a_test_stand_nothing_is_replaced():
    (output, _) = run([rolling(0, 0, 30, 0, rear_left_invalid=1, mode=SERVICE)])
    assert kmh(output.rear_left) == pytest.approx(30.0, abs=0.01)


def test_a_range_error_that_the_failure_management_remembers_keeps_it_degraded():
    (output, _) = run([rolling(50, 50, 50, 50, range_error_known=1)])
    assert (output.mode, output.range_error) == (DEGRADED, 0)


def test_it_is_off_when_it_should_be_and_before_and_after():
    with Running("wheel_speed_calculation") as wheels:
        assert tuple(wheels.initial) == (0, 0, 0, 0, OFF, 0, 0), "a step before the initialization does nothing"
        assert tuple(wheels.step(())[:5]) == (STILL, STILL, STILL, STILL, OFF)
        wheels.step(rolling(50, 50, 50, 50))
        assert wheels.end()[4] == OFF
    (output, _) = run([rolling(50, 50, 50, 50, mode=OFF)])
    assert output.mode == OFF
