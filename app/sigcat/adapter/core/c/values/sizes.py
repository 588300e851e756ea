"""Types of the function's own variables, compared with what is declared of them while the core is compiled (section 14)."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from sigcat.adapter.core.c.names.scope import Scope
from sigcat.adapter.core.plan import CorePlan, Input, Method, Value
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
    if not scope.plan.code.headers:
        return ()
    held = f"{scope.constant('SELF')}->"
    found = (each._replace(variable=each.variable.replace("self->", held)) for each in _checks(scope.plan))
    return tuple(dict.fromkeys(found))


def needs_self(found: Sequence[Check], scope: Scope) -> bool:
    """Return whether any check is about a member of the adapter."""
    return any(f"{scope.constant('SELF')}->" in each.variable for each in found)


def _checks(plan: CorePlan) -> Iterator[Check]:
    for call in plan.calls:
        for item in call.inputs:
            yield from _of_input(item)
        for output in call.outputs:
            count = output.queue.length if output.queue and output.queue.count_variable is not None else None
            yield from _of_value(output.variable, output.value, GOT, output.named.pointer, count)
    for parameter in plan.parameters:
        yield from _of_value(parameter.variable, parameter.value, PUT, parameter.named.pointer)
        if parameter.learned:
            yield from _of_value(parameter.variable, parameter.learned, GOT, parameter.named.pointer)
    for method in plan.methods:
        yield from _of_method(method)
    for mode in (plan.mode_in, plan.mode_out):
        if mode is not None and mode.variable is not None:
            codes = [each.code for each in mode.modes]
            yield Check(NUMBERS, mode.variable, f"{min(codes)}, {max(codes)}", mode.named.pointer)


def _of_input(item: Input) -> Iterator[Check]:
    if item.queue and item.queue.count_variable is not None:
        numbers = f"0, {item.queue.values_per_step}"
        yield Check(NUMBERS, item.queue.count_variable, numbers, item.named.pointer)
    count = item.queue.values_per_step if item.queue and item.queue.values_per_step > 1 else None
    yield from _of_value(item.variable, item.value, PUT, item.named.pointer, count)


def _of_method(method: Method) -> Iterator[Check]:
    put, got = (method.arguments, method.results) if method.is_offered else (method.results, method.arguments)
    for macro, arguments in ((PUT, put), (GOT, got)):
        for each in arguments:
            yield from _of_value(each.variable, each.value, macro, method.named.pointer)


def _of_value(variable: str, value: Value, macro: str, pointer: Pointer, count: int | None = None) -> Iterator[Check]:
    """A number has its size; an array has as many elements as declared, that of a queue at least as many."""
    first = variable if count is None else f"{variable}[0]"
    for leaf in value.leaves:
        if count is not None:
            yield Check("HAS_ROOM", variable, str(count), pointer)
        place = leaf.target if macro == PUT else leaf.source
        if leaf.length is not None:
            yield Check("HAS", f"{first}{place.partition('[i]')[0]}", str(leaf.length), pointer)
        number = leaf.element.target if macro == PUT else leaf.element.source
        target = f"{first}{place.replace('[i]', '[0]')}"
        if leaf.element.coded is not None:
            least, greatest = leaf.element.coded
            yield Check(NUMBERS, target, f"{least}, {greatest}", pointer)
        elif number.is_boolean:
            yield Check(WHOLE, target, "", pointer)
        else:
            yield Check(macro, target, number.c, pointer)
