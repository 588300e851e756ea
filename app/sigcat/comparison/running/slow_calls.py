"""Calls that take as long as a drive says: in lock step they end when their time is over, whatever hosts the core.

The core is what all platforms share. Where it is compiled for a comparison, a file of its name stands before it, which keeps the end
of a call until the core is asked after that time; hosts are as they were generated. Without durations nothing is kept.
"""

from collections import defaultdict
from collections.abc import Iterable, Iterator
from pathlib import PurePosixPath

from sigcat.adapter.core.c.names.scope import Scope
from sigcat.adapter.files import GeneratedFile
from sigcat.adapter.host.connections import Member
from sigcat.adapter.templates import rendered
from sigcat.comparison.running.runner import Drive
from sigcat.runs.prepare import Prepared
from sigcat.runs.recording.trace_file import moments, open_trace

_VARIABLE = "SIGCAT_TAKES_"
"""Begins the name of the variable that has, for a call, times and how long it takes from then on, in ns."""


def with_slow_calls(
    files: Iterable[GeneratedFile], members: Iterable[Member], *, passes_time: bool = False
) -> Iterator[GeneratedFile]:
    """The files of a platform, with one more before each core.

    `passes_time`: the host can run others while a call takes time (`TestRte_PassTime`): nothing has to be kept.
    """
    cores = {f"{member.name}_adapter{ending}": member for member in members for ending in (".c", ".cpp")}
    for file in files:
        path = PurePosixPath(file.name)
        member = cores.get(path.name)
        if member is None or path.parent.name != "core":
            yield file
        else:
            core = path.with_name(f"{path.name}.inc")
            yield file._replace(name=str(core))
            yield file._replace(data=_before(member, core.name, passes_time=passes_time).encode())


def _before(member: Member, core: str, *, passes_time: bool) -> str:
    """Return code that wraps functions of the core, which it renames."""
    scope, calls = Scope(member.plan), member.plan.steps
    wrapped = "Run" if passes_time else "GetOutput"
    queried = ("NextCall",) if passes_time else ("NextCall", "NextTime")
    return rendered(
        "comparison/running/slow_calls.c.j2",
        function=member.name,
        core=core,
        p=scope.prefix,
        none_due=scope.constant("NO_CALL"),
        renamed=[*queried, *(f"{wrapped}_{call.name}" for call in calls)],
        calls=calls,
        variable=_VARIABLE,
        passes_time=passes_time,
    )


def durations(drive: Drive, prepared: Prepared, begin: int = 0) -> dict[str, str]:
    """The environment of a process whose calls take what the drive says; `begin` is when the drive is at the process's time 0, in ns.

    Empty where it says nothing, and in free run, in which a call takes as long as it does.
    """
    if drive.mode != "lock step":
        return {}
    calls = {call.interface for call in prepared.numbers.calls if call}
    opened = open_trace(drive.trace, prepared.known_columns(())._replace(others=None))
    if calls.isdisjoint(opened.columns):
        return {}
    told: defaultdict[str, list[str]] = defaultdict(list)
    for row in moments(opened):
        for name, value in row.values:
            if name in calls:
                told[name] += [str(row.time - begin), str(value)]
    return {f"{_VARIABLE}{name}": " ".join(each) for name, each in told.items()}
