"""Calls of a function: when they are due, and how they are supervised (sections 9 and 10)."""

from collections.abc import Mapping

from sigcat import codes
from sigcat.adapter.core.identifiers import identifier
from sigcat.adapter.core.interfaces import port_key
from sigcat.adapter.core.modes import excluded_in
from sigcat.adapter.core.plan import Alive, Call, Deadline, Input, Logical, Output
from sigcat.adapter.core.planning import Context, ListedCall, nanoseconds
from sigcat.function.document.document import Pointer
from sigcat.function.document.problem import Subject
from sigcat.function.function_json.interfaces.data_interfaces import DataQueue
from sigcat.function.function_json.runnable import Runnable, WatchdogLimits
from sigcat.function.function_json.triggers import EVENT_TRIGGERED, triggers


def short_name(call: str, function: str) -> str:
    """The last part of the name of a call: `CoreAcc_Step` of CoreAcc → `Step`."""
    return identifier(call.removeprefix(f"{function}_"))


def planned_call(
    listed: ListedCall, inputs: tuple[Input, ...], outputs: tuple[Output, ...], graph: Mapping[str, Logical],
    ports: Mapping[str, str], context: Context,
) -> Call:  # fmt: skip
    """A call with what it reads and writes. `ports` has the names under which signals are received."""
    call, at = listed.call, listed.at
    is_event = call.run_type == EVENT_TRIGGERED
    cycle = None if is_event or not call.cycle_time else nanoseconds(call.cycle_time, (*at, "Cycletime"), context)
    events = triggers(call) if is_event else ()
    queues = [item for item in events if isinstance(item, DataQueue)]
    previous = tuple(name.strip() for name in (call.previous_runnable or "").split(",") if name.strip())
    return Call(
        name=listed.name,
        interface=call.name,
        pointer=at,
        symbol=call.symbol or call.name,
        arguments=call.arguments or (),
        success=call.success_value,
        before=call.pre_processing or (),
        after=call.post_processing or (),
        description=call.description,
        cycle=cycle,
        offset=nanoseconds(call.execution_offset, (*at, "ExecOffset"), context) or 0,
        debounce=nanoseconds(call.debounce_delay, (*at, "DebounceDelay"), context) or 0,
        priority=call.priority_number or 0,
        previous=tuple(short_name(name, context.name) for name in previous),
        most_events=max((item.queue_length for item in queues), default=1),
        events_per_call=min((min(item.values_per_step or 1, item.queue_length) for item in queues), default=1),
        triggers=frozenset(ports[port_key(item)] for item in events),
        is_exclusive=call.parallel_processing is False,
        modes=excluded_in(call.name, context),
        inputs=inputs,
        outputs=outputs,
        overrun_error=call.overrun_error,
        alive=_alive(call, at, cycle, context),
        deadline=_deadline(call, at, context),
        logical=graph.get(call.name),
    )


def _alive(call: Runnable, at: Pointer, cycle: int | None, context: Context) -> Alive | None:
    limits = call.watchdog.alive if call.watchdog else None
    if limits is None:
        return None
    if cycle is None:
        subject = Subject("scheduling", call.name)
        message = f"The alive supervision of {call.name} has no effect: the call has no cycle."
        at = (*at, "Watchdog", "AliveSupervision")
        context.report(codes.SUPERVISION_WITHOUT_EFFECT, at, message, "Remove it, or give a cycle time.", subject)
        return None
    return Alive(int(limits.min), int(limits.max), int(limits.reference) * cycle, limits.error_name)


def _deadline(call: Runnable, at: Pointer, context: Context) -> Deadline | None:
    limits: WatchdogLimits | None = call.watchdog.deadline if call.watchdog else None
    if limits is None:
        return None
    at = (*at, "Watchdog", "DeadlineSupervision")
    least = nanoseconds(limits.min, (*at, "Min"), context)
    most = nanoseconds(limits.max, (*at, "Max"), context)
    return Deadline(least or 0, most or 0, limits.error_name)


def logical_graph(calls: list[Runnable]) -> dict[str, Logical]:
    """Calls in the graph of the logical supervision, by their names."""
    checkpoints = {call.name: call.checkpoint for call in calls if call.checkpoint}
    numbers = {name: number for number, name in enumerate(checkpoints, 1)}
    errors = {call.name: call.watchdog.logical_error if call.watchdog else None for call in calls}
    return {
        name: Logical(
            number=numbers[name],
            is_initial=bool(checkpoint.initial),
            is_final=bool(checkpoint.final),
            previous=tuple(numbers[other] for other, each in checkpoints.items() if name in (each.next or ())),
            error=errors[name],
        )
        for name, checkpoint in checkpoints.items()
    }


def in_order_of_due(steps: tuple[Call, ...]) -> tuple[Call, ...]:
    """Steps in the order in which they run at the same time: previous ones first, then priority, then the file's."""
    waiting = sorted(steps, key=lambda step: -step.priority)
    found: list[Call] = []
    while waiting:
        names = {step.name for step in waiting}
        ready = [step for step in waiting if not names.intersection(step.previous) - {step.name}]
        found.append((ready or waiting)[0])  # a circle of previous ones is a finding of the function
        waiting.remove(found[-1])
    return tuple(found)
