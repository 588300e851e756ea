"""Ten minutes on a road with hills and curves, with and without a vehicle ahead, and with faults on the way."""

import json
import random
from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from scripts.drive.road import altitude, curvature
from scripts.drive.schedule import Changes, at, between
from scripts.drive.trace import MILLISECOND, Gap, Message, damaged, number, write
from scripts.drive.vehicle import STEP, Motion, driven

SPEED = "Vehicle.Speed"
ACCELERATION = "Vehicle.Acceleration.Longitudinal"
BRAKE = "Vehicle.Chassis.Brake.CylP"
STEERING = "Vehicle.Chassis.Steering.WhlAg"
DISTANCE = "Vehicle.ADAS.ObstacleDetection.Front.Center.Distance"
SET_SPEED = "Vehicle.ADAS.CruiseControl.SpeedSet"
ENABLED = "Vehicle.ADAS.EcoControl.IsEnabled"
UNIT = "Vehicle.ADAS.Map.DFS.MapDataSpdUnitTyp"
HORIZON = "Vehicle.ADAS.Map.Horizon.Altitude"
MASS = "Vehicle.Mass"
ACC_MODE = "CoreAcc_Mode_In"
MPC_MODE = "EcoControlMpc_Mode_In"
COLUMNS = (SPEED, ACCELERATION, BRAKE, STEERING, DISTANCE, SET_SPEED, ENABLED, UNIT, HORIZON, MASS, ACC_MODE, MPC_MODE)

DURATION = 600
STEPS = round(DURATION / STEP)
HORIZON_STEPS = 10
"""The map tells the road ahead every 500 ms."""
POINTS, SPACING = 50, 20.0
STEERING_RATIO, WHEELBASE, CHARACTERISTIC_SPEED = 15.0, 3.0, 28.0

SET_SPEEDS: Changes[int] = (
    (0, 0), (24, 80), (70, 100), (105, 120), (232, 100), (290, 120), (356, 110), (476, 100), (520, 115), (576, 0),
)  # fmt: skip
"""In km/h, as the driver sets them; 0 = none."""
TARGETS: Changes[float] = (
    (0, 0), (3, 50), (24, 80), (70, 100), (105, 120), (232, 100), (290, 120), (345, 70), (348.5, 90), (356, 110), (476, 100),
    (520, 115), (576, 0),
)  # fmt: skip
"""Speeds that were driven, where road and traffic let them."""
FOOT_ON_THE_BRAKE = ((345.0, 348.5), (576.0, 600.0))
SWITCHED_ON: Changes[bool] = (
    (0, False),
    (22, True),
    (306, False),
    (308, True),
    (352, False),
    (354, True),
    (575, False),
)
UNITS: Changes[str] = ((0, "KM_PER_HOUR"), (500, "NOT_IN_MAP"), (530, "KM_PER_HOUR"))
ACC_MODES: Changes[str] = ((0, "OFF"), (5, "STANDBY"), (20, "ACTIVE"), (588, "STANDBY"), (594, "OFF"))
MPC_MODES: Changes[str] = (
    (0, "OFF"), (5, "STANDBY"), (30, "ACTIVE"), (555, "STANDBY"), (563, "ACTIVE"), (588, "STANDBY"), (594, "OFF"),
)  # fmt: skip
FAULTS = (
    Gap(BRAKE, 300.0, 301.2),
    Gap(STEERING, 330.0, 332.0, "20.5"),
    Gap(HORIZON, 370.0, 373.0),
    Gap(ACCELERATION, 385.0, 385.15, "nan"),
    Gap(SPEED, 388.0, 388.1, "nan"),
    Gap(HORIZON, 482.0, 490.0),
    Gap(HORIZON, 512.0, 514.5, json.dumps([600.0 * (point % 2) for point in range(POINTS)], separators=(",", ":"))),
    Gap(STEERING, 536.0, 537.5),
)


class Leader(NamedTuple):
    """A vehicle that drives ahead for a while."""

    begin: float
    end: float
    gap: float
    """When it comes, in meters."""
    speeds: Sequence[tuple[float, float]]
    """In km/h, by time; straight lines between them."""


LEADERS = (
    Leader(150, 228, 110, ((150, 96), (186, 96), (190, 60), (200, 60), (212, 92), (228, 92))),
    Leader(398, 474, 62, ((398, 92), (408, 86), (424, 0), (436, 0), (450, 62), (474, 78))),
    Leader(540, 552, 70, ((540, 104), (552, 118))),
)


class Moment(NamedTuple):
    """Return the values at a time."""

    step: int
    motion: Motion
    gap: float
    """To the vehicle ahead; 0 = none."""

    @property
    def time(self) -> float:
        return self.step * STEP


def moments() -> Iterator[Moment]:
    """The drive, in steps of 50 ms."""
    motion, leader, lead = Motion(0.0, 0.0, 0.0), None, 0.0
    for step in range(STEPS):
        time = step * STEP
        present = next((each for each in LEADERS if each.begin <= time < each.end), None)
        if present != leader:
            leader, lead = present, motion.way + (present.gap if present else 0.0)
        speed_ahead = between(leader.speeds, time) / 3.6 if leader else 0.0
        gap = lead - motion.way if leader else 0.0
        yield Moment(step, motion, gap)
        motion = driven(motion, at(TARGETS, time) / 3.6, (gap, speed_ahead) if leader else None)
        lead += speed_ahead * STEP


def steering_angle(motion: Motion) -> float:
    """Angle of the steering wheel, in radians."""
    slip = motion.speed / CHARACTERISTIC_SPEED
    return STEERING_RATIO * WHEELBASE * curvature(motion.way) * (1.0 + slip * slip)


def brake_pressure(moment: Moment) -> float:
    """Pressure of the driver's foot, in bar."""
    pressed = any(begin <= moment.time < end for begin, end in FOOT_ON_THE_BRAKE)
    return max(1.0, -7.0 * moment.motion.acceleration) if pressed else 0.0


def horizon(way: float) -> str:
    """Altitudes of the road ahead, as a JSON list."""
    return f"[{','.join(number(altitude(way + SPACING * point), 2) for point in range(POINTS))}]"


def chassis(drive: Iterable[Moment], noise: random.Random) -> Iterator[Message]:
    """Every 50 ms."""
    for moment in drive:
        time = moment.step * 50 * MILLISECOND + 10 * MILLISECOND
        motion = moment.motion
        yield Message(time, SPEED, number(max(0.0, motion.speed * 3.6 + 0.04 * (noise.random() - 0.5)), 2))
        yield Message(time, ACCELERATION, number(motion.acceleration + 0.06 * (noise.random() - 0.5), 2))
        yield Message(time, BRAKE, number(0.3 * round(brake_pressure(moment) / 0.3), 1))
        yield Message(time, STEERING, number(steering_angle(motion) + 0.004 * (noise.random() - 0.5), 3))


def radar(drive: Iterable[Moment], noise: random.Random) -> Iterator[Message]:
    """Every 50 ms while there is a vehicle ahead, and once when there is none any more."""
    had = True
    for moment in drive:
        time = moment.step * 50 * MILLISECOND + 30 * MILLISECOND
        if moment.gap > 0.0:
            yield Message(time, DISTANCE, number(moment.gap + 0.1 * (noise.random() - 0.5), 2))
        elif had:
            yield Message(time, DISTANCE, "0")
        had = moment.gap > 0.0


def road_ahead(drive: Iterable[Moment]) -> Iterator[Message]:
    for moment in drive:
        if moment.step % HORIZON_STEPS == 0:
            yield Message(moment.step * 50 * MILLISECOND + 5 * MILLISECOND, HORIZON, horizon(moment.motion.way))


def switches() -> Iterator[Message]:
    """Values that change by hand or by the system."""
    yield Message(0, MASS, "2495")
    for time, speed in SET_SPEEDS:
        yield Message(round(time * 1000) * MILLISECOND, SET_SPEED, str(speed))
    for time, is_on in SWITCHED_ON:
        yield Message(round(time * 1000) * MILLISECOND, ENABLED, str(is_on).lower())
    for column, changes in ((UNIT, UNITS), (ACC_MODE, ACC_MODES), (MPC_MODE, MPC_MODES)):
        for time, word in changes:
            yield Message(round(time * 1000) * MILLISECOND, column, word)


def recording() -> str:
    """The drive as CSV."""
    drive, noise = tuple(moments()), random.Random(1)
    messages = [*chassis(drive, noise), *radar(drive, noise), *road_ahead(drive), *switches()]
    return write(COLUMNS, damaged(messages, FAULTS))
