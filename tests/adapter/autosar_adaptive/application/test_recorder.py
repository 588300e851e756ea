"""The recorder of a player: a value has the time at which it was sent, if known, and otherwise the time of its reception."""

import csv
import subprocess
from pathlib import Path

import pytest

from sigcat.adapter.autosar_adaptive import bench
from sigcat.adapter.autosar_adaptive.application.player import player_source
from sigcat.adapter.toolchain import toolchain
from tests.needs import c_compiler

pytestmark = c_compiler
PLAYER = Path(player_source.__file__).with_name("cpp")
BENCH = Path(bench.__file__).with_name("runtime") / "include"
MAIN = """
#include <chrono>
#include <cstdint>
#include <optional>
#include <thread>

#include "player/ports.h"

int main() {
    player::Recorder recorder{"recorded.csv", false};
    recorder.BeginNow();
    const std::chrono::nanoseconds now = std::chrono::steady_clock::now().time_since_epoch();
    const auto sent_at = static_cast<std::uint64_t>(now.count());
    std::this_thread::sleep_for(std::chrono::milliseconds{20});
    recorder.Take("sent before", "1", sent_at);
    recorder.Take("came", "1", std::nullopt);
    recorder.Take("sent later than it came", "1", sent_at + 3600000000000U);
    recorder.Take("sent before the begin", "1", 1U);
    player::Recorder stepped{"stepped.csv", false};
    stepped.Begin(50000000);
    stepped.Take("in lock step", "1", sent_at);
    return 0;
}
"""


@pytest.fixture(scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> dict[str, int]:
    folder = tmp_path_factory.mktemp("recorder")
    (folder / "player").symlink_to(PLAYER)
    (folder / "main.cpp").write_text(MAIN)
    warnings = ["-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Wconversion", "-Werror"]
    sources = [folder / "main.cpp", folder / "player/recorder.cpp"]
    command = [
        *toolchain().cpp,
        "-std=c++17",
        *warnings,
        f"-I{folder}",
        f"-I{BENCH}",
        "-o",
        folder / "main",
        *sources,
        "-pthread",
    ]
    subprocess.run(list(map(str, command)), check=True)
    subprocess.run([str(folder / "main")], check=True, cwd=folder)
    rows = [row for name in ("recorded.csv", "stepped.csv") for row in csv.DictReader((folder / name).open())]
    return {row["name"]: int(row["time"]) for row in rows}


def test_a_value_has_the_time_at_which_it_was_sent(recorded: dict[str, int]) -> None:
    assert 0 <= recorded["sent before"] <= recorded["came"] - 20_000_000


def test_no_value_is_sent_after_it_came_or_before_the_begin(recorded: dict[str, int]) -> None:
    assert recorded["came"] <= recorded["sent later than it came"] < 3600 * 10**9
    assert recorded["sent before the begin"] == 0


def test_in_lock_step_the_time_is_that_of_the_step(recorded: dict[str, int]) -> None:
    assert recorded["in lock step"] == 50_000_000
