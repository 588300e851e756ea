"""Parameters: stored, checked, written to the code, and learned (section 11)."""

from sigcat.adapter.core.c.lines import Lines, block, choice, function, joined, lines
from sigcat.adapter.core.c.scope import Scope
from sigcat.adapter.core.c.values import (
    Ends,
    assigned,
    check,
    constant,
    flag,
    index,
    known_values,
    names_functions,
    stored,
    tables,
)
from sigcat.adapter.core.plan import GLOBALS, Parameter, Value


def ends_of(parameter: Parameter, scope: Scope) -> Ends:
    """From the catalogue's value to the variable."""
    name = parameter.named.name
    source = f"self->parameter.{name}.value"
    names = f"{scope.prefix}_{name}"
    return Ends(source, scope.variable(parameter.variable), names, parameter.named.pointer, put=scope.put)


def parameter_functions(scope: Scope) -> list[Lines]:
    """Functions for each parameter."""
    found: list[Lines] = []
    for parameter in scope.plan.parameters:
        ends = ends_of(parameter, scope)
        kinds = ("init", "default", "replacement") if parameter.value.is_replaced else ("init", "default")
        found += [*tables(parameter.value, ends.names, kinds), *names_functions(parameter.value, ends)]
        found += [_is_within(parameter, scope), _load(parameter, scope), _write(parameter, scope)]
        if parameter.learned:
            found += [
                *tables(parameter.learned, _back(parameter, scope).names, ("default",)),
                *names_functions(parameter.learned, _back(parameter, scope)),
                _learn(parameter, parameter.learned, scope),
            ]
    return [each for each in found if each]


def is_checked(parameter: Parameter) -> bool:
    """Whether a value can be out of range."""
    return bool(_checked(parameter.value, Ends("value", "", "", ())))


def _checked(value: Value, ends: Ends) -> Lines:
    return () if [line.text for line in check(value, ends)] == ["const bool is_within = true;"] else check(value, ends)


def _is_within(parameter: Parameter, scope: Scope) -> Lines:
    """A function that tells whether a value is within its limits."""
    if not is_checked(parameter):
        return ()
    wire = parameter.value.wire
    is_pointer = wire.length is not None or wire.is_struct
    is_one_struct = wire.is_struct and wire.length is None
    ends = ends_of(parameter, scope)._replace(source="(*value)" if is_one_struct else "value")
    head = f"static bool {scope.prefix}_IsWithin_{parameter.named.name}({'const ' if is_pointer else ''}{wire.c} {'*' if is_pointer else ''}value)"
    body = [index(parameter.value), known_values(parameter.value), flag(parameter.value), check(parameter.value, ends),
            lines("return is_within;")]  # fmt: skip
    return function(head, body, parameter.named.comment)


def handed(parameter: Parameter, place: str) -> str:
    """A value as an argument."""
    wire = parameter.value.wire
    return f"&{place}" if wire.is_struct and wire.length is None else place


def _load(parameter: Parameter, scope: Scope) -> Lines:
    """Use the stored value, if it exists and is within its limits."""
    name = parameter.named.name
    place, kept = f"self->parameter.{name}", f"self->stored.{name}"
    take = taken(parameter, f"{kept}.value", scope)
    if is_checked(parameter):
        take = choice([
            (f"{scope.prefix}_IsWithin_{name}({handed(parameter, f'{kept}.value')})", take),
            ("", _refused(parameter, scope)),
        ])  # fmt: skip
    body = [
        lines(f"{place}.origin = {scope.constant('INIT')};"),
        block(f"if ({kept}.is_there)", [take]),
    ]
    return function(f"static void {scope.prefix}_Load_{name}({scope.self_argument})", body, parameter.named.comment)


def taken(parameter: Parameter, source: str, scope: Scope) -> Lines:
    """A good value, taken."""
    place = f"self->parameter.{parameter.named.name}"
    return joined([
        stored(parameter.value.wire, handed(parameter, source), f"{place}.value"),
        lines(f"{place}.origin = {scope.constant('RECEIVED')};"),
        lines(f"{place}.range = {scope.absent};") if parameter.range_error else (),
    ])  # fmt: skip


def _refused(parameter: Parameter, scope: Scope) -> Lines:
    place = f"self->parameter.{parameter.named.name}"
    is_replaced = parameter.value.is_replaced
    found = joined([
        lines(f"{place}.origin = {scope.constant('REPLACEMENT')};") if is_replaced else (),
        lines(f"{place}.range = {scope.present};") if parameter.range_error else (),
    ])  # fmt: skip
    return found or lines("/* it stays as it is */")


def _write(parameter: Parameter, scope: Scope) -> Lines:
    ends, value = ends_of(parameter, scope), parameter.value
    place = f"self->parameter.{parameter.named.name}.origin"
    ways = [(f"{place} == {scope.constant('RECEIVED')}", assigned(value, ends, scope.prefix, is_new=True))]
    if value.is_replaced and is_checked(parameter):
        replaced = constant(value, "replacement", ends)
        ways.append((f"{place} == {scope.constant('REPLACEMENT')}", replaced))
    body = [index(value), known_values(value), choice([*ways, ("", constant(value, "init", ends))])]
    is_read_only = "const " if scope.plan.code.signature == GLOBALS else ""
    head = f"static void {scope.prefix}_Write_{parameter.named.name}({is_read_only}{scope.self_argument})"
    return function(head, body, parameter.named.comment)


def written(parameter: Parameter, scope: Scope) -> Lines:
    """A parameter, written to its variable."""
    return lines(f"{scope.prefix}_Write_{parameter.named.name}(self);")


# -- all of them --------------------------------------------------------------------------------------------------


def settable(scope: Scope) -> list[Parameter]:
    """Parameters that are set from outside: all but those that the function learns."""
    return list(scope.plan.settable)


def set_function(scope: Scope) -> Lines:
    """All parameters change, or none."""
    if not settable(scope):
        return ()
    p = scope.prefix
    conditions = [
        f"{p}_IsWithin_{each.named.name}({handed(each, f'parameters->{each.named.name}')})"
        for each in settable(scope)
        if is_checked(each)
    ]
    take = [taken(each, f"parameters->{each.named.name}", scope) for each in settable(scope)]
    body = [
        lines(f"const bool are_within = {' && '.join(conditions) or 'true'};"),
        block("if (are_within)", take),
        lines("return are_within;"),
    ]
    return function(f"bool {p}_SetParameters({scope.self_argument}, const {p}_Parameters *parameters)", body)


# -- learning -----------------------------------------------------------------------------------------------------


def _back(parameter: Parameter, scope: Scope) -> Ends:
    name = f"{scope.prefix}_{parameter.named.name}_Learned"
    target = f"self->stored.{parameter.named.name}.value"
    return Ends(scope.variable(parameter.variable), target, name, parameter.named.pointer, is_read=scope.is_cpp)


def _learn(parameter: Parameter, learned_value: Value, scope: Scope) -> Lines:
    name, ends = parameter.named.name, _back(parameter, scope)
    keep = joined(
        [assigned(learned_value, ends, scope.prefix, quiet=True), lines(f"self->stored.{name}.is_there = true;")]
    )
    is_limited = bool(_checked(learned_value, ends))
    checked = (
        [flag(learned_value), check(learned_value, ends), block("if (is_within)", [keep])] if is_limited else [keep]
    )
    body = [index(learned_value), known_values(learned_value), *checked]
    head = f"static void {scope.prefix}_Learn_{name}({scope.self_argument})"
    return function(head, body, f"{parameter.named.comment}: stored if it is within its limits")
