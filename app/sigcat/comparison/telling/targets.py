"""Acceptance criteria: each figure beside its target."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from sigcat.comparison.load import Load, overhead
from sigcat.comparison.report import model
from sigcat.comparison.report.words import counted, duration

ADAPTER_NS = 10_000
CALLS = 100
"""Fewer have no p99 but their worst one."""
OVERHEAD = 0.10
FAULTS = 20
LONGEST_S = 300
WHOLE_DRIVE_S = 600
WAITING = "processes that wanted to run, before it began"
"""Name of the machine's load in a report."""
_INTERPRETED = frozenset(("ros2-py",))
"""Platforms whose adapters are not compiled."""


class _Beyond(NamedTuple):
    """Additional time of the adapter in a run over the loop without transport, in ns."""

    call: str
    mode: str
    calls: int
    p50: float
    p99: float


def targets(told: model.Report) -> Iterator[model.Target]:
    """All targets, from the measurements; those that were not measured are marked."""
    compiled = [
        each.name
        for each in told.platforms
        if not (each.left_out or each.is_by_hand or each.name in _INTERPRETED or each.name == told.reference)
    ]
    yield _equal(told)
    yield _faults(told)
    for name in compiled:
        yield _adapter(told, name)
    for name in compiled:
        if name.startswith("ros2"):
            yield _overhead(told, name)
    for each in told.platforms:
        if told.supervision and not (each.left_out or each.is_by_hand or each.name == told.reference):
            yield _supervision(told, each.name)
    yield _by_hand(told)
    yield _seconds(told)


def _own(told: model.Report) -> Sequence[model.Behaviour]:
    return [each for each in told.behaviour if not _is_by_hand(told, each.platform)]


def _is_by_hand(told: model.Report, platform: str) -> bool:
    return next((each.is_by_hand for each in told.platforms if each.name == platform), False)


def _equal(told: model.Report) -> model.Target:
    own = _own(told)
    ended = {each.name for each in told.platforms if not each.last_words}
    wrong, values = sum(each.wrong for each in own), sum(each.values for each in own)
    longest = max((each.seconds for each in own), default=0.0)
    broken = [told.title_of(each.platform) for each in own if each.platform not in ended]
    return model.Target(
        what="outputs equal on all platforms, in lock step",
        wanted="every bit of every step, in a drive of ten minutes",
        measured=f"{wrong:,} of {values:,} values differ, {counted(len(own), 'platform')}, {longest:g} s"
        if own
        else "",
        holds=_is_equal(wrong, values, broken, longest) if own else None,
        note="; ".join(
            [f"{told.title_of(each.platform)}: {each.wrong:,} of {each.values:,} differ" for each in own if each.wrong]
            + [f"{', '.join(broken)} did not come to the end"] * bool(broken)
            + [f"the drive has {longest:g} s"] * (bool(own) and round(longest) < WHOLE_DRIVE_S)
            + ["no platform but the simulation was played to"] * (not own)
        ),
    )


def _is_equal(wrong: int, values: int, broken: Sequence[str], longest: float) -> bool | None:
    """Whether all values are equal; None if they are, but in a drive shorter than the whole one."""
    if wrong or broken or not values:
        return False
    return True if round(longest) >= WHOLE_DRIVE_S else None


def _faults(told: model.Report) -> model.Target:
    """A few equal ones do not prove the target."""
    outcomes = [outcome for each in told.faults for outcome in each.outcomes]
    same = [each for each in told.faults if each.outcomes and all(outcome.is_same for outcome in each.outcomes)]
    played = dict.fromkeys(outcome.platform for outcome in outcomes)
    otherwise = {name: sum(not each.is_same for each in outcomes if each.platform == name) for name in played}
    notes = [f"{told.title_of(name)}: {count} otherwise" for name, count in otherwise.items() if count]
    return model.Target(
        what="faults, the same everywhere",
        wanted=f"at least {FAULTS}; same step, same errors, same substitute values",
        measured=f"{len(same)} of {len(told.faults)}, {counted(len(played), 'platform')}" if told.faults else "",
        holds=_is_same(len(same), len(told.faults)) if played else None,
        note="; ".join((*notes, *_too_few_faults(len(told.faults), len(played)))),
    )


def _too_few_faults(faults: int, platforms: int) -> Iterator[str]:
    if not faults:
        yield "no fault was injected"
    elif faults < FAULTS:
        yield f"{counted(faults, 'fault')}, of the required {FAULTS}"
    if faults and not platforms:
        yield "no platform but the simulation was played to"


def _is_same(same: int, faults: int) -> bool | None:
    if same < faults:
        return False
    return True if faults >= FAULTS else None


def _adapter(told: model.Report, platform: str) -> model.Target:
    """Return the target for the most frequent call, beyond the loop without transport; other calls are in the note.

    Only calls that kept their processor are checked: time of other processes is not time of the adapter.
    """
    floors = {each.call: each.t_adapter_judged for each in told.timing if each.platform == told.reference}
    often = max(floors, key=lambda call: floors[call].total, default="")
    own = [each for each in told.timing if each.platform == platform and each.call in floors]
    over = [
        _Beyond(each.call, each.mode, found.total, found.p50 - floors[each.call].p50, found.p99 - floors[each.call].p99)
        for each in own
        for found in [each.t_adapter_judged]
    ]
    judged = [each for each in over if each.call == often]
    few = [f"{each.calls:,} calls in {each.mode} are too few for a p99" for each in judged if each.calls < CALLS]
    none = [] if judged else ["no call was measured on it and in the simulation"]
    preempted = [_preempted(each, floors[often]) for each in own if each.call == often and each.t_adapter_alone]
    return model.Target(
        what=f"adapter of {told.title_of(platform)}, beyond an in-process loop",
        wanted="p50 and p99 at most 10 µs",
        measured="; ".join(map(_beyond, judged)),
        holds=_is_short(judged),
        note="; ".join((*none, *few, *preempted, *map(_beyond, (each for each in over if each.call != often)))),
    )


def _is_short(judged: Sequence[_Beyond]) -> bool | None:
    """The p99 of few calls is their worst one, which says nothing."""
    if any(each.p50 > ADAPTER_NS or (each.p99 > ADAPTER_NS and each.calls >= CALLS) for each in judged):
        return False
    return True if judged and all(each.calls >= CALLS for each in judged) else None


def _beyond(each: _Beyond) -> str:
    return f"{each.call}, {each.mode}: {duration(each.p50)} and {duration(each.p99)}"


def _preempted(each: model.Timing, floor: model.Durations) -> str:
    return (
        f"{each.preempted:,} of {counted(each.t_adapter.total, 'call')} in {each.mode} were preempted and are excluded: "
        f"with them, p99 is {duration(each.t_adapter.p99 - floor.p99)}"
    )


def _supervision(told: model.Report, platform: str) -> model.Target:
    """Return whether a platform calls `Supervise` as often as the core needs. A machine that does other work may be late once in a while."""
    rows = [each for each in told.supervision if each.platform == platform]
    return model.Target(
        what=f"period of `Supervise` on {told.title_of(platform)}",
        wanted="99 % at most the shortest cycle, or the deadline of a call that runs, and 1 ms",
        measured="; ".join(f"{_supervised(each)}: {each.over:,} of {each.gaps:,} longer" for each in rows),
        holds=all(each.over * 100 <= each.gaps for each in rows) if rows else None,
        note="; ".join(
            f"{_supervised(each)}: longest {duration(each.longest)}, allowed {duration(each.period)}" for each in rows
        ),
    )


def _supervised(each: model.Supervision) -> str:
    return f"{f'{each.call} beyond its deadline' if each.call else each.function}, {each.mode}"


def _overhead(told: model.Report, platform: str) -> model.Target:
    """All processes of a platform together, in each run, over those that people wrote."""
    by_hand = [each.name for each in told.platforms if each.is_by_hand]
    more = [
        (mode, overhead(ours, theirs))
        for mode in dict.fromkeys(each.mode for each in told.processes)
        if (ours := _whole(told, [platform], mode)) and (theirs := _whole(told, by_hand, mode))
    ]
    texts = [
        f"{mode}: {each.cpu * 100:+.0f} % processor time, {each.memory * 100:+.0f} % memory" for mode, each in more
    ]
    return model.Target(
        what=f"{told.title_of(platform)}, over the nodes written by hand",
        wanted="at most 10 % more processor time and memory",
        measured="; ".join(texts),
        holds=all(max(each.cpu, each.memory) <= OVERHEAD for _, each in more) if more else None,
        note="" if more else "they were not played, or what they took was not measured",
    )


def _whole(told: model.Report, platforms: Sequence[str], mode: str) -> Load | None:
    own = [each for each in told.processes if each.platform in platforms and each.mode == mode and not each.is_player]
    if not own:
        return None
    cpu, peak, size = (sum(getattr(each, key) for each in own) for key in ("cpu_s", "peak", "size"))
    return Load("", cpu, own[0].drive_s, peak, size)


def _by_hand(told: model.Report) -> model.Target:
    """Return the target for hand-written lines. The hand-written baseline is not a platform and not counted."""
    own = {each.name for each in told.platforms if not each.is_by_hand}
    written = sum(each.code for each in told.effort if each.by == "person" and each.platform in own)
    return model.Target(
        what="lines written by hand for a platform", wanted="0", measured=f"{written:,}", holds=not written
    )


def other_work(told: model.Report) -> str:
    """Figures of a machine that did other work say little of those of one that does nothing else."""
    facts = dict(told.machine)
    waiting, cores = facts.get(WAITING, ""), facts.get("cores", "")
    if not waiting or not cores or float(waiting) <= float(cores) / 2:
        return ""
    return f"the machine did other work: {waiting} processes wanted to run on {cores} cores before it began"


def _remark(told: model.Report) -> str:
    return other_work(told) if told.seconds else "parts were built before"


def _seconds(told: model.Report) -> model.Target:
    unfinished = [each for each in told.platforms if each.left_out or each.last_words]
    is_whole = not unfinished and len(told.platforms) > 1
    return model.Target(
        what="the whole comparison, built and run",
        wanted="under 5 minutes on two cores",
        measured=f"{told.seconds:.0f} s" if told.seconds else "",
        holds=told.seconds < LONGEST_S if told.seconds and is_whole else None,
        note=_remark(told) if is_whole else "not every platform was played to its end",
    )
