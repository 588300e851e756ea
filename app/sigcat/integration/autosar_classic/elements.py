"""Exchanged elements of a set: each signal, status, mode and method once, with every side of it."""

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Literal, NamedTuple

from sigcat import codes
from sigcat.function.function_json.data_interfaces import DataQueue, Signal
from sigcat.function.function_json.methods import MethodInterface
from sigcat.function.function_json.role import PROVIDER
from sigcat.function.function_json.status_interfaces import ErrorInterface, ModeInterface, SafetyReaction
from sigcat.integration.application import Part
from sigcat.integration.autosar_classic.context import OF_BASE_SOFTWARE, Context
from sigcat.integration.autosar_names import distinct, event_name, short_name
from sigcat.integration.autosar_parts import Interface, Item, items
from sigcat.integration.finding_collector import Subject

ElementKind = Literal["data", "method", "error", "reaction", "mode in", "mode out"]
_OF_CLASS: dict[type, ElementKind] = {
    Signal: "data", DataQueue: "data", MethodInterface: "method", ErrorInterface: "error", SafetyReaction: "reaction",
}  # fmt: skip


class Side(NamedTuple):
    """One use of an element: by a call, or by a component."""

    item: Item
    provides: bool

    @property
    def part(self) -> Part:
        """The component."""
        return self.item.part

    @property
    def interface(self) -> Interface:
        """The interface of the function."""
        return self.item.interface


class Element(NamedTuple):
    """Something that is exchanged, and its sides."""

    name: str
    """Name of its interface and of its ports."""
    leaf: str
    """Name of the data element, operation or mode within the interface."""
    identity: str
    kind: ElementKind
    sides: tuple[Side, ...]

    @property
    def leading(self) -> Side:
        """The side that says what is sent: the provider, or the first consumer."""
        return next((side for side in self.sides if side.provides), self.sides[0])

    @property
    def is_queued(self) -> bool:
        """Whether one of its sides queues values: then all have to."""
        return any(isinstance(side.interface, DataQueue) for side in self.sides)

    def of(self, part: Part) -> tuple[Side, ...]:
        """The sides of a component."""
        return tuple(side for side in self.sides if side.part.name == part.name)


def elements_of(context: Context) -> tuple[Element, ...]:
    """Every element of the set, by name."""
    found: defaultdict[tuple[ElementKind, str], list[Side]] = defaultdict(list)
    all_items = list(items(context.parts))
    for item in all_items:
        kind = kind_of(item.interface)
        found[kind, _identity(item, context)].append(Side(item, _provides(item, kind)))
    for item, name in _foreign(all_items):
        found["error", name].append(Side(item, provides=False))
    wanted = {f"{kind} {identity}": _wanted(sides[0], identity, context) for (kind, identity), sides in found.items()}
    names = distinct(wanted, (*OF_BASE_SOFTWARE, *(f"{part.name}_Parameters" for part in context.parts)))
    for (kind, identity), sides in found.items():
        _report_renamed(names[f"{kind} {identity}"], wanted[f"{kind} {identity}"], sides[0], context)
        _report_providers(identity, sides, context)
    made = [
        Element(names[f"{kind} {identity}"], _leaf(kind, identity, sides[0]), identity, kind, tuple(sides))
        for (kind, identity), sides in found.items()
    ]
    return tuple(sorted(made, key=lambda element: element.name))


def by_part(elements: Iterable[Element]) -> Mapping[str, tuple[Element, ...]]:
    """The elements of each component, by its name."""
    found: defaultdict[str, dict[str, Element]] = defaultdict(dict)
    for element in elements:
        for side in element.sides:
            found[side.part.name][element.name] = element
    return defaultdict(tuple, {name: tuple(listed.values()) for name, listed in found.items()})


def kind_of(interface: Interface) -> ElementKind:
    """Return the kind of an interface for the RTE."""
    if isinstance(interface, ModeInterface):
        return "mode out" if interface.direction == "Out" else "mode in"
    return _OF_CLASS[type(interface)]


def _identity(item: Item, context: Context) -> str:
    interface = item.interface
    return context.identity_of(item.part, interface) if isinstance(interface, Signal | DataQueue) else interface.name


def _provides(item: Item, kind: ElementKind) -> bool:
    interface = item.interface
    if isinstance(interface, Signal | DataQueue | MethodInterface):
        return interface.role == PROVIDER
    return kind in ("error", "mode out")


def _foreign(all_items: Sequence[Item]) -> Iterator[tuple[Item, str]]:
    """Errors of other components that set an error or a safety reaction of a component: it requires their status."""
    reported = {item.interface.name: item for item in reversed(all_items) if isinstance(item.interface, ErrorInterface)}
    seen: set[tuple[str, str]] = set()
    for item in all_items:
        for name in causes(item.interface):
            other = reported.get(name)
            is_own = other is not None and other.part.name == item.part.name
            if not is_own and (item.part.name, name) not in seen:
                seen.add((item.part.name, name))
                yield Item(item.part, item.call, other.interface if other else _unknown_error(name)), name


def _unknown_error(name: str) -> ErrorInterface:
    """An error that no function of the set reports: its status is a number, 0 or 1."""
    return ErrorInterface.model_construct(
        name=name, description="An error that no function of the set reports.", datatype="", dependencies=()
    )


def causes(interface: Interface) -> tuple[str, ...]:
    """Names of the errors that set an error or a safety reaction."""
    if isinstance(interface, SafetyReaction):
        return interface.errors
    return interface.dependencies if isinstance(interface, ErrorInterface) else ()


def _wanted(side: Side, identity: str, context: Context) -> str:
    interface = side.interface
    has_path = isinstance(interface, Signal | DataQueue) and context.path_of(side.part, interface)
    return event_name(identity) if has_path else short_name(identity)


def _leaf(kind: ElementKind, identity: str, side: Side) -> str:
    if kind == "data":
        return short_name(identity.rpartition(".")[2])
    if kind == "method":
        return short_name(side.interface.name)
    return "Mode" if kind.startswith("mode") else "Status"


def _report_renamed(name: str, wanted: str, side: Side, context: Context) -> None:
    if name != wanted:
        message = f"{wanted} is the name of another interface or port too: short names have no dots, and case does not count. This one is {name}."
        context.findings.report(codes.NAME_TAKEN_CLASSIC, message, Subject(wanted, side.interface))


def _report_providers(identity: str, sides: Iterable[Side], context: Context) -> None:
    providers = [side for side in sides if side.provides]
    names = list(dict.fromkeys(side.part.name for side in providers))
    if len(names) > 1:
        subject = Subject(identity, providers[1].interface)
        message = f"{identity} must have one provider, not {', '.join(names)}. Consumers are connected to {names[0]}."
        context.findings.report(codes.SEVERAL_WRITERS, message, subject, "Let only one of them provide it.", key="Role")
