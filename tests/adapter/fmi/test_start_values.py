"""Start values of an FMU are in the unit of the catalogue, whatever the code has: an importer may set an input to its start."""

import json

import pytest

from sigcat.cli import main

FUNCTION = """\
function: Fan
description: Cools the cabin.
responsible: Cabin team
code: {signature: globals, sources: [fan.c], headers: [fan.h]}
define:
  data:
    Vehicle.Cabin.Fan: {type: branch, description: Fan.}
    Vehicle.Cabin.Fan.Temperatures: {datatype: 'float[]', arraysize: 2, unit: Celsius, description: Temperatures.}
    Vehicle.Cabin.Fan.Request: {datatype: string, allowed: [NONE, LOW, HIGH], description: Request.}
    Vehicle.Cabin.Fan.Level: {datatype: float, unit: percent, description: Level.}
  parameters:
    Limit: {datatype: float, unit: Celsius, min: 0, max: 50, default: 24, asil: QM, description: Limit.}
  scheduling:
    Step: {cycleTime: 20, asil: QM, description: Sets the level.}
components:
  - name: Fan
    runnables:
      - interface: Step
        data:
          - {path: Vehicle.Speed, role: consumed, variable: speed, unit: m/s, init: 10, max: 100, asil: QM}
          - {path: Vehicle.LowVoltageBattery.CurrentVoltage, role: consumed, variable: voltage, datatype: uint16,
             factor: 0.01, min: 0, max: 20, init: 12, asil: QM}
          - {path: Vehicle.Cabin.Fan.Temperatures, role: consumed, provider: Seats, variable: t, init: [20, 21], asil: QM}
          - {path: Vehicle.Cabin.Fan.Request, role: consumed, provider: Panel, variable: r,
             values: {NONE: 7, LOW: 8, HIGH: 9}, init: LOW, asil: QM}
          - {path: Vehicle.Cabin.Fan.Level, role: provided, variable: level, datatype: uint8, factor: 0.5, init: 50, asil: QM}
        parameters: [{path: Limit, variable: limit, datatype: uint16, factor: 0.1}]
"""
STARTS = {
    "Vehicle.Speed": [36.0],
    "Vehicle.LowVoltageBattery.CurrentVoltage": [12.0],
    "Vehicle.Cabin.Fan.Temperatures": [20.0, 21.0],
    "Vehicle.Cabin.Fan.Request": [1],
    "Vehicle.Cabin.Fan.Level": [50.0],
    "Vehicle.Function.Fan.Parameter.Limit": [24.0],
}


@pytest.fixture(scope="module")
def starts(tmp_path_factory):
    folder = tmp_path_factory.mktemp("fan")
    (folder / "function.yaml").write_text(FUNCTION)
    for name in ("fan.c", "fan.h"):
        (folder / name).write_text("")
    assert main(["integrate", "fmi", str(folder / "function.yaml"), "--isolated", "-o", str(folder / "fmi.json")]) == 0
    document = json.loads((folder / "fmi.json").read_text())
    return {each["Name"]: each["Start"] for fmu in document["FmuList"] for each in fmu["VariableList"]}


@pytest.mark.parametrize("name", STARTS)
def test_the_start_value_is_that_of_the_declaration(starts, name):
    assert starts[name] == STARTS[name]


def test_members_of_structs_have_their_units(tmp_path):
    text = FUNCTION.replace("define:\n", TYPES, 1).replace(
        "        data:\n",
        "        data:\n          - {path: Vehicle.Cabin.Fan.Air, role: consumed, provider: Seats, variable: air, asil: QM}\n",
    )
    (tmp_path / "function.yaml").write_text(text.replace("  data:\n", AIR, 1))
    for name in ("fan.c", "fan.h"):
        (tmp_path / name).write_text("")
    for version in ("3.0", "2.0"):
        (tmp_path / "fmi.yaml").write_text(f"fmi: {{version: '{version}'}}\n")
        made = tmp_path / "fmi.json"
        options = ["--deployment", str(tmp_path / "fmi.yaml"), "--isolated", "-o", str(made)]
        assert main(["integrate", "fmi", str(tmp_path / "function.yaml"), *options]) == 0
        variables = json.loads(made.read_text())["FmuList"][0]["VariableList"]
        units = {
            each["Name"].removeprefix("Vehicle.Cabin.Fan.Air"): each.get("Unit")
            for each in variables
            if ".Air" in each["Name"]
        }
        flows = {".Flows[1].Speed": "m/s", ".Flows[2].Speed": "m/s", ".Flows[1].Count": None, ".Flows[2].Count": None}
        assert units == {".Temperature": "Celsius", **flows}


TYPES = """\
define:
  types:
    Types.Flow: {description: A flow., fields: {Speed: {datatype: float, unit: m/s, description: Speed.}, Count: {datatype: uint8, description: Count.}}}
    Types.Air:
      description: Air.
      fields:
        Temperature: {datatype: float, unit: Celsius, description: How warm it is.}
        Flows: {datatype: 'Types.Flow[]', arraysize: 2, description: Flows.}
"""
AIR = """\
  data:
    Vehicle.Cabin.Fan.Air: {datatype: Types.Air, description: Air., asil: QM}
"""
