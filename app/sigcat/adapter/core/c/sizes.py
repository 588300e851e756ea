"""Sizes of the function's own variables, held against what is declared of them while the core is compiled (section 14)."""

from collections.abc import Iterator

from sigcat.adapter.core.c.lines import Line, Lines, joined, lines
from sigcat.adapter.core.c.scope import Scope
from sigcat.adapter.core.plan import Argument, Input, Leaf, Method, Output, Parameter
from sigcat.adapter.text_filters import block_comment
from sigcat.function.document.document import Pointer

PUT, GOT = "HOLDS", "FITS"
"""A variable that numbers are put into may be wider than declared; one that they are got from may be narrower."""


def sizes(scope: Scope) -> list[Lines]:
    """The macros, and a line for each variable that a header declares."""
    checks = joined(_checks(scope)) if scope.plan.code.headers else ()
    if not checks:
        return []
    text = lines(
        block_comment(f"Variables of {scope.plan.function} are as large as declared: a build fails where one is not.")
    )
    return [_assertion(scope), _macros(scope, "\n".join(line.text for line in checks)), (*text, *dict.fromkeys(checks))]


def _assertion(scope: Scope) -> Lines:
    check, size = scope.constant("CHECK"), scope.constant("SIZE_OF")
    named, in_line = scope.constant("NAMED"), scope.constant("IN_LINE")
    if scope.is_cpp:
        return lines(f"""
            #define {check}(holds, name, message) static_assert(holds, message)
            #define {size}(variable) sizeof(decltype(variable))
        """)
    return lines(f"""
        /*
         * The comma makes a value of a bit field, which has a size. Before C11, an array of -1 elements is the error, and
         * its name the message: some libraries have an assertion of their own there, which says nothing.
         */
        #if defined(__cplusplus)
        #define {check}(holds, name, message) static_assert(holds, message)
        #define {size}(variable) sizeof(decltype(variable))
        #else
        #if defined(__GNUC__) && !defined(__STRICT_ANSI__)
        #define {check}(holds, name, message) __extension__ _Static_assert(holds, message)
        #elif defined(__STDC_VERSION__) && (__STDC_VERSION__ >= 201112L)
        #define {check}(holds, name, message) _Static_assert(holds, message)
        #else
        #define {named}(name, line) {scope.prefix}_##name##_in_line_##line
        #define {in_line}(name, line) {named}(name, line)
        #define {check}(holds, name, message) typedef char {in_line}(name, __LINE__)[(holds) ? 1 : -1]
        #endif
        #define {size}(variable) sizeof(((void)0, variable))
        #endif
    """)


_MACROS = {
    "HOLDS": ("variable, type", "{size}(variable) >= sizeof(type)", "variable_must_not_be_narrower_than_declared", '#variable " must be " #type'),
    "FITS": ("variable, type", "{size}(variable) <= sizeof(type)", "variable_must_not_be_wider_than_declared", '#variable " must be " #type'),
    "HAS": ("variable, count", "sizeof(variable) == ((size_t)(count) * sizeof((variable)[0]))", "variable_must_have_as_many_elements_as_declared", '#variable " must have " #count " elements"'),
    "HAS_ROOM": ("variable, count", "sizeof(variable) >= ((size_t)(count) * sizeof((variable)[0]))", "variable_must_have_at_least_as_many_elements_as_declared", '#variable " must have at least " #count " elements"'),
}  # fmt: skip
"""Arguments, condition, name and message of each check."""


def _macros(scope: Scope, text: str) -> Lines:
    """Those that a text uses."""
    check, size = scope.constant("CHECK"), scope.constant("SIZE_OF")
    nobody = "static_cast<{0} *>(nullptr)" if scope.is_cpp else "(({0} *)0)"
    rows = [f"#define {scope.constant('SELF')} {nobody.format(scope.prefix)}"] if "SELF" in text else []
    for name, (arguments, holds, declared, message) in _MACROS.items():
        macro = scope.constant(name)
        if f"{macro}(" in text:
            rows.append(
                f"#define {macro}({arguments}) \\\n    {check}({holds.format(size=size)}, \\\n        {declared}, {message})"
            )
    return lines("\n".join(rows))


def _checks(scope: Scope) -> Iterator[Lines]:
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


def _of_input(item: Input, scope: Scope) -> Iterator[Lines]:
    count = item.queue.values_per_step if item.queue and item.queue.values_per_step > 1 else None
    for leaf in item.value.leaves:
        yield from _of_leaf(item.variable, leaf.target, leaf, PUT, count, item.named.pointer, scope)


def _of_output(output: Output, scope: Scope) -> Iterator[Lines]:
    count = output.queue.length if output.queue and output.queue.count_variable is not None else None
    for leaf in output.value.leaves:
        yield from _of_leaf(output.variable, leaf.source, leaf, GOT, count, output.named.pointer, scope)


def _of_parameter(parameter: Parameter, scope: Scope) -> Iterator[Lines]:
    pointer = parameter.named.pointer
    for leaf in parameter.value.leaves:
        yield from _of_leaf(parameter.variable, leaf.target, leaf, PUT, None, pointer, scope)
    for leaf in parameter.learned.leaves if parameter.learned else ():
        yield from _of_leaf(parameter.variable, leaf.source, leaf, GOT, None, pointer, scope)


def _of_method(method: Method, scope: Scope) -> Iterator[Lines]:
    put, got = (method.arguments, method.results) if method.is_offered else (method.results, method.arguments)
    for macro, arguments in ((PUT, put), (GOT, got)):
        for each in arguments:
            yield from _of_argument(each, macro, method.named.pointer, scope)


def _of_argument(argument: Argument, macro: str, pointer: Pointer, scope: Scope) -> Iterator[Lines]:
    for leaf in argument.value.leaves:
        place = leaf.target if macro == PUT else leaf.source
        yield from _of_leaf(argument.variable, place, leaf, macro, None, pointer, scope)


def _of_leaf(
    variable: str, place: str, leaf: Leaf, macro: str, count: int | None, pointer: Pointer, scope: Scope
) -> Iterator[Lines]:
    """A number has its size; an array has as many elements as declared, that of a queue at least as many."""
    if count is not None:
        yield _check("HAS_ROOM", variable, str(count), pointer, scope)
        variable = f"{variable}[0]"
    if leaf.length is not None:
        yield _check("HAS", f"{variable}{place.partition('[i]')[0]}", str(leaf.length), pointer, scope)
    number = leaf.element.target if macro == PUT else leaf.element.source
    if not leaf.element.is_enumeration and not number.is_boolean:
        yield _check(macro, f"{variable}{place.replace('[i]', '[0]')}", number.c, pointer, scope)


def _check(macro: str, variable: str, declared: str, pointer: Pointer, scope: Scope) -> Lines:
    """A variable held against its declared type or number of elements."""
    return (Line(f"{scope.constant(macro)}({_outside(variable, scope)}, {declared});", pointer),)


def _outside(variable: str, scope: Scope) -> str:
    """A variable, seen from outside of functions."""
    return scope.variable(variable).replace("self->", f"{scope.constant('SELF')}->")
