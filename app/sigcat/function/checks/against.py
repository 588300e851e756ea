"""Function JSON against the catalogue: paths, datatypes, units, ranges and defaults that it states itself."""

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.catalogue.model.interfaces import Category, category_of, interface_name
from sigcat.function.document.document import Pointer
from sigcat.function.document.hints import Hints
from sigcat.function.document.problem import Problem
from sigcat.function.function_json.conversion import IDENTITY, Linear, between
from sigcat.function.function_json.model import DataQueue, FunctionJson, Parameter, Signal
from sigcat.function.function_json.types import symbols_of
from sigcat.function.function_json.walk import contracts, data, parameters, runnables

Problems = Iterator[Problem]
Item = Signal | DataQueue | Parameter


def check_against(function: FunctionJson, catalogue: Catalogue) -> Problems:
    """Everything in which the document and the catalogue differ."""
    hint = Hints()
    for pointer, _, item in (*data(function), *parameters(function)):
        if not item.vss_path:
            continue
        node = catalogue.get(item.vss_path)
        if node is not None:
            yield from _item(pointer, item, node, catalogue)
            continue
        message = f"The catalogue has no signal {item.vss_path!r}."
        yield Problem("F010", (*pointer, "VssPath"), message, hint(item.vss_path, catalogue.nodes), item.name)
    yield from _interfaces(function, catalogue)


def _item(pointer: Pointer, item: Item, node: Node, catalogue: Catalogue) -> Problems:
    if not node.is_leaf or category_of(node.path) != "data":
        what = f"a {node.type}" if not node.is_leaf else f"the interface {interface_name(node.path)}"
        yield Problem("F011", (*pointer, "VssPath"), f"{node.path!r} is {what}, not data.", path=item.name)
        return
    if node.values.get("deprecation"):
        message = f"{node.path!r} is deprecated: {node.values['deprecation']}"
        yield Problem("F012", (*pointer, "VssPath"), message, path=node.path)
    for key, own, known in (
        ("VssDatatype", item.vss_datatype, node.values.get("datatype")),
        ("VssUnit", item.vss_unit, node.values.get("unit")),
    ):
        if own is not None and own != known:
            yield _stale((*pointer, key), key, own, known, node)
    if symbols_of(node) is None:
        yield from _values(pointer, item, node, catalogue)


def _stale(pointer: Pointer, key: str, own: Any, known: Any, node: Node) -> Problem:
    message = f"`{key}` is {own}, and the catalogue says {'nothing' if known is None else known} of {node.path!r}."
    return Problem(
        "F016", pointer, message, "Build the document again, or use the catalogue that it was made with.", node.path
    )


def _values(pointer: Pointer, item: Item, node: Node, catalogue: Catalogue) -> Problems:
    conversion = _to_code(item, node, catalogue)
    if conversion is None:
        message = f"{item.units!r} cannot be converted to {node.values.get('unit')!r}, the unit of {node.path!r}."
        yield Problem("F021", (*pointer, "Units"), message, path=node.path)
        return
    yield from _outside(pointer, item, node, conversion)
    default, own = _number(node.values.get("default")), item.default if not isinstance(item, DataQueue) else None
    if own is not None and default is not None and not _close(Fraction(own), conversion(default)):
        yield _stale((*pointer, "Default"), "Default", own, float(conversion(default)), node)


def _to_code(item: Item, node: Node, catalogue: Catalogue) -> Linear | None:
    """From the catalogue's unit to the document's; None if there is no way. An unknown unit is told elsewhere."""
    known = catalogue.vocabulary.unit(item.units) if item.units else None
    unit = node.values.get("unit")
    if known is None or not isinstance(unit, str):
        return IDENTITY
    own = catalogue.vocabulary.unit(unit)
    return between(own.key if own else unit, known.key)


def _outside(pointer: Pointer, item: Item, node: Node, conversion: Linear) -> Problems:
    """A range wider than the catalogue's. Parameters have to have limits: those of the datatype stand for none."""
    names = ("min", "max") if conversion.factor > 0 else ("max", "min")
    for key, own, name, sign in (("Min", item.min, names[0], 1), ("Max", item.max, names[1], -1)):
        bound = _number(node.values.get(name))
        if own is None or bound is None:
            continue
        limit = conversion(bound)
        if Fraction(own) * sign < limit * sign and not _close(Fraction(own), limit):
            message = f"`{key}` {own} lies outside the range of {node.path!r}, which ends at {float(limit):.12g}."
            yield Problem("F022", (*pointer, key), message, path=node.path)


def _number(value: object) -> Fraction | None:
    """A number as it is written: 0.1 is a tenth."""
    if isinstance(value, bool):
        return Fraction(int(value))
    try:
        return Fraction(repr(value)) if isinstance(value, int | float) else None
    except ValueError:  # not a finite number
        return None


def _close(one: Fraction, other: Fraction) -> bool:
    """Whether two numbers differ by no more than the rounding of a double."""
    return abs(one - other) <= max(abs(one), abs(other)) * Fraction(1, 10**12)


# -- errors, safety reactions, modes and calls --------------------------------------------------------------------


def _interfaces(function: FunctionJson, catalogue: Catalogue) -> Problems:
    hint = Hints()
    for pointer, name, path, category in _named(function):
        if not path:
            continue
        words = category.replace("_", " ")
        if catalogue.get(path) is None:
            near = hint(path, [p for p in catalogue.nodes if category_of(p) == category])
            message = f"The catalogue has no {words} interface {path!r}."
            yield Problem("F013", (*pointer, "VssPath"), message, near, name)
        elif category_of(path) != category:
            yield Problem("F014", (*pointer, "VssPath"), f"{path!r} is not a {words} interface.", path=name)
        elif interface_name(path) != name:
            message = f"`Name` is {name!r}, and the interface at {path!r} is {interface_name(path)!r}."
            yield Problem("F016", (*pointer, "Name"), message, path=name)


def _named(function: FunctionJson) -> Iterator[tuple[Pointer, str, str | None, Category]]:
    for pointer, _, call in runnables(function):
        yield pointer, call.name, call.vss_path, "scheduling"
    for pointer, _, contract in contracts(function):
        for i, error in enumerate(contract.errors or ()):
            yield (*pointer, "ErrorList", i), error.name, error.vss_path, "error"
        for i, reaction in enumerate(contract.safety_reactions or ()):
            yield (*pointer, "SafetyReactionList", i), reaction.name, reaction.vss_path, "safety_reaction"
    for i, mode in enumerate(function.mode_interfaces or ()):
        yield ("ModeInterfaceList", i), mode.name, mode.vss_path, "mode"
