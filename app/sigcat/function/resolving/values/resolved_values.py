"""Data and parameters: from a path and what the author adds, to datatype, unit, range and start values."""

from fractions import Fraction
from typing import NamedTuple

from sigcat.catalogue.model.catalogue import Node
from sigcat.function.declaration.declaration import DataItem
from sigcat.function.document.document import Pointer
from sigcat.function.function_json.conversion import IDENTITY, Linear
from sigcat.function.function_json.datatypes.type_list import Symbols, symbols_of
from sigcat.function.resolving.absent import absent_node, is_absent
from sigcat.function.resolving.context import Context
from sigcat.function.resolving.data_nodes import data_node, data_of
from sigcat.function.resolving.values.code_datatype import code_datatype, code_symbols
from sigcat.function.resolving.values.code_unit import code_unit, scale_of
from sigcat.function.resolving.values.code_value import CodeValue, Item
from sigcat.function.resolving.values.elements import default_elements, init_elements
from sigcat.function.resolving.values.numbers import optional_number
from sigcat.function.resolving.values.ranges import is_upside_down, range_of
from sigcat.function.resolving.values.start_values import default_of, start_value


class Value(NamedTuple):
    """A data interface, resolved. Numbers are physical values in `unit`."""

    node: Node
    reference: str
    unit: str | None
    min: float | None
    max: float | None
    default: float | None
    init: float | None
    default_elements: str | None
    """As JSON, where the value is an array or a struct; and the same of the start value."""
    init_elements: str | None
    conversion: Linear | None
    """From the code's unit to the catalogue's; None where they are the same."""
    own_symbols: Symbols | None
    """Names and numbers of an enumeration in the catalogue; None where the code has the same."""


def value_of(item: Item, at: Pointer, context: Context) -> Value | None:
    """Everything that the catalogue knows about an item, as the code wants it; None, with problems, if unusable."""
    code = _code_value(item, at, context)
    if code is None:
        return None
    if not code.has_fit_unit:  # its numbers cannot be compared with those of the catalogue
        return _value(code, None, None, None, context)
    low, high = range_of(code, context)
    init = start_value(code, *((None, None) if is_upside_down(low, high) else (low, high)), context)
    return _value(code, low, high, init, context)


def _code_value(item: Item, at: Pointer, context: Context) -> CodeValue | None:
    node = _node(item, at, context)
    if node is None:
        return None
    symbols = code_symbols(item, at, node, context)
    datatype = code_datatype(item, at, node, symbols, context)
    if datatype is None:
        return None
    unit, to_code, is_fit = code_unit(item, at, node, context)
    return CodeValue(item, at, node, datatype, unit, symbols, to_code, scale_of(item, at, context), is_fit)


def _node(item: Item, at: Pointer, context: Context) -> Node | None:
    if not isinstance(item, DataItem) or not is_absent(item, context):
        return data_node(item.path, (*at, "path"), context)
    node = absent_node(item, at, context)
    return data_of(node, (*at, "path"), context) if node is not None else None


def _value(code: CodeValue, low: Fraction | None, high: Fraction | None, init: float | None, context: Context) -> Value:
    node = code.node
    reference = context.types.reference(code.datatype, node.template, code.symbols, node.values.get("arraysize"))
    conversion = None if code.to_code == IDENTITY else code.to_code.inverse
    ends = optional_number(low), optional_number(high)
    symbols = symbols_of(node)
    own_symbols = None if symbols == code.symbols else symbols
    default = default_elements(code, reference, context.types.get, context.catalogue)
    elements = default, init_elements(code, reference, context.types.get, default)
    return Value(node, reference, code.unit, *ends, default_of(code), init, *elements, conversion, own_symbols)
