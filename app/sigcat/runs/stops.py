"""Why a run did not come to its end, and with which inputs, as text."""

from collections.abc import Mapping

from sigcat import codes
from sigcat.adapter.host.connections import Entry
from sigcat.adapter.host.shapes import Value
from sigcat.errors import InputRefused
from sigcat.findings import Finding, RuleCode
from sigcat.runs.prepare import Prepared
from sigcat.runs.recording.cells import cell_of
from sigcat.runs.recording.times import seconds
from sigcat.runs.recording.trace_file import Trace
from sigcat.runs.recording.traces import moments
from sigcat.runs.running.process import Limits
from sigcat.runs.running.run import Stopped

_LONGEST = 200
"""Characters of a value that is shown."""


def refusal(
    stopped: Stopped, prepared: Prepared, trace: Trace | None, sent: Mapping[int, Value], limits: Limits
) -> InputRefused:
    """Return the error for a run that stopped. `sent` are the values sent last, by the numbers of exits."""
    at = f"{seconds(stopped.time)} s"
    if stopped.reason == "no end":
        message = f"At {at}, calls trigger each other without end."
        return InputRefused(f"The run was stopped at {at}.", (codes.CALLS_WITHOUT_END.finding(message),))
    if stopped.reason == "garbled":
        message = f"The results must be complete, and after {at} they are not: {stopped.how}."
        finding = codes.RESULTS_DAMAGED.finding(message, fix="Look for code that writes beyond its own memory.")
        return InputRefused(f"The run was stopped at {at}.", (finding,))
    if stopped.begun is None:
        return InputRefused(f"The run ended at {at} with {stopped.how}.", (_outside(stopped, limits),))
    rule, what = _kind(stopped, at, limits)
    finding = _finding(rule, stopped.begun, what, prepared)
    return InputRefused(_with_inputs(stopped, finding.path, prepared, trace, sent), (finding,))


def _kind(stopped: Stopped, at: str, limits: Limits) -> tuple[RuleCode, str]:
    if stopped.reason == "hangs":
        return codes.CALL_NEVER_RETURNS, f"must return within {limits.seconds:g} s; the call at {at} did not"
    if stopped.reason == "prints too much":
        return codes.PRINTS_TOO_MUCH, f"must print less; at {at} it was more than {limits.printed // 2**20} MiB"
    return codes.CALL_CRASHES, f"ended the process at {at} with {stopped.how}"


def _outside(stopped: Stopped, limits: Limits) -> Finding:
    if stopped.reason == "prints too much":
        return codes.PRINTS_TOO_MUCH.finding(f"The functions printed more than {limits.printed // 2**20} MiB.")
    how = "said nothing any more" if stopped.reason == "hangs" else f"ended with {stopped.how}"
    return codes.CALL_CRASHES.finding(f"The process {how} while no call was running.")


def _finding(rule: RuleCode, begun: int, what: str, prepared: Prepared) -> Finding:
    call = prepared.numbers.calls[begun]
    member = prepared.connections.members[prepared.numbers.owner(begun)]
    name, pointer = (call.interface, (*call.pointer, "Symbol")) if call else (member.name, ())
    return member.function.finding(rule, pointer, f"{name} {what}.", path=name)


# -- the last inputs ----------------------------------------------------------------------------------------------


def _with_inputs(
    stopped: Stopped, call: str, prepared: Prepared, trace: Trace | None, sent: Mapping[int, Value]
) -> str:  # fmt: skip
    """The message, with what the function of a call had received."""
    assert stopped.begun is not None
    member = prepared.numbers.owner(stopped.begun)
    has_started = prepared.numbers.calls[stopped.begun] not in prepared.connections.members[member].plan.inits
    entries = [entry for entry in prepared.connections.entries if entry.member == member and has_started]
    values = {**_from_trace(trace, stopped.time), **_from_functions(prepared, sent)}
    lines = [line for entry in entries if (line := _line(entry, values))]
    inputs = f" What it had received last:{''.join(lines)}" if lines else " It had received nothing."
    return f"The run was stopped in {call} at {seconds(stopped.time)} s.{inputs}"


def _line(entry: Entry, values: Mapping[str, Value]) -> str:
    name = next((name for name in entry.names if name in values), None)
    if name is None:
        return ""
    text = cell_of(values[name], entry.shape)
    return f"\n  {name} = {text if len(text) <= _LONGEST else f'{text[:_LONGEST]}...'}"


def _from_trace(trace: Trace | None, time: int) -> dict[str, Value]:
    """The last value of each column of a trace, until a time."""
    found: dict[str, Value] = {}
    for moment in moments(trace) if trace else ():
        if moment.time > time:
            break
        found.update(moment.values)
    return found


def _from_functions(prepared: Prepared, sent: Mapping[int, Value]) -> dict[str, Value]:
    """Return the last values that functions of the set sent to others, by each of their names."""
    exits = prepared.connections.exits
    return {name: value for number, value in sent.items() if exits[number].is_shared for name in exits[number].names}
