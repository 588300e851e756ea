"""Types of the function's own variables, compared with what is declared of them while the core is compiled (section 14)."""

from collections.abc import Iterator

from sigcat.adapter.core.c.lines import Line, Lines, code_of, joined, lines
from sigcat.adapter.core.c.scope import Scope
from sigcat.adapter.core.plan import Argument, Input, Leaf, Method, Output, Parameter
from sigcat.function.document.document import Pointer
from sigcat.function.document.text_filters import block_comment

PUT, GOT = "HOLDS", "FITS"
"""A variable that numbers are put into may be wider than declared; one that they are got from may be narrower."""
WHOLE = "WHOLE"
"""A flag or an enumeration may be in an integer of any size, but not in a floating-point variable."""


def sizes(scope: Scope) -> list[Lines]:
    """The macros, and a line for each variable that a header declares."""
    checks = joined(_checks(scope)) if scope.plan.code.headers else ()
    if not checks:
        return []
    text = lines(
        block_comment(f"Variables of {scope.plan.function} have the declared kind, sign and size, or the build fails.")
    )
    macros = _macros(scope, code_of(checks))
    kinds = _kinds(scope, code_of(macros))
    return [_assertion(scope), kinds, macros, (*text, *dict.fromkeys(checks))]


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


def _kinds(scope: Scope, macros: str) -> Lines:
    """The macros that tell kinds of numbers, if the checks use them."""
    kind = _kind_in_cpp(scope) if scope.is_cpp else _kind_in_c(scope)
    if scope.constant("AGREES") in macros:
        return joined([kind, _agreement(scope)])
    return kind if scope.constant("KIND") in macros else ()


def _kind_in_c(scope: Scope) -> Lines:
    kind, generic = scope.constant("KIND"), scope.constant("GENERIC")
    return lines(f"""
        /* Kinds of numbers: 1 unsigned, 2 signed, 3 floating, 4 boolean; 0 is any other type, or a language before C11. */
        #if !defined(__cplusplus) && defined(__GNUC__) && !defined(__STRICT_ANSI__)
        #define {generic} __extension__ _Generic
        #elif !defined(__cplusplus) && defined(__STDC_VERSION__) && (__STDC_VERSION__ >= 201112L)
        #define {generic} _Generic
        #endif
        #if defined({generic})
        #define {kind}(value) {generic}((value), \\
            _Bool: 4, float: 3, double: 3, long double: 3, \\
            signed char: 2, short: 2, int: 2, long: 2, long long: 2, \\
            unsigned char: 1, unsigned short: 1, unsigned int: 1, unsigned long: 1, unsigned long long: 1, default: 0)
        #else
        #define {kind}(value) 0
        #endif
    """)


def _kind_in_cpp(scope: Scope) -> Lines:
    name = f"{scope.prefix}_KindOf"
    return lines(f"""
        /* Kinds of numbers: 1 unsigned, 2 signed, 3 floating, 4 boolean; 0 is any other type. */
        template <typename T> constexpr int {name}()
        {{
            return std::is_same<T, bool>::value ? 4 : std::is_floating_point<T>::value ? 3
                : (!std::is_integral<T>::value || std::is_same<T, char>::value) ? 0 : std::is_signed<T>::value ? 2 : 1;
        }}
        #define {scope.constant("KIND")}(value) \\
            {name}<std::remove_cv<std::remove_reference<decltype(value)>::type>::type>()
    """)


def _agreement(scope: Scope) -> Lines:
    kind = scope.constant("KIND")
    return lines(f"""
        /* A number keeps its value in a type of its kind, and an unsigned one in a signed type that is wider. */
        #define {scope.constant("AGREES")}(from, to, is_wider) \\
            (({kind}(from) == 0) || ({kind}(to) == 0) || \\
             ({kind}(from) == {kind}(to)) || \\
             (({kind}(from) == 1) && ({kind}(to) == 2) && (is_wider)))
    """)


_MACROS = {
    "WHOLE": ("variable", "{kind}(variable) != 3", "variable_must_be_an_integer", '#variable " must be an integer, not a floating-point number"'),
    "HOLDS": ("variable, type", "({size}(variable) >= sizeof(type)) && \\\n        {agrees}((type)0, variable, {size}(variable) > sizeof(type))", "variable_must_not_be_narrower_than_declared", '#variable " must be " #type'),
    "FITS": ("variable, type", "({size}(variable) <= sizeof(type)) && \\\n        {agrees}(variable, (type)0, {size}(variable) < sizeof(type))", "variable_must_not_be_wider_than_declared", '#variable " must be " #type'),
    "HAS": ("variable, count", "sizeof(variable) == ((size_t)(count) * sizeof((variable)[0]))", "variable_must_have_as_many_elements_as_declared", '#variable " must have " #count " elements"'),
    "HAS_ROOM": ("variable, count", "sizeof(variable) >= ((size_t)(count) * sizeof((variable)[0]))", "variable_must_have_at_least_as_many_elements_as_declared", '#variable " must have at least " #count " elements"'),
}  # fmt: skip
"""Arguments, condition, name and message of each check."""


def _macros(scope: Scope, text: str) -> Lines:
    """Those that a text uses."""
    check = scope.constant("CHECK")
    names = {"size": scope.constant("SIZE_OF"), "kind": scope.constant("KIND"), "agrees": scope.constant("AGREES")}
    nobody = "static_cast<{0} *>(nullptr)" if scope.is_cpp else "(({0} *)0)"
    rows = [f"#define {scope.constant('SELF')} {nobody.format(scope.prefix)}"] if "SELF" in text else []
    for name, (arguments, holds, declared, message) in _MACROS.items():
        macro = scope.constant(name)
        if f"{macro}(" in text:
            rows.append(
                f"#define {macro}({arguments}) \\\n    {check}({holds.format(**names)}, \\\n        {declared}, {message})"
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
    target = f"{variable}{place.replace('[i]', '[0]')}"
    if leaf.element.is_enumeration or number.is_boolean:
        yield _check(WHOLE, target, "", pointer, scope)
    else:
        yield _check(macro, target, number.c, pointer, scope)


def _check(macro: str, variable: str, declared: str, pointer: Pointer, scope: Scope) -> Lines:
    """A variable compared with its declared type or number of elements."""
    arguments = ", ".join(filter(None, (_outside(variable, scope), declared)))
    return (Line(f"{scope.constant(macro)}({arguments});", pointer),)


def _outside(variable: str, scope: Scope) -> str:
    """A variable, seen from outside of functions."""
    return scope.variable(variable).replace("self->", f"{scope.constant('SELF')}->")
