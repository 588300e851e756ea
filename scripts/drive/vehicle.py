"""The driving of the recorded vehicle: an intelligent driver, who slows down before curves and keeps a distance."""

from math import sqrt
from typing import NamedTuple

from scripts.drive.road import altitude, curvature

STEP = 0.05
"""Seconds."""
LARGEST_ACCELERATION = 1.4
COMFORTABLE_BRAKING = 1.8
HARDEST_BRAKING = 4.0
TIME_GAP = 1.4
STANDSTILL_GAP = 4.5
LATERAL_ACCELERATION = 2.4
CURVE_BRAKING = 1.3
SLOPE_FELT = 0.15
"""Share of the slope that the powertrain does not make up for."""
SIGHT = range(0, 200, 20)
"""Meters at which a driver looks for curves."""


class Motion(NamedTuple):
    """Position, speed and acceleration of the vehicle."""

    way: float
    speed: float
    acceleration: float


def moved(motion: Motion, wanted: float) -> Motion:
    """Return the state a step later; the powertrain follows the requested acceleration with a lag of 0.3 s."""
    acceleration = motion.acceleration + (wanted - motion.acceleration) * STEP / 0.3
    speed = max(0.0, motion.speed + acceleration * STEP)
    if speed == 0.0:
        acceleration = max(0.0, acceleration)
    return Motion(motion.way + (motion.speed + speed) / 2 * STEP, speed, acceleration)


def free(motion: Motion, target: float) -> float:
    """The acceleration towards a speed."""
    if target <= 0.0:
        return -COMFORTABLE_BRAKING if motion.speed > 0.0 else 0.0
    share = motion.speed / target
    if share <= 1.0:
        return LARGEST_ACCELERATION * (1.0 - share * share * share * share)
    return max(-COMFORTABLE_BRAKING, 0.6 * (target - motion.speed))


def curve_speed(motion: Motion) -> float:
    """The speed from which the curves in sight can be taken."""
    return min(sqrt(allowed(motion.way + ahead) + 2.0 * CURVE_BRAKING * ahead) for ahead in SIGHT)


def allowed(way: float) -> float:
    """The square of the speed that a curve allows."""
    return LATERAL_ACCELERATION / max(1e-5, abs(curvature(way)))


def keep_distance(motion: Motion, gap: float, speed_ahead: float) -> float:
    """By how much the vehicle ahead reduces the acceleration (intelligent driver model)."""
    closing = motion.speed * (motion.speed - speed_ahead) / (2.0 * sqrt(LARGEST_ACCELERATION * COMFORTABLE_BRAKING))
    share = (STANDSTILL_GAP + max(0.0, motion.speed * TIME_GAP + closing)) / max(gap, 0.5)
    return LARGEST_ACCELERATION * share * share


def driven(motion: Motion, target: float, ahead: tuple[float, float] | None) -> Motion:
    """A step later, with the gap and the speed of the vehicle ahead if there is one."""
    wanted = free(motion, min(target, curve_speed(motion)))
    if ahead:
        wanted -= keep_distance(motion, *ahead)
    return moved(motion, max(-HARDEST_BRAKING, wanted - SLOPE_FELT * 9.81 * slope(motion.way)))


def slope(way: float) -> float:
    """Altitudes of the next meters of the road."""
    return (altitude(way + 5.0) - altitude(way)) / 5.0
