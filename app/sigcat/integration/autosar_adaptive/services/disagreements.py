"""Differences between the sides of an event about the sent values."""

from collections.abc import Iterable

from sigcat import codes
from sigcat.function.exchange import Side
from sigcat.integration.autosar_adaptive.context import Context
from sigcat.integration.autosar_adaptive.services.elements import Element, Service
from sigcat.integration.autosar_adaptive.types import TypeTable
from sigcat.integration.finding_collector import Subject


def report_disagreements(all_services: Iterable[Service], types: TypeTable, context: Context) -> None:
    """Report where the sides of an event differ in what they take to be sent."""
    for service in all_services:
        for element in service.elements:
            if element.is_event:
                _compare(element, types, context)


def _compare(element: Element, types: TypeTable, context: Context) -> None:
    leading = element.leading
    wanted = _sent_as(leading, types)
    for side in element.sides:
        found = _sent_as(side, types)
        if found != wanted and not (found[1] == wanted[1] and _same_names(found[0], wanted[0], types)):
            message = (
                f"{element.identity}: {side.where} takes it as {found[0]} in {found[1] or 'no unit'}, "
                f"{leading.where} as {wanted[0]} in {wanted[1] or 'no unit'}, as it is sent."
            )
            subject = Subject(element.identity, side.interface)
            context.findings.report(
                codes.MEANINGS_DIFFER_ADAPTIVE, message, subject, "Build both from the same catalogue."
            )


def _same_names(one: str, other: str, types: TypeTable) -> bool:
    """Whether both are the same enumeration with other numbers, which each side converts by name."""
    names = [{item.symbol for item in types.symbols_sent(word)} for word in (one, other)]
    return bool(names[0]) and names[0] == names[1]


def _sent_as(side: Side, types: TypeTable) -> tuple[str, str]:
    word = types.on_the_wire(side.part.function, side.data.datatype, side.data.vss_datatype)
    return word, (side.data.vss_unit or side.data.units or "")
