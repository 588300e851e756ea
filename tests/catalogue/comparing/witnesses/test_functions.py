"""A function that uses signals of the old tree: C code and SOME/IP break if, and only if, what is generated for it differs."""

import json
import re
import subprocess
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest

from sigcat.catalogue.comparing.bindings import Binding, form_of
from sigcat.catalogue.comparing.changes import worst
from sigcat.catalogue.comparing.diff import compare
from sigcat.catalogue.comparing.sides import read_side
from sigcat.cli import main
from sigcat.errors import NotFound
from tests.catalogue.trees import ROOT
from tests.needs import C_COMPILERS, c_compiler

FUNCTION = """\
function: Echo
description: Receives.
responsible: Demo team
code: {signature: globals, sources: [echo.c], headers: [echo.h]}
components:
  - name: Echo
    runnables:
      - {interface: Init, symbol: echo_init}
      - interface: Step
        symbol: echo_step
        data:
          - {path: Vehicle.Speed, role: consumed, variable: in_speed, provider: Trace}
          - {path: Vehicle.Mode, role: consumed, variable: in_mode, provider: Trace}
          - {path: Vehicle.Level, role: consumed, variable: in_level, provider: Trace}
          - {path: Vehicle.Temperatures, role: consumed, variable: in_temperatures, provider: Trace}
      - {interface: Terminate, symbol: echo_terminate}
define:
  scheduling:
    Init: {description: Prepares., asil: QM, priority: 1, scheduling: Preemptive}
    Step: {description: Works., asil: QM, cycleTime: 20, priority: 10, scheduling: Preemptive}
    Terminate: {description: Ends., asil: QM, priority: 1, scheduling: Preemptive}
"""
HEADER = "#include <stdint.h>\nextern float in_speed, in_temperatures[4]; extern uint8_t in_mode, in_level;\nvoid echo_init(void); void echo_step(void); void echo_terminate(void);\n"
SIGNALS: Mapping[str, Mapping[str, Any]] = {
    "Speed": {"type": "sensor", "datatype": "float", "unit": "km/h"},
    "Mode": {"type": "sensor", "datatype": "string", "allowed": "[ECO, SPORT, SNOW]"},
    "Level": {"type": "sensor", "datatype": "uint8"},
    "Temperatures": {"type": "sensor", "datatype": "float[]", "arraysize": 4},
}
OTHER = {"Other": {"type": "sensor", "datatype": "float"}}
CHANGES: Mapping[str, Mapping[str, Mapping[str, Any]]] = {
    "a new signal before the others": {**OTHER, **SIGNALS},
    "another order": dict(reversed(list(SIGNALS.items()))),
    "a text": {**SIGNALS, "Speed": {**SIGNALS["Speed"], "comment": "New."}},
    "another unit": {**SIGNALS, "Speed": {**SIGNALS["Speed"], "unit": "m/s"}},
    "a range": {**SIGNALS, "Speed": {**SIGNALS["Speed"], "max": 250}},
    "a removed signal": {name: values for name, values in SIGNALS.items() if name != "Level"},
    "a moved signal": {**{("Stage" if name == "Level" else name): values for name, values in SIGNALS.items()}},
    "a wider integer": {**SIGNALS, "Level": {**SIGNALS["Level"], "datatype": "uint16"}},
    "a double": {**SIGNALS, "Speed": {**SIGNALS["Speed"], "datatype": "double"}},
    "a longer array": {**SIGNALS, "Temperatures": {**SIGNALS["Temperatures"], "arraysize": 8}},
    "a value at the end": {**SIGNALS, "Mode": {**SIGNALS["Mode"], "allowed": "[ECO, SPORT, SNOW, ICE]"}},
    "a value before the others": {**SIGNALS, "Mode": {**SIGNALS["Mode"], "allowed": "[ICE, ECO, SPORT, SNOW]"}},
    "values in another order": {**SIGNALS, "Mode": {**SIGNALS["Mode"], "allowed": "[SPORT, ECO, SNOW]"}},
}


def tree(signals: Mapping[str, Mapping[str, Any]]) -> str:
    lines = (
        f"Vehicle.{name}:\n  description: A value.\n  asil: QM\n"
        + "".join(f"  {key}: {value}\n" for key, value in values.items())
        for name, values in signals.items()
    )
    return ROOT + "".join(lines)


class Generated:
    """What is generated for the function with a tree."""

    def __init__(self, folder: Path, signals: Mapping[str, Mapping[str, Any]]) -> None:
        folder.mkdir()
        for name, text in (
            ("tree.vspec", tree(signals)),
            ("function.yaml", FUNCTION),
            ("echo.h", HEADER),
            ("echo.c", HEADER),
        ):
            (folder / name).write_text(text)
        self.tree = folder / "tree.vspec"
        common = (str(folder / "function.yaml"), "-s", str(self.tree), "-o")
        self.core, document = folder / "core", folder / "integration.json"
        self.has_core = main(["generate", "core", *common, str(self.core)]) == 0
        self.has_document = main(["integrate", "autosar-adaptive", *common, str(document)]) == 0
        self.text = document.read_text() if self.has_document else "{}"

    @property
    def header(self) -> str:
        return (self.core / "Echo_adapter.h").read_text()

    @property
    def events(self) -> Mapping[str, tuple[int, str]]:
        """Id and datatype of each event."""
        return {each["Name"]: (each["EventID"], each["DataType"]) for each in found(json.loads(self.text), "EventID")}

    @property
    def numbers(self) -> Mapping[str, int]:
        """Number of each text."""
        return {each["Symbol"]: each["Value"] for each in found(json.loads(self.text), "Symbol") if "Value" in each}


def found(value: Any, key: str) -> list[Any]:
    """Every object with a key."""
    items = value.values() if isinstance(value, dict) else value if isinstance(value, list) else ()
    return [
        *([value] if isinstance(value, dict) and key in value else []),
        *(each for item in items for each in found(item, key)),
    ]


def compiles(old: Generated, new: Generated) -> bool:
    """Whether the declarations of the old header agree with the new one."""
    calls = re.findall(r"^void Echo_Adapter_Receive_.*;$", old.header, re.MULTILINE)
    members = re.findall(r"struct \{ (\w+) value(\[\d+\])?; Sigcat_Reception reception; \} (\w+);", old.header)
    assert len(calls) == len(members) == len(SIGNALS)
    sizes = [
        f"extern {kind} {name}{size}; extern __typeof__(((Echo_Adapter *)0)->received.{name}.value) {name};"
        for kind, size, name in members
    ]
    consumer = new.core / "consumer.c"
    consumer.write_text("\n".join(['#include "Echo_adapter.h"', *calls, *sizes, ""]))
    command = [*C_COMPILERS[0], "-fsyntax-only", "-I", str(new.core.parent), str(consumer)]
    return subprocess.run(command, capture_output=True, check=False).returncode == 0


def no_release(name: str) -> Any:
    raise NotFound(name)


@pytest.fixture(scope="module")
def old(tmp_path_factory):
    return Generated(tmp_path_factory.mktemp("old") / "function", SIGNALS)


@c_compiler
@pytest.mark.parametrize("name", CHANGES)
def test_what_a_function_uses_breaks_as_the_table_says(name, old, tmp_path):
    new = Generated(tmp_path / "function", CHANGES[name])
    before, after = (read_side(str(side.tree), no_release).catalogue for side in (old, new))
    changes = compare(before, after)
    keeps_numbers = old.numbers.items() <= new.numbers.items()
    verdicts: dict[Binding, bool] = {
        "c": not (new.has_core and keeps_numbers and compiles(old, new)),
        "someip": not (new.has_document and keeps_numbers and old.events.items() <= new.events.items()),
    }
    assert len(old.events) == len(SIGNALS)
    assert old.numbers == {"ECO": 0, "SPORT": 1, "SNOW": 2}
    for binding, breaks in verdicts.items():
        assert (worst(form_of(change, binding) for change in changes) == "breaking") is breaks
