"""Values of inputs, outputs, parameters and arguments in C: checked, converted, or taken from a constant."""

from collections.abc import Sequence
from typing import NamedTuple

from sigcat.adapter.core.c.lines import Line, Lines, block, function, indented, joined, lines
from sigcat.adapter.core.c.literals import converted, is_beyond_float, literal, within
from sigcat.adapter.core.numbers import Number, NumberType
from sigcat.adapter.core.plan import Element, Leaf, Value, WireType
from sigcat.function.document.document import Pointer
from sigcat.function.document.text_filters import block_comment
from sigcat.function.function_json.conversion import IDENTITY


def declared(wire: WireType, name: str) -> str:
    """A member or variable that holds a value as it is received or sent."""
    return f"{wire.c} {name}{f'[{wire.length}]' if wire.length is not None else ''}"


def as_argument(wire: WireType, name: str) -> str:
    """The argument by which a value is handed over."""
    if wire.length is not None or wire.is_struct:
        return f"const {wire.c} *{name}"
    return f"{wire.c} {name}"


def stored(wire: WireType, source: str, target: str) -> Lines:
    """A value that came as an argument, kept."""
    if wire.length is not None:
        return lines(f"(void)memcpy({target}, {source}, sizeof({target}));")
    return lines(f"{target} = {'*' if wire.is_struct else ''}{source};")


class Ends(NamedTuple):
    """Source and target of a value."""

    source: str
    target: str
    names: str
    """Prefix of the functions of its enumerations: `CoreAcc_Adapter_Step_SpdLimUnit`."""
    pointer: Pointer
    put: str = ""
    """Function that puts a number into an enumeration of C++, where the target is one."""
    is_read: bool = False
    """Whether the source is a variable of C++, which may be an enumeration."""

    def assigned(self, target: str, number: str, element: Element) -> str:
        """A number assigned to a place of the target."""
        return f"{self.put}({target}, {number});" if self.put and element.is_enumeration else f"{target} = {number};"

    def number(self, source: str, element: Element) -> str:
        """A number of the source."""
        is_cast = self.is_read and element.is_enumeration
        return f"({element.source.c}){source}" if is_cast else source


def looped(leaf: Leaf, body: Lines) -> Lines:
    """Statement for a number, for each number of an array."""
    if leaf.length is None:
        return body
    return block(f"for (i = 0U; i < {leaf.length}U; i++)", [body])


def needs_index(value: Value) -> bool:
    """Whether any part of a value is an array."""
    return any(leaf.length is not None for leaf in value.leaves)


def index(value: Value) -> Lines:
    """The variable that runs over arrays, where there are any."""
    return lines("uint32_t i;") if needs_index(value) else ()


def index_of_check(value: Value) -> Lines:
    """The variable that runs over arrays in a check: not every array has something to check."""
    is_looped = any(leaf.length is not None and _may_be_outside(leaf) for leaf in value.leaves)
    return index(value) if is_looped else ()


def check(value: Value, ends: Ends) -> Lines:
    """Sets `is_within`: whether every number is within its range. It is declared here where there is one number."""
    conditions = [(leaf, _condition(leaf, number, ends)) for number, leaf in enumerate(value.leaves)]
    if value.is_bare:
        return lines(f"const bool is_within = {conditions[0][1] or 'true'};", ends.pointer)
    found = []
    for leaf, condition in conditions:
        if condition:
            flag_name = passing(value) if leaf.element.names is not None else "is_within"
            text = f"{flag_name} = {flag_name} && {_grouped(condition)};"
            found.append(looped(leaf, lines(text, ends.pointer)))
    return joined([*found, lines("is_within = is_within && is_named;") if _is_mixed(value) else ()])


def passing(value: Value) -> str:
    """The flag that says whether a value may pass where nothing replaces it: every enumeration has a name."""
    return "is_named" if _is_mixed(value) else "is_within"


def _is_mixed(value: Value) -> bool:
    """Whether nothing replaces a value, and of its numbers some may pass out of range and others may not."""
    has_names = {leaf.element.names is not None for leaf in value.leaves if _may_be_outside(leaf)}
    return not value.is_replaced and len(has_names) > 1


def _may_be_outside(leaf: Leaf) -> bool:
    return leaf.element.names is not None or within("", leaf.element) is not None


def _grouped(condition: str) -> str:
    return f"({condition})" if " && " in condition else condition


def flag(value: Value) -> Lines:
    """The declaration of `is_within`, before several numbers are checked."""
    named = "\nbool is_named = true;" if _is_mixed(value) else ""
    return () if value.is_bare else lines(f"bool is_within = true;{named}")


def _condition(leaf: Leaf, number: int, ends: Ends) -> str | None:
    source = f"{ends.source}{leaf.source}"
    if leaf.element.names is not None:
        return f"{names_function(ends, number)}({_whole(source, leaf, ends)}, &known_{number})"
    return within(source, leaf.element)


def _whole(source: str, leaf: Leaf, ends: Ends) -> str:
    """A number that is looked up: a wider variable than declared is not cut."""
    return f"({_widest(leaf.element)}){source}" if ends.is_read else source


def _widest(element: Element) -> str:
    return "uint64_t" if element.source.name == "uint64" else "int64_t"


def known_values(value: Value) -> Lines:
    """Variables that enumerations are converted to while they are checked."""
    return tuple(
        Line(f"{leaf.element.target.c} known_{number} = {literal(leaf.default[0], leaf.element.target)};")
        for number, leaf in enumerate(value.leaves)
        if leaf.element.names is not None
    )


def assigned(value: Value, ends: Ends, prefix: str, *, quiet: bool = False, is_new: bool = False) -> Lines:
    """The value, converted into its target. `is_new`: no check has just looked up the names of its enumerations."""
    found = []
    for number, leaf in enumerate(value.leaves):
        source, target = f"{ends.source}{leaf.source}", f"{ends.target}{leaf.target}"
        if leaf.element.names is not None:
            named = f"(void){names_function(ends, number)}({_whole(source, leaf, ends)}, &known_{number});\n"
            put = ends.assigned(target, f"known_{number}", leaf.element)
            text = f"{named if is_new or leaf.length is not None else ''}{put}"
        else:
            found_number = _converted(ends.number(source, leaf.element), leaf, number, ends, prefix)
            text = ends.assigned(target, _quiet(found_number, leaf.element, prefix, quiet), leaf.element)
        found.append(looped(leaf, lines(text, ends.pointer)))
    return joined(found)


def _converted(source: str, leaf: Leaf, number: int, ends: Ends, prefix: str) -> str:
    return converted(source, leaf.element, given(leaf.default, leaf, f"{ends.names}_default_{number}"), prefix)


def _quiet(text: str, element: Element, prefix: str, quiet: bool) -> str:
    """A number whose NaN has the usual bits, where one may come so far."""
    target = element.target
    is_copied = element.source == target and element.conversion == IDENTITY
    is_quiet = is_beyond_float(element) and not is_copied  # the conversion has seen to it
    can_be_nan = quiet and target.is_floating and element.source.is_floating and not is_quiet
    return f"{prefix}_Quiet{target.c.capitalize()}({text})" if can_be_nan else text


def constant(value: Value, kind: str, ends: Ends) -> Lines:
    """A constant value put into the target: its `init`, its `default`, or its `replacement`."""
    found = []
    for number, leaf in enumerate(value.leaves):
        numbers = _numbers(leaf, kind)
        constant_number = given(numbers, leaf, f"{ends.names}_{kind}_{number}")
        text = ends.assigned(f"{ends.target}{leaf.target}", constant_number, leaf.element)
        found.append(looped(leaf, lines(text, ends.pointer)))
    return joined(found)


def _numbers(leaf: Leaf, kind: str) -> tuple[Number, ...]:
    if kind == "replacement":
        return leaf.replacement or leaf.default
    return leaf.init if kind == "init" else leaf.default


def given(numbers: tuple[Number, ...], leaf: Leaf, table: str) -> str:
    """A constant number; of an array with different ones that of its table."""
    target = leaf.element.target
    if len({repr(number) for number in numbers}) == 1:
        return literal(numbers[0], target)
    return f"{table}[i]"


def tables(value: Value, names: str, kinds: Sequence[str]) -> list[Lines]:
    """Tables of constants, for arrays whose elements differ."""
    found = []
    for number, leaf in enumerate(value.leaves):
        for kind in kinds:
            numbers = _numbers(leaf, kind)
            if len({repr(each) for each in numbers}) > 1:
                found.append(_table(numbers, leaf.element.target, f"{names}_{kind}_{number}"))
    return found


def _table(numbers: tuple[Number, ...], target: NumberType, name: str) -> Lines:
    texts = [literal(number, target) for number in numbers]
    rows = [", ".join(texts[start : start + 8]) for start in range(0, len(texts), 8)]
    body = indented(lines(",\n".join(rows)))
    return (Line(f"static const {target.c} {name}[{len(numbers)}] = {{"), *body, Line("};"))


# -- enumerations -------------------------------------------------------------------------------------------------


def names_function(ends: Ends, number: int) -> str:
    """Name of the function that converts an enumeration by name."""
    return f"{ends.names}_Named{number or ''}"


def names_functions(value: Value, ends: Ends) -> list[Lines]:
    """Functions that convert enumerations by name, and say whether a number has one."""
    return [
        _names_function(leaf.element, names_function(ends, number), value.wire)
        for number, leaf in enumerate(value.leaves)
        if leaf.element.names is not None
    ]


def _names_function(element: Element, name: str, wire: WireType) -> Lines:
    texts = {number: text for text, number in wire.symbols}
    cases = [_case(source, target, element, texts) for source, target in (element.names or {}).items()]
    switch = block("switch (source)", [*cases, lines("default:\n    is_known = false;\n    break;")])
    body = [lines("bool is_known = true;"), switch, lines("return is_known;")]
    return function(f"static bool {name}({_widest(element)} source, {element.target.c} *target)", body)


def _case(source: int, target: int, element: Element, texts: dict[int, str]) -> Lines:
    name = texts.get(source) or texts.get(target)
    return lines(f"""
        case {literal(source, element.source)}:{f" {block_comment(name)}" if name else ""}
            *target = {literal(target, element.target)};
            break;
    """)
