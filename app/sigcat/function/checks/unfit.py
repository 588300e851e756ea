"""Strings of a function that the types of their fields refuse: what generators would refuse is found here."""

from collections.abc import Iterator

from sigcat import codes
from sigcat.function.document.field_types import C_EXPRESSION
from sigcat.function.document.problem import Problem
from sigcat.function.document.unfit_texts import unfit_texts
from sigcat.function.function_json.model import FunctionJson


def check_texts(function: FunctionJson) -> Iterator[Problem]:
    """Every string that is not of the type of its field."""
    for each in unfit_texts(function, accessors_of(function)):
        rule = codes.VARIABLE_NO_EXPRESSION if each.grammar is C_EXPRESSION else codes.TEXT_OF_WRONG_TYPE
        yield Problem(rule, each.pointer, each.message, each.fix)


def accessors_of(function: FunctionJson) -> tuple[str, ...]:
    """The functions that expressions of a function may call."""
    return (function.code.accessors or ()) if function.code else ()
