"""Elements of the exchange under the names of their interfaces and ports."""

from collections import defaultdict
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from sigcat import codes
from sigcat.function.exchange import Element as Exchanged
from sigcat.function.exchange import Part, Side
from sigcat.integration.autosar_classic.context import OF_BASE_SOFTWARE, Context
from sigcat.integration.autosar_names import distinct, event_name, short_name
from sigcat.integration.autosar_parts import several_providers
from sigcat.integration.finding_collector import Subject


@dataclass(frozen=True)
class Element(Exchanged):
    """Something that is exchanged, and its sides."""

    name: str
    """Name of its interface and of its ports."""

    @property
    def leaf(self) -> str:
        """Name of the data element, operation or mode within the interface."""
        if self.kind == "data":
            return short_name(self.identity.rpartition(".")[2])
        if self.kind == "method":
            return short_name(self.identity)
        return "Mode" if self.kind.startswith("mode") else "Status"

    def of(self, part: Part) -> tuple[Side, ...]:
        """The sides of a component."""
        return tuple(side for side in self.sides if side.part.name == part.name)


def elements_of(context: Context) -> tuple[Element, ...]:
    """Every element of the set, by name."""
    exchanged = context.exchange.elements.values()
    wanted = {f"{each.kind} {each.identity}": _wanted(each) for each in exchanged}
    names = distinct(wanted, (*OF_BASE_SOFTWARE, *(f"{part.name}_Parameters" for part in context.parts)))
    for each in exchanged:
        _report_renamed(names[f"{each.kind} {each.identity}"], _wanted(each), each.sides[0], context)
        _report_providers(each, context)
    made = (Element(each.kind, each.identity, each.sides, names[f"{each.kind} {each.identity}"]) for each in exchanged)
    return tuple(sorted(made, key=lambda element: element.name))


def by_part(elements: Iterable[Element]) -> Mapping[str, tuple[Element, ...]]:
    """The elements of each component, by its name."""
    found: defaultdict[str, dict[str, Element]] = defaultdict(dict)
    for element in elements:
        for side in element.sides:
            found[side.part.name][element.name] = element
    return defaultdict(tuple, {name: tuple(listed.values()) for name, listed in found.items()})


def _wanted(element: Exchanged) -> str:
    has_path = element.kind == "data" and element.sides[0].path
    return event_name(element.identity) if has_path else short_name(element.identity)


def _report_renamed(name: str, wanted: str, side: Side, context: Context) -> None:
    if name != wanted:
        message = f"{wanted} is the name of another interface or port too: short names have no dots, and case does not count. This one is {name}."
        context.findings.report(codes.NAME_TAKEN_CLASSIC, message, Subject(wanted, side.interface))


def _report_providers(element: Exchanged, context: Context) -> None:
    if len(element.providers) > 1:
        message, fix = several_providers(element.identity, element.providers), "Let only one of them provide it."
        context.findings.report(codes.SEVERAL_WRITERS, message, element.providers[1], fix, key="Role")
