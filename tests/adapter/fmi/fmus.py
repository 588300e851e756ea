"""FMUs of functions for tests: generated, built and packed; and what a simulation says of the same communication points."""

import csv
import json
import subprocess
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from sigcat.adapter.fmi.fmi_integration import units_of
from sigcat.adapter.fmi.variables import Variable
from sigcat.adapter.host.connections import Connections
from sigcat.adapter.host.shapes import Shape, Value, numbers, packing
from sigcat.cli import main
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.integration.reading import read_functions
from sigcat.runs.recording.cells import cell_of, value_of
from sigcat.runs.recording.times import nanoseconds
from tests.function.shipped import interfaces

NAME = "Tested"

SANITIZED = (
    "-std=c11", "-g", "-O1", "-Wall", "-Wextra", "-Werror", "-ffp-contract=off", "-fsanitize=address,undefined",
    "-fno-sanitize-recover=all",
)  # fmt: skip
"""Options of gcc for programs that get hostile input."""


class Built(NamedTuple):
    """An FMU, and what its variables are made from."""

    file: Path
    connections: Connections
    variables: Sequence[Variable]
    files: Sequence[Path]


def built(
    files: Sequence[Path], folder: Path, *options: str, version: str = "3.0", is_scheduled: bool = False
) -> Built:
    """The FMU of a set of functions, or of one function for scheduled execution, by the commands that a user types."""
    settings = "{interface: scheduledExecution}" if is_scheduled else f"{{fmus: set, version: '{version}'}}"
    (folder / "deployment.yaml").write_text(f"name: {NAME}\nfmi: {settings}\n")
    document, made = folder / "fmi.json", folder / "made"
    paths = [str(each) for each in files]
    deployment = ["--deployment", str(folder / "deployment.yaml")]
    assert main(["integrate", "fmi", *paths, *deployment, "-o", str(document)]) in (0, 1)
    assert main(["generate", "fmi", str(document), "-o", str(made)]) == 0
    functions = read_functions([(each.read_bytes(), str(each)) for each in files], interfaces()).functions
    ordered = sorted(functions, key=lambda each: each.name)
    return packed(ordered, folder, *options, has_arrays=version == "3.0", name=None if is_scheduled else NAME)


def packed(
    functions: Sequence[ResolvedFunction], folder: Path, *options: str, has_arrays: bool = True, name: str | None = NAME
) -> Built:
    """The FMU that is generated in a folder, built and packed."""
    (unit,) = units_of(functions, name, has_arrays=has_arrays)
    files = [Path(member.function.document.name) for member in unit.connections.members]
    settings = [
        f"-D{member.plan.code_setting}={file.parent.absolute()}"
        for member, file in zip(unit.connections.members, files, strict=True)
    ]
    flags = "-Wall -Wextra -Werror"
    languages = [f"-DCMAKE_C_FLAGS={flags}", f"-DCMAKE_CXX_FLAGS={flags}"]
    run("cmake", "-S", folder / "made", "-B", folder / "build", *languages, *settings, *options)
    run("cmake", "--build", folder / "build")
    fmu = folder / "build" / f"{unit.name}.fmu"
    assert fmu.is_file()
    return Built(fmu, unit.connections, unit.layout.variables, files)


def run(*command: object) -> str:
    done = subprocess.run([str(each) for each in command], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


# -- traces -------------------------------------------------------------------------------------------------------


def sampled(trace: Path, built: Built, step: int, end: int) -> Iterator[tuple[int, dict[str, Value]]]:
    """At each communication point the last value since the one before of everything that the FMU receives; `step` and `end` in ns."""
    shapes = built.connections.received
    rows = list(csv.DictReader(trace.open(newline="", encoding="utf-8")))
    at = 0
    for point in range(0, end, step):
        values: dict[str, Value] = {}
        while at < len(rows) and (nanoseconds(rows[at]["time"]) or 0) <= point:
            given = {name: cell for name, cell in rows[at].items() if cell and name in shapes}
            values |= {name: value_of(cell, shapes[name]) for name, cell in given.items()}
            at += 1
        yield point, values


def write_trace(points: Sequence[tuple[int, Mapping[str, Value]]], built: Built, file: Path) -> None:
    """The points as a trace for the simulation: a row at each, also where nothing is set."""
    names = sorted({name for _, values in points for name in values})
    shapes = built.connections.received
    with file.open("w", newline="", encoding="utf-8") as stream:
        writer = csv.writer(stream)
        writer.writerow(["time", *names])
        for point, values in points:
            cells = [cell_of(values[name], shapes[name]) if name in values else "" for name in names]
            writer.writerow([f"{point / 1e9:.9f}", *cells])


def write_fmu_trace(points: Sequence[tuple[int, Mapping[str, Value]]], built: Built, file: Path) -> None:
    """The points as a trace for the FMU, whose variables are numbers and arrays of numbers."""
    leaves = {name: leaves_of(built, name) for _, values in points for name in values}
    names = sorted({leaf.name for each in leaves.values() for leaf in each})
    with file.open("w", newline="", encoding="utf-8") as stream:
        writer = csv.writer(stream)
        writer.writerow(["time", *names])
        for point, values in points:
            cells: dict[str, str] = {}
            for name, value in values.items():
                cells |= split(value, built.connections.received[name], leaves[name])
            writer.writerow([f"{point / 1e9:.9f}", *(cells.get(name, "") for name in names)])


def leaves_of(built: Built, name: str) -> list[Variable]:
    """The variables of an input, whatever name it is given by."""
    owner = next(index for index, entry in enumerate(built.connections.entries) if name in entry.names)
    return [each for each in built.variables if each.causality == "input" and each.owner == owner]


def split(value: Value, shape: Shape, leaves: Sequence[Variable]) -> dict[str, str]:
    """Cells of the variables of one value."""
    flat = list(numbers(value, shape))
    cells = {}
    for leaf in leaves:
        count = leaf.length or 1
        taken, flat = flat[:count], flat[count:]
        texts = [cell_of(each, leaf.number) for each in taken]
        cells[leaf.name] = texts[0] if leaf.length is None else json.dumps([json_number(each) for each in texts])
    return cells


def json_number(text: str) -> object:
    return (
        float(text)
        if text in ("NaN", "Infinity", "-Infinity", "nan", "inf", "-inf")
        else json.loads(text)
        if text[:1] in "-0123456789tf"
        else text
    )


# -- outputs ------------------------------------------------------------------------------------------------------


def simulated(built: Built, trace: Path, out: Path, end: int) -> list[tuple[int, str, bytes]]:
    """What a simulation sends, as bytes: time, field of `out`, value."""
    main(["simulate", *map(str, built.files), "--trace", str(trace), "-o", str(out), "--duration", str(end / 1e9)])
    exits = {each.name: each for each in built.connections.exits}
    found = []
    for row in csv.DictReader(out.open(newline="", encoding="utf-8")):
        for name, cell in row.items():
            if cell and name in exits:
                shape = exits[name].shape
                found.append((nanoseconds(row["time"]) or 0, name, packing(shape).pack(value_of(cell, shape))))
    return found


def differences(
    built: Built, sent: Sequence[tuple[int, str, bytes]], played: Path, step: int, end: int
) -> tuple[int, list[str]]:
    """The number of compared values, and what differs: at each point all that the simulation has sent before it."""
    outputs = {
        index: [v for v in built.variables if v.causality == "output" and v.owner == index]
        for index in range(len(built.connections.exits))
    }
    known: dict[str, str] = {}
    last: dict[str, bytes] = {}
    compared, wrong, at = 0, [], 0
    rows = {nanoseconds(row["time"]): row for row in csv.DictReader(played.open(newline="", encoding="utf-8"))}
    for point in range(step, end + step, step):
        known |= {name: cell for name, cell in rows.get(point, {}).items() if cell}
        while at < len(sent) and sent[at][0] < point:
            last[sent[at][1]] = sent[at][2]
            at += 1
        for index, each in enumerate(built.connections.exits):
            if each.name not in last:
                continue
            got = b"".join(_bytes(known[leaf.name], leaf) for leaf in outputs[index])
            compared += 1
            if got != last[each.name]:
                wrong.append(f"{point / 1e9:g} s {each.name}: {got!r} instead of {last[each.name]!r}")
    return compared, wrong


def _bytes(cell: str, leaf: Variable) -> bytes:
    shape: Shape = leaf.number
    if leaf.length is None:
        return packing(shape).pack(value_of(cell, shape))
    from sigcat.adapter.host.shapes import Array

    array = Array(leaf.number, leaf.length)
    return packing(array).pack(value_of(cell, array))


Simulate = Callable[[Built, Path, Path, int], list[tuple[int, str, bytes]]]
"""From an FMU, a trace, a file for results and the end in ns to what is sent."""


def compare(
    made: Built,
    points: Sequence[tuple[int, Mapping[str, Value]]],
    step: int,
    end: int,
    folder: Path,
    sent_by: Simulate = simulated,
) -> int:
    """Play the same points to a simulation and to the FMU. Returns the number of compared values; nothing may differ."""
    write_trace(points, made, folder / "simulated.csv")
    write_fmu_trace(points, made, folder / "trace.csv")
    sent = sent_by(made, folder / "simulated.csv", folder / "sent.csv", end)
    files = ["--fmu", str(made.file), "--trace", str(folder / "trace.csv"), "-o", str(folder / "played.csv")]
    assert main(["simulate", *files, "--step", str(step / 10**6), "--duration", str(end / 1e9)]) == 0
    compared, wrong = differences(made, sent, folder / "played.csv", step, end)
    assert not wrong, wrong[:5]
    return compared
