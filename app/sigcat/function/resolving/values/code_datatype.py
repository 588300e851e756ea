"""The datatype in which the code holds a value, and the numbers of an enumeration."""

from collections.abc import Mapping

from sigcat import codes
from sigcat.catalogue.model.catalogue import Node
from sigcat.catalogue.model.datatypes import DATATYPES, INTEGER_RANGES, element_of, is_array
from sigcat.function.document.document import Pointer
from sigcat.function.document.problem import Problem, Problems, Subject
from sigcat.function.function_json.datatypes.primitive_types import BY_VSS
from sigcat.function.function_json.datatypes.type_list import Symbols, smallest_integer, symbols_of
from sigcat.function.resolving.context import Context
from sigcat.function.resolving.values.code_value import Item
from sigcat.names import did_you_mean


def code_symbols(item: Item, at: Pointer, node: Node, context: Context) -> Symbols | None:
    """Names and numbers of an enumeration, as the code has them."""
    symbols = symbols_of(node)
    if item.values is None:
        return symbols
    if symbols is None:
        message = f"{item.path!r} must be an enumeration to have `values`: the catalogue allows no named values."
        context.report(codes.ENUMERATION_MISCODED, (*at, "values"), message, "Remove `values`.")
        return None
    miscoded = tuple(_miscoded(item.values, symbols, (*at, "values")))
    context.problems.extend(miscoded)
    return symbols if miscoded else item.values


def _miscoded(values: Mapping[str, int], symbols: Symbols, at: Pointer) -> Problems:
    missing = [name for name in symbols if name not in values]
    if missing:
        message, fix = f"`values` must have {', '.join(map(repr, missing))}.", "Give each allowed value a number."
        yield Problem(codes.ENUMERATION_MISCODED, at, message, fix)
    for name in values:
        if name not in symbols:
            fix = did_you_mean(name, symbols) or f"Use one of {', '.join(symbols)}."
            yield Problem(codes.ENUMERATION_MISCODED, (*at, name), f"The catalogue does not allow {name!r}.", fix)
    if len(set(values.values())) < len(values):
        fix = "Give each value its own number."
        yield Problem(codes.ENUMERATION_MISCODED, at, "Two values have the same number.", fix)


def code_datatype(item: Item, at: Pointer, node: Node, symbols: Symbols | None, context: Context) -> str | None:
    """VSS datatype in which the code holds the value."""
    own, wanted = str(node.values["datatype"]), item.datatype
    if wanted is None or wanted == own:
        return _stored(own, symbols)
    message, fix = _other_datatype(own, wanted, symbols)
    if message:
        context.report(codes.DATATYPE_UNFIT, (*at, "datatype"), message, fix, Subject("data", item.path))
        return None
    return wanted


def _stored(own: str, symbols: Symbols | None) -> str:
    """An enumeration of texts is held as the smallest integer that has room for it."""
    if symbols is None or element_of(own) != "string":
        return own
    return smallest_integer(symbols) + ("[]" if is_array(own) else "")


def _other_datatype(own: str, wanted: str, symbols: Symbols | None) -> tuple[str, str]:
    """Why the code cannot hold a value of the catalogue in a datatype, and what to do; empty if it can."""
    if element_of(wanted) not in BY_VSS:
        return f"Unknown datatype {wanted!r}.", did_you_mean(wanted, BY_VSS)
    if own not in DATATYPES:
        return f"`datatype` must be the struct {own}, not {wanted}.", "Remove `datatype`."
    holds_numbers = element_of(own) != "string" or symbols is not None
    if is_array(own) != is_array(wanted) or holds_numbers == (element_of(wanted) == "string"):
        held = f"{element_of(wanted)}{'[]' if is_array(own) else ''}"
        fits = is_array(own) != is_array(wanted) and holds_numbers != (element_of(wanted) == "string")
        fix = f"Write `{held}`, or remove `datatype`." if fits else "Remove `datatype`."
        return f"`datatype` must hold {own}, which the catalogue has; {wanted} cannot.", fix
    if symbols is not None and element_of(wanted) not in INTEGER_RANGES:
        return f"`datatype` of an enumeration must be an integer, not {wanted}.", ""
    return "", ""
