"""Interface of a platform for comparison: whether it is installed, how to build it, and how to play to it."""

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import NamedTuple

from sigcat.adapter.toolchain import Toolchain
from sigcat.comparison.recording import Built, Mode, Recording
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.integration.deployment import Deployment
from sigcat.runs.prepare import Prepared


class Subject(NamedTuple):
    """Functions that fit together, and their deployment."""

    functions: tuple[ResolvedFunction, ...]
    prepared: Prepared
    deployment: Deployment

    @property
    def code_settings(self) -> Mapping[str, Path]:
        """Folders of the code of each function, by their settings of CMake."""
        return {each.plan.code_setting: each.folder.absolute() for each in self.prepared.connections.members}


class Kill(NamedTuple):
    """A function is gone from a time on: its process is killed, its simulation ends silently."""

    function: str
    time_ns: int


class Drive(NamedTuple):
    """A drive to play, and how."""

    trace: Path
    """CSV, as `sigcat simulate` reads it; a column that is named like a call says how long the call takes from then on."""
    end_ns: int
    """A time of the trace, as those of kills are."""
    mode: Mode = "lock step"
    name: str = "run"
    """Name of the recording's folder."""
    kills: tuple[Kill, ...] = ()
    step_limit_s: float = 10.0
    """Longest time that a call may take before the run is stopped."""


class Runner(NamedTuple):
    """One platform."""

    name: str
    title: str
    missing: Callable[[Mapping[str, str]], str | None]
    """One line that says how to get what is not there; None if everything is."""
    build: Callable[[Subject, Path, Toolchain], Built]
    """Generate and compile in a folder. Raises InputRefused, or BuildFails with what the compiler says."""
    play: Callable[[Built, Subject, Drive], Recording]
    """Play and record. A process that dies ends the run: the recording has its last words."""
    shared_folder: str = ""
    """Folder of the build, if other platforms share it; empty: its name is that of the folder."""
    paper_platform: str = ""
    """Platform of the paper whose figures it is compared with, as in the keys of the figures; empty for none."""
    is_interpreted: bool = False
    """Whether its adapters are not compiled."""
    has_baseline: bool = False
    """Whether code written by hand is built beside it, and its load is compared with that."""
    is_sampled: bool = False
    """Whether outputs are seen at points that an importer chooses. It runs in lock step alone, without faults."""

    @property
    def folder(self) -> str:
        """Folder in which it is built."""
        return self.shared_folder or self.name
