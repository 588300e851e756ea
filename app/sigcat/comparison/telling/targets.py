"""Acceptance criteria: each figure beside its target."""

from collections.abc import Iterator, Sequence
from statistics import median

from sigcat.comparison.load import Load, Overhead, overhead
from sigcat.comparison.report import model
from sigcat.comparison.report.words import counted, duration, signed
from sigcat.comparison.running.table import RUNNERS

ADAPTER_NS = 10_000
CALLS = 100
"""Fewer have no p99 but their worst one."""
OVERHEAD = 0.10
FAULTS = 20
LONGEST_S = 300
WHOLE_DRIVE_S = 600
WAITING = "processes that wanted to run, before it began"
"""Name of the machine's load in a report."""


def targets(told: model.Report) -> Iterator[model.Target]:
    """All targets, from the measurements; those that were not measured are marked."""
    compiled = [
        each.name
        for each in told.platforms
        if not (each.left_out or each.is_by_hand or each.name == told.reference or RUNNERS[each.name].is_interpreted)
    ]
    yield _equal(told)
    yield _faults(told)
    for name in compiled:
        yield from _adapters(told, name)
    for name in compiled:
        if RUNNERS[name].has_baseline:
            yield from _overheads(told, name)
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


def _adapters(told: model.Report, platform: str) -> Iterator[model.Target]:
    """Yield a target for each call in each run, beyond the same call in the loop without transport."""
    floors = {each.call: each.t_adapter_judged for each in told.timing if each.platform == told.reference}
    own = [each for each in told.timing if each.platform == platform and each.call in floors]
    yield from (_adapter(told, each, floors[each.call]) for each in own)
    if not own:
        yield _adapter_target(told, platform, "").model_copy(
            update={"note": "no call was measured on it and in the simulation"}
        )


def _adapter_target(told: model.Report, platform: str, what: str) -> model.Target:
    return model.Target(
        criterion="Adapter beyond a loop",
        platform=platform,
        what=f"adapter of {told.title_of(platform)}{f', {what}' if what else ''}, beyond an in-process loop",
        wanted="p50 and p99 at most 10 µs",
        measured="",
        holds=None,
    )


def _adapter(told: model.Report, each: model.Timing, floor: model.Durations) -> model.Target:
    """Only calls that kept their processor are checked: time of other processes is not time of the adapter."""
    found = each.t_adapter_judged
    p50, p99 = found.p50 - floor.p50, found.p99 - floor.p99
    has_p99 = found.total >= CALLS
    few = [] if has_p99 else [f"{found.total:,} calls in {each.mode} are too few for a p99"]
    preempted = [_preempted(each, floor)] if each.t_adapter_alone else []
    faster = ["below zero: shorter than the same call in the loop, which is subtracted"] if min(p50, p99) < 0 else []
    is_long = p50 > ADAPTER_NS or (p99 > ADAPTER_NS and has_p99)
    return _adapter_target(told, each.platform, f"{each.call} in {each.mode}").model_copy(
        update={
            "measured": f"{duration(p50)} and {duration(p99)}",
            "holds": False if is_long else True if has_p99 else None,
            "note": "; ".join((*few, *preempted, *faster)),
        }
    )


def _preempted(each: model.Timing, floor: model.Durations) -> str:
    return (
        f"{each.preempted:,} of {counted(each.t_adapter.total, 'call')} in {each.mode} were preempted and are excluded: "
        f"with them, p99 is {duration(each.t_adapter.p99 - floor.p99)}"
    )


def _supervision(told: model.Report, platform: str) -> model.Target:
    """Return whether a platform calls `Supervise` as often as the core needs. A machine that does other work may be late once in a while."""
    rows = [each for each in told.supervision if each.platform == platform]
    return model.Target(
        criterion="Period of Supervise",
        platform=platform,
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


def _overheads(told: model.Report, platform: str) -> Iterator[model.Target]:
    """Yield a target for each run: all processes of a platform together, over those that people wrote."""
    by_hand = [each.name for each in told.platforms if each.is_by_hand]
    modes = dict.fromkeys(each.mode for each in told.processes if each.platform == platform)
    found = [(mode, list(_repeated(told, platform, by_hand, mode))) for mode in modes]
    measured = [_overhead(told, platform, mode, more) for mode, more in found if more]
    yield from measured or [_overhead_target(told, platform, "", _NOT_PLAYED)]


_NOT_PLAYED = "they were not played, or what they took was not measured"


def _overhead_target(told: model.Report, platform: str, mode: str, note: str) -> model.Target:
    return model.Target(
        criterion="Load over code by hand",
        platform=platform,
        what=f"{told.title_of(platform)}, over the nodes written by hand{f', in {mode}' if mode else ''}",
        wanted="at most 10 % more processor time and memory",
        measured="",
        holds=None,
        note=note,
    )


def _overhead(told: model.Report, platform: str, mode: str, more: Sequence[Overhead]) -> model.Target:
    """A median that the spread could carry across the limit says nothing, nor does a single run."""
    cpu = [each.cpu for each in more]
    middle, memory, spread = median(cpu), max(each.memory for each in more), max(cpu) - min(cpu)
    is_decided = len(more) > 1 and spread <= abs(middle - OVERHEAD)
    note = f"{counted(len(more), 'run')}, of which the processor time spreads over {spread * 100:.0f} points"
    return _overhead_target(
        told, platform, mode, note if len(more) > 1 else "one run: its spread is unknown"
    ).model_copy(
        update={
            "measured": signed(f"{middle * 100:+.0f} % processor time, {memory * 100:+.0f} % memory"),
            "holds": False if memory > OVERHEAD else middle <= OVERHEAD if is_decided else None,
        }
    )


def _repeated(told: model.Report, platform: str, by_hand: Sequence[str], mode: str) -> Iterator[Overhead]:
    """Overheads of each repetition of a run."""
    for run in sorted({each.run for each in told.processes if each.mode == mode}):
        ours, theirs = _load_of_processes(told, [platform], mode, run), _load_of_processes(told, by_hand, mode, run)
        if ours and theirs:
            yield overhead(ours, theirs)


def _load_of_processes(told: model.Report, platforms: Sequence[str], mode: str, run: int) -> Load | None:
    of_run = [each for each in told.processes if (each.mode, each.run) == (mode, run) and not each.is_player]
    own = [each for each in of_run if each.platform in platforms]
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
