"""The core of an adapter beside what one would write by hand: 162 signals, half of them received and half of them sent."""

import subprocess
import sys
from pathlib import Path

from bench.cortex_m4 import Memory, memory
from bench.measuring import command, interleaved
from bench.rows import Bench, Missing, Row, time_of
from sigcat.adapter.toolchain import EXACT, toolchain
from sigcat.data import ROOT_FILE
from sigcat.errors import UsageError

SIGNALS = 81
_ROUNDS = 200_000


def generated(bench: Bench) -> Row:
    """`sigcat generate core` as a command."""
    _write(bench.folder, with_conversions=True)
    (seconds,) = interleaved([command(*_generate(bench.folder, bench.folder / "core"))], bench.runs)
    return Row("`sigcat generate core`, 162 signals", time_of(seconds), "", "", "under 300 ms", seconds < 0.3)


def conversions(bench: Bench) -> Row:
    """SetInput and GetOutput with a conversion of each signal, beside assignments that convert alike."""
    figure, reference = _measured(bench, with_conversions=True)
    return _row("SetInput and GetOutput of 162 signals with conversions", figure, "assignments by hand", reference, 3)


def copies(bench: Bench) -> Row:
    """SetInput and GetOutput without conversions, beside copies of both images."""
    figure, reference = _measured(bench, with_conversions=False)
    return _row("the same without conversions", figure, "`memcpy` of the images", reference, 5)


def _row(work: str, figure: float, name: str, reference: float, wanted: int) -> Row:
    ratio, beside = figure / reference, f"{name}: {reference * 1e9:.0f} ns"
    return Row(work, f"{figure * 1e9:.0f} ns", beside, f"{ratio:.2f} ×", f"at most {wanted} ×", ratio <= wanted)


def on_a_controller(bench: Bench) -> Row:
    """Memory of the core with float arithmetic on a Cortex-M4, beside the one with double arithmetic."""
    _write(bench.folder, with_conversions=True)
    figure, reference = (_on_a_controller(bench.folder, arithmetic) for arithmetic in ("float", "double"))
    work = "the core of 162 signals with float arithmetic on a Cortex-M4 (clang `-Os`), bytes"
    ratio, beside = figure.text / reference.text, f"double arithmetic, without its library: {_bytes(reference)}"
    return Row(work, _bytes(figure), beside, f"{ratio:.2f} × text", "at most 1 × text", ratio <= 1)


def _on_a_controller(folder: Path, arithmetic: str) -> Memory:
    """Memory of the core and of what all cores share."""
    output = folder / arithmetic
    subprocess.run([*_generate(folder, output), "--arithmetic", arithmetic], check=True, capture_output=True)
    core, shared = (memory(output / name, [folder, output]) for name in ("Many_adapter.c", "sigcat_core.c"))
    stack = max(core.stack, shared.stack)
    return Memory(core.text + shared.text, core.data + shared.data, core.bss + shared.bss, stack)


def _bytes(found: Memory) -> str:
    return f"text {found.text:,}, data {found.data:,}, bss {found.bss:,}, largest stack frame {found.stack}"


ROWS = {"core": generated, "core_conversions": conversions, "core_copies": copies, "core_memory": on_a_controller}


def _generate(folder: Path, output: Path) -> tuple[str, ...]:
    words = (sys.executable, "-m", "sigcat.cli", "generate", "core", str(folder / "function.yaml"))
    units = ("-u", str(ROOT_FILE.with_name("units.yaml")), "-q", str(ROOT_FILE.with_name("quantities.yaml")))
    return *words, "-s", str(folder / "tree.vspec"), *units, "-o", str(output)


def _measured(bench: Bench, *, with_conversions: bool) -> tuple[float, float]:
    """Seconds of one round, of the core and by hand."""
    try:
        compiler = toolchain().c
    except UsageError as missing:
        raise Missing(str(missing)) from missing
    folder = bench.folder
    _write(folder, with_conversions=with_conversions)
    subprocess.run(_generate(folder, folder / "core"), check=True, capture_output=True)
    program = folder / "program"
    sources = [folder / "core/Many_adapter.c", folder / "core/sigcat_core.c", folder / "code.c", folder / "driver.c"]
    flags = ("-std=c99", "-O2", "-D_POSIX_C_SOURCE=199309L", *EXACT, f"-I{folder}", f"-I{folder / 'core'}")
    subprocess.run([*compiler, *flags, *map(str, sources), "-o", str(program)], check=True, capture_output=True)

    def run(what: str) -> float:
        return float(subprocess.run([program, what], check=True, capture_output=True, text=True).stdout)

    figure, reference = interleaved([lambda: run("core"), lambda: run("hand")], 3 * bench.runs)
    return figure, reference


# -- what is measured ---------------------------------------------------------------------------------------------


def _write(folder: Path, *, with_conversions: bool) -> None:
    """A tree, a function over it, its code, and a program that measures."""
    numbers = range(SIGNALS)
    unit = ", unit: km/h" if with_conversions else ""
    tree = ["Vehicle: {type: branch, description: Vehicle.}"]
    tree += [
        f"Vehicle.{side}{n}: {{type: actuator, datatype: float{unit}, description: Signal {n}.}}"
        for side in ("In", "Out") for n in numbers
    ]  # fmt: skip
    own = ", unit: m/s" if with_conversions else ""
    data = [
        f"          - {{path: Vehicle.{side}{n}, role: {role}, variable: many.{side}{n}{own}, init: 0}}"
        for side, role in (("In", "consumed"), ("Out", "provided")) for n in numbers
    ]  # fmt: skip
    members = "".join(f"    float {side}{n};\n" for side in ("In", "Out") for n in numbers)
    files = {
        "tree.vspec": "\n".join(tree) + "\n",
        "function.yaml": _FUNCTION.format(data="\n".join(data)),
        "code.h": f"typedef struct {{\n{members}}} Many;\nextern Many many;\nvoid many_step(void);\n",
        "code.c": '#include "code.h"\nMany many;\nvoid many_step(void) {}\n',
        "driver.c": _driver(with_conversions=with_conversions),
    }
    for name, text in files.items():
        (folder / name).write_text(text, encoding="utf-8")


_FUNCTION = """\
function: Many
description: Takes and gives many signals.
responsible: Team
code: {{signature: globals, headers: [code.h]}}
components:
  - name: Many
    runnables:
      - {{interface: Init, symbol: many_step}}
      - interface: Step
        symbol: many_step
        data:
{data}
      - {{interface: Terminate, symbol: many_step}}
define:
  scheduling:
    Init: {{description: Begins., priority: 20, scheduling: NonPreemptive, asil: QM}}
    Step: {{description: Runs., cycleTime: 10, priority: 10, scheduling: NonPreemptive, asil: QM}}
    Terminate: {{description: Ends., priority: 30, scheduling: NonPreemptive, asil: QM}}
"""


def _driver(*, with_conversions: bool) -> str:
    names = [f"In{n}" for n in range(SIGNALS)]
    received = "\n".join(f"    Many_Adapter_Receive_{name}(self, 1.0F, 1U);" for name in names)
    if with_conversions:
        takes = "\n".join(f"    many.{name} = (float)((double)image.{name} * 0.2777777777777778);" for name in names)
        gives = "\n".join(f"    image.Out{n} = (float)((double)many.Out{n} * 3.6);" for n in range(SIGNALS))
        by_hand = f"{takes}\n{gives}"
    else:
        by_hand = "    (void)memcpy(&many, &image, sizeof(many));\n    (void)memcpy(&image, &many, sizeof(many));"
    return _DRIVER.replace("RECEIVED", received).replace("BY_HAND", by_hand).replace("ROUNDS", str(_ROUNDS))


_DRIVER = """\
#include "Many_adapter.h"
#include <stdio.h>
#include <string.h>
#include <time.h>

static Many image;

static void by_hand(void)
{
    __asm__ volatile("" ::: "memory");
BY_HAND
    __asm__ volatile("" ::: "memory");
}

static void core(Many_Adapter *self)
{
    __asm__ volatile("" ::: "memory");
    Many_Adapter_SetInput_Step(self, 2U);
    Many_Adapter_GetOutput_Step(self, 2U);
    __asm__ volatile("" ::: "memory");
}

int main(int count, char **arguments)
{
    Many_Adapter *self = &Many_Adapter_Instance;
    struct timespec begin, end;
    long round;

    (void)Many_Adapter_Init(self, NULL, 1U);
    Many_Adapter_Start(self, 0U);
RECEIVED
    (void)clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &begin);
    for (round = 0; round < ROUNDS; round++) {
        if (count > 1 && strcmp(arguments[1], "core") == 0) {
            core(self);
        } else {
            by_hand();
        }
    }
    (void)clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &end);
    (void)printf("%.12f", ((double)(end.tv_sec - begin.tv_sec) + (double)(end.tv_nsec - begin.tv_nsec) * 1e-9) / ROUNDS);
    return 0;
}
"""
