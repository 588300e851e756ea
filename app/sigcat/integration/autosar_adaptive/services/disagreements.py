"""Differences between the sides of an event about the sent values."""

from collections.abc import Iterable

from sigcat import codes
from sigcat.function.exchange import Side
from sigcat.integration.autosar_adaptive.context import Context
from sigcat.integration.autosar_adaptive.services.elements import Element, Service


def report_disagreements(all_services: Iterable[Service], context: Context) -> None:
    """Report where the sides of an event differ in what they take to be sent."""
    for service in all_services:
        for element in service.elements:
            if element.is_event:
                _compare(element, context)


def _compare(element: Element, context: Context) -> None:
    leading = element.leading
    wanted = _sent_as(leading, context)
    for side in element.sides:
        found = _sent_as(side, context)
        if found != wanted and not (found[1] == wanted[1] and _same_names(found[0], wanted[0], context)):
            message = (
                f"{element.identity}: {side.where} takes it as {found[0]} in {found[1] or 'no unit'}, "
                f"{leading.where} as {wanted[0]} in {wanted[1] or 'no unit'}, as it is sent."
            )
            fix = "Build both from the same catalogue."
            context.findings.report(codes.MEANINGS_DIFFER_ADAPTIVE, message, side, fix)


def _same_names(one: str, other: str, context: Context) -> bool:
    """Whether both are the same enumeration with other numbers, which each side converts by name."""
    names = [{item.symbol for item in context.types.symbols_sent(word)} for word in (one, other)]
    return bool(names[0]) and names[0] == names[1]


def _sent_as(side: Side, context: Context) -> tuple[str, str]:
    word = context.types.on_the_wire(side.part.function, side.data.datatype, side.data.vss_datatype)
    return word, (side.data.vss_unit or side.data.units or "")
