"""Parameters: stored, checked, written to the code, and learned (section 11)."""

from sigcat.adapter.core.c.lines import Lines, block, choice, function, joined, lines
from sigcat.adapter.core.c.literals import literal
from sigcat.adapter.core.c.scope import Scope
from sigcat.adapter.core.c.values import (
    Ends,
    assigned,
    check,
    flag,
    index,
    known_values,
    looped,
    names_functions,
    tables,
)
from sigcat.adapter.core.numbers import Number
from sigcat.adapter.core.plan import Leaf, Parameter, Value


def ends_of(parameter: Parameter, scope: Scope) -> Ends:
    """From the catalogue's value to the variable."""
    name = parameter.named.name
    source = f"self->parameters.{name}"
    return Ends(source, scope.variable(parameter.variable), f"{scope.prefix}_{name}", parameter.named.pointer)


def _back(parameter: Parameter, scope: Scope, target: str) -> Ends:
    name = f"{scope.prefix}_{parameter.named.name}_Learned"
    return Ends(scope.variable(parameter.variable), target, name, parameter.named.pointer)


def parameter_functions(scope: Scope) -> list[Lines]:
    """What every parameter needs, and what they need together."""
    found: list[Lines] = []
    for parameter in scope.plan.parameters:
        ends = ends_of(parameter, scope)
        found += [tables(parameter.value, ends.names, ("default",)), *names_functions(parameter.value, ends)]
        if parameter.learned:
            found += names_functions(parameter.learned, _back(parameter, scope, ""))
        found.append(_is_within(parameter, scope))
        if not parameter.value.is_bare or any(leaf.element.names is not None for leaf in parameter.value.leaves):
            found.append(_write(parameter, scope))
    return [each for each in found if each]


def is_checked(parameter: Parameter) -> bool:
    """Whether a value can be out of range."""
    return any(_is_limited(leaf) for leaf in parameter.value.leaves)


def _is_limited(leaf: Leaf) -> bool:
    element = leaf.element
    is_limited = element.least is not None or element.greatest is not None or element.source.is_floating
    return element.names is not None or (element.is_checked and is_limited)


def _is_within(parameter: Parameter, scope: Scope) -> Lines:
    """A function that tells whether a value is within its limits."""
    if not is_checked(parameter):
        return ()
    value = parameter.value
    is_pointer = value.wire.length is not None or value.wire.is_struct
    ends = ends_of(parameter, scope)._replace(
        source="(*value)" if value.wire.is_struct and value.wire.length is None else "value"
    )
    argument = f"const {value.wire.c} *value" if is_pointer else f"{value.wire.c} value"
    head = f"static bool {scope.prefix}_IsWithin_{parameter.named.name}({argument})"
    body = [index(value), known_values(value), flag(value), check(value, ends), lines("return is_within;")]
    return function(head, body, parameter.named.comment)


def _write(parameter: Parameter, scope: Scope) -> Lines:
    ends, value = ends_of(parameter, scope), parameter.value
    body = [index(value), _initialised(parameter), assigned(value, ends, scope.prefix, is_new=True)]
    head = f"static void {scope.prefix}_Write_{parameter.named.name}({scope.self_argument})"
    return function(head, body, parameter.named.comment)


def _initialised(parameter: Parameter) -> Lines:
    """An enumeration's number before it is known; a stored one was checked."""
    return joined(
        lines(f"{leaf.element.target.c} known_{number} = {literal(leaf.default[0], leaf.element.target)};")
        for number, leaf in enumerate(parameter.value.leaves)
        if leaf.element.names is not None
    )


def written(parameter: Parameter, scope: Scope) -> Lines:
    """A parameter, written to its variable."""
    if not parameter.value.is_bare or any(leaf.element.names is not None for leaf in parameter.value.leaves):
        return lines(f"{scope.prefix}_Write_{parameter.named.name}(self);")
    (line,) = assigned(parameter.value, ends_of(parameter, scope), scope.prefix)
    return lines(f"{line.text} /* {parameter.named.comment} */", line.source)


# -- all of them --------------------------------------------------------------------------------------------------


def defaults(parameter: Parameter, numbers: tuple[tuple[Number, ...], ...]) -> Lines:
    """Constants in the catalogue's unit, put into the parameter."""
    found = []
    for leaf, given in zip(parameter.value.leaves, numbers, strict=True):
        place = f"self->parameters.{parameter.named.name}{leaf.source}"
        source = leaf.element.source
        if leaf.length is None or len({repr(number) for number in given}) == 1:
            found.append(looped(leaf, lines(f"{place} = {literal(given[0], source)};")))
        else:
            each = (f"{place.replace('[i]', f'[{n}]')} = {literal(number, source)};" for n, number in enumerate(given))
            found.append(joined(lines(text) for text in each))
    return joined(found)


def load_function(scope: Scope) -> Lines:
    """Defaults, and what is stored over them."""
    if not scope.plan.parameters:
        return ()
    parts = [part for each in scope.plan.parameters for part in (defaults(each, each.default), _loaded(each, scope))]
    needs_index = any(leaf.length is not None for each in scope.plan.parameters for leaf in each.value.leaves)
    body = [lines("uint32_t i;\n") if needs_index else (), *parts]
    head = f"static void {scope.prefix}_LoadParameters({scope.self_argument})"
    return function(head, body, "The defaults, and over them what is stored and within its limits.")


def _loaded(parameter: Parameter, scope: Scope) -> Lines:
    name = parameter.named.name
    stored, place = f"self->stored.{name}", f"self->parameters.{name}"
    take = _copied(parameter, f"{stored}.value", place)
    judged = [lines(f"self->parameter.{name} = {verdict};") if parameter.range_error else ()
              for verdict in (scope.absent, scope.present)]  # fmt: skip
    if not is_checked(parameter):
        return joined([block(f"if ({stored}.is_there)", [take]), judged[0]])
    inside = f"{scope.prefix}_IsWithin_{name}({_handed(parameter, f'{stored}.value')})"
    instead = joined([defaults(parameter, parameter.replacement), judged[1]])
    return joined([
        judged[0], block(f"if ({stored}.is_there)", [choice([(inside, take), ("", instead)])])
    ])  # fmt: skip


def _handed(parameter: Parameter, place: str) -> str:
    wire = parameter.value.wire
    return f"&{place}" if wire.is_struct and wire.length is None else place


def _copied(parameter: Parameter, source: str, target: str) -> Lines:
    if parameter.value.wire.length is not None:
        return lines(f"(void)memcpy({target}, {source}, sizeof({target}));")
    return lines(f"{target} = {source};")


def set_function(scope: Scope) -> Lines:
    """All parameters change, or none."""
    if not scope.plan.parameters:
        return ()
    p = scope.prefix
    conditions = [
        f"{p}_IsWithin_{each.named.name}({_handed(each, f'parameters->{each.named.name}')})"
        for each in scope.plan.parameters if is_checked(each)
    ]  # fmt: skip
    body = [
        lines("const bool are_within = " + ("\n    && ".join(conditions) or "true") + ";\n"),
        block("if (are_within)", [lines("self->parameters = *parameters;")]),
        lines("return are_within;"),
    ]
    return function(f"bool {p}_SetParameters({scope.self_argument}, const {p}_Parameters *parameters)", body)


def learn_functions(scope: Scope) -> list[Lines]:
    """What the function has learned, kept to be stored."""
    return [_learn(each, each.learned, scope) for each in scope.plan.parameters if each.learned]


def _learn(parameter: Parameter, learned: Value, scope: Scope) -> Lines:
    name = parameter.named.name
    ends = _back(parameter, scope, f"self->stored.{name}.value")
    keep = joined([assigned(learned, ends, scope.prefix), lines(f"self->stored.{name}.is_there = true;")])
    checked = (
        [flag(learned), check(learned, ends), block("if (is_within)", [keep])] if is_checked(parameter) else [keep]
    )
    head = f"static void {scope.prefix}_Learn_{name}({scope.self_argument})"
    body = [index(learned), known_values(learned), *checked]
    return function(head, body, f"{parameter.named.comment}: kept if it is within its limits")


def learned(scope: Scope) -> Lines:
    """All that has been learned, kept."""
    return joined(
        lines(f"{scope.prefix}_Learn_{each.named.name}(self);") for each in scope.plan.parameters if each.learned
    )
