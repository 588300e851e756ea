"""Calls: when they are due, what they read and write, how they are supervised."""

import re
from collections.abc import Iterable, Mapping

from sigcat.function.function_json.interfaces.role import CONSUMER
from sigcat.function.function_json.model import Mode
from sigcat.function.function_json.runnable import Runnable
from tests.adapter.reference.function import Call
from tests.adapter.reference.parts.inputs import Input
from tests.adapter.reference.parts.schedule import Timing
from tests.adapter.reference.parts.supervision import AliveLimits, Checkpoint, DeadlineLimits
from tests.adapter.reference.reading.data import absent_input_of, absent_of, data_of, input_of, output_of
from tests.adapter.reference.reading.times import nanoseconds
from tests.adapter.reference.reading.transfers import Table

EVENT_TRIGGERED = "EventTriggered"


def call_of(runnable: Runnable, modes: Iterable[Mode], ports: Mapping[str, str], table: Table) -> Call:
    """A call."""
    data = data_of(runnable)
    inputs = tuple(input_of(item, ports, table) for item in data if item.role == CONSUMER)
    absent = tuple(absent_input_of(item, table) for item in absent_of(runnable) if item.role == CONSUMER)
    triggers = _triggers(runnable, inputs, absent)
    return Call(
        name=runnable.name,
        symbol=runnable.symbol or runnable.name,
        run_type=runnable.run_type,
        before=runnable.pre_processing or (),
        after=runnable.post_processing or (),
        success=runnable.success_value,
        timing=_timing(runnable, triggers),
        priority=_whole(runnable.priority),
        previous=_listed(runnable.previous_runnable),
        is_alone=runnable.parallel_processing is False,
        triggers=frozenset(each.port for each in triggers),
        excluding_modes=frozenset(mode.name for mode in modes if runnable.name not in mode.runnables),
        inputs=(*inputs, *absent),
        outputs=tuple(output_of(item, table) for item in data if item.role != CONSUMER),
        overrun_error=runnable.overrun_error,
        errors=tuple(error.name for contract in runnable.contracts or () for error in contract.errors or ()),
        alive=_alive(runnable),
        deadline=_deadline(runnable),
    )


def _listed(text: str | None) -> tuple[str, ...]:
    return tuple(name.strip() for name in (text or "").split(",") if name.strip())


def _whole(text: str) -> int:
    return int(text) if re.fullmatch(r"\s*[+-]?[0-9]{1,18}\s*", text) else 0


def _triggers(runnable: Runnable, inputs: tuple[Input, ...], absent: tuple[Input, ...]) -> tuple[Input, ...]:
    """Inputs that trigger a call: those listed as events, or else all. Absent ones may be listed, and trigger nothing."""
    if runnable.run_type != EVENT_TRIGGERED:
        return ()
    events = set(_listed(runnable.events))
    listed = [each for each in (*inputs, *absent) if events.intersection(each.names)]
    return tuple(each for each in inputs if each in listed) if listed else inputs


def _timing(runnable: Runnable, triggers: tuple[Input, ...]) -> Timing:
    is_event = runnable.run_type == EVENT_TRIGGERED
    return Timing(
        cycle=None if is_event else nanoseconds(runnable.cycle_time) or None,
        offset=nanoseconds(runnable.execution_offset) or 0,
        debounce=nanoseconds(runnable.debounce_delay) or 0,
        most_events=max((each.queue.length for each in triggers if each.queue), default=1),
        events_per_call=min((each.queue.values_per_step for each in triggers if each.queue), default=1),
    )


def _alive(runnable: Runnable) -> AliveLimits | None:
    limits = runnable.watchdog.alive if runnable.watchdog else None
    cycle = nanoseconds(runnable.cycle_time)
    if limits is None or not cycle or runnable.run_type == EVENT_TRIGGERED:
        return None
    return AliveLimits(int(limits.min), int(limits.max), int(limits.reference) * cycle, limits.error_name)


def _deadline(runnable: Runnable) -> DeadlineLimits | None:
    limits = runnable.watchdog.deadline if runnable.watchdog else None
    if limits is None:
        return None
    return DeadlineLimits(nanoseconds(limits.min) or 0, nanoseconds(limits.max) or 0, limits.error_name)


def checkpoints_of(runnables: Iterable[Runnable]) -> dict[str, Checkpoint]:
    """The graph of the logical supervision, by the names of calls."""
    return {
        each.name: Checkpoint(
            bool(each.checkpoint.initial),
            bool(each.checkpoint.final),
            each.checkpoint.next or (),
            each.watchdog.logical_error if each.watchdog else None,
        )
        for each in runnables
        if each.checkpoint
    }
