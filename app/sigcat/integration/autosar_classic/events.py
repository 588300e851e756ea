"""Events that start the runnables of a component."""

from collections.abc import Iterator
from typing import Any

from sigcat.function.function_json.duration import milliseconds, time_in_a_name
from sigcat.function.function_json.triggers import EVENT_TRIGGERED
from sigcat.integration.autosar_classic import model
from sigcat.integration.autosar_classic.context import INIT, STEP, TERMINATE
from sigcat.integration.autosar_classic.interfaces import in_seconds
from sigcat.integration.autosar_classic.runnables import AREA, CALLS, JUDGE_WINDOWS, Behaviour
from sigcat.integration.autosar_classic.service_needs import ECU_PORT, STORED
from sigcat.integration.autosar_names import distinct_names, short_name

SHUTDOWN = "SHUTDOWN"


def events_of(behaviour: Behaviour, runnables: tuple[model.Runnable, ...], modes: tuple[str, ...]) -> tuple[model.Event, ...]:  # fmt: skip
    """All of them. `modes` are those that the function receives."""
    made = [event for runnable in runnables for event in _events(runnable, behaviour, runnables, modes)]
    taken = {AREA, CALLS, STORED, *(runnable.name for runnable in runnables), *behaviour.parameters}
    names = distinct_names([event.name for event in made], taken)
    return tuple(event.model_copy(update={"name": name}) for event, name in zip(made, names, strict=True))


def _events(
    runnable: model.Runnable, behaviour: Behaviour, runnables: tuple[model.Runnable, ...], modes: tuple[str, ...]
) -> Iterator[model.Event]:
    if runnable.role == INIT:
        yield model.Event(name="OnInit", kind="Init", runnable=runnable.name)
    if runnable.role == TERMINATE:
        yield _on_entry(runnable, ECU_PORT, "currentMode", SHUTDOWN)
    if runnable.role == "Receive":
        yield from _received(runnable, behaviour, modes)
    if runnable.role == "Answer":
        yield from _answered(runnable, runnables)
    if runnable.role == "Supervise":
        yield _timing(runnable, _period_of_supervision(behaviour), 0)
    if runnable.role == JUDGE_WINDOWS:
        yield _timing(runnable, behaviour.tick / 1000, 0)
    if runnable.role == "Method":
        port = next(p for p in behaviour.ports if p.direction == "Provided" and p.kind == "ClientServer" and p.elements[0].uses and p.elements[0].uses[0].interface == runnable.method)  # fmt: skip
        element = port.elements[0].name
        yield _event(f"Invoked_{runnable.name}", "OperationInvoked", runnable, port=port.name, element=element)
    if runnable.role == STEP:
        yield from _starts(runnable, behaviour, runnables)


def _period_of_supervision(behaviour: Behaviour) -> float:
    """The longest period that the core allows, in ms: the shortest of the cycles and longest durations, in whole ticks."""
    cycles = [each.call.cycle_time for each in behaviour.steps if each.call.cycle_time]
    deadlines = [each.call.watchdog.deadline for each in behaviour.steps if each.call.watchdog]
    durations = [each.max for each in deadlines if each is not None and each.max > 0]
    shortest = min((*cycles, *durations), default=100)
    ticks = max(int(shortest * 1000 / behaviour.tick + 1e-6), 1)
    return ticks * behaviour.tick / 1000


def _starts(runnable: model.Runnable, behaviour: Behaviour, runnables: tuple[model.Runnable, ...]) -> Iterator[model.Event]:  # fmt: skip
    call = next(each.call for each in behaviour.steps if each.name == runnable.name)
    if call.cycle_time and call.run_type != EVENT_TRIGGERED:
        yield _timing(runnable, call.cycle_time, milliseconds(call.execution_offset) or 0)
    if milliseconds(call.debounce_delay):
        yield _timing(runnable, behaviour.tick / 1000, 0)
    for other in runnables:
        for access in other.accesses:
            if access.kind == "InternalTrigger" and access.element == runnable.name:
                name = f"{other.name}_{access.name}"
                yield _event(name, "InternalTrigger", runnable, source=other.name, element=access.name)


def _received(runnable: model.Runnable, behaviour: Behaviour, modes: tuple[str, ...]) -> Iterator[model.Event]:
    for access in runnable.accesses:
        if access.kind in ("ExplicitRead", "QueuedReceive") and access.port:
            name = f"{runnable.name}_{access.port}"
            yield _event(name, "DataReceived", runnable, port=access.port, element=access.element)
    port = behaviour.mode_port
    for mode in modes if port is not None else ():
        assert port is not None
        yield _on_entry(runnable, port.name, port.elements[0].name, mode)


def _answered(runnable: model.Runnable, runnables: tuple[model.Runnable, ...]) -> Iterator[model.Event]:
    result = next(access for access in runnable.accesses if access.kind == "Result")
    for other in runnables:
        for access in other.accesses:
            if access.kind == "AsynchronousCall" and access.port == result.port:
                at = {"source": other.name, "port": access.port, "element": access.element}
                yield _event(f"Returns_{access.element}", "CallReturns", runnable, **at)


def _timing(runnable: model.Runnable, cycle: float, offset: float) -> model.Event:
    name = f"{runnable.name}_{time_in_a_name(cycle)}"
    return _event(name, "Timing", runnable, period=in_seconds(cycle), offset=in_seconds(offset))


def _on_entry(runnable: model.Runnable, port: str, element: str, mode: str) -> model.Event:
    name = f"{runnable.name}_{mode}"
    return _event(name, "ModeSwitch", runnable, port=port, element=element, mode=mode, activation="OnEntry")


def _event(name: str, kind: Any, runnable: model.Runnable, **more: Any) -> model.Event:
    """An event that starts a runnable."""
    return model.Event(name=short_name(name), kind=kind, runnable=runnable.name, **more)
