"""Reentrant code, whose calls take pointers: to a model with pointers in it, or to inputs and outputs themselves."""

import re
from collections.abc import Iterable, Iterator
from typing import NamedTuple

from sigcat import codes
from sigcat.findings import Finding
from sigcat.function.c_project.code_values import Code, Value, values_of
from sigcat.function.c_project.declarations import CFunction, CType, Member, Variable
from sigcat.function.c_project.found_calls import Group, use_of
from sigcat.function.c_project.globals import ADD_BY_HAND, direction_unknown
from sigcat.function.c_project.project import CodeObject, Interface, interface_of
from sigcat.function.c_project.roles import Role, is_model_of_the_generator, role_of, role_of_words

_MEMBERS: dict[str, tuple[Role, str]] = {
    "inputs": ("input", "U"),
    "outputs": ("output", "Y"),
    "defaultParam": ("parameter", "P"),
    "dwork": ("internal", "DW"),
    "blockIO": ("internal", "B"),
    "contStates": ("internal", "X"),
    "prevZCSigState": ("internal", "PrevZCX"),
}
"""Members of the model of Simulink that point to other objects, with the end of the names of these."""
_INTERNAL_MEMBERS = frozenset(
    ("errorStatus", "derivs", "contStateDisabled", "solverInfo", "rtwLogInfo", "childSfunctions")
)


class _Found(NamedTuple):
    """An object with its role, and where its values are."""

    object: CodeObject
    role: Role
    type: CType


def pointer_interface(group: Group, code: Code) -> Interface:
    """The interface in the objects that calls take."""
    passed = list(_passed(group, code))
    model = passed[0] if passed and passed[0].role in ("model", "") else None
    objects = [*passed, *(_wired(model, code) if model else ())]
    has_own = any(found.role in ("input", "output") for found in passed)
    members = _of_members(model, code, has_own) if model else ()
    parts = (*_of_objects([found for found in objects if found is not model], code), *members)
    values = [(role, list(each)) for role, each in parts]
    used = use_of((step.name for step in group.steps), code.declarations).used
    unknown = [value for value in _of("", values) if value.key in used and not value.problem]
    return interface_of(
        [(role, each) for role, found in values for each in found],
        objects=tuple(found.object for found in objects),
        arguments={function.name: tuple(_arguments(function, passed)) for function in group.functions},
        findings=(*_by_value(group.functions), *direction_unknown(unknown, ADD_BY_HAND)),
        others=(*_of("", values), *_of("internal", values), *_of("model", values)),
    )


def takes_pointers(group: Group) -> bool:
    """Whether a call takes anything."""
    return any(function.parameters for function in group.functions)


def _of(role: Role, values: Iterable[tuple[Role, list[Value]]]) -> tuple[Value, ...]:
    return tuple(value for of, found in values if of == role for value in found)


def _passed(group: Group, code: Code) -> Iterator[_Found]:
    """An object for each parameter, of the steps first."""
    names: set[str] = set()
    for function in (*group.steps, *group.functions):
        for parameter in function.parameters:
            kind = parameter.type
            if not _is_object(kind):
                continue
            name = parameter.name or _named_after(kind.target, code) or "instance"
            if name not in names:
                names.add(name)
                yield _Found(CodeObject(name, kind.target.name, function.place), _role(parameter), kind.target)


def _named_after(kind: CType, code: Code) -> str:
    """The name in the example program, if that has one object of the type."""
    found = _variables_of(kind, code)
    return found[0].name if len(found) == 1 else ""


def _variables_of(kind: CType, code: Code) -> list[Variable]:
    """Variables of a type, each once, with its value if it has one."""
    found: dict[str, Variable] = {}
    for each in code.declarations.variables:
        if _is_same(each.type, kind) and not each.is_const and (each.name not in found or each.value is not None):
            found[each.name] = each
    return list(found.values())


def _is_same(one: CType, other: CType) -> bool:
    return one.kind == "record" == other.kind and one.key == other.key


def _role(parameter: Member) -> Role:
    """By the names of Simulink, then by `const`, then by words."""
    target = parameter.type.target
    if target.kind == "record":
        told = role_of(parameter.name, target.name)
        return told or ("input" if parameter.type.const else "")
    if parameter.type.const:
        return "input"
    return "input" if re.search(r"_U_|^rtu_", parameter.name) else "output"


# -- objects that the model points to -----------------------------------------------------------------------------


def _wired(first: _Found, code: Code) -> Iterator[_Found]:
    """Objects that members of the first one have to point to."""
    record = code.declarations.records.get(first.type.key)
    if record is None:
        return
    for member in record.members:
        kind = member.type
        if kind.kind != "pointer" or kind.target.kind != "record" or member.name in _INTERNAL_MEMBERS:
            continue
        told, end = _MEMBERS.get(member.name, (role_of(member.name, kind.target.name), member.name))
        role = role_of("", kind.target.name) or told
        name = _named_after(kind.target, code) or _beside(first.object.name, end)
        yield _Found(CodeObject(name, kind.target.name, member.place, member.name), role, kind.target)


def _beside(model: str, end: str) -> str:
    """The name of an object as Simulink gives it: `X_U` beside `X_M`, `rtU` beside `rtM`."""
    return f"{model[:-1]}{end}" if model.endswith("M") else f"{model}_{end}"


# -- values -------------------------------------------------------------------------------------------------------


def _of_objects(objects: list[_Found], code: Code) -> Iterator[tuple[Role, Iterator[Value]]]:
    for found in objects:
        start = next((each.value for each in _variables_of(found.type, code) if each.value is not None), None)
        yield found.role, values_of(found.object.name, found.type, found.object.place, code, start)


def _of_members(model: _Found, code: Code, has_own: bool) -> Iterator[tuple[Role, Iterator[Value]]]:
    """Values in the model: `self->in.speed`, unless the calls take inputs or outputs.

    Other values of a model of Simulink are its timing and its states.
    """
    record = code.declarations.records.get(model.type.key)
    for member in record.members if record else ():
        if member.type.kind != "pointer":
            role = role_of_words(member.name) if member.type.kind == "record" else ""
            if has_own or (not role and is_model_of_the_generator(model.type.name)):
                role = "internal"
            expression = f"{model.object.name}.{member.name}"
            yield role, values_of(expression, member.type, member.place, code, name=member.name, key=member.key)


def _arguments(function: CFunction, passed: list[_Found]) -> Iterator[str]:
    """The objects that a call takes, in order: by the name of the parameter, or else by its type."""
    names = {found.object.name for found in passed}
    for parameter in function.parameters:
        if not _is_object(parameter.type):
            continue
        same = [found.object.name for found in passed if found.type.key and found.type.key == parameter.type.target.key]
        if parameter.name in names:
            yield parameter.name
        elif same:
            yield same[0]


def _by_value(functions: Iterable[CFunction]) -> Iterator[Finding]:
    for function in functions:
        wrong = [each for each in function.parameters if not _is_object(each.type)]
        if wrong:
            taken = "; ".join(_taken(kind, wrong) for kind in _OTHERWISE if any(_kind(each) == kind for each in wrong))
            message = f"{function.name!r} must take pointers to objects; it takes {taken}."
            yield codes.CALL_NOT_EXPRESSIBLE.finding(message, *function.place, fix=_FIX)


_OTHERWISE = {"": "by value", "array": "as arrays", "pointer": "as pointers to what no header declares"}


def _kind(parameter: Member) -> str:
    return parameter.type.kind if parameter.type.kind in _OTHERWISE else ""


def _taken(kind: str, wrong: list[Member]) -> str:
    """`2 by value: 'a', 'b'`."""
    named = [repr(each.name) for each in wrong if _kind(each) == kind]
    return f"{len(named)} {_OTHERWISE[kind]}: {', '.join(named[:3])}{', ...' if len(named) > 3 else ''}"


_FIX = (
    "Generate the code with root-level inputs and outputs as a structure reference or as part of the model data structure, "
    "or write a function around it."
)


def _is_object(kind: CType) -> bool:
    return kind.kind == "pointer" and kind.target.kind in ("record", "number", "enumeration", "array")
