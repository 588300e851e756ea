"""Problems of enumerations and ranges: repeated names and numbers, limits with nothing between them."""

from collections.abc import Iterator

from sigcat.function.document.document import Pointer
from sigcat.integration.autosar_classic.datatypes.used_types import enumerations_of, exchanged_types
from sigcat.integration.autosar_classic.model import ClassicIntegration, CompuMethod
from sigcat.integration.autosar_classic.problems.problem import identifier
from sigcat.integration.problem import Problem


def literal_problems(model: ClassicIntegration) -> Iterator[Problem]:
    """Names and numbers of each enumeration, and the limits of each range."""
    for index, method in enumerate(model.compu_methods):
        yield from _literals(method, ("CompuMethods", index, "Symbols"))
    for index, each in enumerate(model.implementation_types):
        if each.literal_prefix is not None:
            yield from identifier(("ImplementationTypes", index, "LiteralPrefix"), each.literal_prefix)
    yield from _shared(model)
    yield from _names_of_limits(model)
    for index, constraint in enumerate(model.constraints):
        if constraint.min is not None and constraint.max is not None and constraint.min > constraint.max:
            message = f"Min must be {constraint.max} or less, as Max is, not {constraint.min}."
            yield Problem(("DataConstraints", index, "Min"), message, "Correct one of the two.")


def _shared(model: ClassicIntegration) -> Iterator[Problem]:
    """Names that would have two numbers in the code of a component."""
    symbols = {each.name: each.symbols or () for each in model.compu_methods}
    positions = {each.name: index for index, each in enumerate(model.implementation_types)}
    types = {each.name: each for each in model.implementation_types}
    meanings = {each.name: each for each in model.application_types}
    exchanged = exchanged_types(model)
    told: set[tuple[str, str]] = set()
    for component in model.components:
        seen: dict[str, tuple[int, str]] = {}
        for each in enumerations_of(component, exchanged, meanings, types):
            for symbol in symbols.get(each.compu_method or "", ()):
                name = f"{each.literal_prefix or ''}{symbol.symbol}"
                number, other = seen.setdefault(name, (symbol.value, each.name))
                if number != symbol.value and other != each.name and (other, each.name) not in told:
                    told.add((other, each.name))
                    message = f"{name} must be one number in the code of {component.name}: it is {number} of {other}, and {symbol.value} of {each.name}."
                    yield Problem(("ImplementationTypes", positions[each.name]), message, "Give it its own `LiteralPrefix`.")  # fmt: skip


def _names_of_limits(model: ClassicIntegration) -> Iterator[Problem]:
    """The RTE names the limits of a type after it, by macros: nothing else of the code may be called so."""
    ranged = [each.name for each in model.application_types if each.constraint]
    limits = {f"{name}_{side}Limit": name for name in ranged for side in ("Lower", "Upper")}
    symbols = {each.name: each.symbols or () for each in model.compu_methods}
    for index, each in enumerate(model.implementation_types):
        at: Pointer = ("ImplementationTypes", index)
        if each.name in limits:
            message = (
                f"{each.name} must not be the name of a datatype: the RTE calls a limit of {limits[each.name]} so."
            )
            yield Problem((*at, "Name"), message, "Rename the datatype.")
        for symbol in symbols.get(each.compu_method or "", ()):
            if owner := limits.get(f"{each.literal_prefix or ''}{symbol.symbol}"):
                message = f"{symbol.symbol} must not be a value of {each.name}: the RTE calls a limit of {owner} so."
                yield Problem(at, message, "Give it another `LiteralPrefix`.")


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
