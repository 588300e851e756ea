"""A drive is played faster than the clock, by the player and by the clocks of components."""

import os
import pty
import subprocess
from pathlib import Path

import pytest

from sigcat.adapter.autosar_adaptive import application, bench
from sigcat.adapter.toolchain import toolchain
from tests.needs import c_compiler

pytestmark = c_compiler
APPLICATION = Path(application.__file__).parent
BENCH = Path(bench.__file__).with_name("runtime") / "include"
MAIN = """
#include <chrono>
#include <cstdio>
#include <thread>

#include "application/clock.h"
#include "bench/counters.h"
#include "player/message.h"
#include "player/progress.h"

namespace bench {
Counters Count() { return {}; }
}

int main() {
    using Steady = std::chrono::steady_clock;
    const auto clock = application::MakeClock("Any");
    const auto begin = clock->Now();
    std::this_thread::sleep_for(std::chrono::milliseconds{20});
    const auto slept = clock->Now();
    const auto start = Steady::now();
    const bool goes_on = clock->WaitUntil(slept + 100000000000U);
    const std::chrono::duration<double> waited = Steady::now() - start;
    std::printf("%d %d %d %d\\n", slept - begin >= 20000000000U, goes_on, clock->Now() >= slept + 100000000000U,
                waited.count() < 50.0);
    player::ProgressLine progress{600000000000U};
    progress.Reach(300000000000U);
    progress.Reach(600000000000U);
    clock->Stop();
    return clock->WaitUntil(0) ? 1 : 0;
}
"""


@pytest.fixture(scope="module")
def program(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("speed")
    (folder / "player").symlink_to(APPLICATION / "player/cpp")
    (folder / "application").symlink_to(APPLICATION / "cpp")
    (folder / "main.cpp").write_text(MAIN)
    sources = ["main.cpp", "player/make_clock.cpp", "player/message.cpp", "application/clock.cpp"]
    warnings = ["-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Wconversion", "-Werror"]
    command = [
        *toolchain().cpp,
        "-std=c++17",
        *warnings,
        f"-I{folder}",
        f"-I{BENCH}",
        "-o",
        "main",
        *sources,
        "-pthread",
    ]
    subprocess.run([*map(str, command)], cwd=folder, check=True)
    return folder / "main"


def run(program: Path, speed: str) -> "subprocess.CompletedProcess[str]":
    environment = {"BENCH_SPEED": speed}
    return subprocess.run([program], env=environment, text=True, capture_output=True, check=False)


def test_the_clock_of_a_component_is_a_thousand_times_faster(program: Path) -> None:
    done = run(program, "1000")
    assert (done.returncode, done.stdout.split()) == (0, ["1", "1", "1", "1"])


@pytest.mark.parametrize("speed", ["0", "-1", "fast", "1e9", "", "nan"])
def test_a_speed_that_is_not_a_number_in_range_is_refused(program: Path, speed: str) -> None:
    done = run(program, speed)
    assert done.returncode == 1
    assert "the speed must be a number from 0.001 to 1000" in done.stderr


def test_progress_is_shown_at_a_terminal_alone(program: Path) -> None:
    assert run(program, "1000").stderr == ""
    ours, theirs = pty.openpty()
    subprocess.run([program], env={"BENCH_SPEED": "1000"}, stdout=subprocess.DEVNULL, stderr=theirs, check=True)
    os.close(theirs)
    shown = os.read(ours, 4096).decode()
    os.close(ours)
    assert "player: 300 of 600 s" in shown
    assert shown.endswith("player: 600 of 600 s\r\n")
