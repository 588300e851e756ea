"""The recorded drive of EcoControl as candump logs it, made from drive.csv with cantools and the CAN database of the example."""

import csv
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import cantools

EXAMPLE = Path(__file__).parents[1] / "examples/ecocontrol"
LOG = "examples/ecocontrol/can/drive.log.gz"
SENT: Mapping[str, Mapping[str, str]] = {
    "Motion": {
        "Vehicle.Speed": "VehicleSpeed",
        "Vehicle.Acceleration.Longitudinal": "LongitudinalAcceleration",
    },
    "Brake": {"Vehicle.Chassis.Brake.CylP": "BrakePressure"},
    "Steering": {"Vehicle.Chassis.Steering.WhlAg": "SteeringAngle"},
    "Obstacle": {"Vehicle.ADAS.ObstacleDetection.Front.Center.Distance": "ObstacleDistance"},
    "CruiseControl": {"Vehicle.ADAS.CruiseControl.SpeedSet": "SetSpeed"},
    "Switches": {"Vehicle.ADAS.EcoControl.IsEnabled": "EcoControlSwitch"},
    "MapData": {"Vehicle.ADAS.Map.DFS.MapDataSpdUnitTyp": "SpeedUnit"},
    "Load": {"Vehicle.Mass": "VehicleMass"},
    "CoreAccMode": {"CoreAcc_Mode_In": "Mode"},
    "EcoControlMpcMode": {"EcoControlMpc_Mode_In": "Mode"},
}
"""Messages, and which column of the drive each of their signals is."""
_BOOLEANS = {"false": 0, "true": 1}


def files() -> Mapping[str, str]:
    """The log, as text: it is kept packed."""
    database: Any = cantools.database.load_file(EXAMPLE / "can/ecocontrol.dbc", "dbc")
    with (EXAMPLE / "drive.csv").open(newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    return {LOG: "".join(_lines(database, rows))}


def _lines(database: Any, rows: Sequence[Mapping[str, str]]) -> Iterator[str]:
    for row in rows:
        for name, signals in SENT.items():
            given = {signal: _value(row[column]) for column, signal in signals.items() if row[column]}
            if given:
                assert len(given) == len(signals), f"{row['time']}: {name} must have all of its signals"
                message = database.get_message_by_name(name)
                data = message.encode(given, strict=False)
                yield f"({row['time'][:-3]}) can0 {message.frame_id:03X}#{data.hex().upper()}\n"


def _value(cell: str) -> float | str:
    if cell in _BOOLEANS:
        return _BOOLEANS[cell]
    try:
        return float(cell)
    except ValueError:
        return cell
