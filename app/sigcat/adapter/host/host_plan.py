"""The plan of a host: a function beside its core, with all that a platform hands over, takes, stores and sets.

Hosts are components of AUTOSAR adaptive and Classic, nodes of ROS 2, the simulation and FMUs. Each connects the values of this
plan with what its platform has for them. The life cycle, the calls and the methods are in the plan of the core.
"""

from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Literal, NamedTuple

from sigcat.adapter.core.identifiers import identifier
from sigcat.adapter.core.plan import CorePlan, Error, Method, ModeIn, ModeOut, Output, Port, Reaction, WireType
from sigcat.function.document.document import Pointer
from sigcat.function.function_json.code import DEFAULT_STORAGE
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.walk import data, parameters, parts

Kind = Literal["signal", "error", "safety reaction", "mode"]


class HostValue(NamedTuple):
    """A value that the host hands to the core, or takes from it."""

    name: str
    """End of the name of the core's function that receives it, or its member in `out` and `publish`."""
    wire: WireType
    comment: str
    kind: Kind
    pointer: Pointer | None
    """Pointer into Function JSON; None of an error of another function."""
    numbers: tuple[int, ...] = ()
    """Numbers that say that all is well, and that it is not; none of a signal and of a mode."""
    port: Port | None = None
    """A received signal."""
    output: Output | None = None
    """A sent signal."""
    call: str = ""
    """The call that sends it; empty if the core may send it at any time."""

    @property
    def is_queue(self) -> bool:
        """Whether the core sends several values at once."""
        return self.output is not None and self.output.queue is not None


@dataclass(frozen=True)
class HostPlan:
    """A function, its core, and what its host has to do for them."""

    function: FunctionJson
    core: CorePlan
    received: tuple[HostValue, ...]
    """Values that the host hands to the core."""
    sent: tuple[HostValue, ...]
    """Values that the host takes from the core."""
    consumed: Mapping[tuple[str, str], HostValue]
    """Received signals, by call and interface."""
    provided: Mapping[tuple[str, str], HostValue]
    """Sent signals, by call and interface."""
    own_ports: Mapping[str, tuple[Port, ...]]
    """For names of sent signals, the ports of other calls of the function that receive them."""
    interfaces: Mapping[Pointer, str]
    """Names of all interfaces, by pointer."""
    errors: Mapping[str, Error]
    """Errors of the function, by interface."""
    methods: Mapping[str, Method]
    """Methods that it offers and uses, by interface."""
    stored_keys: Mapping[str, str]
    """Keys of stored parameters, by variable, where all of them share one file."""

    def received_status(self, interface: str) -> HostValue | None:
        """An error of another function, a safety reaction or the mode, as the core receives it."""
        foreign = identifier(interface)
        of_others = (each for each in self.received if each.pointer is None and each.name == foreign)
        return next(of_others, None) or self._status(interface, self.received)

    def sent_status(self, interface: str) -> HostValue | None:
        """An error of the function, a safety reaction or the mode, as the core sends it."""
        return self._status(interface, self.sent)

    def _status(self, interface: str, values: tuple[HostValue, ...]) -> HostValue | None:
        own = (each for each in values if each.kind != "signal" and each.pointer is not None)
        return next((each for each in own if self.interfaces[each.pointer or ()] == interface), None)


def host_plan(function: FunctionJson, core: CorePlan) -> HostPlan:
    """The plan of a function and its core."""
    signals = {pointer: (at.runnable.name, item.name) for pointer, at, item in data(function)}
    interfaces = {at: name for at, item in parts(function) if isinstance(name := getattr(item, "name", None), str)}
    received, sent = tuple(received_values(core)), tuple(sent_values(core))
    return HostPlan(
        function=function,
        core=core,
        received=received,
        sent=sent,
        consumed={signals[at]: each for each in received if each.port for at in each.port.pointers},
        provided={signals[each.output.named.pointer]: each for each in sent if each.output},
        own_ports=dict(_own_ports(function, core)),
        interfaces=interfaces,
        errors={interfaces[error.named.pointer]: error for error in core.errors},
        methods={interfaces[method.named.pointer]: method for method in core.methods},
        stored_keys=stored_keys(function, core),
    )


def received_values(core: CorePlan) -> Iterator[HostValue]:
    """Yield the values that a core receives."""
    for port in core.ports:
        yield HostValue(port.name, port.wire, port.comment, "signal", port.pointers[0], port=port)
    for foreign in core.foreign_errors:
        numbers = tuple(number for _, number in foreign.wire.symbols)
        yield HostValue(foreign.name, foreign.wire, foreign.comment, "error", None, numbers)
    yield from map(_value, core.reactions)
    if core.mode_in is not None:
        yield _value(core.mode_in)


def sent_values(core: CorePlan) -> Iterator[HostValue]:
    """Yield the values that a core sends."""
    for step in core.steps:
        for output in step.outputs:
            named, wire = output.named, output.value.wire
            yield HostValue(named.name, wire, named.comment, "signal", named.pointer, output=output, call=step.name)
    yield from map(_value, core.statuses)


def _value(status: Error | Reaction | ModeIn | ModeOut) -> HostValue:
    named, wire = status.named, status.wire
    if isinstance(status, Error):
        return HostValue(named.name, wire, named.comment, "error", named.pointer, (status.passed, status.failed))
    if isinstance(status, Reaction):
        numbers = (status.inactive, status.active)
        return HostValue(named.name, wire, named.comment, "safety reaction", named.pointer, numbers)
    symbols = tuple((each.name, each.number) for each in status.modes)
    return HostValue(named.name, wire._replace(symbols=symbols), named.comment, "mode", named.pointer)


def _own_ports(function: FunctionJson, core: CorePlan) -> Iterator[tuple[str, tuple[Port, ...]]]:
    signals = {pointer: item.vss_path or item.name for pointer, _, item in data(function)}
    for output in core.outputs:
        signal = signals[output.named.pointer]
        yield output.named.name, tuple(port for port in core.ports if signal in map(signals.get, port.pointers))


def stored_keys(function: FunctionJson, core: CorePlan) -> Mapping[str, str]:
    """The key of each parameter: with the storage before it where two storages have one of this name."""
    default = (function.code.storage if function.code else None) or DEFAULT_STORAGE
    storages = {item.variable or item.name: item.storage or default for _, _, item in parameters(function)}
    uses = Counter(parameter.key for parameter in core.parameters)
    return {
        each.variable: each.key if uses[each.key] == 1 else f"{storages[each.variable]}.{each.key}"
        for each in core.parameters
    }
