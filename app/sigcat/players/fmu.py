"""An FMU, of sigcat or of any tool, is played a trace: inputs are set at communication points, and outputs are read there."""

import json
import subprocess
import sys
from collections.abc import Iterator, Mapping
from contextlib import suppress
from math import prod
from pathlib import Path
from threading import Timer
from typing import Any, NamedTuple

from sigcat.adapter.host.shapes import Array, Number, Shape, Value, built, numbers
from sigcat.catalogue.model.interfaces import interface_name
from sigcat.errors import UsageError
from sigcat.runs.recording.recorded import Recorded
from sigcat.runs.recording.trace_file import Known, Trace, moments, open_trace

_DATATYPES: Mapping[str, str] = {
    "Float32": "float", "Float64": "double", "Real": "double", "Int8": "int8", "UInt8": "uint8", "Int16": "int16",
    "UInt16": "uint16", "Int32": "int32", "Integer": "int32", "UInt32": "uint32", "Int64": "int64", "UInt64": "uint64",
    "Boolean": "boolean", "Enumeration": "int64",
}  # fmt: skip
"""Datatypes of VSS for those of FMI 2.0 and 3.0. Strings, binaries and clocks have none, and are not played."""
_STARTS_WITHIN_S = 60.0
_MOST_SAID = 2000
"""Characters of the output of an FMU that a message has."""


class Port(NamedTuple):
    """A variable that is set or read."""

    name: str
    reference: int
    type: str
    shape: Shape
    size: int
    """Count of the numbers of its value."""


class Fmu(NamedTuple):
    """A model description, as far as a player needs it."""

    file: Path
    step: int
    """Proposed step in ns."""
    inputs: Mapping[str, Port]
    """Inputs, and parameters that may change; those that are interfaces of a function by the names of traces, too."""
    outputs: tuple[Port, ...]


def read_fmu(file: Path) -> Fmu:
    """The model description of a file. Raises UsageError if it is not an FMU for co-simulation, or FMPy is missing."""
    try:
        from fmpy import read_model_description
    except ImportError:
        raise UsageError("FMUs need the extra `fmi`: run `pip install 'sigcat[fmi]'`") from None
    try:
        description: Any = read_model_description(str(file))
    except Exception as error:  # noqa: BLE001 — FMPy raises any for a file that is none
        reason = next(iter(str(error).splitlines()), type(error).__name__)
        raise UsageError(f"{file} is not an FMU: {reason}") from None
    if description.coSimulation is None:
        raise UsageError(f"{file} must be for co-simulation. Export it as a co-simulation FMU.")
    experiment = description.defaultExperiment
    step = float(experiment.stepSize) if experiment is not None and experiment.stepSize else 0.01
    known = [each for each in description.modelVariables if each.type in _DATATYPES]
    inputs = [_port(each) for each in known if _is_set(each)]
    outputs = tuple(_port(each) for each in known if each.causality == "output")
    by_name = {**{interface_name(each.name): each for each in inputs}, **{each.name: each for each in inputs}}
    return Fmu(file, round(step * 1e9), by_name, outputs)


def _is_set(variable: Any) -> bool:
    """Whether it may change between steps. A structural parameter may not."""
    return (variable.causality, variable.variability) == ("parameter", "tunable") or bool(variable.causality == "input")


def _port(variable: Any) -> Port:
    symbols: tuple[tuple[str, int], ...] = ()
    if variable.type == "Enumeration" and variable.declaredType is not None:
        symbols = tuple((each.name, int(each.value)) for each in variable.declaredType.items)
    shape: Shape = Number(_DATATYPES.get(variable.type, "double"), symbols)
    lengths = variable.shape or ()  # an array of FMI 3.0 has a structural parameter for a length, too
    for length in reversed(lengths):
        shape = Array(shape, length)
    return Port(variable.name, variable.valueReference, variable.type, shape, prod(lengths))


def columns_of(fmu: Fmu) -> Mapping[str, Shape]:
    """Shapes of the outputs that are recorded."""
    return {each.name: each.shape for each in fmu.outputs}


class Limits(NamedTuple):
    """Limits of the process of an FMU."""

    step_s: float = 10.0
    """Longest time that a step may take."""
    memory_mib: int = 2048


def played(fmu: Fmu, trace: Path, step: int, duration: int | None, limits: Limits) -> Iterator[Recorded]:
    """Outputs after each step, as far as they have changed. `step` is in ns, and `duration` too; None: to the end of the trace.

    A row of the trace is set at the first communication point that is not before it. Raises InputRefused for a trace that
    does not fit, and UsageError for an FMU that refuses a step or ends.
    """
    known = {name: each.shape for name, each in fmu.inputs.items()}
    opened = open_trace(trace, Known(known, (), kinds="not an input of the FMU"))
    yield from stepped(fmu, _steps(opened, step, duration), limits)


class Step(NamedTuple):
    """A communication step, and what is set before it; times in ns since the start."""

    begin: int
    length: int
    values: Mapping[str, Value]
    """By names of inputs."""


def stepped(fmu: Fmu, steps: Iterator[Step], limits: Limits) -> Iterator[Recorded]:
    """Outputs after each step, as far as they have changed. Raises UsageError for an FMU that refuses a step or ends."""
    process = subprocess.Popen(  # noqa: S603 — our own interpreter
        [sys.executable, "-m", "sigcat.players.fmu_process", str(fmu.file.absolute()), str(limits.memory_mib)],
        stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
    )  # fmt: skip
    try:
        yield from _rows(fmu, steps, process, limits.step_s)
    finally:
        process.kill()
        process.wait()
        for stream in (process.stdin, process.stdout, process.stderr):
            assert stream is not None
            stream.close()


def _steps(trace: Trace, step: int, duration: int | None) -> Iterator[Step]:
    now, values = 0, dict[str, Value]()
    for moment in moments(trace):
        while moment.time > now and (duration is None or now < duration):
            yield Step(now, step, values)
            now, values = now + step, {}
        values.update(moment.values)
    end = now + step if duration is None else duration
    while now < end:
        yield Step(now, step, values)
        now, values = now + step, {}


def _rows(fmu: Fmu, steps: Iterator[Step], process: "subprocess.Popen[str]", limit_s: float) -> Iterator[Recorded]:
    before: dict[str, Value] = {}
    read = [(each.reference, each.type, each.size) for each in fmu.outputs]
    _say(process, read)
    if _answer(process, _STARTS_WITHIN_S, f"{fmu.file} did not start") is None:
        raise _ended(fmu, "at its start", process)
    for each in steps:
        when = f"at {each.begin / 1e9:g} s"
        given = [_set(fmu.inputs[name], value) for name, value in each.values.items()]
        _say(process, [each.length, given])
        line = _answer(process, limit_s, f"{fmu.file} did not return from the step {when}")
        if line is None:
            raise _ended(fmu, when, process)
        answers = zip(fmu.outputs, json.loads(line), strict=True)
        after = {port.name: _value(found, port.shape) for port, found in answers}
        changed = tuple(
            (name, value) for name, value in after.items() if name not in before or not _same(before[name], value)
        )
        before = after
        if changed:
            yield Recorded(each.begin + each.length, "", changed)


def _say(process: "subprocess.Popen[str]", what: object) -> None:
    assert process.stdin is not None
    with suppress(OSError):  # it has ended, and the answer says so
        process.stdin.write(json.dumps(what) + "\n")
        process.stdin.flush()


def _answer(process: "subprocess.Popen[str]", limit_s: float, what: str) -> str | None:
    """The next line; None if the process has ended. Raises UsageError if none comes in time."""
    assert process.stdout is not None
    watchdog = Timer(limit_s, process.kill)
    watchdog.start()
    line = process.stdout.readline()
    if not line and watchdog.finished.is_set():
        raise UsageError(f"{what} within {limit_s:g} s.")
    watchdog.cancel()
    return line or None


def _same(one: Value, other: Value) -> bool:
    """Whether values are equal, also if both are not numbers."""
    return repr(one) == repr(other)


def _set(port: Port, value: Value) -> tuple[int, str, list[Any]]:
    return port.reference, port.type, list(numbers(value, port.shape))


def _value(found: list[Any], shape: Shape) -> Value:
    is_boolean = shape == Number("boolean")  # FMI 2.0 has 0 and 1
    return built((bool(each) if is_boolean else each for each in found), shape)


def _ended(fmu: Fmu, when: str, process: "subprocess.Popen[str]") -> UsageError:
    """An error with what the FMU said last."""
    assert process.stderr is not None
    status = process.wait()
    said = process.stderr.read()[-_MOST_SAID:].strip().splitlines()
    how = f"ended with signal {-status}" if status < 0 else "refused what was asked of it"
    last = f" It said: {said[-1]}" if said else ""
    return UsageError(f"{fmu.file} {how} {when}.{last}")
