"""`sigcat simulate` on a long trace of 40 signals, beside a loop in C by hand: `strtod`, the step, `fprintf`."""

import os
import random
import subprocess
import sys
from collections.abc import Callable, Mapping
from pathlib import Path

from bench.measuring import Measure, command, interleaved
from bench.rows import Bench, Missing, Row, at_most
from sigcat.adapter.toolchain import toolchain
from sigcat.errors import UsageError

_ROWS, _IN, _OUT = 100_000, 40, 10
_MOST = 100
"""Megabytes."""


def from_csv(bench: Bench) -> Row:
    """CSV to CSV, with start, build and all."""
    _write(bench.folder)
    figure, reference = interleaved(
        [_simulate(bench.folder, "trace.csv", "out.csv"), _by_hand(bench.folder)], bench.runs
    )
    work = f"`sigcat simulate`, CSV to CSV, {_ROWS:,} rows of {_IN} signals"
    return at_most(work, figure, "a loop in C with `strtod`", reference, 4)


def from_mcap(bench: Bench) -> Row:
    """MCAP to CSV, beside the same from CSV."""
    _write(bench.folder)
    _simulate(bench.folder, "trace.csv", "trace.mcap")()
    ours = [_simulate(bench.folder, trace, "out.csv") for trace in ("trace.mcap", "trace.csv")]
    figure, reference = interleaved(ours, bench.runs)
    return at_most("the same from MCAP", figure, "from CSV", reference, 1)


def memory(bench: Bench) -> Row:
    """The most memory of a run, MCAP written, too."""
    _write(bench.folder)
    outputs = ("-o", str(bench.folder / "out.csv"), "-o", str(bench.folder / "out.mcap"))
    with subprocess.Popen(_words(bench.folder, "trace.csv", *outputs), stderr=subprocess.DEVNULL) as process:
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    assert process.returncode == 0
    megabytes = used.ru_maxrss / 1000 if sys.platform == "linux" else used.ru_maxrss / 1e6
    work = "memory of the same, with MCAP written"
    return Row(work, f"{megabytes:.0f} MB", "", "", f"at most {_MOST} MB, whatever the length", megabytes <= _MOST)


ROWS: Mapping[str, Callable[[Bench], Row]] = {
    "simulate": from_csv, "simulate-mcap": from_mcap, "simulate-memory": memory,
}  # fmt: skip


def _words(folder: Path, trace: str, *outputs: str) -> tuple[str, ...]:
    words = (sys.executable, "-m", "sigcat.cli", "simulate", str(folder / "function.yaml"))
    return *words, "--trace", str(folder / trace), *outputs


def _simulate(folder: Path, trace: str, output: str) -> Measure:
    return command(*_words(folder, trace, "-o", str(folder / output)))


def _by_hand(folder: Path) -> Measure:
    try:
        compiler = toolchain().c
    except UsageError as missing:
        raise Missing(str(missing)) from missing
    program = folder / "by_hand"
    sources = (str(folder / "by_hand.c"), str(folder / "many.c"))
    subprocess.run([*compiler, "-O2", *sources, "-o", str(program)], check=True, capture_output=True)
    return command(str(program), str(folder / "trace.csv"), str(folder / "by_hand.csv"))


# -- what is measured ---------------------------------------------------------------------------------------------


def _write(folder: Path) -> None:
    """A function, its code, the loop by hand, and a trace."""
    signals = [("In", "in", "consumed", _IN), ("Out", "out", "provided", _OUT)]
    each = [(name, code, role, number) for name, code, role, count in signals for number in range(count)]
    init = {"consumed": ", init: 0", "provided": ""}
    data = [
        f'          - {{path: Vehicle.Many.{name}{number}, role: {role}, variable: "{code}[{number}]"{init[role]}}}\n'
        for name, code, role, number in each
    ]
    own = [
        f"    Vehicle.Many.{name}{number}: {{datatype: float, unit: m/s, asil: QM, description: {name} {number}.}}\n"
        for name, _, _, number in each
    ]
    files = {
        "function.yaml": _FUNCTION.format(data="".join(data), own="".join(own)),
        "many.h": f"extern float in[{_IN}];\nextern float out[{_OUT}];\nvoid many_init(void);\nvoid many_step(void);\n",
        "many.c": _CODE.replace("OUT", str(_OUT)).replace("IN", str(_IN)),
        "by_hand.c": _BY_HAND.replace("OUT", str(_OUT)).replace("IN", str(_IN)),
    }
    for name, text in files.items():
        (folder / name).write_text(text, encoding="utf-8")
    numbers = random.Random(1)
    with (folder / "trace.csv").open("w", encoding="utf-8") as file:
        file.write(f"time,{','.join(f'Vehicle.Many.In{number}' for number in range(_IN))}\n")
        file.writelines(
            f"{row / 1000:.3f},{','.join([f'{numbers.uniform(0, 100):.4f}' for _ in range(_IN)])}\n"
            for row in range(_ROWS)
        )


_FUNCTION = """\
function: Many
description: Takes and gives many signals.
responsible: Team
code: {{signature: globals, sources: [many.c], headers: [many.h]}}
components:
  - name: Many
    runnables:
      - {{interface: Init, symbol: many_init}}
      - interface: Step
        symbol: many_step
        data:
{data}      - {{interface: Terminate, symbol: many_init}}
define:
  data:
    Vehicle.Many: {{type: branch, description: Many signals.}}
{own}  scheduling:
    Init: {{description: Begins., asil: QM}}
    Step: {{description: Runs., cycleTime: 1, asil: QM}}
    Terminate: {{description: Ends., asil: QM}}
"""

_CODE = """\
#include "many.h"

float in[IN];
float out[OUT];

void many_init(void)
{
    for (int i = 0; i < OUT; i++) {
        out[i] = 0.0F;
    }
}

void many_step(void)
{
    for (int i = 0; i < OUT; i++) {
        out[i] += 0.1F * (in[i] + in[i + OUT] - out[i]);
    }
}
"""

_BY_HAND = """\
#include "many.h"

#include <stdio.h>
#include <stdlib.h>

int main(int count, char **arguments)
{
    static char line[65536];
    FILE *trace = fopen(arguments[1], "r");
    FILE *written = fopen(arguments[2], "w");
    (void)count;
    many_init();
    (void)fgets(line, sizeof(line), trace);
    while (fgets(line, sizeof(line), trace)) {
        char *at = line;
        const double time = strtod(at, &at);
        for (int i = 0; i < IN; i++) {
            in[i] = (float)strtod(at + 1, &at);
        }
        many_step();
        (void)fprintf(written, "%.9f", time);
        for (int i = 0; i < OUT; i++) {
            (void)fprintf(written, ",%.9g", (double)out[i]);
        }
        (void)fputc('\\n', written);
    }
    return fclose(written) == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
"""
