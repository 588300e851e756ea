"""A whole comparison: everything is built, played to, recorded and stopped, one platform after the other."""

import os
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import NamedTuple

from sigcat.adapter.toolchain import Toolchain
from sigcat.comparison.compared_set import ComparedSet
from sigcat.comparison.effort import count_lines
from sigcat.comparison.faults.drives import faulty_drives, watched
from sigcat.comparison.faults.scenario import Scenario
from sigcat.comparison.machine import machine
from sigcat.comparison.recording import Built, Recording
from sigcat.comparison.running import by_hand as baseline
from sigcat.comparison.running.runner import Drive, Runner, Subject
from sigcat.comparison.running.table import RUNNERS
from sigcat.comparison.telling.material import Material, Played, PlayedFault, WrittenLines
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.players.commands import BuildFails
from sigcat.runs.columns import Column, columns_of

REFERENCE = next(iter(RUNNERS))
BESIDE_BASELINE = "ros2-cpp"
"""The platform that what people wrote is built beside, and measured against."""
_FOLDERS = {"ros2-cpp": "ros2", "ros2-py": "ros2"}
"""Platforms that share what is built."""
_LAST_WORDS = 2000
_BUILT_BEFORE = "Parts were built before: times to build are of what had changed, and the whole has no time."
Play = Callable[[Built, Subject, Drive], Recording]
Tell = Callable[[str], None]
"""What says how far it is."""


class Asked(NamedTuple):
    """What is compared, and how."""

    compared: ComparedSet
    subject: Subject
    trace: Path
    end_ns: int
    platforms: tuple[str, ...]
    free_ns: int
    """How long each platform runs freely; 0: not at all."""
    folder: Path
    """Where everything is built."""
    scenarios: tuple[Scenario, ...] = ()
    """Faults that are injected."""
    translation_ns: Sequence[int] = ()
    """Of each frame of CAN, if that is where the trace comes from."""


def compare(asked: Asked, tools: Toolchain, tell: Tell) -> Material:
    """What each platform did. One that is not installed, or cannot be built, is left out with the reason."""
    begin, here = time.monotonic(), machine(tools)
    is_fresh = not any(each.is_dir() for each in asked.folder.iterdir())
    names = [REFERENCE, *(name for name in asked.platforms if name != REFERENCE)]
    built = [_built(RUNNERS[name], asked, tools, tell) for name in names]
    players = {each.name: RUNNERS[each.name].play for each in built}
    if asked.compared.baseline is not None:
        by_hand = _built_by_hand(asked.compared.baseline, built, asked, tell)
        built += by_hand
        players[baseline.NAME] = partial(baseline.play, asked.compared.baseline)
    played = tuple(_played(each, players[each.name], asked, tell) for each in built)
    faults = tuple(_faults(played, players, asked, tell)) if asked.scenarios else ()
    functions = asked.subject.functions
    return Material(
        asked.compared.name,
        tuple(each.function.info.function_name for each in functions),
        asked.trace.name,
        asked.end_ns,
        _sent_columns(functions),
        _shortest_cycle(asked.subject),
        played,
        faults,
        tuple(_written(asked.compared)),
        time.monotonic() - begin if is_fresh else 0.0,
        here,
        () if is_fresh else (_BUILT_BEFORE,),
        asked.translation_ns,
    )


def _built(runner: Runner, asked: Asked, tools: Toolchain, tell: Tell) -> Played:
    """A platform that is there is built; of another one it is said how to get it."""
    missing = runner.missing(os.environ)
    if missing is not None:
        tell(f"{runner.title}: left out. {missing}")
        return Played(runner.name, runner.title, left_out=missing)
    tell(f"{runner.title}: building")
    folder = asked.folder / _FOLDERS.get(runner.name, runner.name)
    folder.mkdir(parents=True, exist_ok=True)
    try:
        return Played(runner.name, runner.title, built=runner.build(asked.subject, folder, tools))
    except BuildFails as failed:
        return _not_built(Played(runner.name, runner.title), failed, tell)


def _built_by_hand(package: Path, built: Sequence[Played], asked: Asked, tell: Tell) -> list[Played]:
    """What people wrote, if what it is measured against is there."""
    beside = next((each.built for each in built if each.name == BESIDE_BASELINE), None)
    if beside is None:
        return []
    tell(f"{baseline.TITLE}: building")
    played = Played(baseline.NAME, baseline.TITLE, is_by_hand=True)
    try:
        return [played._replace(built=baseline.build(package, beside, asked.subject))]
    except BuildFails as failed:
        return [_not_built(played, failed, tell)]


def _not_built(played: Played, failed: BuildFails, tell: Tell) -> Played:
    tell(f"{played.title}: it cannot be built")
    return played._replace(left_out=f"it cannot be built: {str(failed)[-_LAST_WORDS:]}")


def _played(each: Played, play: Play, asked: Asked, tell: Tell) -> Played:
    """In lock step to the end of the drive, then freely, alone on the machine."""
    if each.built is None:
        return each
    tell(f"{each.title}: {asked.end_ns / 1e9:g} s in lock step")
    lock_step = play(each.built, asked.subject, Drive(asked.trace, asked.end_ns))
    if lock_step.last_words:
        tell(f"{each.title}: it did not come to the end. {lock_step.last_words}")
    free = None
    if asked.free_ns and each.name != REFERENCE and not lock_step.last_words:
        tell(f"{each.title}: {asked.free_ns / 1e9:g} s in free run")
        free = play(each.built, asked.subject, Drive(asked.trace, asked.free_ns, "free run"))
    return each._replace(lock_step=lock_step, free_run=free)


def _faults(played: Sequence[Played], players: Mapping[str, Play], asked: Asked, tell: Tell) -> Iterator[PlayedFault]:
    """Each scenario on each platform, but for what people wrote: as many in one drive as fit."""
    drives = faulty_drives(asked.scenarios, asked.trace, asked.folder / "faults")
    for number, (drive, scenarios) in enumerate(drives, 1):
        recordings: dict[str, Recording] = {}
        for each in played:
            if each.built is not None and not each.is_by_hand:
                tell(f"{each.title}: faults, drive {number} of {len(drives)}, {drive.end_ns / 1e9:g} s")
                recordings[each.name] = players[each.name](each.built, asked.subject, drive)
        for scenario in scenarios:
            found = {name: watched(recording, scenario) for name, recording in recordings.items()}
            yield PlayedFault(scenario.name, scenario.title, scenario.description, found)


def _sent_columns(functions: Sequence[ResolvedFunction]) -> Mapping[str, Column]:
    return {name: column for each in functions for name, column in columns_of(each).columns.items() if column.is_sent}


def _shortest_cycle(subject: Subject) -> int:
    """In ns."""
    plans = [member.plan for member in subject.prepared.connections.members]
    cycles = [call.cycle for plan in plans for call in plan.calls if call.cycle]
    return min(cycles, default=10**8)


def _written(compared: ComparedSet) -> Iterator[WrittenLines]:
    """What a person wrote: declarations and the deployment for all platforms, the baseline for one."""
    for what, path in compared.written:
        counted = count_lines([(path.name, path.read_text(encoding="utf-8", errors="replace"))])
        yield WrittenLines(f"{what} {path.parent.name}/{path.name}", "", counted)
    if compared.baseline is not None:
        files = [(path.name, path.read_text(encoding="utf-8")) for path in baseline.written_files(compared.baseline)]
        yield WrittenLines("the same nodes without declarations", baseline.NAME, count_lines(files))
