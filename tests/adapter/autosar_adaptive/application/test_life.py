"""A process of a function that uses everything: it starts, is stopped, keeps what it has learned, and says when it cannot start."""

import os
import signal
import subprocess
import time
from pathlib import Path

import pytest

from scripts import run_autosar
from sigcat.comparison.running import processes
from tests.adapter.autosar_adaptive.application.generated import FULL, full, write
from tests.needs import cmake, own_network, slow
from tests.waiting import DEADLINE, wait_until

pytestmark = [cmake, own_network, slow]


@pytest.fixture(scope="module")
def executable(tmp_path_factory):
    folder = tmp_path_factory.mktemp("full")
    write(full(), folder)
    run_autosar.build(folder, "", "-DCMAKE_BUILD_TYPE=None", code={"FULL_CODE": FULL})
    return folder / "build/FullExecutable/FullExecutable"


def started(executable, storage, errors=None, **environment):
    storage.mkdir(exist_ok=True)
    return subprocess.Popen(
        [*(processes.own_network() or ()), "sh", "-c", 'ip link set lo up; exec "$0"', executable],
        env={**os.environ, "BENCH_STORAGE": str(storage), **environment}, stderr=errors,
    )  # fmt: skip


def run(executable, storage, seconds=1.0):
    process = started(executable, storage)
    wait_until(lambda: handles_sigterm(process.pid), "the program handles SIGTERM")
    time.sleep(seconds)
    process.send_signal(signal.SIGTERM)
    return process.wait(DEADLINE)


def handles_sigterm(pid):
    """Whether a process has a handler of SIGTERM, by the mask of Linux."""
    status = Path(f"/proc/{pid}/status").read_text(encoding="ascii")
    caught = int(status.partition("SigCgt:")[2].split()[0], 16)
    return bool(caught >> (signal.SIGTERM - 1) & 1)


def contents(storage):
    """Return the content of each storage, by the end of its port."""
    return {file.suffix.removeprefix("."): file.read_bytes() for file in storage.iterdir()}


def test_it_ends_well_when_it_is_asked_to(executable, tmp_path):
    assert run(executable, tmp_path / "storage") == 0


def test_it_keeps_what_it_has_learned_and_counted(executable, tmp_path):
    storage = tmp_path / "storage"
    run(executable, storage)
    first = contents(storage)
    run(executable, storage)
    assert {name: b"Cnt" in data for name, data in first.items()} == {"Adapter": False, "Parameters": True}
    assert b"IgnitionCycle" in first["Adapter"]
    assert contents(storage)["Adapter"] != first["Adapter"]


def test_it_fails_if_the_initialization_of_the_function_does(executable, tmp_path):
    assert started(executable, tmp_path / "storage", FULL_FAILS="1").wait(DEADLINE) == 1


def test_it_fails_if_its_state_cannot_be_reported(tmp_path):
    folder = tmp_path / "full"
    write(full(), folder)
    (client,) = folder.rglob("execution_client.cpp")
    reports, fails = (
        "return {};  // no exec",
        "return ara::core::Result<void>::FromError(ExecErrc::kCommunicationError);  // no exec",
    )
    assert reports in client.read_text()
    client.write_text(client.read_text().replace(reports, fails))
    run_autosar.build(folder, "", "-DCMAKE_BUILD_TYPE=None", code={"FULL_CODE": FULL})
    process = started(folder / "build/FullExecutable/FullExecutable", tmp_path / "storage", subprocess.PIPE)
    _, errors = process.communicate(timeout=DEADLINE)
    assert process.returncode == 1
    assert b"The state Running cannot be reported: " in errors
