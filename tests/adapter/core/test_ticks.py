"""Cores that count time in ticks of 32 bits: the same decisions as in nanoseconds, also while the clock wraps around."""

import re
import subprocess
from collections.abc import Mapping
from itertools import permutations
from pathlib import Path

import pytest
from hypothesis import HealthCheck, Phase, given, settings
from hypothesis import strategies as st

from bench.cortex_m4 import memory
from bench.rows import Missing
from sigcat.adapter.core.clocks import with_common_clock
from sigcat.adapter.core.core_files import RUNTIME_SOURCE, runtime_files
from sigcat.adapter.core.cores import cores
from sigcat.adapter.core.numbers import DOUBLE, FLOAT
from sigcat.adapter.core.plan import MICROSECONDS, MILLISECONDS, NANOSECONDS, Clock
from sigcat.adapter.toolchain import EXACT, toolchain
from sigcat.function.function_json.model import FunctionJson, to_json
from tests.adapter.core import core_side
from tests.adapter.core.compared import difference, disagreement
from tests.adapter.core.compilers import STRICT, compilers
from tests.adapter.core.fixed import FIXED
from tests.adapter.core.functions import functions
from tests.adapter.core.script import Script
from tests.adapter.core.subject import Subject, subject
from tests.adapter.core.test_float_cores import IS_SLOW, SAME, in_float
from tests.adapter.core.test_strict import HAVING_MUCH, undocumented, warnings_of_clang
from tests.adapter.core.traces import MS, Tracer
from tests.adapter.written import FLOAT as FLOAT_VARIABLE
from tests.adapter.written import error, function, signal, step, watchdog
from tests.function.shipped import resolved
from tests.needs import slow
from tests.properties import FUZZ, IS_SEARCH, examples
from tests.reference_tools import checked_with

LINES = 5000 if FUZZ else 2000
NEAR_WRAP, NEAR_HALF = 2**32 - 2000, 2**31 - 2000
"""Ticks at the beginning of a script, soon before the clock wraps around, and before half of it."""


def clock_of(document: FunctionJson) -> Clock:
    """The clock of a core with float arithmetic."""
    return with_common_clock([subject(document).plan])[0].clock


def flags(first: int, level: str = "-O1") -> tuple[str, ...]:
    return (level, "-w", f"-DFIRST={first}U")


# -- decisions ----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("first", [0, NEAR_WRAP, NEAR_HALF])
@pytest.mark.parametrize("name", FIXED)
def test_every_decision_is_that_in_nanoseconds(name, first, tmp_path):
    clock = clock_of(FIXED[name]())
    assert clock.is_in_ticks
    assert disagreement(FIXED[name](), 1, LINES, tmp_path, flags(first), DOUBLE, clock) == ""


@pytest.mark.parametrize("name", SAME)
def test_so_it_is_with_float_arithmetic(name, tmp_path):
    document = FIXED[name]()
    assert disagreement(document, 2, LINES, tmp_path, flags(NEAR_WRAP), FLOAT, clock_of(document)) == ""


@given(functions().map(to_json), st.integers(0, 2**32))
@settings(
    examples(6),
    suppress_health_check=list(HealthCheck),
    phases=[Phase.explicit, Phase.generate, *([Phase.shrink] if IS_SEARCH else [])],
)
def test_functions_at_random(tmp_path_factory, document, trace):
    folder, made = tmp_path_factory.mktemp("ticks"), FunctionJson.model_validate_json(document)
    clock = clock_of(made)
    assert disagreement(made, trace, LINES, folder, flags(trace % 2**32), DOUBLE, clock) == "", folder


FAULTS = {
    "times are compared as numbers": ("schedules", r"return \(now - time\) < SIGCAT_HALF;", "return now >= time;"),
    "time stands still at the wrap": ("schedules", r"Sigcat_IsReached\(last, t\.ticks\) \?", "(t.ticks >= last) ?"),
    "the first time is after 0": ("schedules", r"\*has_time \? \*now : t\.ticks", "*now"),
    "ages are signed": (
        "time_outs",
        r"\(now - last\) > time_out",
        "((int32_t)(now - last) > (int32_t)time_out) && (now > time_out)",
    ),
    "the time of the start decides as a number": ("time_outs", r"age_of_a < age_of_b", "a > b"),
    "skipped releases are not counted": ("optional", r"Sigcat_CountSkipped\(skipped, &releases\);", ""),
    "skipped releases move the grid": ("optional", r"\*release \+= releases \* cycle;", "*release += releases;"),
    "the end of a window is a number": (
        "supervision",
        r"Sigcat_IsReached\(alive->window \+ length, now\)",
        "now >= (alive->window + length)",
    ),
    "the next time may be over": ("schedules", r"Sigcat_IsReached\(time, now\) \? 0U : \(time - now\)", "time - now"),
}
"""Faults of the shared files, each in a function that finds it."""


@pytest.mark.parametrize(("name", "pattern", "replacement"), FAULTS.values(), ids=FAULTS)
def test_a_fault_is_found(name, pattern, replacement, tmp_path):
    def change(texts: Mapping[str, str]) -> Mapping[str, str]:
        changed = {file: re.sub(pattern, replacement, text) for file, text in texts.items()}
        assert changed != texts
        return changed

    document = FIXED[name]()
    made = subject(document, DOUBLE, clock_of(document))
    program = core_side.compiled(made, tmp_path, flags(NEAR_WRAP), change=change)
    assert any(is_found(made, seed, program) for seed in range(1, 7))


def is_found(made: Subject, seed: int, program: Path) -> bool:
    script = Tracer(made, seed).script(LINES)
    return difference(made, script, core_side.run(program, script)) != ""


# -- pauses as long as the clock takes to wrap around -------------------------------------------------------------


TIMES_OF = {"finish": (1, 2), "next": (0,), "supervise": (0,), "start": (0,), "terminate": (0,), "receive": (2,),
            "reject": (1,), "lose": (1,), "advance": (1,), "answer": (4,)}  # fmt: skip
"""Places of times in the lines of a script."""


def paused(made: Subject, seed: int) -> Script:
    """A script in which sometimes only Supervise happens now and then, until the clock has the same ticks again."""
    found: Script = []
    tick, shift, last = made.plan.clock.tick, 0, 0
    is_ready = is_started = False
    for number, (word, *rest) in enumerate(Tracer(made, seed).script(LINES), 37 * seed):
        times = TIMES_OF.get(str(word), ())
        moved = [int(each) + shift if place in times else each for place, each in enumerate(rest)]
        found.append((word, *moved))
        last = 0 if word == "init" else max([last, *(int(moved[place]) for place in times)])
        is_ready = word == "init" or (is_ready and word != "terminate")
        is_started = is_ready and (word == "start" or (is_started and word != "init"))
        if is_started and number % 250 == 249:
            found += [("supervise", last + part * 2**29 * tick) for part in range(1, 9)]
            shift, last = shift + 2**32 * tick, last + 2**32 * tick
    return found


PAUSED = ("time_outs", "rejections", "errors", "schedules", "supervision", "classes")
"""Functions whose Init cannot fail: they take the time after each Start."""
KEPT = {
    "times": ("time_outs", r"\n *Sigcat_KeepNear\(&self->.*;"),
    "begins of calls": ("schedules", r"\n *Sigcat_KeepNear\(&self->\w+\.begun.*;"),
    "begins of errors": ("errors", r"\n *Sigcat_KeepNear\(&self->error.*;"),
    "receptions": ("time_outs", r"\n *Sigcat_KeepNear\(&self->received.*;"),
    "starts of clocks": ("time_outs", r"\n *Sigcat_KeepNear\(&self->\w+\.entered.*;"),
    "requests": ("classes", r"\n *Sigcat_KeepNear\(&self->method.*;"),
    "receptions of reactions": ("time_outs", r"\n *Sigcat_KeepNear\(&self->reaction.*;"),
    "releases": ("schedules", r"\n *Sigcat_CatchUp\(&self->(?:.|\n)*?;"),
}


@pytest.mark.parametrize("first", [0, NEAR_WRAP])
@pytest.mark.parametrize("name", PAUSED)
def test_what_is_long_over_stays_over(name, first, tmp_path):
    document = FIXED[name]()
    made = subject(document, DOUBLE, clock_of(document))
    program = core_side.compiled(made, tmp_path, flags(first))
    for seed in (1, 2):
        script = paused(made, seed)
        assert difference(made, script, core_side.run(program, script)) == ""


@pytest.mark.parametrize(("name", "pattern"), KEPT.values(), ids=KEPT)
def test_each_kind_of_time_is_kept_near(name, pattern, tmp_path):
    def change(texts: Mapping[str, str]) -> Mapping[str, str]:
        changed = {file: re.sub(pattern, "", text) for file, text in texts.items()}
        assert changed != texts
        return changed

    document = FIXED[name]()
    made = subject(document, DOUBLE, clock_of(document))
    program = core_side.compiled(made, tmp_path, flags(0), change=change)
    scripts = (paused(made, seed) for seed in range(1, 60))
    assert any(difference(made, script, core_side.run(program, script)) for script in scripts)


def received_alone() -> tuple[Subject, Script]:
    """A supervised function for which only values come, for long: no call of it looks at its windows."""
    signals = signal("A", FLOAT_VARIABLE, VssDatatype="float")
    made = subject(function(step(error("E"), signals, Watchdog=watchdog(alive=(1, 1, 5, "E")))), FLOAT, MILLISECONDS)
    longest = 2**30 * MS
    received = [("receive", 0, "3f800000", number * longest) for number in range(1, 3)]
    return made, [("init", 0, 0), ("start", 0), *received, ("supervise", 2 * longest + 152 * MS)]


@pytest.mark.parametrize("first", [0, NEAR_WRAP, NEAR_HALF])
def test_windows_that_nobody_closed_are_over(first, tmp_path):
    made, script = received_alone()
    program = core_side.compiled(made, tmp_path, flags(first))
    printed = core_side.run(program, script)
    assert difference(made, script, printed) == ""
    assert "E:3" in printed[-1]  # failed


def test_a_window_has_to_be_kept_near(tmp_path):
    made, script = received_alone()
    program = core_side.compiled(made, tmp_path, flags(0), change=lambda texts: {
        file: re.sub(r"\n *Sigcat_KeepWindowNear\(&self->(?:.|\n)*?;", "", text) for file, text in texts.items()
    })  # fmt: skip
    assert difference(made, script, core_side.run(program, script)) != ""


@pytest.mark.parametrize("word", ["supervise", "next"])
def test_the_clock_is_followed_before_the_start(word, tmp_path):
    made = subject(FUNCTION, FLOAT, MILLISECONDS)
    half = 2**30 * MS
    before = [(word, number * half) for number in range(5)]
    script: Script = [("init", 0, 0), *before, ("start", 5 * half), ("next", 5 * half + 10 * MS)]
    printed = core_side.run(core_side.compiled(made, tmp_path, flags(0)), script)
    assert difference(made, script, printed) == ""


LONGEST_CYCLE = 268435
"""Milliseconds that are just not too many microseconds."""


@pytest.mark.parametrize("first", [0, NEAR_WRAP, NEAR_HALF])
def test_the_longest_times_hold_with_the_longest_steps_of_time(first, tmp_path):
    late = {"VssDatatype": "float", "Timeout": str(LONGEST_CYCLE), "TimeoutError": "E"}
    error_times = {"MaturationTime": LONGEST_CYCLE, "ResetTime": LONGEST_CYCLE}
    call = step(error("E", **error_times), signal("A", FLOAT_VARIABLE, **late), cycle=LONGEST_CYCLE, ExecOffset="0.001")
    made = subject(function(call), FLOAT, MICROSECONDS)
    longest = 2**30 * MICROSECONDS.tick
    script: Script = [("init", 0, 0), ("start", 0), ("receive", 0, "3f800000", 0)]
    for number in range(1, 60):
        script.append(("supervise", number * longest))
        if number % 3 == 0:
            script += [
                ("next", number * longest + 1000),
                ("finish", 0, number * longest + 2000, number * longest + 3000),
            ]
        if number % 7 == 0:
            script.append(("receive", 0, "3f800000", number * longest + 4000))
    program = core_side.compiled(made, tmp_path, flags(first))
    assert difference(made, script, core_side.run(program, script)) == ""


def cyclic_script(first: int, releases: int) -> Script:
    """A call that is made whenever it is due."""
    times = [first + number * 10 * MS for number in range(releases)]
    return [
        ("init", 0, 0),
        ("start", first),
        *(line for t in times for line in (("next", t), ("finish", 0, t, t + MS))),
    ]


def test_a_core_that_runs_survives_the_wrap_without_a_missed_release(tmp_path):
    made = subject(FUNCTION, FLOAT, MILLISECONDS)
    script = cyclic_script(0, 500)
    printed = core_side.run(core_side.compiled(made, tmp_path, flags(NEAR_WRAP)), script)
    assert difference(made, script, printed) == ""
    assert printed.count("call=1") == 500
    assert "now=4991000000 next=5000000000" in printed[-1]


# -- the choice ---------------------------------------------------------------------------------------------------

LATE = {"VssDatatype": "float", "Timeout": "20"}
FUNCTION = function(step(signal("A", FLOAT_VARIABLE, **LATE)))
IN_MICROSECONDS = function(
    step(signal("B", FLOAT_VARIABLE, **{**LATE, "Timeout": "7.5"})),
    FunctionInfo={"FunctionName": "G", "FunctionResponsible": "Tests", "Description": "G."},
)
WHOLE = "All times are in milliseconds, in 32 bits that wrap around: the declared ones are whole milliseconds."
CHOICES = {
    "whole milliseconds": (step(), MILLISECONDS, WHOLE),
    "a time in microseconds": (
        step(ExecOffset="2.001"), MICROSECONDS,
        "All times are in microseconds, in 32 bits that wrap around: the offset of Step in F is 2.001 ms.",
    ),
    "a supervised duration": (
        step(error("E"), Watchdog=watchdog(deadline=(1, 5, "E"))), MICROSECONDS,
        "All times are in microseconds, in 32 bits that wrap around: the deadline supervision of Step in F needs them.",
    ),
    "nanoseconds": (
        step(error("E", MaturationTime=0.0005)), NANOSECONDS,
        "All times are in nanoseconds, in 64 bits: the maturation time of E in F is 0.0005 ms.",
    ),
    "microseconds for the longest time": (
        step(ExecOffset="0.001", cycle=268435), MICROSECONDS,
        "All times are in microseconds, in 32 bits that wrap around: the offset of Step in F is 0.001 ms.",
    ),
    "a time too long for microseconds": (
        step(ExecOffset="0.001", cycle=268436), NANOSECONDS,
        "All times are in nanoseconds, in 64 bits: the offset of Step in F is 0.001 ms, and the cycle of Step in F is 268436 ms, too long for microseconds in 32 bits.",
    ),
    "milliseconds for days": (step(cycle=268435455), MILLISECONDS, WHOLE),
    "a time too long for milliseconds": (
        step(cycle=268435456), NANOSECONDS,
        "All times are in nanoseconds, in 64 bits: the cycle of Step in F is 268435456 ms, too long for milliseconds in 32 bits, and the cycle of Step in F is 268435456 ms, too long for microseconds in 32 bits.",
    ),
}  # fmt: skip


@pytest.mark.parametrize(("call", "clock", "reason"), CHOICES.values(), ids=CHOICES)
def test_the_declared_times_choose_the_clock(call, clock, reason):
    header, source, *shared = cores([resolved(function(call))], FLOAT).files
    assert f" * {reason}\n" in header.data.decode()
    assert f" * {reason}\n" in source.data.decode()
    assert set(shared) == set(runtime_files(FLOAT, clock))


def test_functions_of_one_program_have_one_clock():
    both = [resolved(FUNCTION), resolved(IN_MICROSECONDS)]
    assert set(runtime_files(FLOAT, MICROSECONDS)) < set(cores(both, FLOAT).files)
    assert set(runtime_files(FLOAT, MILLISECONDS)) < set(cores(both[:1], FLOAT).files)


def test_with_double_arithmetic_times_are_nanoseconds():
    assert set(runtime_files(DOUBLE, NANOSECONDS)) < set(cores([resolved(FUNCTION)], DOUBLE).files)


# -- what does not compile ----------------------------------------------------------------------------------------


def compiler_says(folder: Path, source: str) -> str:
    line = [*toolchain().c, "-std=c99", "-w", "-c", source, "-o", "object.o"]
    return subprocess.run(line, cwd=folder, capture_output=True, text=True, check=False).stderr


TIMES = {
    "milliseconds": (MILLISECONDS, "Sigcat_Milliseconds(5U)", ""),
    "microseconds": (MICROSECONDS, "Sigcat_Microseconds(5U)", ""),
    "a number": (MILLISECONDS, "UINT64_C(5000000)", "incompatible type"),
    "a number of 32 bits": (MILLISECONDS, "5U", "incompatible type"),
    "another unit": (MICROSECONDS, "Sigcat_Milliseconds(5U)", "Sigcat_Milliseconds"),
    "nanoseconds": (NANOSECONDS, "UINT64_C(5000000)", ""),
    "ticks for nanoseconds": (NANOSECONDS, "Sigcat_Milliseconds(5U)", "Sigcat_Milliseconds"),
}


@pytest.mark.parametrize(("clock", "time", "message"), TIMES.values(), ids=TIMES)
def test_a_time_in_another_unit_does_not_compile(clock, time, message, tmp_path):
    core_side.write(subject(FUNCTION, FLOAT, clock), tmp_path)
    (tmp_path / "caller.c").write_text(
        f'#include "F_adapter.h"\nint main(void)\n{{\n    F_Adapter_Start(&F_Adapter_Instance, {time});\n    return 0;\n}}\n'
    )
    line = [*toolchain().c, "-std=c99", "-Werror=implicit-function-declaration", "-c", "caller.c", "-o", "caller.o"]
    done = subprocess.run(line, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert message in done.stderr
    assert (done.returncode == 0) is (message == "")


@pytest.mark.parametrize(("own", "other"), [*permutations((NANOSECONDS, MICROSECONDS, MILLISECONDS), 2)])
def test_the_files_of_another_clock_do_not_compile(own, other, tmp_path):
    core_side.write(subject(FUNCTION, FLOAT, own), tmp_path)
    for file in runtime_files(FLOAT, other):
        (tmp_path / file.name).write_bytes(file.data)
    assert "sigcat_core_time.h counts time in another unit" in compiler_says(tmp_path, "F_adapter.c")


@pytest.mark.parametrize(("own", "other"), [*permutations((NANOSECONDS, MICROSECONDS, MILLISECONDS), 2)])
def test_headers_of_two_clocks_are_not_in_one_file(own, other, tmp_path):
    for folder, clock, name in (("own", own, "F"), ("other", other, "G")):
        (tmp_path / folder).mkdir()
        core_side.write(subject(FUNCTION, FLOAT, clock), tmp_path / folder)
        (tmp_path / folder / "F_adapter.h").rename(tmp_path / folder / f"{name}_adapter.h")
    other_header = tmp_path / "other/G_adapter.h"
    other_header.write_text(
        other_header.read_text().replace("F_Adapter", "G_Adapter").replace("F_ADAPTER", "G_ADAPTER")
    )
    (tmp_path / "caller.c").write_text('#include "own/F_adapter.h"\n#include "other/G_adapter.h"\n')
    assert "sigcat_core_time.h counts time in another unit" in compiler_says(tmp_path, "caller.c")


def test_a_core_in_ticks_does_not_link_with_the_shared_file_of_nanoseconds(tmp_path):
    for folder, clock in (("ticks", MILLISECONDS), ("nanoseconds", NANOSECONDS)):
        (tmp_path / folder).mkdir()
        core_side.write(subject(FUNCTION, FLOAT, clock), tmp_path / folder)
    main = (
        '#include "F_adapter.h"\nint main(void)\n{\n    return F_Adapter_Init(&F_Adapter_Instance, 0, 0U) ? 0 : 1;\n}\n'
    )
    (tmp_path / "ticks/main.c").write_text(main)
    own = [
        "ticks/main.c",
        "ticks/F_adapter.c",
        *(str(path.relative_to(tmp_path)) for path in tmp_path.glob("ticks/code*.c")),
    ]
    said = {
        shared: subprocess.run(
            [*toolchain().c, "-w", *own, f"{shared}/{RUNTIME_SOURCE}", "-lm", "-o", "program"],
            cwd=tmp_path, capture_output=True, text=True, check=False,
        ).stderr
        for shared in ("ticks", "nanoseconds")
    }  # fmt: skip
    assert "Sigcat_CountsInTicks" not in said["ticks"]
    assert "Sigcat_CountsInTicks" in said["nanoseconds"]


@pytest.mark.parametrize("name", FIXED)
@pytest.mark.parametrize("vendor", compilers())
def test_no_compiler_warns(vendor, name, tmp_path):
    document = in_float(name)
    core_side.write(subject(document, FLOAT, clock_of(document)), tmp_path)
    core = next(tmp_path.glob("F_adapter.c*"))
    is_cpp = core.suffix == ".cpp"
    for source, cpp in ((core.name, is_cpp), (RUNTIME_SOURCE, False)):
        standard = "-std=c++17" if cpp else "-std=c99"
        line = [
            *compilers()[vendor].compiler(is_cpp=cpp),
            standard,
            *STRICT,
            "-Wdouble-promotion",
            *EXACT,
            "-c",
            source,
        ]
        done = subprocess.run([*line, "-o", "core.o"], cwd=tmp_path, capture_output=True, text=True, check=False)
        assert (done.returncode, done.stderr) == (0, "")


@pytest.mark.parametrize("name", ["life", *(pytest.param(each, marks=slow) for each in FIXED if each != "life")])
def test_clang_has_no_warning_but_those_that_are_left_out_for_a_reason(name, tmp_path):
    document = in_float(name)
    assert warnings_of_clang(subject(document, FLOAT, clock_of(document)), tmp_path) == ""


@checked_with("cppcheck", "Generated cores have only documented deviations from MISRA C")
@slow
@pytest.mark.parametrize("name", ["time_outs", "errors", "schedules", "supervision"])
def test_cppcheck_finds_documented_deviations(name, tmp_path):
    document = in_float(name)
    core_side.write(subject(document, FLOAT, clock_of(document)), tmp_path)
    for source in ("F_adapter.c", RUNTIME_SOURCE):
        assert undocumented(tmp_path / source, tmp_path) == []


# -- on a controller ----------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", HAVING_MUCH)
def test_a_controller_needs_no_double_and_no_division_of_64_bits(name, tmp_path):
    document = in_float(name)
    core_side.write(subject(document, FLOAT, clock_of(document)), tmp_path)
    for source in ("F_adapter.c", RUNTIME_SOURCE):
        try:
            found = memory(tmp_path / source, [tmp_path])
        except Missing as missing:
            pytest.skip(str(missing))
        assert [each for each in found.library if IS_SLOW.match(each)] == []
