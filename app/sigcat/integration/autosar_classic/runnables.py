"""Runnables of a component: one for each call, and those of the adapter; what each accesses."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property

from sigcat.function.document.text import Text
from sigcat.function.exchange import Part
from sigcat.function.function_json.duration import milliseconds
from sigcat.function.function_json.interfaces.data_interfaces import DataQueue, Signal, rejection_error
from sigcat.function.function_json.interfaces.role import CONSUMER
from sigcat.function.function_json.runnable import Runnable as Call
from sigcat.function.function_json.triggers import EVENT_TRIGGERED, triggers
from sigcat.function.function_json.walk import data_of
from sigcat.integration.autosar_classic import model
from sigcat.integration.autosar_classic.context import INIT, STEP, TERMINATE, NamedCall
from sigcat.integration.autosar_classic.partitioning import asil_of, code_section
from sigcat.integration.autosar_classic.service_needs import (
    CLOCK_PORT,
    IGNITION_PORT,
    NV_PORT,
    SUPERVISION_PORT,
)
from sigcat.integration.autosar_names import short_name

JUDGE_WINDOWS = "JudgeWindows"
AREA = "Core"
"""Exclusive area around the core."""
CALLS = "Calls"
"""Exclusive area around the code of a function that offers methods: none of them runs while a call does."""


@dataclass(frozen=True)
class Behaviour:
    """Parts that the runnables of a component are made of."""

    part: Part
    calls: tuple[NamedCall, ...]
    ports: tuple[model.Port, ...]
    nv_blocks: tuple[model.NvBlock, ...]
    tick: int
    """Period of the counter that starts timing events, in µs: a call that waits for its debounce time is looked for then."""
    parameters: tuple[str, ...]
    """Internal calibration parameters."""

    @property
    def steps(self) -> tuple[NamedCall, ...]:
        """Calls that are neither init nor terminate."""
        return tuple(each for each in self.calls if each.role == STEP)

    @cached_property
    def data_ports(self) -> Mapping[tuple[str, str | None, str], model.Port]:
        """Ports of signals and queues, by direction, call and name."""
        return {
            (port.direction, use.call, use.interface): port
            for port in self.ports
            if port.kind == "SenderReceiver"
            for use in port.elements[0].uses or ()
            if use.kind in ("signal", "queue")
        }

    @property
    def has_floating_windows(self) -> bool:
        """Whether windows of its alive supervision may end between the releases of their call: they begin again with a mode
        that the call comes back with, and modes come at any time."""
        modes = self.part.function.modes or ()
        return any(
            each.call.watchdog is not None
            and each.call.watchdog.alive is not None
            and any(each.call.name not in mode.runnables for mode in modes)
            for each in self.steps
        )

    @property
    def offers(self) -> bool:
        """Whether others may call its methods."""
        return any(_offers(port) for port in self.ports)

    def call(self, role: str) -> Call | None:
        """The first call of a role."""
        return next((each.call for each in self.calls if each.role == role), None)

    def port(self, name: str) -> model.Port | None:
        """A port by its name."""
        return next((port for port in self.ports if port.name == name), None)

    @property
    def mode_port(self) -> model.Port | None:
        """The port over which the function receives its mode."""
        return next(
            (p for p in self.ports if p.kind == "ModeSwitch" and p.direction == "Required" and not p.service), None
        )


def runnables_of(behaviour: Behaviour) -> tuple[model.Runnable, ...]:
    """All of them: init, what receives values, steps, methods, answers, supervision, terminate."""
    clock, mode, statuses = _calls_to(behaviour, CLOCK_PORT), _mode(behaviour), _statuses(behaviour)
    stored = _calls_to(behaviour, NV_PORT, "GetErrorStatus"), _calls_to(behaviour, NV_PORT, "SetRamBlockStatus")
    arriving = _arriving(behaviour)
    init = [*clock, *_calls_to(behaviour, IGNITION_PORT), *stored[0], *_parameters(behaviour), *mode, *statuses]
    made = [_runnable(INIT, INIT, init, behaviour, "Starts the core, and its clocks.", behaviour.call(INIT))]
    if behaviour.mode_port is not None or arriving:
        accesses = [*arriving, *clock, *mode, *statuses, *_triggers(behaviour, None)]
        description = "Receives values when they arrive, and starts due calls."
        made.append(_runnable("Receive", "Receive", accesses, behaviour, description))
    made += [_step(each, behaviour) for each in behaviour.steps]
    made += [_method(port, [*clock, *statuses], behaviour) for port in behaviour.ports if _offers(port)]
    made += [_answer(port, clock, behaviour) for port in behaviour.ports if uses_method(port)]
    if any(port.service == "WatchdogManager" for port in behaviour.ports):
        description = "Looks for calls that hang or do not come."
        made.append(_runnable("Supervise", "Supervise", [*clock, *mode, *statuses], behaviour, description))
    if behaviour.has_floating_windows:
        description = "Judges windows of alive supervision that end between releases: they began with a mode."
        made.append(_runnable(JUDGE_WINDOWS, JUDGE_WINDOWS, [*clock, *statuses], behaviour, description))
    description = "Ends the core, and hands over what is stored."
    end = [*clock, *stored[1], *statuses]
    made.append(_runnable(TERMINATE, TERMINATE, end, behaviour, description, behaviour.call(TERMINATE)))
    return tuple(made)


def _offers(port: model.Port) -> bool:
    return port.kind == "ClientServer" and port.direction == "Provided"


def uses_method(port: model.Port) -> bool:
    """Whether a method of another function is called through it."""
    return port.kind == "ClientServer" and port.direction == "Required" and bool(port.elements[0].uses)


def _runnable(
    name: str,
    role: str,
    accesses: Iterable[model.Access],
    behaviour: Behaviour,
    description: Text | str | None,
    call: Call | None = None,
) -> model.Runnable:
    level = asil_of(behaviour.part)  # each of them reads and writes the core, which is in memory of this level
    stack = milliseconds(call.stack_size) if call else None
    return model.Runnable(
        name=name,
        symbol=short_name(f"{behaviour.part.name}_Run_{name}"),
        role=role,  # type: ignore[arg-type]
        call=call.name if call else None,
        description=Text(description) if isinstance(description, str) else description or None,
        concurrent=False,
        minimum_start_interval=0,
        accesses=_numbered(accesses),
        exclusive_areas=(AREA, CALLS) if behaviour.offers and role in (STEP, "Method") else (AREA,),
        parameters=behaviour.parameters or None if role in (INIT, STEP) else None,
        stack_size=int(stack) if stack else None,
        asil_level=level,
        section=code_section(level),
    )


def _numbered(accesses: Iterable[model.Access]) -> tuple[model.Access, ...]:
    """Each once, under names that no other one has."""
    found: dict[tuple[str, str | None, str], model.Access] = {}
    for access in accesses:
        found.setdefault((access.kind, access.port, access.element), access)
    return tuple(found.values())


def _access(kind: model.AccessKind, port: model.Port, element: model.Element, reason: str = "") -> model.Access:
    name = short_name(f"{kind}_{port.name}_{element.name}")
    return model.Access(
        name=name, kind=kind, port=port.name, element=element.name, reason=Text(reason) if reason else None
    )


def _method(port: model.Port, accesses: Iterable[model.Access], behaviour: Behaviour) -> model.Runnable:
    (element,) = port.elements
    made = _runnable(short_name(f"Serve_{element.name}"), "Method", accesses, behaviour, port.description)
    return made.model_copy(update={"method": _method_of(element)})


def _answer(port: model.Port, clock: Iterable[model.Access], behaviour: Behaviour) -> model.Runnable:
    (element,) = port.elements
    accesses = [_access("Result", port, element), *clock]
    description = f"Takes the answer of {element.name}."
    made = _runnable(short_name(f"Answer_{element.name}"), "Answer", accesses, behaviour, description)
    return made.model_copy(update={"method": _method_of(element)})


def _method_of(element: model.Element) -> str:
    return element.uses[0].interface if element.uses else element.name


def _arriving(behaviour: Behaviour) -> list[model.Access]:
    """Return accesses to data that must be taken when it arrives: the core derives times and due calls from it."""
    found = [
        access for each in behaviour.steps for access in (*_data(each.call, behaviour), *_received_statuses(behaviour))
    ]
    return list({each.name: each for each in found if each.kind in ("ExplicitRead", "QueuedReceive")}.values())


def _step(each: NamedCall, behaviour: Behaviour) -> model.Runnable:
    accesses = [
        *_calls_to(behaviour, CLOCK_PORT),
        *(access for port in _checkpoint_ports(behaviour, each) for access in _calls_to(behaviour, port)),
        *_data(each.call, behaviour),
        *_received_statuses(behaviour),
        *_mode(behaviour),
        *_statuses(behaviour),
        *_requests(each.call, behaviour),
        *_parameters(behaviour),
        *_triggers(behaviour, each),
    ]
    return _runnable(each.name, STEP, accesses, behaviour, each.call.description, each.call)


def _calls_to(behaviour: Behaviour, name: str, operation: str = "") -> list[model.Access]:
    port = behaviour.port(name)
    if port is None:
        return []
    called = (element for element in port.elements if operation in ("", element.name))
    return [_access("SynchronousCall", port, element) for element in called]


def _mode(behaviour: Behaviour) -> list[model.Access]:
    port = behaviour.mode_port
    return [_access("Mode", port, port.elements[0])] if port else []


def _parameters(behaviour: Behaviour) -> list[model.Access]:
    ports = (port for port in behaviour.ports if port.kind == "Parameter")
    return [_access("Parameter", port, element) for port in ports for element in port.elements]


def _statuses(behaviour: Behaviour) -> list[model.Access]:
    """Return accesses that the core may use at any time: states of errors and reactions, its mode, DEM results."""
    made = []
    for port in behaviour.ports:
        kinds = {use.kind for element in port.elements for use in element.uses or ()}
        if port.kind == "SenderReceiver" and port.direction == "Provided" and kinds <= {"error", "safety reaction"}:
            made.append(_access("ExplicitWrite", port, port.elements[0]))
        if port.kind == "ModeSwitch" and port.direction == "Provided":
            made.append(_access("ModeSwitch", port, port.elements[0]))
        if port.service == "DiagnosticEventManager":
            made.append(_access("SynchronousCall", port, port.elements[0]))
    return made


def _received_statuses(behaviour: Behaviour) -> list[model.Access]:
    """Errors of others and safety reactions, which the core takes for all calls."""
    return [
        _access("ExplicitRead", port, port.elements[0], "The core learns which values are fresh.")
        for port in behaviour.ports
        if port.kind == "SenderReceiver" and port.direction == "Required"
        and {use.kind for use in port.elements[0].uses or ()} <= {"error", "safety reaction"}
    ]  # fmt: skip


def _data(call: Call, behaviour: Behaviour) -> Iterator[model.Access]:
    """Signals and queues of a call."""
    for contract in call.contracts or ():
        for data in data_of(contract):
            port = _port_of(data, call, behaviour)
            if port is None:
                continue
            element = port.elements[0]
            if data.role != CONSUMER:
                yield _access("ExplicitWrite" if element.init is not None else "QueuedSend", port, element, "Sent when the core says so.")  # fmt: skip
            elif element.queue_length is not None:
                yield _access("QueuedReceive", port, element, "Each value is received.")
            else:
                yield _access(*_reading(data, call, port, behaviour))


def _reading(
    data: Signal | DataQueue, call: Call, port: model.Port, behaviour: Behaviour
) -> tuple[model.AccessKind, model.Port, model.Element, str]:
    element = port.elements[0]
    if (data.access or "").lower() == "immediate":
        return "ExplicitRead", port, element, "Access is Immediate: the latest value when the call begins."
    if data.timeout:
        return "ExplicitRead", port, element, "The core's time-out has to know what is fresh."
    if rejection_error(data):
        return "ExplicitRead", port, element, "The core has to know what was rejected."
    if _is_trigger(data, call):
        return "ExplicitRead", port, element, "It triggers the call: each value counts."
    if any(other is not data and _is_watched(other, reader) for other, reader in _readers(port, behaviour)):
        return "ExplicitRead", port, element, "Another call has to know what is fresh."
    return "ImplicitRead", port, element, "Access is Buffered: the same value for the whole call."


def _is_trigger(data: Signal | DataQueue, call: Call) -> bool:
    return call.run_type == EVENT_TRIGGERED and data in triggers(call)


def _is_watched(data: Signal, call: Call) -> bool:
    """Whether a value that is handed over twice would be taken for a new one."""
    return bool(data.timeout or rejection_error(data)) or _is_trigger(data, call)


def _readers(port: model.Port, behaviour: Behaviour) -> Iterator[tuple[Signal, Call]]:
    """Yield the signals that the calls of a component read from a port."""
    for step in behaviour.steps:
        for contract in step.call.contracts or ():
            for data in contract.signals or ():
                if data.role == CONSUMER and _port_of(data, step.call, behaviour) is port:
                    yield data, step.call


def _port_of(data: Signal | DataQueue, call: Call, behaviour: Behaviour) -> model.Port | None:
    direction = "Required" if data.role == CONSUMER else "Provided"
    return behaviour.data_ports.get((direction, call.name, data.name))


def _requests(call: Call, behaviour: Behaviour) -> Iterator[model.Access]:
    """Methods that a call uses: the answer comes later."""
    first: dict[str, str] = {}  # the first call that uses a method asks for all
    for each in behaviour.steps:
        for method in (method for contract in each.call.contracts or () for method in contract.methods or ()):
            if method.role == CONSUMER:
                first.setdefault(method.name, each.call.name)
    for port in behaviour.ports:
        if port.kind == "ClientServer" and port.direction == "Required" and not port.service:
            for element in port.elements:
                if any(first.get(use.interface) == call.name for use in element.uses or ()):
                    yield _access("AsynchronousCall", port, element)


def _checkpoint_ports(behaviour: Behaviour, each: NamedCall) -> list[str]:
    """Ports of the checkpoints of a call."""
    names = {short_name(f"{SUPERVISION_PORT}_{each.name}_{moment}") for moment in ("Begin", "End")}
    return [port.name for port in behaviour.ports if port.name in names]


def _triggers(behaviour: Behaviour, own: NamedCall | None) -> list[model.Access]:
    """The core decides which call is due: a trigger starts each call that this runnable does not run.

    An event-triggered call starts itself again: more values may wait than it takes at once, or were received meanwhile.
    """
    started = [each for each in behaviour.steps if each is not own or each.call.run_type == EVENT_TRIGGERED]
    due = Text("The core may find it due.")
    return [
        model.Access(name=f"Start_{each.name}", kind="InternalTrigger", element=each.name, reason=due)
        for each in started
    ]
