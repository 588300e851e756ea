"""Types of the function's own variables, compared with what is declared of them while the core is compiled (section 14)."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from sigcat.adapter.core.c.names.scope import Scope
from sigcat.adapter.core.plan import Argument, Input, Leaf, Method, Output, Parameter
from sigcat.function.document.document import Pointer

PUT, GOT = "HOLDS", "FITS"
"""A variable that numbers are put into may be wider than declared; one that they are got from may be narrower."""
WHOLE = "WHOLE"
"""A flag may be in an integer of any size, but not in a floating-point variable."""
NUMBERS = "NUMBERS"
"""An enumeration, a mode or a count of values may be in any integer that holds its numbers."""


class Check(NamedTuple):
    """A variable that is compared with its type or its number of elements."""

    macro: str
    variable: str
    declared: str
    pointer: Pointer


def checks(scope: Scope) -> tuple[Check, ...]:
    """Return the checks of each variable that a header declares, each once."""
    return tuple(dict.fromkeys(_checks(scope))) if scope.plan.code.headers else ()


def needs_self(found: Sequence[Check], scope: Scope) -> bool:
    """Return whether any check is about a member of the adapter."""
    return any(f"{scope.constant('SELF')}->" in each.variable for each in found)


def _checks(scope: Scope) -> Iterator[Check]:
    plan = scope.plan
    for call in plan.calls:
        for item in call.inputs:
            yield from _of_input(item, scope)
        for output in call.outputs:
            yield from _of_output(output, scope)
    for parameter in plan.parameters:
        yield from _of_parameter(parameter, scope)
    for method in plan.methods:
        yield from _of_method(method, scope)
    for mode in (plan.mode_in, plan.mode_out):
        if mode is not None and mode.variable is not None:
            codes = [each.code for each in mode.modes]
            yield _check(NUMBERS, mode.variable, f"{min(codes)}, {max(codes)}", mode.named.pointer, scope)


def _of_input(item: Input, scope: Scope) -> Iterator[Check]:
    if item.queue and item.queue.count_variable is not None:
        numbers = f"0, {item.queue.values_per_step}"
        yield _check(NUMBERS, item.queue.count_variable, numbers, item.named.pointer, scope)
    count = item.queue.values_per_step if item.queue and item.queue.values_per_step > 1 else None
    for leaf in item.value.leaves:
        yield from _of_leaf(item.variable, leaf.target, leaf, PUT, count, item.named.pointer, scope)


def _of_output(output: Output, scope: Scope) -> Iterator[Check]:
    count = output.queue.length if output.queue and output.queue.count_variable is not None else None
    for leaf in output.value.leaves:
        yield from _of_leaf(output.variable, leaf.source, leaf, GOT, count, output.named.pointer, scope)


def _of_parameter(parameter: Parameter, scope: Scope) -> Iterator[Check]:
    pointer = parameter.named.pointer
    for leaf in parameter.value.leaves:
        yield from _of_leaf(parameter.variable, leaf.target, leaf, PUT, None, pointer, scope)
    for leaf in parameter.learned.leaves if parameter.learned else ():
        yield from _of_leaf(parameter.variable, leaf.source, leaf, GOT, None, pointer, scope)


def _of_method(method: Method, scope: Scope) -> Iterator[Check]:
    put, got = (method.arguments, method.results) if method.is_offered else (method.results, method.arguments)
    for macro, arguments in ((PUT, put), (GOT, got)):
        for each in arguments:
            yield from _of_argument(each, macro, method.named.pointer, scope)


def _of_argument(argument: Argument, macro: str, pointer: Pointer, scope: Scope) -> Iterator[Check]:
    for leaf in argument.value.leaves:
        place = leaf.target if macro == PUT else leaf.source
        yield from _of_leaf(argument.variable, place, leaf, macro, None, pointer, scope)


def _of_leaf(
    variable: str, place: str, leaf: Leaf, macro: str, count: int | None, pointer: Pointer, scope: Scope
) -> Iterator[Check]:
    """A number has its size; an array has as many elements as declared, that of a queue at least as many."""
    if count is not None:
        yield _check("HAS_ROOM", variable, str(count), pointer, scope)
        variable = f"{variable}[0]"
    if leaf.length is not None:
        yield _check("HAS", f"{variable}{place.partition('[i]')[0]}", str(leaf.length), pointer, scope)
    number = leaf.element.target if macro == PUT else leaf.element.source
    target = f"{variable}{place.replace('[i]', '[0]')}"
    if leaf.element.coded is not None:
        least, greatest = leaf.element.coded
        yield _check(NUMBERS, target, f"{least}, {greatest}", pointer, scope)
    elif number.is_boolean:
        yield _check(WHOLE, target, "", pointer, scope)
    else:
        yield _check(macro, target, number.c, pointer, scope)


def _check(macro: str, variable: str, declared: str, pointer: Pointer, scope: Scope) -> Check:
    outside = variable.replace("self->", f"{scope.constant('SELF')}->")
    return Check(macro, outside, declared, pointer)
