"""Calls of different priorities run in separate threads, unless they would disturb each other."""

import platform
import shutil
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import chdir, contextmanager
from itertools import islice
from pathlib import Path

import pytest
from e2e.p04 import e2e_p04_check

from scripts import run_autosar
from sigcat import codes
from sigcat.adapter.autosar_adaptive.application.plan import ComponentPlan
from sigcat.adapter.autosar_adaptive.application.planning.planned_application import derive
from sigcat.adapter.host.connections import Connections
from sigcat.adapter.source_cores import source_cores
from sigcat.adapter.source_functions import source_functions
from sigcat.comparison.running import marks
from sigcat.function.function_file import build_function
from sigcat.function.function_json.wire import written
from sigcat.integration.autosar_adaptive.document import read_integration
from sigcat.integration.autosar_adaptive.model import ServiceInterface
from sigcat.limits import DEFAULT_LIMITS
from sigcat.runs.prepare import prepare
from tests.adapter.autosar_adaptive.application.generated import (
    FULL,
    PACED,
    full,
    paced,
    paced_functions,
    paced_integration,
    write,
)
from tests.adapter.autosar_adaptive.application.test_generate import STRICT
from tests.adapter.autosar_adaptive.bench.building import THREADS
from tests.adapter.autosar_adaptive.own_network import PATIENCE, Network, Program, network
from tests.function.shipped import interfaces
from tests.integration.autosar_adaptive.sets import derive as integrated
from tests.needs import CPP_COMPILERS, cmake, cpp_compiler, own_network

DECLARED = (PACED / "function.yaml").read_text()


def planned(text: str, name: str = "function.yaml") -> ComponentPlan:
    """The plan of the one component."""
    function, _ = build_function(text.encode(), name, interfaces())
    assert function is not None
    data = written(integrated([function]).model)
    model = read_integration(data, name)
    functions = source_functions(model.functions, data, name, DEFAULT_LIMITS, codes.NOT_WRITABLE_AS_ARXML, "all")
    return derive(model, source_cores(functions)).components[0]


def threads(text: str) -> list[list[str]]:
    """Names of the calls of each thread."""
    return [[call.name for call in thread.calls] for thread in planned(text).threads]


def reasons(text: str) -> list[str]:
    """Why calls of different priorities run in one thread."""
    return [each.reason for each in planned(text).joined]


def test_each_priority_has_a_thread() -> None:
    assert threads(DECLARED) == [["Step"], ["SlowStep"], ["AloneStep"]]


def test_calls_of_one_priority_share_a_thread() -> None:
    assert threads(DECLARED.replace("priority: 5", "priority: 20")) == [["Step", "AloneStep"], ["SlowStep"]]


SHARED = DECLARED.replace("paced_slow_speed", "paced_speed")


def test_calls_that_use_one_variable_share_a_thread_and_the_reason_is_given() -> None:
    assert threads(SHARED) == [["Step", "SlowStep"], ["AloneStep"]]
    assert reasons(SHARED) == ["both use paced_speed"]


def test_calls_share_a_thread_where_a_variable_is_in_another_one() -> None:
    whole = SHARED.replace("variable: paced_speed, provider", "variable: paced.in, provider", 1)
    assert reasons(whole.replace("variable: paced_speed, provider", "variable: paced.in.speed, provider")) == [
        "both use paced.in"
    ]
    assert not reasons(whole.replace("variable: paced_speed, provider", "variable: paced.inner, provider"))


def test_calls_that_are_declared_parallel_run_at_the_same_time_whatever_they_share() -> None:
    declared = SHARED
    for symbol in ("paced_step", "paced_slow_step"):
        declared = declared.replace(f"symbol: {symbol}\n", f"symbol: {symbol}\n        parallel: true\n")
    assert threads(declared) == [["Step"], ["SlowStep"], ["AloneStep"]]


def test_no_other_call_runs_while_one_runs_that_is_not_preemptive() -> None:
    slow = "SlowStep: {description: Waits for steps., cycleTime: 50, priority: 10, scheduling: "
    assert threads(DECLARED.replace(f"{slow}Preemptive", f"{slow}NonPreemptive")) == [
        ["Step", "SlowStep"],
        ["AloneStep"],
    ]
    urgent = "Step: {description: Counts., cycleTime: 10, priority: 20, scheduling: "
    assert threads(DECLARED.replace(f"{urgent}Preemptive", f"{urgent}NonPreemptive")) == threads(DECLARED)


def test_calls_that_take_the_mode_share_a_thread() -> None:
    assert threads((FULL / "function.yaml").read_text()) == [["Step", "EventStep"]]
    assert "CallThread" not in full()["FullExecutable/full_adapter.cpp"]


@cpp_compiler
def test_no_compiler_warns_of_the_threads(tmp_path: Path) -> None:
    write(paced(), tmp_path)
    includes = ("-I.", "-Igenerated/include", "-Ibench/include", f"-I{PACED}")
    for source in ("application/call_thread.cpp", "PacedExecutable/paced_adapter.cpp"):
        command = [*CPP_COMPILERS[0], "-std=c++17", *STRICT, *includes, "-fsyntax-only", source]
        done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr


def test_the_page_for_the_integrator_has_the_threads() -> None:
    assert r"| Paced | Paced\_SlowStep | priority 10 |" in paced()["README.md"]
    assert r"| Full | Full\_Step and Full\_EventStep | the same: both use g\_in.mode |" in full()["README.md"]


def ended(program: Program) -> int:
    """Its exit status after the request to end."""
    program.process.send_signal(signal.SIGTERM)
    return program.process.wait(PATIENCE)


def connections() -> Connections:
    """The functions, as points of measurement know them."""
    with chdir(PACED):
        return prepare(paced_functions()).connections


@pytest.fixture(scope="module")
def executable(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The function, compiled for ThreadSanitizer, with points of measurement."""
    folder = tmp_path_factory.mktemp("paced")
    measured = marks.cmake_settings(connections().members, folder)
    flags = f"-O1 -g {' '.join(THREADS)} {measured['CMAKE_C_FLAGS']}"
    write(paced(), folder)
    run_autosar.build(
        folder,
        flags,
        f"-DCMAKE_C_FLAGS={flags}",
        "-DCMAKE_BUILD_TYPE=None",
        code={"PACED_CODE": PACED, "FOLLOW_CODE": PACED},
    )
    return folder / "build/PacedExecutable/PacedExecutable"


# Addresses that are the same each time: some kernels give others, which the sanitizer does not know.
FIXED = ["setarch", platform.machine(), "-R"] if shutil.which("setarch") else []


def started(net: Network, executable: Path, folder: Path, address: str, **environment: str) -> Program:
    """A process of which ThreadSanitizer writes reports."""
    environment |= {"TSAN_OPTIONS": f"log_path={folder}/reports", "SIGCAT_BENCH_ADDRESS": address}
    return net.start([*FIXED, executable], **environment)


@contextmanager
def running(executable: Path, folder: Path, **environment: str) -> Iterator[tuple[Program, Network]]:
    """The process in a separate network; it ends well, and ThreadSanitizer is quiet."""
    with network(folder) as net:
        program = started(net, executable, folder, "127.0.0.2", **environment)
        yield program, net
        assert ended(program) == 0
    assert [file.read_text() for file in folder.glob("reports.*")] == []


@cmake
@own_network
def test_a_slow_call_does_not_block_an_urgent_one_and_threads_are_in_order(executable: Path, tmp_path: Path) -> None:
    """The slow call ends when the urgent one has run three times."""
    with running(executable, tmp_path) as (program, _):
        program.tells("slow step 1", "slow step 5")
    assert "not alone" not in program.told


@cmake
@own_network
def test_threads_that_are_measured_are_in_order(executable: Path, tmp_path: Path) -> None:
    """A call of each thread is measured, while all write to the file of one core."""
    with running(executable, tmp_path, **{marks.FOLDER: str(tmp_path)}) as (program, _):
        program.tells("slow step 1", "slow step 5")
    called = {(call.function, call.call) for call in marks.read_marks(connections(), tmp_path, 0).calls}
    assert called == {("Paced", step.interface) for step in planned(DECLARED).core.steps}


def provided() -> ServiceInterface:
    """The service of the function."""
    services: list[ServiceInterface] = [each for part in paced_integration().components for each in part.services]
    return next(each for each in services if each.role == "Provider" and each.name == "PacedService")


def states(net: Network, address: str) -> Iterator[bytes]:
    """Messages of the protected error, as another implementation of SOME/IP receives them."""
    interface = provided()
    groups = {group.name: group.id for group in interface.event_groups or ()}
    ids = (str(interface.service_id), str(interface.instance_id), str(groups["Fields"]))
    listener = net.start([sys.executable, "-m", f"{__package__}.raw_listener", address, *ids])
    (error,) = interface.services[0].fields
    while True:
        event, _, data = listener.next_line().partition(" ")
        if event == f"{error.notifier_id:#06x}":
            yield bytes.fromhex(data)


@cmake
@own_network
def test_a_state_that_is_protected_is_sent_at_once_and_again_with_each_call(executable: Path, tmp_path: Path) -> None:
    (error,) = provided().services[0].fields
    assert error.protection is not None
    with running(executable, tmp_path) as (_, net):
        for address in ("127.0.0.100", "127.0.0.101"):
            heard = list(islice(states(net, address), 5))
            assert all(e2e_p04_check(each[8:], error.protection.data_id, offset=8) for each in heard)
            counters = [int.from_bytes(each[18:20], "big") for each in heard]
            assert counters == list(range(counters[0], counters[0] + 5))


@cmake
@own_network
def test_a_state_that_is_protected_reaches_another_function_early_and_late(executable: Path, tmp_path: Path) -> None:
    follow = executable.parents[1] / "FollowExecutable/FollowExecutable"
    with running(executable, tmp_path) as (_, net):
        for _ in range(2):
            program = started(net, follow, tmp_path, "127.0.0.3")
            program.tells("dep 1", "dep 0")
            assert ended(program) == 0
