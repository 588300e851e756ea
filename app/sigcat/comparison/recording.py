"""Recording of a platform while a drive was played to it: the same shape for all platforms."""

from collections.abc import Mapping
from pathlib import Path
from typing import Literal, NamedTuple

from sigcat.adapter.files import GeneratedFile

Mode = Literal["lock step", "free run"]
Sent = tuple[int, str]
"""A time in ns, in that of the trace, and the text of a value as `sigcat simulate` writes it: the same bits, the same text."""


class CallTime(NamedTuple):
    """Durations of one call, by the four points of measurement of its core."""

    function: str
    call: str
    """Its interface: `CoreAcc_Step`."""
    time_ns: int
    """When, in the time of the trace; in free run of the platform's clock."""
    t_exec_ns: int
    """From the begin of SetInput to the end of GetOutput."""
    t_logic_ns: int
    """The function itself."""
    begin_ns: int = 0
    """When it began, by the clock of the machine."""
    is_preempted: bool = False
    """Whether the system gave its processor to something else before it ended. A wait for a lock is none."""

    @property
    def end_ns(self) -> int:
        """When it ended, by the clock of the machine."""
        return self.begin_ns + self.t_exec_ns

    @property
    def t_adapter_ns(self) -> int:
        """The rest."""
        return self.t_exec_ns - self.t_logic_ns


class Supervised(NamedTuple):
    """Times between calls of `Supervise` of a function on a platform, in ns of the platform's time."""

    function: str
    call: str
    """The interface of the call while which they were measured, because it took longer than its deadline; empty: any time."""
    period_ns: int
    """The longest one that the core allows (docs/reference/adapter.md, §10)."""
    gaps_ns: tuple[int, ...]


class ProcessLoad(NamedTuple):
    """Resources that a process used from its start to its end."""

    name: str
    cpu_s: float
    peak_rss_bytes: int
    executable_bytes: int
    """Its program, with the libraries that were built for it; of Python with its modules."""
    is_player: bool = False
    """Whether it plays and records, and is not part of the platform."""


class Built(NamedTuple):
    """A set of functions, generated and compiled for a platform."""

    platform: str
    folder: Path
    generated: tuple[GeneratedFile, ...]
    """Files that sigcat writes for this platform alone, and that run in production: without those for a comparison."""
    generate_s: float
    build_s: float
    notes: tuple[str, ...] = ()
    """Parts that sigcat provides instead of the real platform: `rclcpp: sigcat's subset of rclcpp 28`."""


class Recording(NamedTuple):
    """Sent values, durations, resources, and the end of a run."""

    platform: str
    mode: Mode
    built: Built
    sent: Mapping[str, tuple[Sent, ...]]
    """By the names of columns that `sigcat simulate` writes. In order of time."""
    calls: tuple[CallTime, ...] = ()
    processes: tuple[ProcessLoad, ...] = ()
    last_words: str = ""
    """Why the run did not come to its end; empty if it did. What was sent until then is there."""
    play_s: float = 0.0
    silent: tuple[str, ...] = ()
    """Columns that the platform has no message for: an AUTOSAR application writes safety reactions to its log."""
    end_to_end: Mapping[str, tuple[int, ...]] = {}
    """By function: how long it took from a row of the drive to each value that was sent by a call that has seen it, in ns."""
    fields: tuple[str, ...] = ()
    """Columns that have a value from the beginning, as a service is offered with the values of its fields (SWS_CM). What depends on
    the first one may have its own first value earlier than where a first value has to come."""
    supervised: tuple[Supervised, ...] = ()
    points: tuple[int, ...] = ()
    """Times in ns at which outputs were read; empty: each value was seen when it was sent. With them, `sent` has changes alone."""
