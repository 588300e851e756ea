"""One minute of four wheels: a curve, a sensor that fails three times, and a test stand."""

import random
from collections.abc import Iterator
from math import pi

from scripts.drive.schedule import Changes, between
from scripts.drive.trace import MILLISECOND, Gap, Message, damaged, number, write

WHEELS = tuple(
    f"Vehicle.Chassis.Axle.Row{row}.Wheel.{side}.AngularSpeed" for row in (1, 2) for side in ("Left", "Right")
)
FRONT_RIGHT, REAR_LEFT = WHEELS[1], WHEELS[2]
MODE = "WheelSpeedCalculation_Mode_In"
REACTION = "WhlSpdRLInvalid_SftyCondSts"
COLUMNS = (*WHEELS, MODE, REACTION)

STEPS = 3000
"""Step of 20 ms."""
TIRE = 0.65
"""Diameter in meters."""
SPEEDS = ((0.0, 0.0), (3.0, 0.0), (20.0, 100.0), (34.0, 100.0), (44.0, 0.0))
"""In km/h, by time."""
CURVE = ((0.0, 0.0), (24.0, 0.0), (26.0, 1.0), (30.0, 1.0), (32.0, 0.0))
OUTER, INNER = 1.015, 0.985
"""Amplitude of the speed in the curve."""
TEST_STAND = ((0.0, 0.0), (47.0, 0.0), (49.0, 30.0), (53.0, 30.0), (54.5, 0.0))
"""Speed of the rear left wheel in km/h, while the others stand."""
MODES: Changes[str] = ((0, "OFF"), (1, "NORMAL"), (46, "SERVICE"), (55, "NORMAL"), (58, "OFF"))
REACTIONS: Changes[str] = ((0, "INACTIVE"), (21, "ACTIVE"), (28, "INACTIVE"), (50, "ACTIVE"), (52, "INACTIVE"))
FAULTS = (
    Gap(REAR_LEFT, 33.0, 33.5, "20000"),
    Gap(REAR_LEFT, 36.0, 36.03, "20000"),
    Gap(REAR_LEFT, 37.0, 37.4, "20000"),
    Gap(REAR_LEFT, 39.5, 40.0, "-20000"),
    Gap(FRONT_RIGHT, 42.0, 42.06, "nan"),
)


def wheel_speed(wheel: str, time: float) -> float:
    """In km/h."""
    change = (OUTER if "Left" in wheel else INNER) - 1.0
    speed = between(SPEEDS, time) * (1.0 + change * between(CURVE, time))
    return speed + (between(TEST_STAND, time) if wheel == REAR_LEFT else 0.0)


def wheels(noise: random.Random) -> Iterator[Message]:
    """Every 20 ms, in degrees/s."""
    for step in range(STEPS):
        for wheel in WHEELS:
            turning = wheel_speed(wheel, step * 0.02) / 3.6 * 2.0 / TIRE * 180.0 / pi
            jitter = 2.0 * (noise.random() - 0.5) if turning else 0.0
            yield Message(step * 20 * MILLISECOND + MILLISECOND, wheel, number(turning + jitter, 1))


def switches() -> Iterator[Message]:
    for column, changes in ((MODE, MODES), (REACTION, REACTIONS)):
        for time, word in changes:
            yield Message(round(time * 1000) * MILLISECOND, column, word)


def recording() -> str:
    """The drive as CSV."""
    return write(COLUMNS, damaged([*wheels(random.Random(1)), *switches()], FAULTS))
