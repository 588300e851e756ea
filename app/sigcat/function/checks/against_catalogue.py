"""Function JSON against the catalogue: paths, datatypes, units, ranges and defaults that it states itself."""

from collections.abc import Iterable
from fractions import Fraction
from typing import Any

from sigcat import codes
from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.catalogue.model.definition import SIGNALS
from sigcat.catalogue.model.interfaces import category_of, interface_name
from sigcat.function.document.document import Pointer
from sigcat.function.document.problem import Problem, Problems, Subject
from sigcat.function.function_json.conversion import IDENTITY, Linear, as_written, between
from sigcat.function.function_json.datatypes.datatype import EnumerationValue
from sigcat.function.function_json.datatypes.type_list import listed, symbols_of
from sigcat.function.function_json.interfaces.data_interfaces import DataQueue, ParameterInterface, Signal
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.walk import absent, data, modes, parameters, runnables, statuses, subject_of
from sigcat.names import did_you_mean

Item = Signal | DataQueue | ParameterInterface
_AGAIN = "Build the document again, or use the catalogue that it was made with."


def check_against(function: FunctionJson, catalogue: Catalogue) -> Problems:
    """Everything in which the document and the catalogue differ."""
    for pointer, _, item in (*data(function), *parameters(function)):
        if not item.vss_path:
            continue
        node = catalogue.get(item.vss_path)
        if node is not None:
            yield from _item(pointer, item, node, catalogue)
        else:
            yield _unknown(pointer, item, item.vss_path, catalogue)
    for pointer, _, one in absent(function):
        if one.vss_path in catalogue.nodes:
            message = f"{one.vss_path!r} is absent in the document, and the catalogue has it."
            subject = Subject("data", one.name)
            yield Problem(codes.DIFFERS_FROM_CATALOGUE, (*pointer, "VssPath"), message, _AGAIN, subject)
    yield from _interfaces(function, catalogue)


def _unknown(pointer: Pointer, item: Item, path: str, catalogue: Catalogue) -> Problem:
    is_optional = not isinstance(item, ParameterInterface) and item.is_optional
    rule = codes.OPTIONAL_SIGNAL_ABSENT if is_optional else codes.SIGNAL_UNKNOWN
    fix = did_you_mean(path, catalogue.nodes) or (_AGAIN if is_optional else "")
    message = f"The catalogue has no signal {path!r}."
    return Problem(rule, (*pointer, "VssPath"), message, fix, Subject("data", path if is_optional else item.name))


def _item(pointer: Pointer, item: Item, node: Node, catalogue: Catalogue) -> Problems:
    if not node.is_leaf or node.type not in SIGNALS or category_of(node.path) != "data":
        is_interface = node.is_leaf and node.type in SIGNALS
        what = f"the interface {interface_name(node.path)}" if is_interface else f"a {node.type}"
        message = f"{node.path!r} must be a data interface, not {what}."
        yield Problem(codes.SIGNAL_HOLDS_NO_VALUE, (*pointer, "VssPath"), message, subject=Subject("data", item.name))
        return
    if node.values.get("deprecation"):
        message = f"{node.path!r} is deprecated: {node.values['deprecation']}"
        yield Problem(codes.SIGNAL_DEPRECATED, (*pointer, "VssPath"), message, subject=Subject("data", node.path))
    for key, own, known in (
        ("VssDatatype", item.vss_datatype, node.values.get("datatype")),
        ("VssUnit", item.vss_unit, node.values.get("unit")),
        ("VssMin", getattr(item, "vss_min", None), node.values.get("min")),
        ("VssMax", getattr(item, "vss_max", None), node.values.get("max")),
    ):
        if own is not None and own != known:
            yield _stale((*pointer, key), key, own, known, node)
    symbols = symbols_of(node)
    if symbols is None:
        yield from _values(pointer, item, node, catalogue)
    elif item.vss_symbols is not None and {each.symbol: each.value for each in item.vss_symbols} != symbols:
        own, known = _words(item.vss_symbols), _words(listed(symbols))
        yield _stale((*pointer, "VssSymbols"), "VssSymbols", own, known, node)


def _words(symbols: Iterable[EnumerationValue]) -> str:
    """An enumeration as text: `OFF 0, ON 1`."""
    return ", ".join(f"{each.symbol} {each.value}" for each in symbols)


def _stale(pointer: Pointer, key: str, own: Any, known: Any, node: Node) -> Problem:
    message = (
        f"`{key}` of {node.path!r} must be {'left out' if known is None else known}, as in the catalogue, not {own}."
    )
    return Problem(codes.DIFFERS_FROM_CATALOGUE, pointer, message, _AGAIN, Subject("data", node.path))


def _values(pointer: Pointer, item: Item, node: Node, catalogue: Catalogue) -> Problems:
    conversion = _to_code(item, node, catalogue)
    if conversion is None:
        message = f"{node.values.get('unit')!r}, the unit of {node.path!r}, cannot be converted to {item.units!r}."
        yield Problem(codes.UNIT_NOT_CONVERTIBLE, (*pointer, "Units"), message, subject=Subject("data", node.path))
        return
    yield from _outside(pointer, item, node, conversion)
    default, own = as_written(node.values.get("default")), item.default
    if own is not None and default is not None and not _close(Fraction(own), conversion(default)):
        yield _stale((*pointer, "Default"), "Default", own, float(conversion(default)), node)


def _to_code(item: Item, node: Node, catalogue: Catalogue) -> Linear | None:
    """From the catalogue's unit to the document's; None if there is none. An unknown unit is a separate problem."""
    known = catalogue.vocabulary.unit(item.units) if item.units else None
    unit = node.values.get("unit")
    if known is None or not isinstance(unit, str):
        return IDENTITY
    own = catalogue.vocabulary.unit(unit)
    return between(own.key if own else unit, known.key)


def _outside(pointer: Pointer, item: Item, node: Node, conversion: Linear) -> Problems:
    """A range wider than the catalogue's. Parameters have to have limits: those of the datatype count as none."""
    names = ("min", "max") if conversion.factor > 0 else ("max", "min")
    for key, own, name, sign in (("Min", item.min, names[0], 1), ("Max", item.max, names[1], -1)):
        bound = as_written(node.values.get(name))
        if own is None or bound is None:
            continue
        limit = conversion(bound)
        if Fraction(own) * sign < limit * sign and not _close(Fraction(own), limit):
            words = f"{float(limit):.12g} or {'more' if sign > 0 else 'less'}"
            message = f"`{key}` must be {words}, as {node.path!r} in the catalogue, not {own}."
            at, subject = (*pointer, key), Subject("data", node.path)
            yield Problem(codes.RANGE_WIDER_THAN_CATALOGUE, at, message, subject=subject)


def _close(one: Fraction, other: Fraction) -> bool:
    """Whether two numbers differ by no more than the rounding of a double."""
    return abs(one - other) <= max(abs(one), abs(other)) * Fraction(1, 10**12)


# -- errors, safety reactions, modes and calls --------------------------------------------------------------------


def _interfaces(function: FunctionJson, catalogue: Catalogue) -> Problems:
    for pointer, _, call in runnables(function):
        yield from _interface(pointer, Subject("scheduling", call.name), call.vss_path, catalogue)
    for pointer, _, status in statuses(function):
        yield from _interface(pointer, subject_of(status), status.vss_path, catalogue)
    for pointer, mode in modes(function):
        yield from _interface(pointer, subject_of(mode), mode.vss_path, catalogue)


def _interface(pointer: Pointer, subject: Subject, path: str | None, catalogue: Catalogue) -> Problems:
    if not path:
        return
    words = f"{subject.kind.replace('_', ' ')} interface"
    if catalogue.get(path) is None:
        near = did_you_mean(path, (each for each in catalogue.nodes if category_of(each) == subject.kind))
        message = f"The catalogue has no {words} {path!r}."
        yield Problem(codes.INTERFACE_UNKNOWN, (*pointer, "VssPath"), message, near, subject)
    elif category_of(path) != subject.kind:
        message = f"{path!r} must be {'an' if words[0] in 'aeiou' else 'a'} {words}."
        yield Problem(codes.INTERFACE_OF_ANOTHER_CATEGORY, (*pointer, "VssPath"), message, subject=subject)
    elif interface_name(path) != subject.name:
        message = f"`Name` must be {interface_name(path)!r}, as its path says, not {subject.name!r}."
        yield Problem(codes.DIFFERS_FROM_CATALOGUE, (*pointer, "Name"), message, subject=subject)
