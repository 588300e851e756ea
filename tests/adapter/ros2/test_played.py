"""Functions that are unlike EcoControl, played in lock step: what their nodes send is what the simulation sends."""

from collections.abc import Mapping
from pathlib import Path

import pytest

from scripts import ros2_environment
from sigcat.adapter.toolchain import toolchain
from sigcat.comparison.behaviour import in_lock_step
from sigcat.comparison.recording import Recording, Sent
from sigcat.comparison.running.runner import Drive, Subject
from sigcat.comparison.running.table import RUNNERS
from sigcat.integration.reading import read_functions
from sigcat.platforms.deployment_file import DEFAULT_DEPLOYMENT, deployment_of_file
from sigcat.runs.prepare import prepare
from tests import needs
from tests.adapter.ros2.built import USUAL
from tests.function.shipped import interfaces

BURSTS = Path(__file__).parents[2] / "runs/cases/events_in_bursts"
EXISTING = Path(__file__).with_name("existing")
INSTALLED = {"AMENT_PREFIX_PATH": str(ros2_environment.ENVIRONMENT)}
"""Folder of the messages of ROS 2."""

pytestmark = [needs.ros2, pytest.mark.parametrize("language", USUAL)]
RUNNER = {"C++": "ros2-cpp", "Python": "ros2-py"}
BURST_COUNT = 20


def played(language: str, case: Path, folder: Path) -> list[Mapping[str, tuple[Sent, ...]]]:
    """Values that the simulation sends, then those of a node of the function."""
    drive = Drive(case / "trace.csv", 10**8)
    return [recorded(name, case, folder, drive).sent for name in ("simulate", RUNNER[language])]


def recorded(platform: str, case: Path, folder: Path, drive: Drive) -> Recording:
    """A drive that was played to a function on a platform."""
    path, deployment = case / "function.yaml", case / "deployment.yaml"
    functions, _ = read_functions([(path.read_bytes(), str(path))], interfaces())
    chosen = deployment_of_file(deployment, INSTALLED) if deployment.exists() else DEFAULT_DEPLOYMENT
    subject = Subject(functions, prepare(functions), chosen)
    built = RUNNERS[platform].build(subject, folder / platform, toolchain())
    recording = RUNNERS[platform].play(built, subject, drive)
    assert recording.last_words == ""
    return recording


def test_a_call_that_runs_several_times_in_a_step_loses_nothing(language, tmp_path):
    expected, found = played(language, BURSTS, tmp_path)
    assert len(expected["Vehicle.Burst.Last"]) > 10
    assert in_lock_step(expected, found).is_equal


def test_a_free_run_has_the_value_of_each_call_of_a_burst(language, tmp_path):
    """Calls follow each other at once, and the topic keeps one value for late subscribers."""
    found = recorded(RUNNER[language], BURSTS, tmp_path, Drive(bursts(tmp_path / "bursts.csv"), 10**9, "free run"))
    assert len(found.calls) > 2 * BURST_COUNT
    assert len(found.sent["Vehicle.Burst.Last"]) == len(found.calls)


def bursts(path: Path) -> Path:
    """A trace with bursts that fill the queue of the function, and time to take the last one."""
    times = [f"{index * 0.02:.3f}" for index in range(BURST_COUNT) for _ in range(12)]
    rows = [f"{time},{number}" for number, time in enumerate(times)]
    path.write_text("\n".join(["time,Vehicle.Burst.Command", *rows, ""]))
    return path


def test_signals_travel_in_messages_that_exist(language, tmp_path):
    """Units and numbers of enumerations differ on the way, and messages without a time have that of the step."""
    expected, found = played(language, EXISTING, tmp_path)
    assert {"P", "R", "D"} <= {value for _, value in expected["Vehicle.Follow.GearOut"]}
    assert found["Vehicle.Follow.GearOut"] == expected["Vehicle.Follow.GearOut"]
    wanted = [[(time, float(value)) for time, value in each["Vehicle.Follow.Wanted"]] for each in (expected, found)]
    assert [time for time, _ in wanted[1]] == [time for time, _ in wanted[0]]
    assert [value for _, value in wanted[1]] == pytest.approx([value for _, value in wanted[0]])
