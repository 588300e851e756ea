"""Releases that are missed by three applications with 18 services and 162 events, each at its cycle time, over SOME/IP."""

import os
import re
import sys
from collections.abc import Sequence
from pathlib import Path

from bench import integration
from bench.measuring import ROOT, command
from bench.rows import Bench, Row
from bench.transport import needed_network

CYCLES = 1000
_FUNCTIONS = range(3)
_SECONDS = CYCLES * 0.05 + 3.0
"""They run for some more, as they do not begin at once."""


def cycles(bench: Bench) -> Row:
    """As many as the log tells; each application counts its own steps."""
    network = needed_network()
    folder = integration.write_set(bench.folder / "set")
    for number in _FUNCTIONS:
        _write_code(folder, number)
    build = _build(folder)
    logs = _run(network, build)
    counted = [int(found) for log in logs for found in re.findall(r"ran (\d+) cycles", log)]
    missed = sum(int(found) for log in logs for found in re.findall(r"has missed releases: (\d+)", log))
    if len(counted) != len(logs) or min(counted) < CYCLES:
        raise RuntimeError(f"not all applications ran {CYCLES} cycles: {counted}\n{''.join(logs)[-2000:]}")
    work = "3 executables with 18 services and 162 events, each for 1,000 cycles of 50 ms"
    return Row(work, f"{missed} releases missed", "", "", "0 on an idle machine", missed == 0)


ROWS = {"cycles": cycles}


def _write_code(folder: Path, number: int) -> None:
    """A function that gives what it takes, and tells at its end how often it ran."""
    branches = [f"Input{number}x{branch}" for branch in range(integration.BRANCHES)] + [f"Output{number}"]
    members = "".join(f"    float {branch}Signal{i};\n" for branch in branches for i in range(integration.SIGNALS))
    name = f"control{number}"
    calls = [f"void {name}_{call}(void)" for call in ("init", "step", "end")]
    header = f"#pragma once\ntypedef struct {{\n{members}}} Control{number};\nextern Control{number} {name};\n"
    (folder / f"{name}.h").write_text(header + "".join(f"{call};\n" for call in calls))
    gives = "".join(
        f"    {name}.Output{number}Signal{i} = {name}.Input{number}x0Signal{i} + 1.0F;\n"
        for i in range(integration.SIGNALS)
    )
    bodies = ("", f"{gives}    cycles++;\n", '    (void)fprintf(stderr, "ran %ld cycles\\n", cycles);\n')
    start = f'#include "{name}.h"\n#include <stdio.h>\nControl{number} {name};\nstatic long cycles;\n'
    text = "".join(f"{call}\n{{\n{body}}}\n" for call, body in zip(calls, bodies, strict=True))
    (folder / f"{name}.c").write_text(start + text)


def _build(folder: Path) -> Path:
    """From the function files to the programs, with the commands and CMake files that are shipped."""
    for file in sorted(folder.glob("function*.yaml")):
        text = file.read_text()
        number = file.stem[-1]
        code = f"headers: [control{number}.h]"
        file.write_text(text.replace(code, f"{code}, sources: [control{number}.c]"))
    own = (sys.executable, "-m", "sigcat.cli")
    tree = (
        "-s",
        str(folder / "tree.vspec"),
        "-u",
        str(ROOT / "vspec/units.yaml"),
        "-q",
        str(ROOT / "vspec/quantities.yaml"),
    )
    functions = map(str, sorted(folder.glob("function*.yaml")))
    document = str(folder / "integration.json")
    command(*own, "integrate", "autosar-adaptive", *functions, *tree, "-o", document)()
    command(*own, "generate", "autosar-adaptive", document, "--bench", "-o", str(folder / "made"))()
    settings = {f"CONTROL{number}_CODE": folder for number in _FUNCTIONS} | {
        "CMAKE_BUILD_TYPE": "Release",
        "CMAKE_UNITY_BUILD": "ON",
    }
    build = folder / "build"
    command(
        "cmake",
        "-S",
        str(folder / "made"),
        "-B",
        str(build),
        *(f"-D{name}={value}" for name, value in settings.items()),
    )()
    command("cmake", "--build", str(build), "-j", str(os.cpu_count() or 1))()
    return build


def _run(network: Sequence[str], build: Path) -> list[str]:
    """Return the log of the applications from start to end."""
    names = [f"Control{number}Executable" for number in _FUNCTIONS]
    each = " ".join(f'{build}/{name}/{name} 2>{build}/{name}.log & ids="$ids $!";' for name in names)
    script = f"ip link set lo up; {each} sleep {_SECONDS}; kill $ids; wait"
    command(*network, "sh", "-c", script)()
    return [(build / f"{name}.log").read_text() for name in names]
