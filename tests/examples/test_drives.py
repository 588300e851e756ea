"""The recorded drives have what the functions read from outside, in the catalogue's datatypes, and what happens on a road."""

import csv
import json
import math
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cache
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest

from tests.examples.compiled import EXAMPLES, Running
from tests.examples.signals import AccInputs, AccOutputs, MpcInputs, MpcOutputs, Status, WheelInputs, WheelOutputs
from tests.function.shipped import interfaces
from tests.function.test_build import example, step
from tests.needs import c_compiler

DRIVES = {
    "ecocontrol": ("core_acc", "eco_control_mpc"),
    "wheel_speed_calculation": ("wheel_speed_calculation",),
}
MODES = {"OFF": 0, "STANDBY": 1, "ACTIVE": 2}
UNITS = {"KM_PER_HOUR": 0, "MI_PER_HOUR": 1, "NOT_IN_MAP": 3}
KMH = 1 / 3.6

Row = Mapping[str, str]


def file(name: str) -> Path:
    return EXAMPLES / name / "drive.csv"


@cache
def rows(name: str) -> Sequence[Row]:
    with file(name).open(newline="") as lines:
        return list(csv.DictReader(lines))


@cache
def signals(name: str, role: str) -> Mapping[str, Any]:
    """Signals of this role of the functions of a drive, by path."""
    contracts = [step(example(function))["funcContractList"][0] for function in DRIVES[name]]
    listed = [signal for contract in contracts for signal in contract["SignalList"]]
    return {signal["VssPath"]: signal for signal in listed if signal["Role"] == role}


def values(name: str, column: str) -> Sequence[tuple[float, str]]:
    """Values of a column, with their times."""
    return [(float(row["time"]), row[column]) for row in rows(name) if row[column]]


@pytest.mark.parametrize("name", DRIVES)
def test_a_drive_has_every_signal_and_mode_that_comes_from_outside(name):
    from_outside = signals(name, "Consumer").keys() - signals(name, "Provider").keys()
    modes = {
        mode["Name"]
        for function in DRIVES[name]
        for mode in example(function)["ModeInterfaceList"]
        if mode["Name"].endswith("_Mode_In")
    }
    columns = rows(name)[0].keys() - {"time"}
    assert {column for column in columns if not column.endswith("_SftyCondSts")} == from_outside | modes


@pytest.mark.parametrize(("name", "duration"), [("ecocontrol", 600), ("wheel_speed_calculation", 60)])
def test_times_rise_from_0_to_the_end_with_nine_decimals(name, duration):
    times = [row["time"] for row in rows(name)]
    assert all(re.fullmatch(r"\d+\.\d{9}", time) for time in times)
    assert [float(time) for time in times] == sorted({float(time) for time in times})
    assert [float(times[0]), float(times[-1])] == pytest.approx([0.0, duration], abs=0.1)
    assert file(name).stat().st_size < 2_500_000


def is_value(column: str, text: str) -> bool:
    """Whether a cell is a value of the catalogue's datatype."""
    if column.endswith(("_Mode_In", "_SftyCondSts")):
        return text in {"OFF", "STANDBY", "ACTIVE", "NORMAL", "SERVICE", "INACTIVE"}
    definition = interfaces().nodes[column].definition.values
    if allowed := definition.get("allowed"):
        return text in allowed
    if size := definition.get("arraysize"):
        return text.startswith("[") and len(json.loads(text)) == size
    return text in {"true", "false"} if definition["datatype"] == "boolean" else isinstance(float(text), float)


@pytest.mark.parametrize("name", DRIVES)
def test_each_cell_is_empty_or_a_value_in_the_datatype_of_the_catalogue(name):
    wrong = [
        (row["time"], column, text)
        for row in rows(name)
        for column, text in row.items()
        if column != "time" and text and not is_value(column, text)
    ]
    assert wrong == []


def test_what_may_time_out_does_so():
    timed = {path: signal for path, signal in signals("ecocontrol", "Consumer").items() if signal.get("Timeout")}
    provided = signals("ecocontrol", "Provider")
    longest = {path: longest_gap("ecocontrol", path) for path in timed if path not in provided}
    assert len(longest) == 3
    assert all(gap > 0.001 * float(timed[path]["Timeout"]) for path, gap in longest.items())


def longest_gap(name: str, column: str) -> float:
    times = [time for time, _ in values(name, column)]
    return max(after - before for before, after in pairwise(times))


def test_there_are_values_out_of_range_and_none_at_all():
    angles = [float(text) for _, text in values("ecocontrol", "Vehicle.Chassis.Steering.WhlAg")]
    assert max(angles) > 16.766
    for column in ("Vehicle.Acceleration.Longitudinal", "Vehicle.Speed"):
        assert "nan" in {text for _, text in values("ecocontrol", column)}


def test_the_road_has_hills_and_curves_and_a_vehicle_ahead_comes_and_goes():
    (_, first), *_ = values("ecocontrol", "Vehicle.ADAS.Map.Horizon.Altitude")
    altitudes = [json.loads(text)[0] for _, text in values("ecocontrol", "Vehicle.ADAS.Map.Horizon.Altitude")]
    assert json.loads(first)[0] == 260
    assert max(altitudes) - min(altitudes[:900]) > 40
    angles = [float(text) for _, text in values("ecocontrol", "Vehicle.Chassis.Steering.WhlAg")]
    assert min(angles) < -0.4 < 0.4 < sorted(angles)[-100]
    distances = [
        float(text) for _, text in values("ecocontrol", "Vehicle.ADAS.ObstacleDetection.Front.Center.Distance")
    ]
    assert distances.count(0.0) == 4
    assert min(distance for distance in distances if distance) > 3.0


def arrived(name: str, period: float, duration: float = 600) -> Iterator[dict[str, str]]:
    """The last value of each column, in steps of a period."""
    last: dict[str, str] = {}
    waiting = iter(rows(name))
    row = next(waiting, None)
    for index in range(round(duration / period)):
        while row and float(row["time"]) <= index * period:
            last |= {column: text for column, text in row.items() if text}
            row = next(waiting, None)
        yield last


def acc_inputs(last: Row, proposal: float) -> AccInputs:
    number: Callable[[str], float] = lambda path: float(last.get(path, "nan"))  # noqa: E731
    return AccInputs(
        brake_pressure=number("Vehicle.Chassis.Brake.CylP"),
        steering_angle=number("Vehicle.Chassis.Steering.WhlAg"),
        acceleration=number("Vehicle.Acceleration.Longitudinal"),
        speed=number("Vehicle.Speed") * KMH,
        set_speed=number("Vehicle.ADAS.CruiseControl.SpeedSet") * KMH,
        is_enabled=last["Vehicle.ADAS.EcoControl.IsEnabled"] == "true",
        unit=UNITS[last["Vehicle.ADAS.Map.DFS.MapDataSpdUnitTyp"]],
        distance=number("Vehicle.ADAS.ObstacleDetection.Front.Center.Distance"),
        proposal=proposal,
        mode=MODES[last["CoreAcc_Mode_In"]],
    )


def wheel_inputs(last: Row) -> WheelInputs:
    wheels = (
        f"Vehicle.Chassis.Axle.Row{row}.Wheel.{side}.AngularSpeed" for row in (1, 2) for side in ("Left", "Right")
    )
    turning = WheelInputs(*(math.radians(float(last.get(wheel, "0"))) for wheel in wheels))
    return turning._replace(
        mode={"OFF": 0, "NORMAL": 1, "SERVICE": 2}[last["WheelSpeedCalculation_Mode_In"]],
        rear_left_invalid=last["WhlSpdRLInvalid_SftyCondSts"] == "ACTIVE",
    )


def mpc_inputs(last: Row, acc: AccInputs) -> MpcInputs:
    return MpcInputs(
        is_enabled=acc.is_enabled,
        speed=acc.speed,
        set_speed=acc.set_speed,
        mode=MODES[last["EcoControlMpc_Mode_In"]],
        altitudes=tuple(json.loads(last.get("Vehicle.ADAS.Map.Horizon.Altitude", json.dumps([0.0] * 50)))),
    )


@c_compiler
def test_the_wheels_fail_and_recover_on_their_drive():
    """Without an adapter: the error is reported, and only the reaction from outside makes other wheels replace it."""
    with Running("wheel_speed_calculation") as wheels:
        wheels.step(())
        told = [WheelOutputs(*wheels.step(wheel_inputs(last))) for last in arrived("wheel_speed_calculation", 0.01, 60)]
        stored = WheelOutputs(*wheels.end()).range_errors
    begins = [after.range_error - before.range_error for before, after in pairwise(told)].count(1)
    assert begins == stored - 7 == 5
    straight, curve, stand = told[2200], told[2700], told[5150]
    assert [output.mode for output in (told[50], told[500], straight, curve, stand)] == [0, 1, 2, 2, 2]
    assert straight.rear_left == pytest.approx(20_000, abs=50)
    assert curve.rear_left == pytest.approx(20_150, abs=50)
    assert stand.rear_left - stand.front_left == pytest.approx(3_000, abs=50)


@c_compiler
def test_the_functions_find_on_the_drive_what_they_are_for():
    """Without an adapter: nothing times out, and what is out of range comes as it is."""
    told: list[tuple[AccOutputs, MpcOutputs]] = []
    with Running("core_acc") as acc, Running("eco_control_mpc") as mpc:
        planned = MpcOutputs(-20.0, 0, 0)
        for index, last in enumerate(arrived("ecocontrol", 0.05)):
            inputs = acc_inputs(last, planned.proposal)
            if index % 10 == 0:
                planned = MpcOutputs(*mpc.step(mpc_inputs(last, inputs).values))
            told.append((AccOutputs(*acc.step(inputs)), planned))
    states = {output.status for output, _ in told}
    assert states >= {*range(Status.STANDBY, Status.FAULT), Status.ECO + Status.NO_CURVE_LIMIT}
    assert all(math.isfinite(output.request) and -5.0 <= output.request <= 2.0 for output, _ in told)
    without_plan = [index * 0.05 for index, (_, output) in enumerate(told) if output.no_solution]
    assert [without_plan[0], without_plan[-1]] == pytest.approx([512.5, 514.5], abs=0.5)
