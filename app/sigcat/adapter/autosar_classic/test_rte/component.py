"""Rte_<component>.c: everything that the RTE does for a component."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from sigcat.adapter.autosar_classic.code.c_text import c_lines
from sigcat.adapter.autosar_classic.code.plan import DataEnd, MethodEnd, RteType, SwcPlan
from sigcat.adapter.autosar_classic.code.rte_headers.api import Call
from sigcat.adapter.autosar_classic.test_rte.operations import Request, Service, request, service
from sigcat.adapter.autosar_classic.test_rte.plan import TestRte, received_at
from sigcat.adapter.autosar_classic.test_rte.shapes import initializer
from sigcat.adapter.core.c.names.shadowing import distinct
from sigcat.adapter.core.c.text.lines import Lines
from sigcat.integration.autosar_classic.model import ModeNumber, Port


class _Change(NamedTuple):
    """The entry of a mode or the exit from it, with the numbers of the events that it raises."""

    is_entry: bool
    mode: int
    activated: Sequence[int]


class _Modes(NamedTuple):
    """A port over which modes come."""

    port: str
    group: str
    initial: ModeNumber
    changes: Sequence[_Change]


class _Sent(NamedTuple):
    """An element that is sent: `<component>_<end>` of those that receive it."""

    end: DataEnd
    receivers: Sequence[str]


class _Calibrated(NamedTuple):
    """A calibration parameter, which is as the document says."""

    type: RteType
    literal: str


class _Function(NamedTuple):
    """A function that runnables call; `kind` decides its body, `of` is what the body needs.

    A switched mode needs `<component>_<port>` of those that receive it, a trigger the numbers of its events.
    """

    call: Call
    kind: str
    of: DataEnd | MethodEnd | _Sent | _Calibrated | Service | Request | Sequence[str | int] = ()


def component_source(swc: SwcPlan, rte: TestRte) -> Lines:
    """The whole file. A variable of the code may be called as one of these functions calls something: that is renamed."""
    modes = [_modes(port, swc, rte) for port in swc.required_modes]
    functions = [_function(each, swc, rte) for each in rte.calls(swc)]
    part = c_lines(
        "test_rte/Rte_component.c.j2",
        swc=swc,
        number=rte.index(swc),
        rte=rte,
        modes=modes,
        functions=functions,
    )
    first = next((number for number, line in enumerate(part) if line.text == "{"), 1) - 1
    return (*part[:first], *distinct(swc.core, part[first:]))  # members of the structs before keep their names


def _modes(port: Port, swc: SwcPlan, rte: TestRte) -> _Modes:
    group = rte.group(port)
    initial = next(each for each in group.modes if each.name == group.initial)
    changes = [
        _Change(word == "OnEntry", mode.value, numbers)
        for mode in group.modes for word in ("OnExit", "OnEntry")
        if (numbers := [*rte.events(swc, "ModeSwitch", port=port.name, mode=mode.name, activation=word)])
    ]  # fmt: skip
    return _Modes(port.name, group.name, initial, changes)


def _function(call: Call, swc: SwcPlan, rte: TestRte) -> _Function:
    key = (call.port, call.element)
    if call.kind in ("Read", "IsUpdated", "Receive", "IRead", "IStatus"):
        return _Function(call, call.kind, next(end for end in swc.received if end.key == key))
    if call.kind in ("Write", "Send"):
        end = next(end for end in swc.sent if end.key == key)
        return _Function(call, call.kind, _Sent(end, [*_receivers(end, swc, rte)]))
    if call.kind == "Switch":
        receivers = [f"{one.swc.name}_{one.port.name}" for one in rte.receivers(swc, call.port)]
        return _Function(call, call.kind, receivers)
    if call.kind in ("Call", "Result"):
        return _operation(call, swc, rte)
    if call.kind == "IrTrigger":
        raised = rte.events(swc, "InternalTrigger", source=call.runnable, element=call.element)
        return _Function(call, call.kind, [*raised])
    return _Function(call, call.kind, _calibrated(call, swc) if call.kind in ("Prm", "CData") else ())


def _receivers(end: DataEnd, swc: SwcPlan, rte: TestRte) -> Iterator[str]:
    for one in rte.receivers(swc, end.port):
        other = received_at(one, end.element)
        if other is not None:
            yield f"{one.swc.name}_{other.name}"


def _operation(call: Call, swc: SwcPlan, rte: TestRte) -> _Function:
    method = next((each for each in swc.requests if (each.port, each.operation) == (call.port, call.element)), None)
    if method is None:
        return _Function(call, "Service", service(call, swc))
    if call.kind == "Result":
        return _Function(call, "Result", method)
    return _Function(call, "Request", request(method, call, swc, rte))


def _calibrated(call: Call, swc: SwcPlan) -> _Calibrated:
    end = next(each for each in swc.parameters if each.function == call.name)
    value: object = next((each.init for each in swc.component.parameters if each.name == call.element), None)
    if call.kind == "Prm":
        port = next(each for each in swc.component.ports if each.name == call.port)
        value = next(each.init for each in port.elements if each.name == call.element)
    return _Calibrated(end.type, initializer(value, end.type))
