"""Parts of a component that an RTE generator would refuse: its ports, runnables and events."""

from collections.abc import Iterable, Iterator, Mapping

from sigcat.asil import is_above, level_of, rank
from sigcat.function.document.document import Pointer
from sigcat.integration.autosar_classic.model import Component, Event, Port, Runnable
from sigcat.integration.problem import Problem
from sigcat.integration.references import unknown

Interfaces = Mapping[str, tuple[str, frozenset[str]]]
"""Kind and elements of each interface."""
LONGEST_QUEUE = 65_535
"""Values or calls that may wait: what an index of 16 bits counts."""


def component_problems(component: Component, at: Pointer, known: Interfaces) -> Iterator[Problem]:
    yield from ports_problems(component.ports, at, known)
    yield from _served(component, at)
    ports = {port.name: port for port in component.ports}
    runnables = {each.name: each for each in component.runnables}
    started = {event.runnable for event in component.events}
    for index, runnable in enumerate(component.runnables):
        if runnable.name not in started:
            message = f"{runnable.name} must be started by an event, and none starts it."
            yield Problem((*at, "Runnables", index), message, "Add an event for it.")
        yield from _accesses(runnable, (*at, "Runnables", index), ports, component)
    for index, event in enumerate(component.events):
        yield from _event(event, (*at, "Events", index), ports, runnables)


def _served(component: Component, at: Pointer) -> Iterator[Problem]:
    """Operations that the component provides: each has one event, which starts what serves it."""
    invoked = [(event.port, event.element) for event in component.events if event.kind == "OperationInvoked"]
    for index, port in enumerate(component.ports):
        for element in port.elements if (port.kind, port.direction) == ("ClientServer", "Provided") else ():
            if invoked.count((port.name, element.name)) != 1:
                message = f"Operation {element.name} of {port.name} must start one runnable, and starts {invoked.count((port.name, element.name))}."
                yield Problem((*at, "Ports", index), message, "Give it one event of kind OperationInvoked.")


def ports_problems(ports: Iterable[Port], at: Pointer, known: Interfaces) -> Iterator[Problem]:
    for index, port in enumerate(ports):
        here: Pointer = (*at, "Ports", index)
        kind, elements = known.get(port.interface, ("", frozenset()))
        if kind != port.kind:
            yield unknown((*here, "Interface"), f"{port.kind} interface", port.interface)
            continue
        for number, element in enumerate(port.elements):
            if element.name not in elements:
                yield unknown((*here, "Elements", number), f"element of {port.interface}", element.name)
            if port.kind == "SenderReceiver" and element.queue_length is None and element.init is None and port.direction == "Required":  # fmt: skip
                message = f"{element.name} of {port.name} must have an initial value, since nothing may have been sent when it is read."
                yield Problem((*here, "Elements", number), message, "Give `InitValue`.")
            yield from _queue(element.queue_length, (*here, "Elements", number, "QueueLength"))


def _queue(length: int | None, at: Pointer) -> Iterator[Problem]:
    if length is not None and not 1 <= length <= LONGEST_QUEUE:
        message = f"A queue must hold at least 1, and {LONGEST_QUEUE:,} at most, not {length}."
        yield Problem(at, message, "Correct it.")


_DIRECTIONS = {
    "ImplicitRead": ("SenderReceiver", "Required"), "ExplicitRead": ("SenderReceiver", "Required"),
    "QueuedReceive": ("SenderReceiver", "Required"), "ExplicitWrite": ("SenderReceiver", "Provided"),
    "QueuedSend": ("SenderReceiver", "Provided"), "Mode": ("ModeSwitch", "Required"),
    "ModeSwitch": ("ModeSwitch", "Provided"), "SynchronousCall": ("ClientServer", "Required"),
    "AsynchronousCall": ("ClientServer", "Required"), "Result": ("ClientServer", "Required"),
    "Parameter": ("Parameter", "Required"),
}  # fmt: skip


def _accesses(runnable: Runnable, at: Pointer, ports: Mapping[str, Port], component: Component) -> Iterator[Problem]:
    yield from _asil(runnable, at, component)
    if runnable.section not in {section.name for section in component.sections if section.kind == "CODE"}:
        yield unknown((*at, "Section"), "memory section of code", runnable.section)
    for index, access in enumerate(runnable.accesses):
        here: Pointer = (*at, "Accesses", index)
        if access.kind == "InternalTrigger":
            if access.element not in {each.name for each in component.runnables}:
                yield unknown(here, "runnable", access.element)
            continue
        port = ports.get(access.port or "")
        if port is None or access.element not in {element.name for element in port.elements}:
            yield unknown(here, f"element {access.element} of a port", str(access.port))
        elif (port.kind, port.direction) != _DIRECTIONS[access.kind]:
            kind, direction = _DIRECTIONS[access.kind]
            message = f"{access.kind} must be of a port that is {kind} and {direction}; {port.name} is {port.kind} and {port.direction}."
            yield Problem(here, message, "Correct the kind of access.")


def _asil(runnable: Runnable, at: Pointer, component: Component) -> Iterator[Problem]:
    """Every runnable writes the core: one with a lower ASIL than that memory could spoil it (ISO 26262-6, 7.4.8)."""
    levels = (level_of(each.asil_level) for each in component.sections if each.kind != "CODE")
    needed = max((level for level in levels if level is not None), key=rank, default=None)
    if is_above(needed, level_of(runnable.asil_level) or "QM"):
        message = f"{runnable.name} must have ASIL {needed}, as the memory that it writes, not {runnable.asil_level or 'none'}."
        yield Problem((*at, "AsilLevel"), message, f"Write {needed}, and a section of code of that ASIL.")


def _event(
    event: Event, at: Pointer, ports: Mapping[str, Port], runnables: Mapping[str, Runnable]
) -> Iterator[Problem]:
    if event.kind == "Timing" and not (event.period and event.period > 0):
        yield Problem((*at, "Period"), f"{event.name} must have a period above 0.", "Correct it.")
    if event.kind in ("DataReceived", "ModeSwitch", "OperationInvoked", "CallReturns"):
        port = ports.get(event.port or "")
        if port is None or event.element not in {element.name for element in port.elements}:
            yield unknown(at, f"element {event.element} of a port", str(event.port))
    if event.kind in ("InternalTrigger", "CallReturns"):
        source = runnables.get(event.source or "")
        names = {access.name for access in source.accesses} if source else set()
        elements = {access.element for access in source.accesses if access.kind == "AsynchronousCall"} if source else set()  # fmt: skip
        if event.element not in (names if event.kind == "InternalTrigger" else elements):
            yield unknown(at, f"access {event.element} of a runnable", str(event.source))
