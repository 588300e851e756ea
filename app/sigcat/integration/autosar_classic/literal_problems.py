"""What is wrong with enumerations and ranges: names and numbers that stand twice, limits that nothing is between."""

from collections.abc import Iterator

from sigcat.function.document.document import Pointer
from sigcat.integration.autosar_classic.model import ClassicIntegration, CompuMethod
from sigcat.integration.autosar_classic.problem import identifier
from sigcat.integration.checked_document import Problem


def literal_problems(model: ClassicIntegration) -> Iterator[Problem]:
    """Names and numbers of each enumeration, and the limits of each range."""
    for index, method in enumerate(model.compu_methods):
        yield from _literals(method, ("CompuMethods", index, "Symbols"))
    for index, constraint in enumerate(model.constraints):
        if constraint.min is not None and constraint.max is not None and constraint.min > constraint.max:
            message = f"Min must be {constraint.max} or less, as Max is, not {constraint.min}."
            yield Problem(("DataConstraints", index, "Min"), message, "Correct one of the two.")


def _literals(method: CompuMethod, at: Pointer) -> Iterator[Problem]:
    by_name: dict[str, int] = {}
    by_number: dict[int, str] = {}
    if method.category == "TEXTTABLE" and not method.symbols:
        yield Problem(at[:-1], f"Enumeration {method.name} must have a value.", "Add `Symbols`.")
    for index, each in enumerate(method.symbols or ()):
        yield from identifier((*at, index, "Symbol"), each.symbol)
        if by_name.setdefault(each.symbol, index) != index:
            message = f"{each.symbol} must be the name of one value of {method.name}, and is that of two."
            yield Problem((*at, index, "Symbol"), message, "Rename one.")
        if by_number.setdefault(each.value, each.symbol) != each.symbol:
            message = f"{each.value} must be the number of one value of {method.name}, and is that of {by_number[each.value]} too."
            yield Problem((*at, index, "Value"), message, "Take another number.")
