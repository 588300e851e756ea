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
from sigcat.comparison.side_by_side import side_by_side
from sigcat.comparison.telling.material import Material, Played, PlayedFault, WrittenLines
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.players.commands import BuildFails
from sigcat.runs.columns import Column, columns_of

REFERENCE = next(iter(RUNNERS))
BESIDE_BASELINE = next(runner.name for runner in RUNNERS.values() if runner.has_baseline)
"""The platform that what people wrote is built beside, and measured against."""
_BUILT_BEFORE = "Parts were built before: build times cover only what had changed, and the total time is not measured."
Play = Callable[[Built, Subject, Drive], Recording]
Tell = Callable[[str], None]
"""Reports progress."""


class Asked(NamedTuple):
    """Settings of a comparison."""

    compared: ComparedSet
    subject: Subject
    trace: Path
    end_ns: int
    platforms: tuple[str, ...]
    free_ns: int
    """Length of each platform's free run; 0: none."""
    folder: Path
    """Folder in which everything is built."""
    scenarios: tuple[Scenario, ...] = ()
    """Faults that are injected."""
    translation_ns: Sequence[int] = ()
    """Times for each CAN frame, if the trace comes from CAN."""
    notes: tuple[str, ...] = ()
    """Notes for readers about the settings."""
    runs: int = 1
    """Runs of the platforms whose load is compared."""
    begin_ns: int = 0
    """Time of the first row of the drive, as `end_ns` is one of the trace."""


def compare(asked: Asked, tools: Toolchain, tell: Tell) -> Material:
    """Play to each platform. One that is not installed, or cannot be built, is skipped with the reason."""
    clock, here = _Clock(), machine(tools)
    is_fresh = not any(each.is_dir() for each in asked.folder.iterdir())
    built = _all_built(asked, tools, tell)
    clock.ends("build")
    players = {each.name: _player(each.name, asked.compared) for each in built}
    in_lock_step = [_in_lock_step(each, players[each.name], asked, tell) for each in built]
    clock.ends("lock step")
    played = tuple(_in_free_run(each, players[each.name], asked, tell) for each in in_lock_step)
    clock.ends("free run")
    faults = tuple(_faults(played, players, asked, tell)) if asked.scenarios else ()
    clock.ends("faults")
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
        sum(clock.phases.values()) if is_fresh else 0.0,
        here,
        (*asked.notes, *(() if is_fresh else (_BUILT_BEFORE,))),
        asked.translation_ns,
        tuple(clock.phases.items()),
        asked.begin_ns,
    )


class _Clock:
    """Duration of each phase, in s."""

    def __init__(self) -> None:
        self.phases: dict[str, float] = {}
        self._begin = time.monotonic()

    def ends(self, phase: str) -> None:
        """Whatever was done since the phase before was this one."""
        begin, self._begin = self._begin, time.monotonic()
        self.phases[phase] = self._begin - begin


def _player(name: str, compared: ComparedSet) -> Play:
    if name == baseline.NAME:
        assert compared.baseline is not None
        return partial(baseline.play, compared.baseline)
    return RUNNERS[name].play


# -- building -----------------------------------------------------------------------------------------------------


def _all_built(asked: Asked, tools: Toolchain, tell: Tell) -> list[Played]:
    """Folders side by side, that of most packages first; platforms of one folder after each other, as they share what is built."""
    names = [REFERENCE, *(name for name in asked.platforms if name != REFERENCE)]
    folders: dict[str, list[str]] = {}
    for name in names:
        folders.setdefault(RUNNERS[name].folder, []).append(name)
    longest_first = sorted(folders.values(), key=lambda each: BESIDE_BASELINE not in each)
    built = side_by_side([partial(_built_in_folder, each, asked, tools, tell) for each in longest_first])
    found = {each.name: each for of_folder in built for each in of_folder}
    return [found[name] for name in (*names, baseline.NAME) if name in found]


def _built_in_folder(names: Sequence[str], asked: Asked, tools: Toolchain, tell: Tell) -> list[Played]:
    built = [_built(RUNNERS[name], asked, tools, tell) for name in names]
    if asked.compared.baseline is not None:
        built += _built_by_hand(asked.compared.baseline, built, asked, tell)
    return built


def _built(runner: Runner, asked: Asked, tools: Toolchain, tell: Tell) -> Played:
    """A platform that is there is built; of another one it is said how to get it."""
    missing = runner.missing(os.environ)
    if missing is not None:
        tell(f"{runner.title}: left out. {missing}")
        return Played(runner.name, runner.title, left_out=missing)
    tell(f"{runner.title}: building")
    folder = asked.folder / runner.folder
    folder.mkdir(parents=True, exist_ok=True)
    try:
        return Played(runner.name, runner.title, built=runner.build(asked.subject, folder, tools))
    except BuildFails as failed:
        return _not_built(Played(runner.name, runner.title), failed, tell)


def _built_by_hand(package: Path, built: Sequence[Played], asked: Asked, tell: Tell) -> list[Played]:
    """Build the package written by hand, if its counterpart was built."""
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
    reason = f"it cannot be built: {failed.first_error}"
    tell(f"{played.title}: {reason}")
    return played._replace(left_out=reason, build_error=str(failed))


# -- playing ------------------------------------------------------------------------------------------------------


def _in_lock_step(each: Played, play: Play, asked: Asked, tell: Tell) -> Played:
    """To the end of the drive, alone on the machine."""
    if each.built is None:
        return each
    tell(f"{each.title}: {(asked.end_ns - asked.begin_ns) / 1e9:g} s in lock step")
    recording = play(each.built, asked.subject, Drive(asked.trace, asked.end_ns, name="lock-step"))
    if recording.last_words:
        tell(f"{each.title}: it did not come to the end. {recording.last_words}")
    return each._replace(lock_step=recording, repeats=_again(each, play, asked, Drive(asked.trace, asked.end_ns)))


def _in_free_run(each: Played, play: Play, asked: Asked, tell: Tell) -> Played:
    """As long as was asked for, alone on the machine."""
    lock_step = each.lock_step
    if each.built is None or lock_step is None or lock_step.last_words or each.name == REFERENCE or not asked.free_ns:
        return each
    if _is_sampled(each):
        return each
    tell(f"{each.title}: {asked.free_ns / 1e9:g} s in free run")
    drive = Drive(asked.trace, asked.free_ns, "free run", "free-run")
    first = play(each.built, asked.subject, drive)
    return each._replace(free_run=first, repeats=(*each.repeats, *_again(each, play, asked, drive)))


def _is_sampled(each: Played) -> bool:
    return each.name in RUNNERS and RUNNERS[each.name].is_sampled


def _again(each: Played, play: Play, asked: Asked, drive: Drive) -> tuple[Recording, ...]:
    """Repeat a run of the platforms whose load is compared: one run has no spread."""
    if each.built is None or each.name not in (BESIDE_BASELINE, baseline.NAME):
        return ()
    drives = [drive._replace(name=f"{drive.mode.replace(' ', '-')}-{number}") for number in range(2, asked.runs + 1)]
    return tuple(play(each.built, asked.subject, one) for one in drives)


def _faults(played: Sequence[Played], players: Mapping[str, Play], asked: Asked, tell: Tell) -> Iterator[PlayedFault]:
    """Each scenario on each platform, but for what people wrote: as many in one drive as fit.

    Nothing of them is measured: they run side by side. The reference is first, as its process has the environment of this one.
    """
    drives = faulty_drives(asked.scenarios, asked.trace, asked.folder / "faults")
    own = [each for each in played if each.built is not None and not each.is_by_hand and not _is_sampled(each)]
    if not own:
        return
    tasks = [
        partial(_one_faulty, each, players[each.name], drive.drive, asked, tell) for each in own[1:] for drive in drives
    ]
    expected = [_one_faulty(own[0], players[own[0].name], drive.drive, asked, tell) for drive in drives]
    recordings = [*expected, *side_by_side(tasks)]
    for number, (_, scenarios) in enumerate(drives):
        of_drive = {
            each.name: recording for each, recording in zip(own, recordings[number :: len(drives)], strict=True)
        }
        for scenario in scenarios:
            found = {name: watched(recording, scenario) for name, recording in of_drive.items()}
            yield PlayedFault(scenario.name, scenario.title, scenario.description, found)


def _one_faulty(each: Played, play: Play, drive: Drive, asked: Asked, tell: Tell) -> Recording:
    assert each.built is not None
    tell(f"{each.title}: {drive.name}, {(drive.end_ns - asked.begin_ns) / 1e9:g} s")
    return play(each.built, asked.subject, drive)


def _sent_columns(functions: Sequence[ResolvedFunction]) -> Mapping[str, Column]:
    return {name: column for each in functions for name, column in columns_of(each).columns.items() if column.is_sent}


def _shortest_cycle(subject: Subject) -> int:
    """In ns."""
    plans = [member.plan for member in subject.prepared.connections.members]
    cycles = [call.cycle for plan in plans for call in plan.calls if call.cycle]
    return min(cycles, default=10**8)


def _written(compared: ComparedSet) -> Iterator[WrittenLines]:
    """Count lines written by hand: declarations and the deployment for all platforms, the baseline for one."""
    for what, path in compared.written:
        counted = count_lines([(path.name, path.read_text(encoding="utf-8", errors="replace"))])
        yield WrittenLines(f"{what} {path.parent.name}/{path.name}", "", counted)
    if compared.baseline is not None:
        files = [(path.name, path.read_text(encoding="utf-8")) for path in baseline.written_files(compared.baseline)]
        yield WrittenLines("the same nodes without declarations", baseline.NAME, count_lines(files))
