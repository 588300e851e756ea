"""A car to control: its motion, the energy that it takes, and a closed loop of both functions around it."""

from collections.abc import Callable, Iterator
from contextlib import ExitStack
from typing import NamedTuple

from tests.examples.compiled import Running
from tests.examples.signals import POINTS, SPACING, AccInputs, AccOutputs, MpcInputs, MpcOutputs

STEP = 0.05
MPC_STEPS = 10
"""EcoControlMpc has one step in so many of CoreAcc."""
SMALL_STEP = 0.01
"""State of the motion."""
MASS, ROLLING, AIR = 2495.0, 0.01, 0.45


class Car(NamedTuple):
    way: float
    speed: float
    acceleration: float = 0.0
    energy: float = 0.0
    """From the battery, in J."""

    def driven(self, request: float, slope: float) -> "Car":
        """A step later. The powertrain follows the request with a lag of 0.3 s; a car that stands stays."""
        car = self
        for _ in range(round(STEP / SMALL_STEP)):
            acceleration = car.acceleration + (request - car.acceleration) * SMALL_STEP / 0.3
            speed = max(0.0, car.speed + acceleration * SMALL_STEP)
            way = (car.speed + speed) / 2 * SMALL_STEP
            force = MASS * (acceleration + 9.81 * (slope + ROLLING)) + AIR * speed * speed
            car = Car(car.way + way, speed, acceleration if speed else 0.0, car.energy + battery(force) * way)
        return car


def battery(force: float) -> float:
    """Energy from the battery for a meter with a force at the wheels: losses of driving, of braking, of large currents."""
    return force * (1.075 if force > 0 else 0.7) + force * force * 2.5e-5


class Moment(NamedTuple):
    time: float
    car: Car
    inputs: AccInputs
    outputs: AccOutputs


Surroundings = Callable[[float, Car], AccInputs]
"""Inputs at a time, where the car is then; its own motion and the proposal are filled in."""
Altitude = Callable[[float], float]


def drive(duration: float, car: Car, around: Surroundings, altitude: Altitude | None = None) -> Iterator[Moment]:
    """The closed loop: with EcoControlMpc where there are altitudes; on a flat road, and without it, where there are none."""
    with ExitStack() as running:
        acc = running.enter_context(Running("core_acc"))
        mpc = running.enter_context(Running("eco_control_mpc")) if altitude else None
        proposal = -20.0
        for step in range(round(duration / STEP)):
            inputs = around(step * STEP, car)
            if mpc and altitude and step % MPC_STEPS == 0:
                proposal = proposed(mpc, car, inputs.set_speed, altitude)
            inputs = inputs._replace(acceleration=car.acceleration, speed=car.speed, proposal=proposal)
            outputs = AccOutputs(*acc.step(inputs))
            yield Moment(step * STEP, car, inputs, outputs)
            car = car.driven(outputs.request, slope(altitude, car.way) if altitude else 0.0)


def proposed(mpc: Running, car: Car, set_speed: float, altitude: Altitude) -> float:
    """Return the proposal of EcoControlMpc."""
    ahead = tuple(altitude(car.way + SPACING * point) for point in range(POINTS))
    outputs = MpcOutputs(*mpc.step(MpcInputs(speed=car.speed, set_speed=set_speed, altitudes=ahead).values))
    assert not outputs.no_solution
    return outputs.proposal


def slope(altitude: Altitude, way: float) -> float:
    return altitude(way + 0.5) - altitude(way - 0.5)


class Leader:
    """A vehicle ahead, which drives at a given speed at each time."""

    def __init__(self, way: float, speed: Callable[[float], float]) -> None:
        self.way, self._speed = way, speed

    def gap(self, time: float, car: Car) -> float:
        """The distance to it, to the decimeter as a radar tells it. Called once a step: it drives on."""
        gap = self.way - car.way
        self.way += self._speed(time) * STEP
        return max(0.1, round(gap, 1))
