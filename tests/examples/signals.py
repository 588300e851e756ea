"""Inputs and outputs of the programs in `programs/`, with inputs that mean nothing special."""

from typing import NamedTuple

OFF, STANDBY, ACTIVE, FAULT = range(4)
NORMAL, SERVICE = 1, 2
DEGRADED = 2
KM_PER_HOUR, MI_PER_HOUR, NOT_IN_MAP = 0, 1, 3
NO_PROPOSAL = -20.0
POINTS, SPACING = 50, 20.0


class AccInputs(NamedTuple):
    brake_pressure: float = 0.0
    steering_angle: float = 0.0
    acceleration: float = 0.0
    speed: float = 30.0
    mass: float = 2495.0
    set_speed: float = 30.0
    is_enabled: float = 1
    unit: float = KM_PER_HOUR
    distance: float = 0.0
    proposal: float = NO_PROPOSAL
    mode: float = ACTIVE
    invalid: float = 0
    brake_missing: float = 0
    angle_missing: float = 0
    proposal_missing: float = 0
    largest_lateral_acceleration: float = 3.0


class AccOutputs(NamedTuple):
    request: float
    mode: float
    status: float


class Status:
    """Values of AsmAcc_AccIntSts."""

    NOT_STARTED, STANDBY, RELEASED, SPEED, ECO, FOLLOW, STANDSTILL, CURVE, FAULT = range(9)
    NO_CURVE_LIMIT = 8


class MpcInputs(NamedTuple):
    instance: float = 0
    is_enabled: float = 1
    speed: float = 30.0
    set_speed: float = 30.0
    mode: float = ACTIVE
    invalid: float = 0
    horizon_missing: float = 0
    mass: float = 2495.0
    spacing: float = SPACING
    energy_weight: float = 0.6
    altitudes: tuple[float, ...] = (0.0,) * POINTS

    @property
    def values(self) -> tuple[float, ...]:
        return (*self[:-1], *self.altitudes)


class MpcOutputs(NamedTuple):
    proposal: float
    mode: float
    no_solution: float


class WheelInputs(NamedTuple):
    front_left: float = 0.0
    front_right: float = 0.0
    rear_left: float = 0.0
    rear_right: float = 0.0
    mode: float = NORMAL
    rear_left_invalid: float = 0
    range_error_known: float = 0
    front_diameter: float = 650.0
    rear_diameter: float = 650.0
    largest_speed: float = 360.0


class WheelOutputs(NamedTuple):
    front_left: float
    front_right: float
    rear_left: float
    rear_right: float
    mode: float
    range_error: float
    range_errors: float
