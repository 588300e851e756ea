"""Functions that a declaration calls, compared with the headers that declare them."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

from sigcat import codes
from sigcat.findings import Finding
from sigcat.function.c_project.declarations import CFunction, CType, Declarations
from sigcat.function.document.document import Pointer
from sigcat.function.document.expression import is_identifier
from sigcat.function.function_json.code import CLASS, POINTERS, CodeInterface
from sigcat.function.function_json.interfaces.role import PROVIDER
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.function.function_json.walk import methods, runnables
from sigcat.names import did_you_mean

_PROBE = "sigcat_call_"


class CalledFunction(NamedTuple):
    """A function of the code, as the adapter calls it."""

    name: str
    pointer: Pointer
    arguments: tuple[str, ...]
    """Types of the objects that it takes pointers to."""
    has_result: bool
    """Whether the adapter compares its result with a number."""


def called_functions(function: ResolvedFunction, code: CodeInterface) -> Iterator[CalledFunction]:
    """The functions of calls and of offered methods, in the order of the document."""
    types = {each.name: each.type for each in code.objects or ()}

    def taken(arguments: Iterable[str]) -> tuple[str, ...]:
        return tuple(types[name] for name in arguments if name in types)

    for pointer, _, call in runnables(function.function):
        at = (*pointer, "Symbol" if call.symbol else "Name")
        has_result = call.success_value is not None
        yield CalledFunction(call.symbol or call.name, at, taken(call.arguments or ()), has_result)
    for pointer, located, method in methods(function.function):
        if method.role == PROVIDER and method.symbol is not None:
            arguments = taken(located.runnable.arguments or ())
            yield CalledFunction(method.symbol, (*pointer, "Symbol"), arguments, has_result=False)


def lines_of(called: CalledFunction, number: int, code: CodeInterface) -> tuple[str, str, str]:
    """Lines for clang: one is wrong if there is no such function, the next if it cannot be called as the adapter calls it.

    The last declares a function that takes the same.
    """
    if not is_identifier(called.name):
        return ("", "", "")
    name = f"{_PROBE}{number}"
    pointers = ", ".join(f"{each} *" for each in called.arguments)
    if code.signature == CLASS:
        there, result = f"&{code.class_name}::{called.name}", f"(({code.class_name} *)0)->{called.name}()"
        return (f"extern decltype({there}) {name};", f"typedef decltype({result}) {name}_result;", "")
    values = ", ".join(f"({each} *)0" for each in called.arguments)
    there, result = f"__typeof__({called.name})", f"__typeof__({called.name}({values}))"
    return (
        f"extern {there} *{name};",
        f"extern {result} *{name}_result;",
        f"extern void {name}_taken({pointers or 'void'});",
    )


def unfit_calls(
    function: ResolvedFunction, called: Sequence[CalledFunction], found: Declarations, first: int
) -> Iterator[Finding]:
    """A finding for each function that is absent, takes something else, or returns no number to compare.

    Its lines are the first ones from the line `first` on.
    """
    wrong = {error.place.line: error.message for error in found.errors}
    types = {each.name: each.type for each in found.variables if each.name.startswith(_PROBE)}
    functions = {each.name: each for each in found.functions}
    for number, each in enumerate(called):
        line, name = first + 3 * number, f"{_PROBE}{number}"
        taken, result = functions.get(f"{name}_taken"), types.get(f"{name}_result")
        declared = functions.get(each.name)
        if line in wrong and line + 1 in wrong:
            yield _absent(function, each, wrong[line], functions)
        elif line + 1 in wrong or (taken and declared and not _takes(declared, taken)):
            yield _unfit(function, each, declared)
        elif each.has_result and result is not None and result.target.kind not in ("number", "enumeration"):
            message = f"{each.name!r} must return a number, as `success` is compared with it; the header has {_shown(result.target)}."
            yield function.finding(codes.CODE_UNFIT, each.pointer, message, "Remove `success`, or correct the code.")


def _absent(
    function: ResolvedFunction, called: CalledFunction, said: str, functions: Mapping[str, CFunction]
) -> Finding:
    message = f"The headers must declare the function {called.name!r}; clang says: {said}."
    known = [name for name in functions if not name.startswith(_PROBE)]
    fix = did_you_mean(called.name, known) or "Give the name of the function in C as `symbol`, or declare it."
    return function.finding(codes.CODE_UNFIT, called.pointer, message, fix)


def _unfit(function: ResolvedFunction, called: CalledFunction, declared: CFunction | None) -> Finding:
    code = function.function.code
    takes = f"pointers to {' and '.join(called.arguments)}" if called.arguments else "no arguments"
    has = ", ".join(_shown(each.type) for each in declared.parameters) if declared else ""
    there = f"; the header has {has or 'none'}" if declared else ""
    fix = "Call it in a function without parameters, and name that one."
    if code is not None and code.signature == POINTERS:
        fix = "Correct `arguments`, or the code."
    message = f"The function {called.name!r} must take {takes}{there}."
    return function.finding(codes.CODE_UNFIT, called.pointer, message, fix)


def _takes(declared: CFunction, taken: CFunction) -> bool:
    """Whether a function takes pointers to the same types. One without parameters may take anything in C."""
    pairs = zip(declared.parameters, taken.parameters, strict=False)
    return all(_same(one.type, other.type) for one, other in pairs)


def _same(one: CType, other: CType) -> bool:
    if one.kind != "pointer":
        return False
    first, second = ((each.kind, each.key, each.names[-1:]) for each in (one.target, other.target))
    return one.target.kind == "void" or first == second


def _shown(kind: CType) -> str:
    return f"{kind.target.name} *" if kind.kind == "pointer" else kind.name or kind.kind
