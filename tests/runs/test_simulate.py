"""`sigcat simulate`: what it says of code that cannot be built, and of calls that do not return. It lives through all of it."""

import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
from contextlib import suppress
from pathlib import Path

import pytest

from scripts.cases import ROOT, RUNS
from sigcat.adapter import toolchain
from sigcat.cli import main
from sigcat.data import EXAMPLES
from tests.needs import slow
from tests.waiting import DEADLINE, wait_until

CASE = ROOT / RUNS.folder / "one_function_feeds_another"
EXPECTED = (CASE / RUNS.expected).read_text()
RUN = ("simulate", "filter.yaml", "counter.yaml", "--trace", "trace.csv")


@pytest.fixture
def case(tmp_path, monkeypatch, capfd):
    """The two functions of a case, in which texts are replaced before they run."""
    shutil.copytree(CASE, tmp_path, dirs_exist_ok=True)
    monkeypatch.chdir(tmp_path)

    def run(*options, **changes):
        for name, (old, new) in changes.items():
            (file,) = (path for path in tmp_path.rglob("*.*") if path.name.replace(".", "_") == name)
            assert old in file.read_text()
            file.write_text(file.read_text().replace(old, new))
        status = main([*RUN, "-o", "out.csv", *options])
        said = capfd.readouterr()
        assert said.out == ""
        assert "Traceback" not in said.err
        said = said.err.replace("what a function prints is no result\n", "").splitlines()
        said = [line for line in said if not re.match(r" +([0-9]+ \| |\^+$)", line)]  # the lines below errors
        return status, said

    return run


@pytest.fixture(params=["system", pytest.param("pypi", marks=slow)])
def compiler(request, monkeypatch):
    """The compiler of the system, and that of PyPI: their messages differ."""
    monkeypatch.delenv("CC", raising=False)
    monkeypatch.delenv("CXX", raising=False)
    if request.param == "pypi":
        if toolchain.packaged() is None:
            pytest.skip("the compiler of PyPI: pip install ziglang")
        monkeypatch.setenv("PATH", "")


def test_two_runs_give_the_same_bytes_and_leave_nothing_behind(case, monkeypatch, tmp_path):
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path / "temporary"))
    Path("temporary").mkdir()
    for _ in range(2):
        assert case() == (0, [])
        assert Path("out.csv").read_text() == EXPECTED
    assert list(Path("temporary").iterdir()) == []


def test_state_and_stack_of_each_core_are_told(case, compiler):
    status, said = case("--memory")
    assert status == 0
    stack = r"(\d+ bytes of stack in \w+_Adapter_\w+|stack unknown)"
    assert [re.sub(rf": \d+ bytes of state, {stack}", "", line) for line in said] == ["Filter", "Counter"]
    states = [int(re.findall(r"\d+", line)[0]) for line in said]
    assert all(100 < state < 5000 for state in states)


def test_what_functions_keep_is_in_a_file_that_the_next_run_reads(case):
    assert case("--stored", "stored.json") == (0, [])
    stored = json.loads(Path("stored.json").read_text())
    assert stored["Filter"]["ignitionCycle"] == 1
    assert stored["Filter"]["errors"]["Filter_Standstill_ErrorSts"]["occurrences"] == 1
    stored["Filter"]["errors"]["Filter_Standstill_ErrorSts"] |= {"occurrences": 7, "isTested": True}
    Path("stored.json").write_text(json.dumps(stored))
    assert case("--stored", "stored.json", "--ignition-cycle", "2")[0] == 0
    again = json.loads(Path("stored.json").read_text())["Filter"]
    assert (again["ignitionCycle"], again["errors"]["Filter_Standstill_ErrorSts"]["occurrences"]) == (2, 8)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("[", "stored.json must be a JSON object"),
        ("[]", "stored.json must be a JSON object"),
        ("null", "stored.json must be a JSON object"),
        ('{"Filter": {"parameters": {"Gian": 2}}}', "stored.json: Filter/parameters/Gian is not kept by the function"),
        ('{"Filter": 5}', "stored.json: Filter must be an object, as a run with --stored writes it"),
        ('{"Filter": {"ignitionCycle": null}}', "stored.json: Filter/ignitionCycle must be a whole number from 0 to"),
        ('{"Filter": {"faults": 3}}', "stored.json: Filter/faults is not kept by the function"),
        ('{"Filter": {"ignitionCycle": -1}}', "stored.json: Filter/ignitionCycle must be a whole number from 0 to"),
        ('{"Filter": {"errors": {"Filter_Standstill_ErrorSts": 3}}}', "must be a mapping with occurrences"),
    ],
)
def test_a_file_of_what_is_kept_that_cannot_be_used(case, text, words):
    Path("stored.json").write_text(text)
    status, (line,) = case("--stored", "stored.json")
    assert status == 2
    assert words in line
    assert Path("stored.json").read_text() == text


def test_what_functions_keep_that_do_not_run_stays_in_the_file(case):
    Path("stored.json").write_text('{"Other": {"parameters": {"Gain": 0.5}}}')
    assert case("--stored", "stored.json") == (0, [])
    stored = json.loads(Path("stored.json").read_text())
    assert stored["Other"] == {"parameters": {"Gain": 0.5}}
    assert stored["Filter"]["ignitionCycle"] == 1


def test_numbers_of_functions_that_do_not_run_keep_their_digits(case):
    kept = '{"Other": {"x": 1e400, "y": 1.00000005960464477539062500001, "ä": [], "z": {}}}'
    Path("stored.json").write_text(kept)
    assert case("--stored", "stored.json") == (0, [])
    text = Path("stored.json").read_text()
    assert '"x": 1e400,' in text
    assert '"y": 1.00000005960464477539062500001,' in text
    assert "Infinity" not in text
    document = json.loads(text)
    assert document["Other"] == json.loads(kept)["Other"]
    assert list(document) == ["Other", "Filter", "Counter"]


STORING = """
function: Storing
description: Keeps two parameters under one key.
responsible: Tests
code: {signature: globals, sources: [storing.c], headers: [storing.h]}
components:
  - name: Storing
    runnables:
      - interface: Step
        data: [{path: Vehicle.Speed, role: consumed, variable: g_speed, asil: QM}]
        parameters:
          - {path: GainA, variable: g_gain_a, key: Gain, storage: CalA}
          - {path: GainB, variable: g_gain_b, key: Gain, storage: CalB}
define:
  parameters:
    GainA: {datatype: float, default: 1, asil: QM, description: In the first storage.}
    GainB: {datatype: float, default: 2, asil: QM, description: In the second storage.}
  scheduling:
    Step: {description: Runs., asil: QM, cycleTime: 20}
"""


def test_storages_that_have_the_same_key_are_kept_apart(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Path("storing.yaml").write_text(STORING)
    Path("storing.h").write_text("extern float g_speed, g_gain_a, g_gain_b;\nvoid Storing_Step(void);\n")
    Path("storing.c").write_text(
        '#include "storing.h"\nfloat g_speed, g_gain_a, g_gain_b;\nvoid Storing_Step(void) {}\n'
    )
    Path("stored.json").write_text('{"Storing": {"parameters": {"CalA.Gain": 0.25, "CalB.Gain": 0.75}}}')
    assert main(["simulate", "storing.yaml", "--duration", "0.1", "-o", "out.csv", "--stored", "stored.json"]) == 0
    assert json.loads(Path("stored.json").read_text())["Storing"]["parameters"] == {
        "CalA.Gain": 0.25,
        "CalB.Gain": 0.75,
    }


@pytest.mark.skipif(os.name != "posix", reason="devices of POSIX")
def test_what_is_kept_is_in_a_regular_file(case):
    assert case("--stored", "/dev/zero") == (2, ["sigcat: /dev/zero must be a regular file"])


@pytest.mark.parametrize("form", ["json", "sarif"])
def test_a_report_has_the_words_of_the_compiler_at_the_line_of_the_declaration(case, form):
    status, _ = case("--report", "report", "--format", form, filter_yaml=("filter_in.speed", "filter_in.sped"))
    assert status == 1
    report = json.loads(Path("report").read_text())
    found = json.dumps(report)
    assert "T010" in found
    assert "filter.yaml" in found
    assert "sped" in found


def test_a_report_of_a_good_run_is_empty(case):
    assert case("--report", "report.json") == (0, [])
    assert json.loads(Path("report.json").read_text())["findings"] == []


# -- code that cannot be built -------------------------------------------------------------------------------------


UNFIT = {
    "a member that does not exist": ({"filter_yaml": ("filter_in.speed", "filter_in.sped")}, "filter.yaml:14:61", "sped"),
    "a variable that is narrower": ({"filter_h": ("double speed", "float speed")}, "filter.yaml:14:61", "filter_in.speed must be double"),
    "an array that is longer": ({"filter_h": ("levels[3]", "levels[4]")}, "filter.yaml:15:69", "filter_out.levels must have 3 elements"),
    "a function that is not declared": ({"filter_yaml": ("symbol: filter_step", "symbol: filter_stepp")}, "filter.yaml:12:17", "filter_stepp"),
    "an undefined function": ({"filter_c": ("void filter_step(", "void filter_stop(")}, "filter.yaml:12:17", "filter_step"),
    "an undefined variable": ({"filter_c": ("filter_in_t filter_in;", "")}, "filter.", "'filter_in'"),
    "a type that does not exist": ({"counter_yaml": ("type: counter_t", "type: counter_s")}, "counter.yaml:5", "counter_s"),
    "a status that is a struct": ({"filter_yaml": ("{variable: filter_out.mode}", "{variable: filter_out}")}, "filter.yaml:24", ""),
}  # fmt: skip


@pytest.mark.parametrize("name", UNFIT)
def test_what_the_declaration_says_of_the_code_and_is_not_so(case, compiler, name):
    changes, place, word = UNFIT[name]
    status, said = case(**changes)
    assert status == 1
    findings = [line for line in said if " T010 " in line or " T011 " in line]
    assert any(line.startswith(place) and word in line for line in findings), said
    assert not any("expression in static assertion" in line for line in findings), said
    assert said[-1].startswith("sigcat: The functions cannot be run: ")


@pytest.mark.parametrize("compiler", ["system", "pypi"], indirect=True)
def test_sources_that_do_not_compile_stand_in_the_words_of_the_compiler(case, compiler):
    status, said = case(counter_c=("self->count += ", "self->cuont += "))
    assert status == 1
    assert re.match(r"code/counter\.c:\d+:\d+: error T011 The compiler says: .*cuont", said[0])
    assert said[-1] == "sigcat: The functions cannot be run: compiling code/counter.c failed."
    assert not Path("out.csv").exists()


@pytest.mark.parametrize("compiler", ["system", "pypi"], indirect=True)
def test_a_call_of_a_function_that_no_header_declares_is_refused(case, compiler):
    status, said = case(counter_c=("self->count += ", "self->count += (int)fabs(0.5) + "))
    assert status == 1
    assert re.match(r"code/counter\.c:\d+:\d+: error T011 The compiler says: .*fabs", said[0])


@pytest.mark.parametrize("compiler", ["system", "pypi"], indirect=True)
def test_warnings_of_the_compiler_are_notes_about_the_code(case, compiler):
    status, said = case(counter_c=("self->count += ", "int unset;\n  self->count += unset + "))
    assert status == 0
    assert [line.partition(":")[0] for line in said if " T012 " in line] == ["code/counter.c"]
    assert "uninitialized" in "".join(said)


def test_code_without_warnings_has_no_notes(case):
    status, said = case()
    assert (status, [line for line in said if " T012 " in line]) == (0, [])


def test_a_build_that_fails_prints_no_header(case):
    status, _ = case("-o", "-", counter_c=("self->count += ", "self->cuont += "))  # which checks standard output
    assert status == 1


@pytest.mark.parametrize(
    ("changes", "expected"),
    [
        ({"filter_yaml": ("[filter.c]", "[flter.c]")}, "filter.yaml:5:38: error F201 There is no file 'flter.c'."),
        (
            {"counter_yaml": ("[counter.h]", "[cuonter.h]")},
            "counter.yaml:8:13: error F201 There is no header 'cuonter.h'.",
        ),
        ({"counter_yaml": ("[code]", "[cod]")}, "counter.yaml:9:20: error F201 There is no folder 'cod'."),
    ],
)
def test_files_that_are_not_there(case, changes, expected):
    status, said = case(**changes)
    assert status == 1
    assert any(line.startswith(expected) for line in said)


def test_without_a_compiler_one_line_says_so(case, monkeypatch):
    monkeypatch.setenv("PATH", "")
    monkeypatch.delenv("CC", raising=False)
    monkeypatch.setattr(toolchain, "find_spec", lambda _: None)
    status, (line,) = case()
    assert (status, line[:36]) == (2, "sigcat: No C compiler found. Install")
    assert not Path("out.csv").exists()


def test_a_function_is_given_once(case):
    assert main(["simulate", "filter.yaml", *RUN[1:]]) == 2


# -- calls that do not return --------------------------------------------------------------------------------------

LAST = "    filter_out.mode = filter_in.mode;"
INPUTS = ["  Vehicle.Speed = 72.5", "  Filter_Mode_In = ON"]


@pytest.mark.parametrize(
    ("statement", "how"),
    [
        ("*(volatile int *)0 = 1;", r"SIGSEGV \(Segmentation fault\)"),
        ("__builtin_trap();", r"(SIGILL|SIGTRAP) \(.*\)"),
        ("__builtin_abort();", r"SIGABRT \(Aborted\)"),
        ("__builtin_exit(3);", "exit status 3"),
        ("__builtin_exit(0);", "exit status 0"),
    ],
)
def test_a_call_that_crashes_is_told_with_what_it_had_received(case, statement, how):
    statement = statement.replace("__builtin_exit", "exit").replace("__builtin_abort", "abort")
    includes = ("#include <stdio.h>", "#include <stdio.h>\n#include <stdlib.h>")
    source = Path("filter.c")
    source.write_text(source.read_text().replace(*includes))
    status, said = case(filter_c=(LAST, f"    if (filter_in.speed > 15) {{ {statement} }}"))
    assert status == 1
    assert re.fullmatch(
        rf"filter\.yaml:12:17: error T020 Filter_Step ended the process at 0\.060000000 s with {how}\.", said[0]
    )
    assert said[1] == "sigcat: The run was stopped in Filter_Step at 0.060000000 s. What it had received last:"
    assert said[2:] == INPUTS
    lines = Path("out.csv").read_text().splitlines()
    assert lines[-1] == "0.040000000,Counter_Step,,,,,6,4.166666666666667,true,"


def test_a_file_that_is_there_stays_if_the_run_is_stopped(case):
    Path("out.csv").write_text("earlier\n")
    status, said = case("-o", "new.csv", filter_c=(LAST, "    if (filter_in.speed > 15) { __builtin_trap(); }"))
    assert status == 1
    assert "sigcat: out.csv stays as it was: the run did not come to its end." in said
    assert Path("out.csv").read_text() == "earlier\n"
    assert len(Path("new.csv").read_text().splitlines()) > 2


def test_a_call_without_an_end_is_stopped_after_a_limit(case):
    status, said = case("--step-limit", "0.3", filter_c=(LAST, "    while (filter_in.speed > 15) {}"))
    assert status == 1
    assert (
        said[0]
        == "filter.yaml:12:17: error T021 Filter_Step must return within 0.3 s; the call at 0.060000000 s did not."
    )
    assert said[2:] == INPUTS


@pytest.mark.parametrize("parent", ["exit(3);", "for (;;) {}"], ids=["has ended", "is stopped"])
def test_processes_that_a_function_began_end_with_it(case, parent, tmp_path):
    """They hold what the run writes to: it would not end before they do."""
    pid = tmp_path / "pid"
    forks = (
        "pid_t child = fork();\n        if (child == 0) { for (;;) { pause(); } }\n"
        f'        FILE *told = fopen("{pid}", "w"); fprintf(told, "%d", (int)child); fclose(told); {parent}'
    )
    includes = (
        "#include <stdio.h>",
        "#define _DEFAULT_SOURCE\n#include <stdio.h>\n#include <stdlib.h>\n#include <unistd.h>",
    )
    source = Path("filter.c")
    source.write_text(source.read_text().replace(*includes))
    status, _ = case("--step-limit", "1", filter_c=(LAST, f"    if (filter_in.speed > 15) {{ {forks} }}"))
    assert status == 1
    wait_until(lambda: not _first_word(Path("/proc") / pid.read_text() / "cmdline"), "what it began has ended")


def test_what_came_from_another_function_is_told_too(case):
    status, said = case(
        counter_c=("    self->rises =", "    if (in->trend == 1) { *(volatile int *)0 = 1; }\n    self->rises =")
    )
    assert status == 1
    assert "Counter_Step ended the process at 0.100000000 s" in said[0]
    assert said[2:] == [
        "  Vehicle.Filter.Levels = [30.5625,61.125,49.75]",
        "  Vehicle.Filter.Trend = FALLS",
        "  Filter_Standstill_ErrorSts = PASSED",
    ]


def test_a_process_goes_on_to_its_end(case):
    """Work that it leaves for then, such as times in a file that is closed, would be lost otherwise."""
    includes = (
        "#include <stdio.h>",
        "#define _DEFAULT_SOURCE\n#include <stdio.h>\n#include <stdlib.h>\n#include <unistd.h>",
    )
    at_exit = """
static void left(void)
{
    usleep(200000);
    fclose(fopen("left", "w"));
}

void filter_init(void)
{
    (void)atexit(left);"""
    source = Path("filter.c")
    source.write_text(source.read_text().replace(*includes))
    assert case(filter_c=("\nvoid filter_init(void)\n{", at_exit)) == (0, [])
    assert Path("left").exists()


def test_an_init_that_crashes_is_told(case):
    status, said = case(filter_c=("    filter_out.trend = 8;\n}", "    *(volatile int *)0 = 1;\n}"))
    assert status == 1
    assert "Filter_Init ended the process at 0.000000000 s with SIGSEGV" in said[0]
    assert said[1:] == ["sigcat: The run was stopped in Filter_Init at 0.000000000 s. It had received nothing."]


def test_an_init_that_fails_is_a_warning(case):
    for name in ("filter.h", "filter.c"):
        file = Path(name)
        file.write_text(file.read_text().replace("void filter_init", "int filter_init"))
    changes = {
        "filter_c": ("filter_out.trend = 8;", "return 7;"),
        "filter_yaml": ("symbol: filter_init", "symbol: filter_init, success: 0"),
    }
    status, (said,) = case(**changes)
    assert (status, said[:30]) == (0, "filter.yaml:10:9: warning T022")
    assert [line for line in Path("out.csv").read_text().splitlines() if "Step" in line] == []


# -- how long, and without a trace ---------------------------------------------------------------------------------


def test_it_runs_as_long_as_one_says(case):
    case("--duration", "0.04")
    lines = Path("out.csv").read_text().splitlines()
    assert lines[:-2] == EXPECTED.splitlines()[: len(lines) - 2]
    assert [line[:11] for line in lines[-4:]] == ["0.040000000"] * 4


def test_a_trace_of_nothing_has_no_length(case):
    Path("trace.csv").write_text("time,Vehicle.Speed,Filter_Mode_In\n")
    assert case() == (
        2,
        ["sigcat: the run has no inputs: name a trace with --trace FILE, or run without inputs for --duration SECONDS"],
    )
    assert case("--duration", "0.1") == (0, [])


def test_without_a_trace_and_a_duration_nothing_is_printed_before_the_error(case, capfd):
    without_trace = [word for word in RUN if word not in ("--trace", "trace.csv")]
    assert main(without_trace) == 2
    said = capfd.readouterr()
    assert said.out == ""
    assert "name a trace with --trace FILE" in said.err


def test_a_run_of_years_is_refused_where_it_is_asked_for(case):
    """Mistyped, or in another unit: a thousand million seconds of calls would never come to their end."""
    trace = Path("trace.csv")
    rows = trace.read_text().splitlines()
    trace.write_text("\n".join([*rows, f"1000000000{',' * rows[0].count(',')}", ""]))
    status, (said, last) = case()
    assert (status, last) == (1, "sigcat: The run would be too long.")
    assert said.startswith(
        f"trace.csv:{len(rows) + 1}:1: error T006 A run from 0.000000000 s to 1000000000.000000000 s has "
    )
    assert case("--duration", "0.04") == (0, [])
    status, (said,) = case("--duration", "1e9")
    assert (status, said[-25:]) == (2, ": give a shorter duration")


def test_calls_that_trigger_each_other_are_stopped(tmp_path, monkeypatch, capfd):
    monkeypatch.chdir(tmp_path)
    for own, other in (("Ping", "Pong"), ("Pong", "Ping")):
        Path(f"{own}.c").write_text(f"float {own}_in, {own}_out;\nvoid {own}_step(void) {{ {own}_out = {own}_in; }}\n")
        Path(f"{own}.h").write_text(f"extern float {own}_in, {own}_out;\nvoid {own}_step(void);\n")
        Path(f"{own}.yaml").write_text(_triggered(own, other))
    Path("trace.csv").write_text("time,Vehicle.Speed\n0,\n0.5,1\n")
    assert main(["simulate", "Ping.yaml", "Pong.yaml", "--trace", "trace.csv"]) == 1
    said = capfd.readouterr().err
    assert "error T023 At 0.500000000 s, calls trigger each other without end." in said


def _triggered(own, other):
    return f"""
function: {own}
description: Answers {other}.
responsible: Demo team
code: {{signature: globals, sources: [{own}.c], headers: [{own}.h]}}
components:
  - name: {own}
    runnables:
      - {{interface: Init, symbol: '{own}_step'}}
      - interface: Step
        symbol: {own}_step
        data:
          - {{path: Vehicle.Demo.{other}, role: consumed, variable: {own}_in}}
          - {{path: Vehicle.Speed, role: consumed, name: Speed, variable: {own}_in, asil: QM}}
          - {{path: Vehicle.Demo.{own}, role: provided, variable: {own}_out}}
      - {{interface: Terminate, symbol: '{own}_step'}}
define:
  data:
    Vehicle.Demo: {{type: branch, description: A demonstration.}}
    Vehicle.Demo.{own}: {{datatype: float, asil: QM, description: The answer.}}
  scheduling:
    Init: {{description: Prepares., asil: QM, priority: 1, scheduling: Preemptive}}
    Step: {{description: Works., asil: QM, runType: EventTriggered, priority: 10, scheduling: Preemptive}}
    Terminate: {{description: Ends., asil: QM, priority: 1, scheduling: Preemptive}}
"""


def test_the_drive_of_the_examples_goes_as_it_was_recorded(tmp_path, capfd):
    """Ten minutes: the predictive control saves energy, and the cruise control continues without it."""
    functions = [str(EXAMPLES / name / "function.yaml") for name in ("core_acc", "eco_control_mpc")]
    trace, output = str(EXAMPLES / "ecocontrol/drive.csv"), str(tmp_path / "out.csv")
    assert main(["simulate", *functions, "--trace", trace, "-o", output]) == 0
    lines = Path(output).read_text().splitlines()
    steps = [line.split(",")[1] for line in lines]
    assert steps.count("CoreAcc_Step") == 11780
    assert steps.count("EcoControlMpc_Step") == 1178
    told = capfd.readouterr().err.splitlines()
    assert ["T008 Vehicle.Chassis.Steering.WhlAg: 40 values" in line for line in told] == [True]


@pytest.mark.skipif(not Path("/proc/self/cmdline").exists(), reason="the list of processes of Linux")
def test_who_ends_it_ends_the_functions_too(tmp_path):
    shutil.copytree(CASE, tmp_path, dirs_exist_ok=True)
    source = next(tmp_path.rglob("filter.c"))
    source.write_text(source.read_text().replace(LAST, "    for (;;) {}"))
    environment = {**os.environ, "TMPDIR": str(tmp_path / "temporary")}
    (tmp_path / "temporary").mkdir()
    command = [sys.executable, "-m", "sigcat.cli", *RUN, "--step-limit", "1000"]
    with subprocess.Popen(command, cwd=tmp_path, env=environment, stdout=subprocess.DEVNULL) as process:
        wait_until(lambda: _runs(tmp_path), "the functions run")
        process.terminate()
        assert process.wait(timeout=DEADLINE) == 128 + signal.SIGTERM
    assert not _runs(tmp_path)
    assert list((tmp_path / "temporary").iterdir()) == []


def _runs(folder):
    """Whether a program below a folder is running."""
    return any(str(folder / "temporary").encode() in _first_word(each) for each in Path("/proc").glob("[0-9]*/cmdline"))


def _first_word(command_line):
    with suppress(OSError):  # it has ended
        return command_line.read_bytes().partition(b"\0")[0]
    return b""
