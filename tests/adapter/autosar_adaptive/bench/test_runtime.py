"""Guarantees of ara::core and ara::com within one process, also if everything ends while it is in use."""

import os
import platform
import shlex
import shutil
import subprocess
from collections.abc import Mapping, Sequence
from pathlib import Path

import pytest

from sigcat.adapter.toolchain import packaged
from tests.adapter.autosar_adaptive.bench.building import THREADS, UNDEFINED, programs
from tests.adapter.autosar_adaptive.own_network import PATIENCE, Network, own_network
from tests.needs import IS_SLOW_RUN, c_compiler, slow

pytestmark = [own_network, c_compiler]
ROUNDS = 200 if IS_SLOW_RUN else 20


def run(net: Network, command: Sequence[str | Path]) -> None:
    """It says that all is done, and no sanitizer says anything."""
    program = net.start(command).tells("done", within=10 * PATIENCE)
    assert program.process.wait(PATIENCE) == 0, program.errors
    assert program.errors == ""


def test_results_futures_fields_and_samples_are_as_the_standard_says(net: Network, built: Mapping[str, Path]) -> None:
    run(net, [built["core"]])


def test_proxies_and_skeletons_may_end_while_their_handlers_run(net: Network, built: Mapping[str, Path]) -> None:
    run(net, [built["stress"], str(ROUNDS)])


def stored(program: Path, folder: Path) -> tuple[str, str]:
    """What the program of a storage prints, and what it logs."""
    environment = {**os.environ, "BENCH_STORAGE": str(folder)}
    done = subprocess.run([program], env=environment, capture_output=True, text=True, check=True)
    return done.stdout, done.stderr


def test_a_value_that_is_absent_is_no_error_and_one_that_cannot_be_read_is_logged(
    built: Mapping[str, Path], tmp_path: Path
) -> None:
    printed, logged = stored(built["storage"], tmp_path)
    assert printed == "absent: 0, 7\nthere: 1, 8\nof another type: 0, 1.5\n"
    assert logged.count("\n") == 1
    assert "Probe/Storage, key Count: the value cannot be read: the value has another type" in logged


def test_a_damaged_storage_is_logged_and_not_read_as_an_empty_one(built: Mapping[str, Path], tmp_path: Path) -> None:
    stored(built["storage"], tmp_path)
    (file,) = tmp_path.iterdir()
    file.write_bytes(file.read_bytes()[:-1])
    printed, logged = stored(built["storage"], tmp_path)
    assert "Probe/Storage cannot be opened: the file is damaged" in logged
    assert "there: 0" in printed


@slow
@pytest.mark.parametrize("sanitizer", [THREADS, UNDEFINED], ids=["threads", "undefined behaviour"])
@pytest.mark.parametrize("name", ["core", "stress"])
def test_the_other_sanitizers_are_quiet(net: Network, name: str, sanitizer: Sequence[str]) -> None:
    made = programs(("core", "stress"), sanitizer)
    # Addresses that are the same each time: some kernels give others, which the sanitizer does not know.
    fixed = ["setarch", platform.machine(), "-R"] if shutil.which("setarch") else []
    run(net, [*fixed, made[name], str(ROUNDS)])


@slow
@pytest.mark.skipif(packaged() is None, reason="a second compiler: `pip install ziglang`")
def test_clang_has_nothing_to_warn_of(net: Network, monkeypatch: pytest.MonkeyPatch) -> None:
    clang = packaged()
    assert clang is not None
    monkeypatch.setenv("CC", shlex.join(clang.c))
    monkeypatch.setenv("CXX", shlex.join(clang.cpp))
    made = programs(("core", "sender", "receiver"))
    run(net, [made["core"]])
