"""Places of the core for the interfaces of a function: every platform needs them to connect the two."""

from collections.abc import Mapping
from functools import cached_property
from typing import NamedTuple

from sigcat.adapter.core.identifiers import identifier
from sigcat.adapter.core.plan import CorePlan, Error, Method, ModeIn, ModeOut, Named, Output, Port, Reaction, WireType
from sigcat.function.document.document import Pointer
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.walk import data, parts


class StatusPlace(NamedTuple):
    """The place of an error, a safety reaction or a mode in the core."""

    name: str
    wire: WireType
    comment: str
    numbers: tuple[int, ...] = ()
    """Numbers that say that all is well, and that it is not; none of a mode, and of an error of another function."""


class CorePlaces:
    """A function beside the core that was planned for it."""

    def __init__(self, function: FunctionJson, core: CorePlan) -> None:
        self.function = function
        self.core = core

    @cached_property
    def data_pointers(self) -> Mapping[tuple[str, str], Pointer]:
        """Pointers of the data interfaces of the function, by call and name."""
        return {(at.runnable.name, item.name): pointer for pointer, at, item in data(self.function)}

    @cached_property
    def ports(self) -> Mapping[Pointer, Port]:
        """Places that take signals, by where these stand."""
        return {item.named.pointer: port for port in self.core.ports for _, item in port.consumers}

    @cached_property
    def outputs(self) -> Mapping[Pointer, Output]:
        """Sent values, by pointer."""
        return {output.named.pointer: output for output in self.core.outputs}

    @cached_property
    def interface_names(self) -> Mapping[Pointer, str]:
        """Names of all interfaces, by where they stand."""
        return {at: name for at, item in parts(self.function) if isinstance(name := getattr(item, "name", None), str)}

    @cached_property
    def errors(self) -> Mapping[str, Error]:
        """Errors of the function, by the name of the interface."""
        return {self.name_of(error.named): error for error in self.core.errors}

    def name_of(self, named: Named) -> str:
        """Name of the interface that a part of the core was made from."""
        return self.interface_names[named.pointer]

    @cached_property
    def methods(self) -> Mapping[str, Method]:
        """Methods of the function, by the name of the interface."""
        return {self.name_of(method.named): method for method in self.core.methods}

    def port(self, call: str | None, signal: str) -> Port | None:
        """The place that takes a signal for a call, if a step has one."""
        return self.ports.get(self.data_pointers.get((call or "", signal), ()))

    def output(self, call: str | None, signal: str) -> Output | None:
        """The value that a call sends."""
        return self.outputs.get(self.data_pointers.get((call or "", signal), ()))

    def received_status(self, interface: str) -> StatusPlace | None:
        """The place that takes an error of another function, a safety reaction or the mode."""
        return self._foreign.get(identifier(interface)) or self._received.get(interface)

    def sent_status(self, interface: str) -> StatusPlace | None:
        """The status that the core sends: an error, a safety reaction or the mode."""
        return self._sent.get(interface)

    @cached_property
    def _foreign(self) -> Mapping[str, StatusPlace]:
        return {each.name: StatusPlace(each.name, each.wire, each.comment) for each in self.core.foreign_errors}

    @cached_property
    def _received(self) -> Mapping[str, StatusPlace]:
        return self._statuses(self.core.mode_in, *self.core.reactions)

    @cached_property
    def _sent(self) -> Mapping[str, StatusPlace]:
        return self._statuses(self.core.mode_out, *self.core.reactions, *self.core.errors)

    def _statuses(self, *listed: Error | Reaction | ModeIn | ModeOut | None) -> Mapping[str, StatusPlace]:
        return {
            self.name_of(each.named): StatusPlace(each.named.name, each.wire, each.named.comment, _numbers(each))
            for each in listed
            if each is not None
        }


def _numbers(status: Error | Reaction | ModeIn | ModeOut) -> tuple[int, ...]:
    if isinstance(status, Error):
        return status.passed, status.failed
    return (status.inactive, status.active) if isinstance(status, Reaction) else ()
