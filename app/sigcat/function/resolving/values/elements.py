"""Values of arrays and structs, as Function JSON has them: JSON, in the code's unit, enumerations by their numbers."""

import json
import math
from collections.abc import Callable
from fractions import Fraction
from typing import Any

from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.catalogue.model.datatypes import DATATYPES
from sigcat.function.function_json.conversion import IDENTITY, Linear, as_number
from sigcat.function.function_json.datatypes.datatype import Datatype
from sigcat.function.resolving.values.code_value import CodeValue

TypeOf = Callable[[str], Datatype | None]
"""The datatype of a reference."""


def init_elements(code: CodeValue, reference: str, type_of: TypeOf, default: str | None) -> str | None:
    """The start value of an array or struct, as its author wrote it; else the default."""
    given, datatype = code.item.init, type_of(reference)
    if (
        datatype is not None
        and datatype.kind == "array"
        and default is not None
        and isinstance(given, int | float | str)
    ):
        given = [given] * (datatype.length or 1)  # beside a default, one number for all elements would not be seen
    if datatype is None or not isinstance(given, {"array": list, "struct": dict}.get(datatype.kind or "", ())):
        return default if given is None else None
    return _text(_in_code(given, reference, type_of))


def default_elements(code: CodeValue, reference: str, type_of: TypeOf, catalogue: Catalogue) -> str | None:
    """The default of an array or struct, as the catalogue has it; of a struct that has none, the defaults of its members."""
    default = _default(code.node, catalogue, ())
    has_elements = isinstance(default, list | dict)
    return _text(_in_code(converted(default, code.to_code), reference, type_of)) if has_elements else None


def converted(value: Any, to_code: Linear) -> Any:
    """Elements of an array, in the code's unit. A struct has the units of the catalogue in the code, too."""
    if isinstance(value, list):
        return [converted(each, to_code) for each in value]
    is_number = isinstance(value, int | float) and not isinstance(value, bool)
    return as_number(to_code(Fraction(str(value)))) if is_number and to_code != IDENTITY else value


def _default(node: Node, catalogue: Catalogue, around: tuple[str, ...]) -> Any:
    """The default of a value; of a struct without one, those of its members. A struct that holds itself has none."""
    datatype = str(node.values.get("datatype"))
    if "default" in node.values or datatype in DATATYPES or datatype in around:
        return node.values.get("default")
    struct = catalogue.get(datatype)
    members = {each.name: _default(each, catalogue, (*around, datatype)) for each in struct.children} if struct else {}
    return members if members and None not in members.values() else None


def _in_code(value: Any, reference: str, type_of: TypeOf) -> Any:
    """A value with numbers in place of the names of enumerations. What does not fit the datatype is left as it is."""
    datatype = type_of(reference)
    if datatype is not None and isinstance(value, list) and datatype.kind == "array":
        return [_in_code(each, datatype.element or "", type_of) for each in value]
    if datatype is not None and isinstance(value, dict):
        references = {field.name: field.datatype for field in datatype.fields or ()}
        return {str(name): _in_code(each, references.get(str(name), ""), type_of) for name, each in value.items()}
    numbers = {each.symbol: each.value for each in (datatype.symbols or ())} if datatype else {}
    return numbers.get(value, value) if isinstance(value, str) else value


def _text(value: Any) -> str:
    return json.dumps(_plain(value), ensure_ascii=False, default=str)


def _plain(value: Any) -> Any:
    """JSON has no infinity and no NaN: as texts they are found to be no numbers."""
    if isinstance(value, list):
        return [_plain(each) for each in value]
    if isinstance(value, dict):
        return {str(name): _plain(each) for name, each in value.items()}
    return str(value) if isinstance(value, float) and not math.isfinite(value) else value
