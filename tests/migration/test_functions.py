"""A function.yaml for the new tree: the C code stays untouched, since its variables keep their units and datatypes."""

import pytest

from tests.needs import c_compiler

HEAD = """\
function: Cooler
description: Cools the engine.
responsible: Engine team
code: {signature: globals, sources: [cooler.c], headers: [cooler.h]}
components:
  - name: Cooler
    runnables:
      - interface: Step
        symbol: step
        data:
"""
TAIL = "define:\n  scheduling:\n    Step: {description: Cools., cycleTime: 10, asil: QM}\n"

ENTRIES = {
    "a path, a datatype and its range": (
        "          - path: Vehicle.Coolant  # here\n            role: consumed\n            variable: t\n",
        (
            "          - path: Vehicle.Engine.Coolant  # here\n            datatype: int16\n            min: -32768\n"
            "            max: 32767\n            role: consumed\n            variable: t\n"
        ),
    ),
    "a unit": (
        "          - path: Vehicle.Speed\n            role: consumed\n            variable: v\n            max: 250\n",
        (
            "          - path: Vehicle.Speed\n            unit: km/h\n            role: consumed\n            variable: v\n"
            "            max: 250\n"
        ),
    ),
    "a unit of its own": (
        "          - {path: Vehicle.Speed, unit: cm/s, role: consumed, variable: v}\n",
        "          - {path: Vehicle.Speed, unit: cm/s, role: consumed, variable: v}\n",
    ),
    "a unit and a datatype in braces": (
        "          - {path: Vehicle.Trip, role: provided, variable: s}\n",
        "          - {path: Vehicle.Trip, unit: km, datatype: float, role: provided, variable: s}\n",
    ),
    "an instance": (
        "          - {path: Vehicle.Door.Row1.Right.IsOpen, role: consumed, variable: d}\n",
        "          - {path: Vehicle.Door.Row1.PassengerSide.IsOpen, role: consumed, variable: d}\n",
    ),
}


@pytest.mark.parametrize("case", ENTRIES)
def test_an_entry_keeps_its_variable(sides, case):
    before, after = ENTRIES[case]
    sides.write("function.yaml", HEAD + before + TAIL)
    result = sides.run()
    assert (result.status, sides.text("function.yaml")) == (0, HEAD + after + TAIL), result.messages
    assert sides.run().status == 0
    assert sides.text("function.yaml") == HEAD + after + TAIL


def test_a_signal_without_a_name_keeps_the_one_that_its_path_gave_it(sides):
    sides.write("function.yaml", f"{HEAD}          - {{path: Vehicle.Same, role: consumed, variable: x}}\n{TAIL}")
    assert sides.run("--accept-guesses").status == 0
    assert "{path: Vehicle.Renamed, name: Same, role: consumed, variable: x}" in sides.text("function.yaml")


def test_own_signals_move_with_their_branch(sides):
    own = "          - {path: Vehicle.Lamp.Own, role: provided, variable: x}\n"
    define = TAIL + "  data:\n    Vehicle.Lamp.Own: {datatype: float, description: Own.}\n"
    sides.write("function.yaml", HEAD + own + define)
    assert sides.run().status == 0
    assert sides.text("function.yaml") == (HEAD + own + define).replace("Vehicle.Lamp.Own", "Vehicle.Light.Own")


@pytest.mark.parametrize("path", ["Vehicle.Level", "Vehicle.Gone", "Vehicle.Door.Row1.Left.IsOpen"])
def test_what_is_not_certain_stays(sides, path):
    text = f"{HEAD}          - {{path: {path}, role: consumed, variable: x}}\n{TAIL}"
    sides.write("function.yaml", text)
    result = sides.run()
    assert (result.status, sides.text("function.yaml")) == (1, text)
    assert f"{path}" in result.messages


CODE = """\
#include "cooler.h"
float v; short t; float s; float out;
void step(void) { out = v * 2.0f + (float)t; s = v / 3.0f; }
"""
HEADER = "extern float v; extern short t; extern float s; extern float out;\nvoid step(void);\n"
SIGNALS = """\
          - {path: Vehicle.Speed, role: consumed, variable: v}
          - {path: Vehicle.Coolant, role: consumed, variable: t}
          - {path: Vehicle.Cooling, role: provided, variable: out}
"""
OWN = "  data:\n    Vehicle.Cooling: {datatype: float, asil: QM, description: Cooling.}\n"
TRACE = "time,Vehicle.Speed,Vehicle.Coolant\n" + "".join(
    f"{n / 100},{speed},{n - 40}\n" for n, speed in enumerate((0, 100, 33.3, 250, 7.125, 129.9, 0.1, 55, 88.8, 36))
)


@c_compiler
@pytest.mark.real
def test_the_migrated_function_gives_the_same_bits_with_the_migrated_trace(sides, tmp_path):
    from sigcat.cli import main

    trees = tmp_path / "trees"
    new = trees / "new.vspec"  # a float in m/s would not hold the bits of one in km/h
    new.write_text(
        new.read_text().replace("datatype: float, unit: m/s", "datatype: double, min: 0, max: 100, unit: m/s")
    )
    for name, text in (("cooler.c", CODE), ("cooler.h", HEADER), ("drive.csv", TRACE)):
        sides.write(name, text)
    sides.write("function.yaml", HEAD + SIGNALS + TAIL + OWN)
    run = ("simulate", "function.yaml", "--trace", "drive.csv", "--isolated")
    assert main([*run, "-s", str(trees / "old.vspec"), "-o", str(tmp_path / "before.csv")]) == 0
    assert sides.run().status == 0
    assert sides.text("cooler.c") == CODE
    assert sides.text("drive.csv") != TRACE
    assert main([*run, "-s", str(trees / "new.vspec"), "-o", str(tmp_path / "after.csv")]) == 0
    assert (tmp_path / "before.csv").read_bytes() == (tmp_path / "after.csv").read_bytes()
