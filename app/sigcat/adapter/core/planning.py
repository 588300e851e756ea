"""Common knowledge of all parts of planning, and the report of obstacles."""

from collections.abc import Mapping
from typing import NamedTuple

from sigcat import codes
from sigcat.adapter.core.numbers import DOUBLE, NumberType
from sigcat.findings import RuleCode
from sigcat.function.document.document import Pointer
from sigcat.function.document.expression import may_hold_value
from sigcat.function.document.problem import Problem, Subject
from sigcat.function.function_json.datatypes.datatype import Datatype
from sigcat.function.function_json.duration import LONGEST_MILLISECONDS, milliseconds, whole_nanoseconds
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.runnable import Runnable


class Context(NamedTuple):
    """The function, and its datatypes by their references."""

    function: FunctionJson
    datatypes: Mapping[str, Datatype]
    problems: list[Problem]
    """Obstacles, in the order in which they are reported."""
    arithmetic: NumberType
    """Type in which values are converted."""

    def report(self, rule: RuleCode, at: Pointer, message: str, fix: str = "", subject: Subject | None = None) -> None:
        """Report an obstacle."""
        self.problems.append(Problem(rule, at, message, fix, subject))

    @property
    def name(self) -> str:
        """Name of the function."""
        return self.function.info.function_name


class ListedCall(NamedTuple):
    """A call as the function lists it."""

    name: str
    """Last part of its name."""
    at: Pointer
    call: Runnable

    @property
    def is_step(self) -> bool:
        """Whether it is neither an init nor a terminate."""
        return self.call.run_type not in (INIT, TERMINATE)


INIT, TERMINATE = "Init", "Shutdown"
"""Run types of the calls at the beginning and at the end."""


def context_of(function: FunctionJson, arithmetic: NumberType = DOUBLE) -> Context:
    """The context of a function."""
    return Context(function, {datatype.reference: datatype for datatype in function.datatypes}, [], arithmetic)


def nanoseconds(value: str | float | None, at: Pointer, context: Context) -> int | None:
    """A duration of the wire format, in ms, as whole ns; None if there is none."""
    number = milliseconds(value) if isinstance(value, str) else value
    if number is None and value is not None:
        context.report(codes.TIME_NOT_WHOLE, at, f"The time must be a number of milliseconds, not {value!r}.")
    if number is None:
        return None
    if not 0 <= number <= LONGEST_MILLISECONDS:
        message = f"The time must be between 0 and {LONGEST_MILLISECONDS} ms, not {number!r} ms."
        context.report(codes.TIME_NOT_WHOLE, at, message)
        return None
    exact = whole_nanoseconds(number)
    if exact is None:
        message = f"The time must be whole nanoseconds, not {number!r} ms."
        context.report(codes.TIME_NOT_WHOLE, at, message)
    return exact


def expression(text: str | None, what: str, at: Pointer, context: Context) -> str | None:
    """An expression of C that holds a value, as the declaration has it; None if there is none, or C has no such."""
    if text is None or may_hold_value(text):
        return text
    message = f"The variable of {what} must be an expression of C, not {text!r}."
    context.report(codes.VARIABLE_MISSING, at, message, "Write it as in the code, such as bus.speed.")
    return None
