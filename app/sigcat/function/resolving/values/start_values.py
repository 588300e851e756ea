"""The value of a signal before the first one arrives, and the default that replaces a missing one."""

from fractions import Fraction
from typing import Any

from sigcat import codes
from sigcat.catalogue.model.datatypes import DATATYPES, element_of, is_array
from sigcat.catalogue.reading.yaml_scalars import number_advice
from sigcat.function.declaration.declaration import DataItem
from sigcat.function.document.problem import Problem, Problems, Subject
from sigcat.function.document.yaml_words import in_yaml
from sigcat.function.function_json.conversion import as_number, as_written, is_outside
from sigcat.function.function_json.datatypes.type_list import Symbols
from sigcat.function.resolving.context import Context
from sigcat.function.resolving.values.code_value import CodeValue
from sigcat.function.resolving.values.numbers import optional_number


def start_value(code: CodeValue, low: Fraction | None, high: Fraction | None, context: Context) -> float | None:
    """The start value as a number; the range is checked with the result."""
    given = code.item.init
    context.problems.extend(_not_carried(code))
    context.problems.extend(_boolean_default(code))
    if given is None or _is_unheld(code, given):
        return default_of(code)
    is_boolean = _is_boolean(code)
    is_unfit = (isinstance(given, bool) and not is_boolean) or code.own_datatype not in DATATYPES
    number = None if is_unfit else _number(given, code.symbols)
    is_between = number is not None and not is_outside(number, low, high)
    if number is None or (is_between and code.symbols and number not in code.symbols.values()):
        message = f"`init` of {code.item.path!r} must be {_wanted(code, is_boolean=is_boolean)}, not {in_yaml(given)}."
        advice = number_advice(given) if isinstance(given, str) else ""
        fix = "Write one of these." if code.symbols or is_boolean else advice
        context.problems.append(code.problem(codes.START_VALUE_OUT_OF_RANGE, (*code.at, "init"), message, fix))
    return optional_number(number)


def _is_boolean(code: CodeValue) -> bool:
    return element_of(code.own_datatype) == "boolean"


def _boolean_default(code: CodeValue) -> Problems:
    """Trees in use have true and false as defaults of numbers; they are read as 1 and 0."""
    default = code.node.values.get("default")
    if isinstance(default, bool) and not _is_boolean(code):
        wanted = _wanted(code, is_boolean=False)
        message = f"The default of {code.item.path!r} must be {wanted}, not {in_yaml(default)}."
        fix, subject = "Change the default in the catalogue.", Subject("data", code.node.path, ("default",))
        yield Problem(codes.START_VALUE_OUT_OF_RANGE, code.at, message, fix, subject)


def _wanted(code: CodeValue, *, is_boolean: bool) -> str:
    if is_array(code.own_datatype) and not code.symbols:
        return "a list, or a number for all elements"
    if code.own_datatype not in DATATYPES:
        return "a mapping of members"
    if code.symbols:
        return f"one of {', '.join(code.symbols)}"
    return "true or false" if is_boolean else "a number"


def _not_carried(code: CodeValue) -> Problems:
    """Function JSON has no text as the start value of a signal; a parameter's default it has in any form."""
    default = code.node.values.get("default") if isinstance(code.item, DataItem) else None
    given = default if code.item.init is None else code.item.init
    if isinstance(given, str) and _is_unheld(code, given):
        message = f"Function JSON cannot have the text {in_yaml(given)} as the start value of {code.item.path!r}."
        yield code.problem(codes.START_VALUE_NOT_CARRIED, code.first_written("init"), message, "Set it in the code.")


def _is_unheld(code: CodeValue, given: Any) -> bool:
    """Whether this is rightly not a number: a text, the elements of an array, the members of a struct."""
    if is_array(code.own_datatype):
        return isinstance(given, list)
    if code.own_datatype not in DATATYPES:
        return isinstance(given, dict)
    return isinstance(given, str) and code.own_datatype == "string" and code.symbols is None


def default_of(code: CodeValue) -> float | None:
    """The catalogue's default, in the code's unit."""
    number = _number(code.node.values.get("default"), code.symbols)
    if number is None or code.symbols:
        return optional_number(number)
    return as_number(code.to_code(number))


def _number(value: Any, symbols: Symbols | None) -> Fraction | None:
    if isinstance(value, str) and symbols is not None:
        return Fraction(symbols[value]) if value in symbols else None
    return as_written(value)
