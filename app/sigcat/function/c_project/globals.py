"""Code whose calls take nothing: inputs, outputs and parameters are global variables."""

import re
from collections.abc import Iterable, Iterator, Sequence

from sigcat import codes
from sigcat.findings import Finding
from sigcat.function.c_project.code_values import Code, Value, values_of
from sigcat.function.c_project.declarations import CType, Declarations, Variable
from sigcat.function.c_project.found_calls import Group, Use, use_of
from sigcat.function.c_project.project import ROLES, CodeObject, Interface, interface_of
from sigcat.function.c_project.roles import Role, is_of_the_generator, role_of

_PARAMETER = re.compile(
    r"Referenced by:|\b(?:Variable|Computed Parameter|Expression|Simulink\.Parameter)\b", re.IGNORECASE
)
_IMPORTED = re.compile(r"\bimport", re.IGNORECASE)
_EXPORTED = re.compile(r"\bexported global signals", re.IGNORECASE)
_FIX = "Import the folder with the sources too, or add it to the function.yaml."
ADD_BY_HAND = "Add those that others send or receive to the function.yaml."
_WITHIN = re.compile(r"'<S\d+>/")


def global_interface(group: Group, code: Code, linked: frozenset[str]) -> Interface:
    """The interface in global variables. `linked` are the files that are compiled."""
    declarations = code.declarations
    use = use_of((step.name for step in group.steps), declarations)
    found: list[tuple[Role, Value]] = []
    unknown: list[Value] = []
    objects: dict[str, CodeObject] = {}
    shared = tuple(_shared(declarations, linked))
    defined = {each.name for each in declarations.variables if each.is_defined and each.place.file in linked}
    for variable in shared:
        is_imported = bool(linked) and variable.name not in defined
        is_object = is_imported and _element(variable).kind == "record"
        defined_by, c_type = ("adapter", variable.written) if is_imported and not is_object else ("function", "")
        for role, value in _with_roles(variable, code, use):
            if role in ROLES:
                is_const = value.is_const or variable.is_const
                found.append((role, value._replace(is_const=is_const, defined_by=defined_by, c_type=c_type)))
                if is_object:
                    objects[variable.name] = _object(variable)
            elif not role:
                unknown.append(value)
    findings = (*direction_unknown(unknown, _FIX), *_constant(shared, use))
    return interface_of(found, objects=tuple(objects.values()), findings=findings)


def _object(variable: Variable) -> CodeObject:
    """An imported struct, or an array of structs, which is defined as a whole."""
    return CodeObject(variable.name, variable.written, variable.place, length=variable.type.length)


def _element(variable: Variable) -> CType:
    """The type of a variable, or of its elements."""
    return variable.type.of if variable.type.kind == "array" and variable.type.of else variable.type


def _shared(declarations: Declarations, linked: frozenset[str]) -> Iterator[Variable]:
    """Variables that other files can see: those that headers declare, else those that the sources define; once each."""
    first: dict[str, Variable] = {}
    for variable in declarations.variables:
        if variable.is_static or "::" in variable.name:
            continue
        is_declared = not variable.is_defined or variable.place.file not in linked
        known = first.get(variable.name)
        if known is None:
            first[variable.name] = variable
        elif variable.value is not None and known.value is None:
            first[variable.name] = known._replace(value=variable.value)
        elif is_declared and known.place.file in linked:
            first[variable.name] = variable._replace(value=known.value)
    declared = {each.name for each in declarations.variables if not each.is_defined}
    yield from (each for each in first.values() if each.name in declared or not declared)


def _with_roles(variable: Variable, code: Code, use: Use) -> Iterator[tuple[Role, Value]]:
    """The values of a variable with their roles: of the variable, or of each value by what the steps do with it."""
    heading = code.heading(variable.place)
    role = _role_by_name_and_comment(variable, heading, use)
    if role in ("internal", "model"):
        return
    for value in values_of(variable.name, variable.type, variable.place, code, variable.value):
        yield role or _role(variable, value, use, heading, code), value


def _role_by_name_and_comment(variable: Variable, heading: str, use: Use) -> Role:
    """The role that names and comments tell; internal if it is not part of the interface."""
    kind = variable.type.kind
    if is_of_the_generator(variable.name) or (kind in ("pointer", "other") and not _is_seen(variable, use)):
        return "internal"
    if variable.is_const and kind != "record":
        return "internal"
    if kind == "record" or role_of("", "", heading):
        told = role_of(variable.name, variable.type.name, heading)
        if told:
            return told
    return "internal" if use.is_known and variable.name not in use.used else ""


def _role(variable: Variable, value: Value, use: Use, heading: str, code: Code) -> Role:
    """Written variables are outputs; those that are only read are inputs, or parameters if they have a value."""
    comments = code.comments.get(value.place.file)
    comment = comments.beside(value.place.line, value.name) if comments else ""
    is_written = value.key in use.written or (variable.name in use.written and value.key == variable.name)
    if _PARAMETER.search(comment) and not is_written:
        return "parameter"
    if not use.is_known:
        return _role_of_headings(comment, heading)
    if is_written:
        return "output"
    if value.key not in use.used:
        return "internal"
    return "parameter" if variable.value is not None and "<Root>/" not in comment else "input"


def _role_of_headings(comment: str, heading: str) -> Role:
    """Without the sources: an imported port comes from outside, and what a block within computes and exports goes there."""
    if _IMPORTED.search(heading) and "<Root>/" in comment:
        return "input"
    return "output" if _EXPORTED.search(heading) and _WITHIN.search(comment) else ""


def _constant(shared: Iterable[Variable], use: Use) -> Iterator[Finding]:
    """One finding, at the first constant that the steps read."""
    constants = (each for each in shared if each.is_const and _element(each).kind != "record")
    found = [each for each in constants if _is_seen(each, use) and not is_of_the_generator(each.name)]
    if found:
        more = f" and {len(found) - 1:,} more" if len(found) > 1 else ""
        message = f"{found[0].name!r}{more} must not be const to be a parameter; left out."
        fix = "Remove 'const' if it is a parameter; a constant of the code needs no entry."
        yield codes.VALUE_LEFT_OUT.finding(message, *found[0].place, fix=fix)


def _is_seen(variable: Variable, use: Use) -> bool:
    return use.is_known and variable.name in use.used


def direction_unknown(values: Sequence[Value], fix: str) -> Iterator[Finding]:
    """One finding, at the first value."""
    if values:
        more = f" and {len(values) - 1:,} more" if len(values) > 1 else ""
        message = f"{values[0].expression!r}{more} must be known to be an input or an output; left out."
        yield codes.DIRECTION_UNKNOWN.finding(message, *values[0].place, fix=fix)
