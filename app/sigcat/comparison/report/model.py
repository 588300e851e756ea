"""A comparison as it is reported: every form of the report is made from this alone.

Times are in ns, if a name does not say otherwise; memory and sizes are in bytes.
"""

from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field, ValidationError
from pydantic.alias_generators import to_camel

from sigcat.errors import InputRefused
from sigcat.limits import COMPARISON_BYTES

Number = Annotated[float, Field(allow_inf_nan=False)]
Count = Annotated[int, Field(ge=0)]
Kind = Literal["other", "missing", "extra"]


class Part(BaseModel):
    """A frozen part of a report."""

    model_config = ConfigDict(frozen=True, alias_generator=to_camel, populate_by_name=True, extra="ignore")


class Platform(Part):
    """A platform that was asked for."""

    name: str
    title: str
    notes: tuple[str, ...] = ()
    """Parts that sigcat simulates instead of the real platform."""
    left_out: str = ""
    """Why it was not played to, and how to get it; empty if it was."""
    build_error: str = ""
    """First error of a compiler and what follows it, if it is the reason."""
    last_words: tuple[str, ...] = ()
    """Last messages of runs that did not complete."""
    silent: tuple[str, ...] = ()
    """Interfaces without a message on this platform."""
    generate_s: Number = 0.0
    build_s: Number = 0.0
    play_s: Number = 0.0
    is_by_hand: bool = False
    """Whether people wrote it, for comparison."""


class Difference(Part):
    """A value that is not what the reference sent at that time."""

    time: int
    kind: Kind
    expected: str
    found: str


class Output(Part):
    """Values that were sent under a name, compared with those of the reference."""

    name: str
    values: Count
    wrong: Count
    first: Difference | None = None
    early: Count = 0
    """1 if it is a field whose first value, which is the same, was there before its time."""


class Behaviour(Part):
    """A platform in lock step with the drive."""

    platform: str
    seconds: Number
    steps: Count
    """Calls of functions."""
    outputs: tuple[Output, ...]

    @property
    def values(self) -> int:
        """Number of values that were compared."""
        return sum(each.values for each in self.outputs)

    @property
    def wrong(self) -> int:
        """Number of values that are not equal."""
        return sum(each.wrong for each in self.outputs)


class Aligned(Part):
    """A name on a platform in free run, beside the reference."""

    name: str
    values: Count
    same: Count
    """Equal to the nearest in time."""
    shifted: Count
    """Equal to what the reference sent up to two cycles before or after: an input came between the two calls."""
    other: Count
    """Neither."""
    lost: int
    """Steps that the reference has, and this one has not."""
    p50_late: int
    worst_late: int
    """Delays of equal values after those of the reference."""


class FreeRun(Part):
    """A platform in free run, aligned with the reference."""

    platform: str
    seconds: Number
    rows: tuple[Aligned, ...]


class Line(Part):
    """A signal on one platform: (time, value), as far as a picture can show it."""

    platform: str
    points: tuple[tuple[int, float | None], ...]


class Trace(Part):
    """A signal on all platforms."""

    name: str
    unit: str = ""
    words: dict[int, str] = {}
    """Names of values, of an enumeration."""
    lines: tuple[Line, ...]


class StatusChange(Part):
    """An error, safety reaction or mode became this."""

    time: int
    name: str
    value: str


class FaultOutcome(Part):
    """A platform under a fault."""

    platform: str
    values: Count
    wrong: Count
    first: Difference | None = None
    name: str = ""
    """Column of the first difference."""
    last_words: str = ""

    @property
    def is_same(self) -> bool:
        """Whether everything came in the same step with the same value."""
        return bool(self.values) and not self.wrong and not self.last_words


class Fault(Part):
    """A fault, injected in the same way everywhere."""

    name: str
    title: str
    description: str = ""
    changes: tuple[StatusChange, ...] = ()
    """Changes in the reference that do not occur without the fault."""
    outcomes: tuple[FaultOutcome, ...] = ()


class Durations(Part):
    """A distribution."""

    total: Count
    least: Number
    p50: Number
    p99: Number
    worst: Number
    first_bin: int
    bins: tuple[Count, ...]


class Timing(Part):
    """Durations of a call on a platform."""

    platform: str
    mode: str
    function: str
    call: str
    t_exec: Durations
    t_adapter: Durations
    t_logic: Durations
    preempted: Count = 0
    """Calls whose processor the system gave to something else before they ended: other work counts as theirs."""
    t_adapter_alone: Durations | None = None
    """Durations of the calls that kept their processor; None if all did, or none."""

    @property
    def t_adapter_judged(self) -> Durations:
        """Durations that are attributed to the adapter."""
        return self.t_adapter_alone or self.t_adapter


class Supervision(Part):
    """Times between calls of `Supervise` of a function, beside the longest period that its core allows."""

    platform: str
    mode: str
    function: str
    call: str = ""
    """If set, the figures apply only while this call ran longer than its deadline."""
    period: Count
    gaps: Count
    over: Count
    """Number of gaps longer than the period and 1 ms."""
    longest: Count


class Measured(Part):
    """A duration that is of no call: from one end to the other, a translation."""

    name: str
    platform: str
    description: str
    durations: Durations


class Process(Part):
    """Resources that a process used."""

    platform: str
    mode: str
    name: str
    cpu_s: Number
    drive_s: Number
    peak: Count
    size: Count
    is_player: bool = False
    run: Count = 0
    """Number of the repetition."""

    @property
    def share(self) -> float:
        """Share of one core, as if the drive had been played in real time."""
        return self.cpu_s / self.drive_s if self.drive_s else 0.0


class Lines(Part):
    """Lines of files: without blank ones and comments, and all."""

    what: str
    by: Literal["person", "sigcat"]
    platform: str = ""
    """Empty: for all platforms."""
    files: Count
    code: Count
    total: Count


class Target(Part):
    """An acceptance criterion."""

    criterion: str = ""
    """Title of the row of the summary; empty for a criterion of no single platform."""
    platform: str = ""
    what: str
    wanted: str
    measured: str
    holds: bool | None
    """None: not measured, or with too few figures."""
    note: str = ""

    @property
    def verdict(self) -> Literal["pass", "fail", "inconclusive", "not measured"]:
        """Whether the criterion passes; with too few figures it is inconclusive."""
        if self.holds is None:
            return "inconclusive" if self.measured else "not measured"
        return "pass" if self.holds else "fail"


class PaperFigure(Part):
    """A figure of the paper, beside ours."""

    what: str
    place: str
    """In the paper."""
    paper: str
    ours: str
    differs: str
    """In the set-up."""


class Report(Part):
    """All of it."""

    sigcat: str
    name: str
    functions: tuple[str, ...]
    trace: str
    machine: tuple[tuple[str, str], ...]
    reference: str
    platforms: tuple[Platform, ...]
    seconds: Number
    """Duration of the whole comparison."""
    phases: tuple[tuple[str, Number], ...] = ()
    """Durations of its phases, in s."""
    targets: tuple[Target, ...] = ()
    behaviour: tuple[Behaviour, ...] = ()
    free_run: tuple[FreeRun, ...] = ()
    traces: tuple[Trace, ...] = ()
    faults: tuple[Fault, ...] = ()
    timing: tuple[Timing, ...] = ()
    supervision: tuple[Supervision, ...] = ()
    measured: tuple[Measured, ...] = ()
    processes: tuple[Process, ...] = ()
    effort: tuple[Lines, ...] = ()
    paper: tuple[PaperFigure, ...] = ()
    notes: tuple[str, ...] = ()
    """Further notes for readers: failed criteria, and criteria that were not measured."""

    def title_of(self, platform: str) -> str:
        """Return the name of a platform in sentences."""
        return next((each.title for each in self.platforms if each.name == platform), platform)

    @property
    def is_equal(self) -> bool:
        """Whether every platform that is installed was built, came to its end, and sent the same values, under every fault too."""
        own = {each.name for each in self.platforms if not each.is_by_hand}
        outcomes = [outcome for fault in self.faults for outcome in fault.outcomes if outcome.platform in own]
        return (
            not any(each.last_words or each.build_error for each in self.platforms if each.name in own)
            and not any(each.wrong for each in self.behaviour if each.platform in own)
            and all(each.is_same for each in outcomes)
        )


def to_json(report: Report) -> bytes:
    """The report as a file."""
    return report.model_dump_json(by_alias=True, indent=1, exclude_defaults=True).encode() + b"\n"


def read_report(data: bytes, name: str) -> Report:
    """A report from its file. Raises InputRefused."""
    if len(data) > COMPARISON_BYTES:
        raise InputRefused(f"{name} must have at most {COMPARISON_BYTES // 2**20} MiB to be a comparison.")
    try:
        return Report.model_validate_json(data)
    except ValidationError as error:
        first = error.errors(include_url=False, include_input=False)[0]
        place = ".".join(str(each) for each in first["loc"])
        raise InputRefused(
            f"{name} is not a comparison that `sigcat compare` wrote: {place}: {first['msg']}."
        ) from None
