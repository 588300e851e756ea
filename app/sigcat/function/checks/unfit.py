"""Strings of a function that the types of their fields refuse: what generators would refuse is found here."""

from collections.abc import Iterator

from sigcat import codes
from sigcat.function.document.document import Pointer
from sigcat.function.document.field_types import C_EXPRESSION
from sigcat.function.document.problem import Problem
from sigcat.function.document.unfit_texts import titled, unfit_texts
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.resolved_function import Origin


def check_texts(function: FunctionJson, origin: Origin | None = None) -> Iterator[Problem]:
    """Every string that is not of the type of its field, which is called as it is in the declaration at `origin`."""

    def name(pointer: Pointer) -> str:
        return titled((origin and origin.exactly(pointer)) or pointer)

    for each in unfit_texts(function, accessors_of(function), name):
        rule = codes.VARIABLE_NO_EXPRESSION if each.grammar is C_EXPRESSION else codes.TEXT_OF_WRONG_TYPE
        yield Problem(rule, each.pointer, each.message, each.fix)


def accessors_of(function: FunctionJson) -> tuple[str, ...]:
    """The functions that expressions of a function may call."""
    return (function.code.accessors or ()) if function.code else ()
