"""Names of a function and its parts: each once, and as conventions have it."""

import re

from sigcat import codes
from sigcat.function.document.document import Pointer
from sigcat.function.document.expression import may_hold_value
from sigcat.function.document.field_types import C_EXPRESSION
from sigcat.function.document.problem import Problem, Problems, Subject
from sigcat.function.function_json.interfaces.role import CONSUMER, PROVIDER
from sigcat.function.function_json.interfaces.status_interfaces import ErrorInterface, ModeInterface, SafetyReaction
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.variables import CodeVariable, variables
from sigcat.function.function_json.walk import (
    declared_data,
    errors,
    methods,
    modes,
    parameters,
    runnables,
    safety_reactions,
    subject_of,
)
from sigcat.names import camel_case, either

_CAMEL = re.compile(r"[A-Z][A-Za-z0-9]*")


def check_names(function: FunctionJson) -> Problems:
    """Every problem of names."""
    yield from _calls_twice(function)
    yield from _names_twice(function)
    yield from _paths_twice(function)
    yield from _variables_twice(function)
    yield from _function_name(function)
    yield from _conventional_names(function)
    yield from _mode_names(function)
    yield from _identifiers(function)
    yield from _expressions(function)


def _names_twice(function: FunctionJson) -> Problems:
    """Names that two interfaces of a call have; one interface that is listed twice is another problem."""
    statuses = _names_of_statuses(function)
    holders: dict[tuple[Pointer, str], tuple[str | None, Pointer]] = {}
    for pointer, located, item in (*declared_data(function), *parameters(function)):
        key = (located.pointer, item.name)
        at = (*pointer, "Name")
        path, first = holders.setdefault(key, (item.vss_path, at))
        if first != at and (item.vss_path is None or item.vss_path != path):
            message = f"The name {item.name!r} is used twice in one call."
            fix, subject = "Set another `name` for one of them.", Subject("data", item.name)
            yield Problem(codes.NAME_USED_TWICE, at, message, fix, subject, first=first)
        elif item.name in statuses:
            message = f"The name {item.name!r} is that of {statuses[item.name]} of the function."
            fix, subject = "Set another `name` for it.", Subject("data", item.name)
            yield Problem(codes.NAME_USED_TWICE, at, message, fix, subject)


def _names_of_statuses(function: FunctionJson) -> dict[str, str]:
    """Names that other interfaces have, with the kind of each."""
    named = {each.name: "a mode interface" for each in function.mode_interfaces or ()}
    named |= {each.name: "an error" for _, _, each in errors(function)}
    return named | {each.name: "a safety reaction" for _, _, each in safety_reactions(function)}


_ROLES = {CONSUMER: "consumed", PROVIDER: "provided"}


def _paths_twice(function: FunctionJson) -> Problems:
    """Interfaces that a call has twice, or that it both reads and writes."""
    roles: dict[tuple[Pointer, str], tuple[str, Pointer]] = {}
    for pointer, located, item in (*declared_data(function), *parameters(function)):
        if not item.vss_path:
            continue
        role = _ROLES.get(getattr(item, "role", ""), "a parameter")
        at = (*pointer, "VssPath")
        known, first = roles.setdefault((located.pointer, item.vss_path), (role, at))
        if first != at:
            again = "twice" if role == known else f"as {known} and as {role}"
            message = f"{located.runnable.name} must list {item.vss_path!r} once, not {again}."
            subject = Subject("data", item.vss_path)
            yield Problem(codes.PATH_USED_TWICE, at, message, "Remove one.", subject, first=first)


def _variables_twice(function: FunctionJson) -> Problems:
    """In one call a variable holds one thing; in another call of the component, and as a mode, it holds the same."""
    components = [component.name for component in function.components]
    holders: dict[tuple[str, str], CodeVariable] = {}
    for each in variables(function):
        for component in [each.place.component] if each.place.component else components:
            known = holders.setdefault((component, each.expression), each)
            if known.holds != each.holds:
                where = "one call" if known.place.call == each.place.call else f"component {component!r}"
                message = f"The variable {each.expression!r} holds two interfaces of {where}."
                fix = "Give each its own variable."
                yield Problem(codes.VARIABLE_USED_TWICE, each.pointer, message, fix, first=known.pointer)
                break


def _calls_twice(function: FunctionJson) -> Problems:
    seen: dict[str, Pointer] = {}
    for pointer, _, runnable in runnables(function):
        name, at = runnable.name, (*pointer, "Name")
        first = seen.setdefault(name, at)
        if first != at:
            message, fix = f"The call {name!r} is listed twice.", "Remove one, or name it otherwise."
            yield Problem(codes.CALL_LISTED_TWICE, at, message, fix, Subject("scheduling", name), first=first)


# -- conventions --------------------------------------------------------------------------------------------------


def _conventional_names(function: FunctionJson) -> Problems:
    own = function.info.function_name
    for pointer, component, runnable in runnables(function):
        if not runnable.name.startswith((f"{own}_", f"{component.name}_")):
            message = f"The name of the call {runnable.name!r} must start with '{own}_'."
            fix = f"Name it {own}_Init, {own}_Step or {own}_Terminate."
            yield Problem(codes.INTERFACE_NAME_UNCONVENTIONAL, (*pointer, "Name"), message, fix)
    for pointer, _, error in errors(function):
        if not (error.name.startswith(f"{own}_") and error.name.endswith("_ErrorSts")):
            yield _unconventional(pointer, f"{own}_<ErrorName>_ErrorSts", error)
    for pointer, _, reaction in safety_reactions(function):
        if not reaction.name.endswith("_SftyCondSts"):
            yield _unconventional(pointer, "<SafetyCondition>_SftyCondSts", reaction)


def _unconventional(pointer: Pointer, form: str, item: ErrorInterface | SafetyReaction | ModeInterface) -> Problem:
    message = f"The interface name must be {form}, not {item.name!r}."
    return Problem(codes.INTERFACE_NAME_UNCONVENTIONAL, (*pointer, "Name"), message, subject=subject_of(item))


def _mode_names(function: FunctionJson) -> Problems:
    own = function.info.function_name
    allowed = (f"{own}_Mode_In", f"{own}_Mode_Out")
    for pointer, interface in modes(function):
        if interface.name not in allowed:
            yield _unconventional(pointer, either(allowed), interface)


def _function_name(function: FunctionJson) -> Problems:
    name = function.info.function_name
    if not _CAMEL.fullmatch(name):
        fix = f"Name it {camel_case(name)!r}." if _CAMEL.fullmatch(camel_case(name)) else "Use letters and digits."
        message = f"The name of a function must be CamelCase, not {name!r}."
        pointer = ("FunctionInfo", "FunctionName")
        yield Problem(codes.FUNCTION_NAME_NOT_CAMEL_CASE, pointer, message, fix, Subject("function", name))


# -- C ------------------------------------------------------------------------------------------------------------


def _identifiers(function: FunctionJson) -> Problems:
    for pointer, _, item in (*declared_data(function), *parameters(function), *methods(function)):
        if not (item.name.isascii() and item.name.isidentifier()):
            message = f"The name {item.name!r} is not a valid C identifier."
            fix = "Use letters, digits and underscores, and a letter first."
            yield Problem(codes.NAME_NO_IDENTIFIER, (*pointer, "Name"), message, fix, Subject("data", item.name))


def _expressions(function: FunctionJson) -> Problems:
    for each in variables(function):
        if not may_hold_value(each.expression):
            key = str(each.pointer[-1])
            fix = C_EXPRESSION.fix
            written = f"`{key[:1].lower()}{key[1:]}`"
            message = f"{written} must be an expression of C that holds a value, not {each.expression!r}."
            yield Problem(codes.VARIABLE_NO_EXPRESSION, each.pointer, message, fix, each.place.subject)
