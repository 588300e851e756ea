"""The points of measurement, compiled into real cores, and what they write."""

import os
import struct
import subprocess
import sys

import pytest

from sigcat.adapter.toolchain import toolchain
from sigcat.comparison.running.marks import FOLDER, read_marks, write_header
from sigcat.errors import UsageError
from tests import needs
from tests.comparison.ecocontrol import subject

pytestmark = needs.c_compiler
MAIN = """
#include <sched.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <unistd.h>
#include "CoreAcc_adapter.h"

#ifdef RUSAGE_THREAD
static long taken(void)
{
    struct rusage usage;
    (void)getrusage(RUSAGE_THREAD, &usage);
    return usage.ru_nivcsw;
}

/* Work without a wait, until a process that may use the same processor alone has had it. */
static void be_preempted(void)
{
    const long before = taken();
    pid_t busy;
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(sched_getcpu(), &one);
    (void)sched_setaffinity(0, sizeof(one), &one);
    busy = fork();
    if (busy == 0) {
        for (;;) {
        }
    }
    while (taken() == before) {
    }
    (void)kill(busy, SIGKILL);
}
#else
static void be_preempted(void)
{
}
#endif

int main(int argc, char **argv)
{
    CoreAcc_Adapter *self = &CoreAcc_Adapter_Instance;
    (void)CoreAcc_Adapter_Init(self, 0, 1);
    CoreAcc_Adapter_Start(self, 0);
    for (uint64_t t = 0; t < 3000000000U; t += 50000000U) {
        CoreAcc_Adapter_Receive_Mode_In(self, 2, t);
        if ((argc > 2) && ((t % (uint64_t)strtoul(argv[2], NULL, 10)) == 0U)) {
            CoreAcc_Adapter_Supervise(self, t);
        }
        while (CoreAcc_Adapter_NextCall(self, t) != CORE_ACC_ADAPTER_NO_CALL) {
            CoreAcc_Adapter_SetInput_Step(self, t);
            CoreAcc_Adapter_Begin_Step(self, t);
            CoreAcc_Adapter_Run_Step(self);
            if ((argc > 1) && (argv[1][0] == 'p') && (t == 50000000U)) {
                be_preempted();
            }
            CoreAcc_Adapter_GetOutput_Step(self, t);
        }
    }
    return 0;
}
"""


@pytest.fixture(scope="module")
def program(tmp_path_factory):
    from sigcat.adapter.core.cores import cores

    folder = tmp_path_factory.mktemp("marks")
    for file in cores(subject().functions).files:
        (folder / file.name).write_bytes(file.data)
    (folder / "main.c").write_text(MAIN)
    header = write_header(subject().prepared.connections.members, folder / "header")
    code = subject().code_settings["CORE_ACC_CODE"]
    sources = [folder / "CoreAcc_adapter.c", folder / "sigcat_core.c", folder / "main.c", code / "CoreAcc.c"]
    flags = [
        "-std=c99",
        "-Wall",
        "-Wextra",
        "-Werror",
        "-ffp-contract=off",
        "-include",
        header,
        f"-I{folder}",
        f"-I{code}",
    ]
    command = [*toolchain().c, *flags, "-o", folder / "program", *sources, "-lm"]
    subprocess.run(list(map(str, command)), check=True)
    return folder / "program"


def test_each_call_is_told_with_its_time_and_how_long_its_parts_took(program, tmp_path):
    subprocess.run([program], check=True, env={**os.environ, FOLDER: str(tmp_path)})
    calls = read_marks(subject().prepared.connections, tmp_path, 0).calls
    assert [each.time_ns for each in calls] == list(range(0, 3_000_000_000, 50_000_000))
    assert {(each.function, each.call) for each in calls} == {("CoreAcc", "CoreAcc_Step")}
    assert all(0 <= each.t_logic_ns <= each.t_exec_ns and each.t_adapter_ns > 0 for each in calls)


@pytest.mark.skipif(sys.platform != "linux", reason="the system does not say it")
def test_a_call_whose_processor_was_given_to_something_else_is_told(program, tmp_path):
    subprocess.run([program, "preempted"], check=True, env={**os.environ, FOLDER: str(tmp_path)})
    calls = read_marks(subject().prepared.connections, tmp_path, 0).calls
    assert calls[1].is_preempted
    assert {each.call for each in calls} == {"CoreAcc_Step"}
    assert not all(each.is_preempted for each in calls)


def test_safety_reactions_are_those_that_the_core_has_after_each_call(program, tmp_path):
    """Nobody sends a brake pressure: after its time-out and the maturation of the error, the reaction is active."""
    subprocess.run([program], check=True, env={**os.environ, FOLDER: str(tmp_path)})
    reactions = read_marks(subject().prepared.connections, tmp_path, 0).reactions["AccReqInvalid_SftyCondSts"]
    assert [text for _, text in reactions] == ["INACTIVE", "ACTIVE"]
    assert reactions[0][0] == 0 < reactions[1][0] < 1_000_000_000


def test_reactions_have_the_time_of_the_drive_whatever_the_clock_of_the_platform(program, tmp_path):
    subprocess.run([program], check=True, env={**os.environ, FOLDER: str(tmp_path)})
    connections = subject().prepared.connections
    (as_marked,), (in_drive,) = (
        [time for time, _ in read_marks(connections, tmp_path, 0, clock).reactions["AccReqInvalid_SftyCondSts"][1:]]
        for clock in (0, 1000)
    )
    assert in_drive == as_marked - 1000


@pytest.mark.parametrize(("period_ms", "longest_ms"), [(50, 50), (100, 100), (1000, 1000), (100_000, 2950)])
def test_times_between_calls_of_supervise_are_those_of_the_host(program, tmp_path, period_ms, longest_ms):
    command = [program, "-", str(period_ms * 1_000_000)]
    subprocess.run(command, check=True, env={**os.environ, FOLDER: str(tmp_path)})
    marked = read_marks(subject().prepared.connections, tmp_path, 0)
    (found,) = [each for each in marked.supervised if each.function == "CoreAcc"]
    assert (found.call, found.period_ns) == ("", 50_000_000)
    assert max(found.gaps_ns) == longest_ms * 1_000_000
    assert {each.call for each in marked.calls} == {"CoreAcc_Step"}


def test_without_a_folder_nothing_is_measured(program, tmp_path):
    environment = {name: value for name, value in os.environ.items() if name != FOLDER}
    subprocess.run([program], check=True, env=environment, cwd=tmp_path)
    assert list(tmp_path.iterdir()) == []


def test_a_record_that_was_cut_off_is_left_out(program, tmp_path):
    subprocess.run([program], check=True, env={**os.environ, FOLDER: str(tmp_path)})
    (file,) = tmp_path.iterdir()
    file.write_bytes(file.read_bytes()[:-5])
    assert len(read_marks(subject().prepared.connections, tmp_path, 0).calls) == 59


@pytest.mark.parametrize("number", [0, 2])
def test_a_call_that_the_function_does_not_have_is_refused(number, tmp_path):
    """As nodes that people wrote may number theirs."""
    (tmp_path / "CoreAcc.1").write_bytes(struct.pack("=QQQQQII", 0, 1, 2, 3, 4, number, 0))
    with pytest.raises(UsageError, match=f"names its call {number}; it has calls 1 to 1"):
        read_marks(subject().prepared.connections, tmp_path, 0)


@needs.cmake
def test_a_core_in_cpp_takes_the_same_header(tmp_path):
    header = write_header(subject().prepared.connections.members, tmp_path)
    flags = ["-std=c++17", "-Wall", "-Wextra", "-Werror", "-fsyntax-only", "-x", "c++"]
    source = tmp_path / "empty.cpp"
    source.write_text("int main() { return 0; }\n")
    subprocess.run([*toolchain().cpp, *flags, "-include", str(header), str(source)], check=True)
