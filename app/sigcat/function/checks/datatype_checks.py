"""The datatypes of a document."""

from collections.abc import Sequence

from sigcat import codes
from sigcat.function.checks.circles import circles
from sigcat.function.document.document import Pointer
from sigcat.function.document.problem import Problem, Problems
from sigcat.function.function_json.datatypes.datatype import Datatype, EnumerationValue
from sigcat.function.function_json.datatypes.primitive_types import integer_limits
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.walk import references
from sigcat.names import did_you_mean


def check_types(function: FunctionJson) -> Problems:
    """Every datatype that is referred to is defined, and has a different number for each of its names."""
    defined = dict.fromkeys(datatype.reference for datatype in function.datatypes)
    for pointer, reference in references(function):
        if reference not in defined:
            message = f"The datatype must be one of the document's `Datatypes`, not {reference!r}."
            yield Problem(codes.TYPE_UNDEFINED, pointer, message, did_you_mean(reference, defined))
    yield from circular_types(function.datatypes)
    for index, datatype in enumerate(function.datatypes):
        at = ("Datatypes", index, "Symbols")
        yield from _numbers(datatype.symbols or (), integer_limits(datatype.c_definition), datatype.c_definition, at)


def circular_types(datatypes: Sequence[Datatype], *, may_be_lists: bool = True) -> Problems:
    """Yield a problem for each circle of datatypes, at its first one.

    A struct may hold a list of itself, unless `may_be_lists` is false: a core has no list of open length.
    """
    found = circles({each.reference: _parts(each, may_be_lists) for each in datatypes}, "datatype", "Fields")
    reported = set[str]()
    for index, datatype in enumerate(datatypes):
        if datatype.reference in found and datatype.reference not in reported:
            reported |= {each.name for each in found[datatype.reference]}
            message = f"A datatype must not contain itself; {datatype.reference!r} does."
            fix = "Give the member another datatype, such as the number of an entry."
            yield Problem(codes.TYPE_CONTAINS_ITSELF, ("Datatypes", index, "typeRef"), message, fix)


def _parts(datatype: Datatype, may_be_lists: bool) -> list[str]:
    is_open = datatype.length is None and may_be_lists
    elements = [datatype.element] if datatype.element is not None and not is_open else []
    return [*(field.datatype for field in datatype.fields or ()), *elements]


def _numbers(
    symbols: Sequence[EnumerationValue], limits: tuple[int, int] | None, definition: str, at: Pointer
) -> Problems:
    names, numbers = set[str](), set[int]()
    for index, each in enumerate(symbols):
        if limits and not limits[0] <= each.value <= limits[1]:
            message = (
                f"The number of {each.symbol!r} must be {limits[0]} to {limits[1]} for {definition}, not {each.value}."
            )
            yield Problem(codes.ENUMERATION_MISCODED, (*at, index, "Value"), message)
        elif each.value in numbers:
            message = f"The number of {each.symbol!r} must be its own; another name has {each.value}, too."
            yield Problem(codes.ENUMERATION_MISCODED, (*at, index, "Value"), message)
        if each.symbol in names:
            message = f"The name must be given once, not {each.symbol!r} again."
            yield Problem(codes.ENUMERATION_MISCODED, (*at, index, "Symbol"), message, "Remove it.")
        names.add(each.symbol)
        numbers.add(each.value)
