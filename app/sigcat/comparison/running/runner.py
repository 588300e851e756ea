"""What a platform brings to be compared: whether it is there, how it is built, and how a drive is played to it."""

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import NamedTuple

from sigcat.adapter.toolchain import Toolchain
from sigcat.comparison.recording import Built, Mode, Recording
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.integration.deployment import Deployment
from sigcat.runs.prepare import Prepared


class Subject(NamedTuple):
    """What is compared: functions that fit together, and what their deployment says."""

    functions: tuple[ResolvedFunction, ...]
    prepared: Prepared
    deployment: Deployment

    @property
    def code_settings(self) -> Mapping[str, Path]:
        """Where the paths of the code of each function begin, as CMake is told."""
        return {each.plan.code_setting: each.folder.absolute() for each in self.prepared.connections.members}


class Kill(NamedTuple):
    """A function is gone from a time on: its process is killed, its simulation ends without a word."""

    function: str
    time_ns: int


class Drive(NamedTuple):
    """What is played, and how."""

    trace: Path
    """CSV, as `sigcat simulate` reads it; a column that is named like a call says how long the call takes from then on."""
    end_ns: int
    """A time of the trace, as those of kills are."""
    mode: Mode = "lock step"
    name: str = "run"
    """Of the folder of what is recorded."""
    kills: tuple[Kill, ...] = ()
    step_limit_s: float = 10.0
    """How long a call may take before the run is stopped."""


class Runner(NamedTuple):
    """One platform."""

    name: str
    title: str
    missing: Callable[[Mapping[str, str]], str | None]
    """One line that says how to get what is not there; None if everything is."""
    build: Callable[[Subject, Path, Toolchain], Built]
    """Generate and compile in a folder. Raises InputRefused, or BuildFails with what the compiler says."""
    play: Callable[[Built, Subject, Drive], Recording]
    """What the platform does. A process that dies ends the run: the recording has its last words."""
