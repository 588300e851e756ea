"""Sections of a report, with sentences, tables and pictures: Markdown and HTML show the same."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Literal, NamedTuple

from sigcat.comparison.report.drawing import Mark, Row, distributions, traces
from sigcat.comparison.report.model import (
    Difference,
    Durations,
    Fault,
    FaultOutcome,
    FreeRun,
    Lines,
    Report,
    Target,
    Timing,
)
from sigcat.comparison.report.words import duration, memory, percent, seconds

Tone = Literal["", "good", "bad", "muted"]


class Cell(NamedTuple):
    """A cell of a table; its text says the same as its colour."""

    text: str
    tone: Tone = ""


class Table(NamedTuple):
    """Rows below a head; the first cell of a row names it."""

    title: str
    head: tuple[str, ...]
    rows: tuple[tuple[Cell, ...], ...]
    is_shown: bool = False
    """Whether a page shows it at once; other tables are folded."""


class Picture(NamedTuple):
    """An SVG, and what it shows."""

    svg: str
    caption: str


class Verbatim(NamedTuple):
    """Output of a tool, verbatim."""

    title: str
    text: str


class Section(NamedTuple):
    """A part with a heading."""

    title: str
    sentences: tuple[str, ...] = ()
    parts: tuple[Table | Picture | Verbatim, ...] = ()


def sections(report: Report) -> tuple[Section, ...]:
    """Return sections that have content, the most important first."""
    made = (
        _targets(report),
        _not_built(report),
        _behaviour(report),
        _free_run(report),
        _faults(report),
        _timing(report),
        _load(report),
        _effort(report),
        _paper(report),
        _set_up(report),
    )
    return tuple(each for each in made if each.sentences or each.parts)


def _cells(*texts: str | Cell) -> tuple[Cell, ...]:
    return tuple(each if isinstance(each, Cell) else Cell(each) for each in texts)


def _table(title: str, head: str, rows: Sequence[tuple[Cell, ...]], *, is_shown: bool = False) -> tuple[Table, ...]:
    return (Table(title, tuple(head.split("|")), tuple(rows), is_shown),) if rows else ()


_TONES: Mapping[bool | None, Tone] = {True: "good", False: "bad", None: "muted"}


def _held(target: Target) -> Cell:
    return Cell(target.verdict, _TONES[target.holds])


def _targets(report: Report) -> Section:
    rows = [_cells(each.what, each.wanted, each.measured, _held(each), each.note) for each in report.targets]
    table = _table("Each criterion", "Criterion|Target|Measured|Pass|Notes", rows)
    return Section("Acceptance criteria", report.notes, (*_summary(report), *table))


def _summary(report: Report) -> tuple[Table, ...]:
    """Criteria and platforms: whether a platform passes each criterion, and by which figure."""
    own = [each for each in report.platforms if each.name != report.reference]
    criteria = dict.fromkeys(each.criterion for each in report.targets if each.criterion)
    rows = [
        _cells("Outputs equal in lock step", *(_equal(report, each.name) for each in own)),
        *([_cells("Faults, the same", *(_same_faults(report, each.name) for each in own))] if report.faults else []),
        *(_cells(name, *(_passed(report, name, each.name) for each in own)) for name in criteria),
    ]
    head = "|".join(["Criterion", *(each.title for each in own)])
    return _table("Criteria by platform", head, rows, is_shown=True) if own else ()


def _equal(report: Report, platform: str) -> Cell:
    found = next((each for each in report.behaviour if each.platform == platform), None)
    if found is None or not found.values:
        return Cell("not measured", "muted")
    return Cell(f"{found.wrong:,} differ", "bad") if found.wrong else Cell("pass", "good")


def _same_faults(report: Report, platform: str) -> Cell:
    played = [each for fault in report.faults for each in fault.outcomes if each.platform == platform]
    same = sum(each.is_same for each in played)
    if not played:
        return Cell("not measured", "muted")
    return Cell(f"{same} of {len(played)}", "good" if same == len(played) else "bad")


def _passed(report: Report, criterion: str, platform: str) -> Cell:
    """Return the worst verdict of the criterion's rows: a call that fails is a failure."""
    own = [each for each in report.targets if (each.criterion, each.platform) == (criterion, platform)]
    failed, unknown = [each for each in own if each.holds is False], [each for each in own if each.holds is None]
    if not own:
        return Cell("not measured", "muted")
    if failed:
        return Cell(f"{len(failed)} of {len(own)} fail" if len(own) > 1 else "fail", "bad")
    if unknown:
        words = "inconclusive" if any(each.measured for each in unknown) else "not measured"
        passed = f"{len(own) - len(unknown)} pass, {len(unknown)} " if len(own) > len(unknown) else ""
        return Cell(f"{passed}{words}", "muted")
    return Cell("pass", "good")


def _not_built(report: Report) -> Section:
    told = tuple(Verbatim(each.title, each.build_error) for each in report.platforms if each.build_error)
    lead = "What the tool said that builds them, from its first error on."
    return Section("Platforms that cannot be built", (lead,) if told else (), told)


# -- behaviour ----------------------------------------------------------------------------------------------------


def _remark(silent: Sequence[str], early: Sequence[str]) -> str:
    found = [f"no message for {', '.join(silent)}"] if silent else []
    if early:
        found.append(
            f"the first value of {', '.join(early)} is there earlier, as fields have a value from the beginning"
        )
    return "; ".join(found)


def _behaviour(report: Report) -> Section:
    titles = {each.name: each.title for each in report.platforms}
    rows = []
    for each in report.behaviour:
        verdict = Cell("identical", "good") if not each.wrong else Cell(f"{each.wrong:,} differ", "bad")
        silent = next((platform.silent for platform in report.platforms if platform.name == each.platform), ())
        rows.append(
            _cells(
                titles.get(each.platform, each.platform), f"{each.seconds:g} s", f"{each.steps:,}", f"{each.values:,}",
                verdict, _remark(silent, [output.name for output in each.outputs if output.early]),
            )
        )  # fmt: skip
    differing = [
        _cells(titles.get(each.platform, each.platform), output.name, f"{output.wrong:,} of {output.values:,}", told(output.first))
        for each in report.behaviour for output in each.outputs if output.wrong
    ]  # fmt: skip
    drawn = traces(report.traces, titles)
    caption = "Lines overlap where platforms agree; later platforms are drawn thinner so that all stay visible."
    parts = (
        *_table("Outputs in lock step", "platform|drive|calls|values||remark", rows),
        *_table("Outputs that differ", "platform|output|values|first difference", differing),
        *((Picture(drawn, caption),) if drawn else ()),
    )
    lead = (
        f"Every value of a platform is compared with {report.title_of(report.reference)}: the same step, the same bits. "
        "In lock step the player gives all processes their time, and continues when all messages have been received."
    )
    return Section("Behaviour in lock step", (lead,) if rows else (), parts)


def told(first: Difference | None) -> str:
    """A difference as text."""
    if first is None:
        return ""
    words = {"other": f"{first.found} instead of {first.expected}", "missing": f"{first.expected} is missing"}
    return f"at {seconds(first.time)}: {words.get(first.kind, f'{first.found} was not expected')}"


def _free_run(report: Report) -> Section:
    rows = [_free_row(report, each) for each in report.free_run]
    details = [
        _cells(
            report.title_of(each.platform), row.name, f"{row.values:,}", f"{row.same:,}", f"{row.shifted:,}", f"{row.other:,}",
            _fewer(row.lost), f"{duration(row.p50_late)}, at most {duration(row.worst_late)}",
        )
        for each in report.free_run for row in each.rows
    ]  # fmt: skip
    lead = (
        "In free run every process keeps its own time. A call may see an input one cycle earlier or later than in the reference. "
        "Those values are counted separately. Other values differ for another reason, usually "
        "internal state left by an earlier shift, or a burst of a queue that calls took in other portions."
    )
    head = "platform|drive|values|equal|a call earlier or later|other|steps"
    parts = (
        *_table("Outputs in free run, by time", head, rows),
        *_table(
            "Each output in free run", "platform|output|values|equal|a call apart|other|steps|later, median", details
        ),
    )
    return Section("Behaviour in free run", (lead,) if rows else (), parts)


def _free_row(report: Report, each: FreeRun) -> tuple[Cell, ...]:
    sums = [sum(getattr(row, key) for row in each.rows) for key in ("values", "same", "shifted", "other", "lost")]
    counts = (f"{value:,}" for value in sums[:-1])
    return _cells(report.title_of(each.platform), f"{each.seconds:.0f} s", *counts, _fewer(sums[-1]))


def _fewer(lost: int) -> str:
    """Than the reference had in the same time."""
    return f"{abs(lost):,} {'fewer' if lost > 0 else 'more'}" if lost else "as many"


# -- faults -------------------------------------------------------------------------------------------------------


def _faults(report: Report) -> Section:
    if not report.faults:
        return Section("Faults")
    platforms = list(dict.fromkeys(outcome.platform for fault in report.faults for outcome in fault.outcomes))
    rows = []
    for fault in report.faults:
        outcomes = {each.platform: each for each in fault.outcomes}
        verdicts = [_verdict(outcomes.get(name)) for name in platforms]
        rows.append(_cells(fault.title, fault.description, _changes(fault), *verdicts))
    head = "|".join(["fault", "what is injected", "what changes because of it", *map(report.title_of, platforms)])
    same = sum(all(outcome.is_same for outcome in fault.outcomes) for fault in report.faults)
    lead = (
        f"{same} of {len(report.faults)} faults change errors, safety reactions, modes and values in the same step on every platform. "
        "A fault is a change of the drive or of the run, the same everywhere."
    )
    return Section("Faults", (lead,), _table("Faults", head, rows))


def _changes(fault: Fault) -> str:
    shown = [f"{seconds(each.time)} {short(each.name)} {each.value}" for each in fault.changes[:8]]
    more = len(fault.changes) - len(shown)
    return "; ".join(shown) + (f"; {more} more" if more > 0 else "") if shown else "values only"


def short(name: str) -> str:
    """An interface without what all of its kind end with."""
    return name.removesuffix("_ErrorSts").removesuffix("_SftyCondSts")


def _verdict(outcome: FaultOutcome | None) -> Cell:
    if outcome is None or not (outcome.values or outcome.last_words):
        return Cell("not played", "muted")
    if outcome.is_same:
        return Cell("same", "good")
    words = outcome.last_words[:160] or f"{outcome.wrong:,} differ: {outcome.name} {told(outcome.first)}"
    return Cell(words, "bad")


# -- timing -------------------------------------------------------------------------------------------------------


def _timing(report: Report) -> Section:
    parts: list[Table | Picture] = []
    for call in dict.fromkeys(each.call for each in report.timing):
        of_call = [each for each in report.timing if each.call == call]
        parts += _drawn_call(report, call, of_call)
        rows = [row for each in of_call for row in _timing_rows(report, each)]
        head = "platform|run||calls|median|p99|worst"
        parts += _table(f"{call} in numbers", head, rows)
    measured = [
        _cells(each.name, report.title_of(each.platform), each.description, *_numbers(each.durations))
        for each in report.measured
    ]
    supervised = [
        _cells(
            report.title_of(each.platform), each.mode, each.function, each.call,
            duration(each.period), f"{each.gaps:,}", f"{each.over:,}", duration(each.longest),
        )
        for each in report.supervision
    ]  # fmt: skip
    head = "platform|run|function|while this call is late|allowed|times between calls|longer|longest"
    parts += _table("Calls of Supervise", head, supervised)
    parts += _table("Other durations", "what|platform|from, to|number|median|p99|worst", measured)
    lead = (
        "A call has four points of measurement: t_exec is from the begin of SetInput to the end of GetOutput, t_logic the function "
        "itself, t_adapter the rest, by the steady clock of the machine. A call is preempted if the system gave its processor to "
        "something else before it ended; one that waits for a lock is not. The first row is the floor: the same core in a loop "
        "without any transport."
    )
    return Section("Timing", (lead,) if parts else (), tuple(parts))


def _drawn_call(report: Report, call: str, of_call: Sequence[Timing]) -> Iterator[Picture]:
    names = [each.name for each in report.platforms]
    for key, word in (("t_adapter", "adapter"), ("t_logic", "logic")):
        rows = [Row(_label(report, each), names.index(each.platform), getattr(each, key)) for each in of_call]
        at = PAPER_MARKS.get(f"{word} {of_call[0].function}")
        marks = [Mark(at, f"the paper's median, {duration(at)}")] if at else []
        yield Picture(
            distributions(f"{key} of {call}, by platform", rows, marks),
            f"{key} of {call}: how often which duration, on a logarithmic axis; the solid line is the median, the dashed one p99.",
        )


PAPER_MARKS = {"adapter CoreAcc": 3e5, "adapter EcoControlMpc": 2e5, "logic CoreAcc": 1e5}
"""Medians of figure 18, in ns."""


def _label(report: Report, each: Timing) -> str:
    modes = {other.mode for other in report.timing if other.platform == each.platform and other.call == each.call}
    title = report.title_of(each.platform)
    return f"{title}, {each.mode}" if len(modes) > 1 else title


def _timing_rows(report: Report, each: Timing) -> Iterator[tuple[Cell, ...]]:
    rows = [("t_exec", each.t_exec), ("t_adapter", each.t_adapter), ("t_logic", each.t_logic)]
    if each.t_adapter_alone:
        rows.insert(2, ("t_adapter, not preempted", each.t_adapter_alone))
    for name, found in rows:
        yield _cells(report.title_of(each.platform), each.mode, name, *_numbers(found))


def _numbers(found: Durations) -> tuple[str, ...]:
    return (f"{found.total:,}", duration(found.p50), duration(found.p99), duration(found.worst))


# -- load, effort, paper ------------------------------------------------------------------------------------------


def _load(report: Report) -> Section:
    rows = [
        _cells(
            report.title_of(each.platform), f"{each.mode} {each.run + 1}" if each.run else each.mode, f"{each.name} (player)" if each.is_player else each.name, f"{each.cpu_s:.2f} s",
            percent(each.share), memory(each.peak), memory(each.size) if each.size else "",
        )
        for each in report.processes
    ]  # fmt: skip
    lead = (
        "Processor time from the start of a process to its end, and as a share of one core for each second of the drive; the memory "
        "that it had at most; its executable with the libraries that were built for it."
    )
    head = "platform|run|process|processor time|of a core|memory|executable"
    return Section("Load", (lead,) if rows else (), _table("Processes", head, rows))


def _effort(report: Report) -> Section:
    rows = [_lines(report, each) for each in report.effort]
    times = [
        _cells(each.title, f"{each.generate_s:.2f} s", f"{each.build_s:.1f} s")
        for each in report.platforms if not each.left_out
    ]  # fmt: skip
    parts = (
        *_table("Lines", "what|for|by|files|lines of code|all lines", rows),
        *_table("Time to generate and to build", "platform|generate|build", times),
    )
    return Section("Effort", (), parts)


def _lines(report: Report, each: Lines) -> tuple[Cell, ...]:
    where = report.title_of(each.platform) if each.platform else "all platforms"
    by = "a person" if each.by == "person" else "sigcat"
    return _cells(each.what, where, by, f"{each.files:,}", f"{each.code:,}", f"{each.total:,}")


def _paper(report: Report) -> Section:
    rows = [_cells(each.what, each.paper, each.ours, each.place, each.differs) for each in report.paper]
    return Section(
        "Beside the paper", (), _table("Figures of the paper", "what|the paper|here|where|what differs", rows)
    )


def _set_up(report: Report) -> Section:
    rows = []
    for each in report.platforms:
        state = (
            Cell("left out", "bad")
            if each.left_out
            else Cell("did not come to its end", "bad")
            if each.last_words
            else Cell("played")
        )
        remark = "; ".join((*((each.left_out,) if each.left_out else ()), *each.notes, *each.last_words))
        rows.append(_cells(each.title, state, remark))
    machine = [_cells(name, value) for name, value in report.machine]
    parts = (*_table("Platforms", "platform||remark", rows), *_table("Machine", "what|", machine))
    return Section("Set-up", tuple(_whole_time(report)), parts)


def _whole_time(report: Report) -> Iterator[str]:
    of = ", ".join(f"{name} {seconds:.0f} s" for name, seconds in report.phases)
    if report.seconds:
        yield f"The whole comparison took {report.seconds:.0f} s{f': {of}' if of else ''}."
    if report.phases:
        yield "Platforms are built side by side, and play faults so; whatever is measured runs alone."
