"""Methods that a function offers or uses (section 12)."""

from typing import NamedTuple

from sigcat.adapter.core.c.names.scope import Scope
from sigcat.adapter.core.c.schedule.schedule import runs, statement
from sigcat.adapter.core.c.values.c_values import Ends, Transfer, from_variable, to_variable, transfer
from sigcat.adapter.core.plan import Argument, Method

STATUS = {"IDLE": 0, "PENDING": 1, "DONE": 2, "FAILED": 3, "TIMED_OUT": 4}
"""Result of a request, as its status variable has it."""


class ArgumentPlan(NamedTuple):
    """An argument or a result."""

    name: str
    """Ending of the names of its functions: `SetSpeed_speed`."""
    value: Transfer
    is_member: bool
    """Whether its variable is a member of the adapter."""


class MethodPlan(NamedTuple):
    """A method."""

    method: Method
    place: str
    """Member with its state, if it is used: `self->method.SetSpeed`."""
    struct: str
    """Type of the received values."""
    received: list[ArgumentPlan]
    given: list[ArgumentPlan]
    takes_arrays: bool
    """Whether values are received element by element."""
    gives_arrays: bool
    statement: str
    """The call of the code that answers."""
    runs: str
    """Whether the mode lets its call run; empty if every mode does."""


def method_plan(method: Method, scope: Scope) -> MethodPlan:
    """A method, as functions of the adapter offer or use it."""
    place = f"self->method.{method.named.name}"
    if method.is_offered:
        received = [_received(each, method, "arguments->", scope) for each in method.arguments]
        given = [_argument_from_code(each, method, "results->", scope) for each in method.results]
    else:
        received = [_received(each, method, f"{place}.answer.", scope) for each in method.results]
        given = [_argument_from_code(each, method, f"{place}.arguments.", scope) for each in method.arguments]
    call = next((step for step in scope.plan.steps if step.name == method.call), None)
    return MethodPlan(
        method=method,
        place=place,
        struct=f"{scope.prefix}_{method.named.name}_{'Arguments' if method.is_offered else 'Results'}",
        received=received,
        given=given,
        takes_arrays=any(each.value.has_arrays and not each.value.is_checked for each in received),
        gives_arrays=any(each.value.has_arrays for each in given),
        statement=statement(method.symbol, call.arguments if call else (), scope),
        runs=runs(call, scope) if call else "",
    )


def _received(argument: Argument, method: Method, source: str, scope: Scope) -> ArgumentPlan:
    """An argument of a request, or a result of an answer; a separate function takes it if it is checked."""
    name, member = _name(argument, method), f"{'given->' if argument.value.is_checked else source}{argument.name}"
    return _plan(argument, name, to_variable(member, argument.variable, name, method.named.pointer, scope))


def _argument_from_code(argument: Argument, method: Method, target: str, scope: Scope) -> ArgumentPlan:
    name, member = _name(argument, method), f"{target}{argument.name}"
    return _plan(argument, name, from_variable(argument.variable, member, name, method.named.pointer, scope))


def _name(argument: Argument, method: Method) -> str:
    return f"{method.named.name}_{argument.name}"


def _plan(argument: Argument, name: str, ends: Ends) -> ArgumentPlan:
    return ArgumentPlan(name, transfer(argument.value, ends), "self->" in argument.variable)
