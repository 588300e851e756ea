"""EcoControlMpc looks ahead: it saves energy over hills, stays near the set speed, and says when it has no solution."""

import math
from collections.abc import Iterable, Sequence

import pytest

from scripts.drive.road import HILLS, altitude
from tests.examples.car import STEP, Car, drive, slope
from tests.examples.compiled import EXAMPLES, Running
from tests.examples.signals import (
    ACTIVE,
    FAULT,
    NO_PROPOSAL,
    OFF,
    POINTS,
    SPACING,
    STANDBY,
    AccInputs,
    MpcInputs,
    MpcOutputs,
)
from tests.needs import c_compiler

pytestmark = c_compiler

DRIVING = MpcInputs()
CLIFF = tuple(100.0 * (point > 20) for point in range(POINTS))
SET_SPEED = 100 / 3.6
HILLY = 6_200.0
"""Length of the road with hills; a level road follows, so that energy gained by speed is given back."""
LENGTH = HILLY + 1_300.0


def run(steps: Iterable[MpcInputs]) -> Sequence[MpcOutputs]:
    with Running("eco_control_mpc") as mpc:
        outputs = [MpcOutputs(*mpc.step(inputs.values)) for inputs in steps]
        return [*outputs, MpcOutputs(*mpc.end())]


def rising(share: float) -> tuple[float, ...]:
    return tuple(share * SPACING * point for point in range(POINTS))


def end_speed(energy_weight: float) -> float:
    """The speed that is reached on a flat road."""
    speed = 30.0
    with Running("eco_control_mpc") as mpc:
        for _ in range(200):
            inputs = DRIVING._replace(speed=speed, energy_weight=energy_weight)
            speed += 0.5 * MpcOutputs(*mpc.step(inputs.values)).proposal
    return speed


def test_on_a_flat_road_the_weight_decides_between_time_and_energy():
    assert end_speed(0.6) == pytest.approx(30.0, abs=0.05)
    assert end_speed(0.0) == pytest.approx(1.05 * 30.0, abs=0.15)
    assert end_speed(1.0) == pytest.approx(0.90 * 30.0, abs=0.15)
    assert 0.90 * 30.0 < end_speed(0.65) < 29.5


def test_it_slows_down_before_it_goes_downhill_and_gathers_speed_before_a_climb():
    down = tuple(min(0.0, -0.05 * (SPACING * point - 200.0)) for point in range(POINTS))
    up = tuple(-altitude for altitude in down)
    before_down, _ = run([DRIVING._replace(altitudes=down)])
    before_up, _ = run([DRIVING._replace(altitudes=up)])
    assert before_down.proposal < -0.03
    assert before_up.proposal > 0.03


@pytest.mark.parametrize(("speed", "least", "most"), [(20.0, 0.3, 0.85), (45.0, -1.05, -0.3)])
def test_a_speed_far_from_the_set_speed_is_led_back_comfortably(speed, least, most):
    (first, _) = run([DRIVING._replace(speed=speed)])
    assert least <= first.proposal <= most


def hills(way: float) -> float:
    """Altitude of the first hills of the recorded drive."""
    return altitude(way, [hill for hill in HILLS if hill.begin + hill.length <= HILLY])


def predictive() -> tuple[float, float]:
    """Energy in J and time in s over the hills, with both functions in the loop."""
    drove = drive(LENGTH / 20, Car(0.0, SET_SPEED), lambda _time, _car: AccInputs(set_speed=SET_SPEED), hills)
    end = next(moment for moment in drove if moment.car.way >= LENGTH)
    assert end.car.speed == pytest.approx(SET_SPEED, abs=0.1)
    return end.car.energy, end.time


def constant(speed: float) -> tuple[float, float]:
    """The same at a constant speed."""
    car, steps = Car(0.0, speed), 0
    while car.way < LENGTH:
        car, steps = car.driven(0.0, slope(hills, car.way)), steps + 1
    return car.energy, steps * STEP


def test_it_saves_energy_over_the_hills_as_its_page_says():
    (energy, time), (plain, plain_time) = predictive(), constant(SET_SPEED)
    as_long, same_time = constant(LENGTH / time)
    assert same_time == pytest.approx(time, abs=0.1)
    page = " ".join((EXAMPLES / "ecocontrol" / "README.md").read_text().split())
    saved, saved_as_long, later = 100 * (1 - energy / plain), 100 * (1 - energy / as_long), time - plain_time
    assert f"{saved:.1f} % less energy than a constant 100 km/h, and take {later:.0f} s more" in page
    assert f"Compared with a constant speed that takes the same time, they use {saved_as_long:.1f} % less" in page
    assert saved_as_long > 2.0


@pytest.mark.parametrize(
    "altitudes", [CLIFF, (math.nan,) * POINTS, (0.0,) * 49 + (math.inf,)], ids=["cliff", "nan", "inf"]
)
def test_no_road_has_no_solution_and_the_next_road_has_one_again(altitudes):
    none, again, _ = run([DRIVING._replace(altitudes=altitudes), DRIVING])
    assert tuple(none) == (NO_PROPOSAL, ACTIVE, True)
    assert tuple(again) == (0.0, ACTIVE, False)


def test_a_climb_that_is_too_steep_for_the_power_has_no_solution():
    (none, _) = run([DRIVING._replace(altitudes=rising(0.25), mass=8000.0)])
    assert none.no_solution


def test_a_fault_withholds_the_proposal_while_it_goes_on_solving():
    slow = DRIVING._replace(speed=28.0)
    with_fault, without, _ = run([slow._replace(invalid=1), slow])
    assert tuple(with_fault) == (NO_PROPOSAL, FAULT, False)
    assert without.proposal > 0.0
    cliff, _ = run([slow._replace(invalid=1, altitudes=CLIFF)])
    assert cliff.no_solution


@pytest.mark.parametrize(
    "inputs",
    [
        {"mode": STANDBY},
        {"is_enabled": 0},
        {"set_speed": 0.0},
        {"speed": 4.0},
        {"speed": math.nan},
        {"set_speed": math.nan},
        {"horizon_missing": 1},
    ],
)
def test_it_proposes_nothing_where_there_is_nothing_to_plan(inputs):
    (output, _) = run([DRIVING._replace(**inputs)])
    assert output == (NO_PROPOSAL, inputs.get("mode", ACTIVE), False)


def test_instances_know_nothing_of_each_other():
    steps = [DRIVING._replace(speed=27.0 + 0.1 * step, altitudes=rising(0.02)) for step in range(20)]
    other = [DRIVING._replace(instance=1, speed=20.0, set_speed=25.0, altitudes=rising(-0.03))] * 20
    alone = run(steps)[:-1]
    mixed = run(inputs for pair in zip(steps, other, strict=True) for inputs in pair)[:-1]
    assert mixed[::2] == alone
    assert mixed[1] != alone[0]


def test_nothing_is_proposed_before_and_after():
    with Running("eco_control_mpc") as mpc:
        assert tuple(mpc.initial) == (NO_PROPOSAL, OFF, False)
        mpc.step(DRIVING.values)
        assert tuple(mpc.end()) == (NO_PROPOSAL, OFF, False)
