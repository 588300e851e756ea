"""Exchange of a set of functions: each signal, method, status and mode once, with its providers and consumers.

Sets, simulation and every platform start here. A platform adds its own names, datatypes and findings.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Literal, NamedTuple, TypeVar

from sigcat.asil import Level, level_of
from sigcat.function.document.document import Pointer
from sigcat.function.function_json.error_fields import SetError
from sigcat.function.function_json.interfaces.data_interfaces import DataQueue, Signal, rejection_error
from sigcat.function.function_json.interfaces.methods import MethodInterface
from sigcat.function.function_json.interfaces.role import PROVIDER
from sigcat.function.function_json.interfaces.status_interfaces import ErrorInterface, ModeInterface, SafetyReaction
from sigcat.function.function_json.model import Component, FunctionJson
from sigcat.function.function_json.runnable import Contract, Runnable
from sigcat.function.function_json.walk import interface_lists

Interface = Signal | DataQueue | MethodInterface | ErrorInterface | SafetyReaction | ModeInterface
Kind = Literal["data", "method", "error", "reaction", "mode in", "mode out"]
_KINDS: Mapping[type, Kind] = {
    Signal: "data", DataQueue: "data", MethodInterface: "method", ErrorInterface: "error", SafetyReaction: "reaction",
}  # fmt: skip
_Status = TypeVar("_Status", ErrorInterface, SafetyReaction)


class Part(NamedTuple):
    """A component of a function, under the name that it has in the set."""

    name: str
    function: FunctionJson
    number: int
    """Index of the component in the function."""

    @property
    def component(self) -> Component:
        """The component."""
        return self.function.components[self.number]

    @property
    def function_name(self) -> str:
        """Name of the function."""
        return self.function.info.function_name

    @property
    def is_first(self) -> bool:
        """Whether it is the component of the function that has what belongs to none."""
        return self.number == 0


class Side(NamedTuple):
    """An interface of a component, at the call that uses it."""

    part: Part
    call: Runnable | None
    """None for a mode, which belongs to no call."""
    interface: Interface
    kind: Kind
    path: str
    """VSS path: its own, or the one that the deployment states; empty if there is none."""
    identity: str
    """Name that all sides of the element share: of data the path, if there is one, or else the name."""
    provides: bool
    pointer: Pointer
    """Pointer of the interface in the function; of an error of another function, of what it sets."""

    @property
    def function(self) -> str:
        """Name of the function."""
        return self.part.function_name

    @property
    def names(self) -> tuple[str, ...]:
        """Names under which it is known outside of its function: of a status or a mode its name and its path."""
        if self.kind in ("data", "method"):
            return (self.identity,)
        return tuple(dict.fromkeys(filter(None, (self.interface.name, self.path))))

    @property
    def data(self) -> Signal | DataQueue:
        """The interface, if it is data."""
        assert isinstance(self.interface, Signal | DataQueue)
        return self.interface

    @property
    def asil(self) -> Level | None:
        """ASIL of the interface; None if it states none that is known."""
        return level_of(getattr(self.interface, "asil_level", None))

    @property
    def queue_length(self) -> int | None:
        """Values to queue, if it is a queue."""
        return self.interface.queue_length if isinstance(self.interface, DataQueue) else None

    @property
    def rejection_error(self) -> SetError | None:
        """The error of messages that end-to-end protection rejects, if it consumes data and names one."""
        return None if self.provides else rejection_error(self.interface)

    @property
    def runnable(self) -> Runnable:
        """The call, if the interface is not a mode."""
        assert self.call is not None
        return self.call

    @property
    def where(self) -> str:
        """For findings: `CoreAcc, CoreAcc_Step`."""
        return self.function + (f", {self.call.name}" if self.call else "")


@dataclass(frozen=True)
class Element:
    """Something that is exchanged, and its sides."""

    kind: Kind
    identity: str
    sides: tuple[Side, ...]

    @cached_property
    def providers(self) -> tuple[Side, ...]:
        """The first providing side of each component."""
        first: dict[str, Side] = {}
        for side in self.sides:
            if side.provides:
                first.setdefault(side.part.name, side)
        return tuple(first.values())

    @property
    def provider(self) -> Side | None:
        """The first of them, to which consumers are connected; None if no function of the set provides it."""
        return next(iter(self.providers), None)

    @property
    def leading(self) -> Side:
        """The side that says what is sent: the provider, or the first consumer."""
        return self.provider or self.sides[0]

    @property
    def is_queued(self) -> bool:
        """Whether one of its sides queues values: then all have to."""
        return any(isinstance(side.interface, DataQueue) for side in self.sides)

    @property
    def is_reported(self) -> bool:
        """Whether it is not an error, or a function of the set reports it."""
        return self.kind != "error" or self.provider is not None

    @property
    def is_checked(self) -> bool:
        """Whether a consumer has an error for messages that end-to-end protection rejects."""
        return any(side.rejection_error for side in self.sides)


class Exchange(NamedTuple):
    """Everything that a set of functions exchanges."""

    sides: tuple[Side, ...]
    """In the order of the documents; after them errors of other components on which something depends."""
    elements: Mapping[tuple[Kind, str], Element]

    @property
    def data(self) -> tuple[Side, ...]:
        """Sides of signals and queues."""
        return tuple(side for side in self.sides if side.kind == "data")

    def element(self, side: Side) -> Element:
        """Return the element of a side."""
        return self.elements[side.kind, side.identity]


def exchange_of(parts: Sequence[Part], paths: Mapping[str, str] | None = None, *, joins_names: bool = True) -> Exchange:
    """Resolve the exchange of components.

    `paths` are those of signals that name none, by `Function.Signal`. Signals without any path are one if they have
    one name; without `joins_names`, each belongs to its function.
    """
    own = [side for part in parts for side in _sides(part, paths or {}, joins_names=joins_names)]
    sides = (*own, *_errors_of_others(own))
    found: dict[tuple[Kind, str], list[Side]] = {}
    for side in sides:
        found.setdefault((side.kind, side.identity), []).append(side)
    return Exchange(sides, {key: Element(*key, tuple(listed)) for key, listed in found.items()})


def parts_of(functions: Iterable[FunctionJson]) -> tuple[Part, ...]:
    """Every component under its own name."""
    return tuple(
        Part(each.name, function, number) for function in functions for number, each in enumerate(function.components)
    )


def contracts_of(part: Part) -> Iterator[Contract]:
    """Every contract of a component's calls."""
    return (contract for call in part.component.runnables for contract in call.contracts or ())


def errors_of(part: Part) -> tuple[ErrorInterface, ...]:
    """Errors that the calls of a component report, each once."""
    return _once(error for contract in contracts_of(part) for error in contract.errors or ())


def reactions_of(part: Part) -> tuple[SafetyReaction, ...]:
    """Safety reactions of the calls of a component, each once."""
    return _once(each for contract in contracts_of(part) for each in contract.safety_reactions or ())


def _once(items: Iterable[_Status]) -> tuple[_Status, ...]:
    first: dict[str, _Status] = {}
    for item in items:
        first.setdefault(item.name, item)
    return tuple(first.values())


def _kind_of(interface: Interface) -> Kind:
    """Return the kind of an interface."""
    if isinstance(interface, ModeInterface):
        return "mode out" if interface.direction == "Out" else "mode in"
    return _KINDS[type(interface)]


def causes(interface: Interface) -> tuple[str, ...]:
    """Names of the errors that set an error or a safety reaction."""
    if isinstance(interface, SafetyReaction):
        return interface.errors
    return interface.dependencies if isinstance(interface, ErrorInterface) else ()


def _sides(part: Part, paths: Mapping[str, str], *, joins_names: bool) -> Iterator[Side]:
    for pointer, call, interface in _interfaces(part):
        kind, name = _kind_of(interface), f"{part.function_name}.{interface.name}"
        path = getattr(interface, "vss_path", None) or (paths.get(name, "") if kind == "data" else "")
        identity = (path or (interface.name if joins_names else name)) if kind == "data" else interface.name
        yield Side(part, call, interface, kind, path, identity, _provides(interface, kind), pointer)


def _interfaces(part: Part) -> Iterator[tuple[Pointer, Runnable | None, Interface]]:
    """Every interface of a component. Parameters are not among them: they stay inside it."""
    for i, call in enumerate(part.component.runnables):
        for j, contract in enumerate(call.contracts or ()):
            at = ("ComponentList", part.number, "functionList", i, "funcContractList", j)
            for key, items in interface_lists(contract):
                if key != "ParameterList":
                    yield from (((*at, key, index), call, item) for index, item in enumerate(items or ()))
    for index, mode in enumerate(part.function.mode_interfaces or ()) if part.is_first else ():
        yield ("ModeInterfaceList", index), None, mode


def _provides(interface: Interface, kind: Kind) -> bool:
    if isinstance(interface, Signal | DataQueue | MethodInterface):
        return interface.role == PROVIDER
    return kind in ("error", "mode out")


def _errors_of_others(own: Sequence[Side]) -> Iterator[Side]:
    """Errors of other components that set an error or a safety reaction of a component, which consumes their status."""
    reported = {side.identity: side for side in reversed(own) if side.kind == "error"}
    seen: set[tuple[str, str]] = set()
    for side in own:
        for name in causes(side.interface):
            other = reported.get(name)
            is_own = other is not None and other.part.name == side.part.name
            if not is_own and (side.part.name, name) not in seen:
                seen.add((side.part.name, name))
                error = other.interface if other else _unknown_error(name)
                path = other.path if other else ""
                yield side._replace(interface=error, kind="error", path=path, identity=name, provides=False)


def _unknown_error(name: str) -> ErrorInterface:
    """An error that no function of the set reports: its status is a number, 0 or 1."""
    return ErrorInterface.model_construct(
        name=name, description="An error that no function of the set reports.", datatype="", dependencies=()
    )
