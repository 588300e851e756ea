"""Values between the catalogue and the code, as C writes them: `values.c.j2` checks and converts them."""

from collections.abc import Collection, Iterator, Sequence
from fractions import Fraction
from typing import NamedTuple

from sigcat.adapter.core.c.names.scope import Scope
from sigcat.adapter.core.c.values.conversions import converted, is_beyond_float, limits, scaling, within
from sigcat.adapter.core.c.values.literals import literal
from sigcat.adapter.core.numbers import Number
from sigcat.adapter.core.plan import Element, Leaf, Value
from sigcat.function.document.document import Pointer
from sigcat.function.function_json.conversion import IDENTITY
from sigcat.names import screaming_snake_case


class Ends(NamedTuple):
    """Source and target of a value."""

    source: str
    target: str
    prefix: str
    """Prefix of all functions: `CoreAcc_Adapter`."""
    name: str
    """Ending of the names of its functions, tables and constants: `Step_SpdLimUnit`."""
    pointer: Pointer
    put: str = ""
    """Function that puts a number into an enumeration of C++, where the target is one."""
    is_read: bool = False
    """Whether the source is a variable of C++, which may be an enumeration."""
    is_from_code: bool = False
    """Whether the source is a variable of the code: a NaN gets the usual bits, and names are those of the target."""

    @property
    def names(self) -> str:
        """Prefix of its functions and tables: `CoreAcc_Adapter_Step_SpdLimUnit`."""
        return f"{self.prefix}_{self.name}"

    def constant(self, kind: str, leaf: int) -> str:
        """Name of a constant: `CORE_ACC_ADAPTER_FACTOR_Step_SpdLim`; of a later leaf with its number behind the kind."""
        return f"{screaming_snake_case(self.prefix)}_{kind}{leaf or ''}_{self.name}"


def to_variable(source: str, variable: str, name: str, pointer: Pointer, scope: Scope) -> Ends:
    """The ends of a value that a variable of the code gets."""
    return Ends(source, variable, scope.prefix, name, pointer, put=scope.put)


def from_variable(variable: str, target: str, name: str, pointer: Pointer, scope: Scope) -> Ends:
    """The ends of a value that a variable of the code has."""
    return Ends(variable, target, scope.prefix, name, pointer, is_read=scope.is_cpp, is_from_code=True)


class Part(NamedTuple):
    """A number of a value, or each number of an array."""

    target: str
    type: str
    """Type of the target."""
    length: int | None
    """Elements of an array."""
    put: str
    """Function that puts a number into the target; empty where `=` does."""
    condition: str
    """Whether it is within its range; empty if it always is."""
    flag: str
    """Variable that says whether this and other numbers are."""
    lookup: str
    """Call that converts an enumeration by name; empty for other numbers."""
    known: str
    """Variable that it is converted to."""
    known_first: str
    converted: str
    init: str
    default: str
    replacement: str

    @property
    def grouped(self) -> str:
        """The converted number, as an operand."""
        return self.converted if self.converted.startswith("(") or " " not in self.converted else f"({self.converted})"


class Case(NamedTuple):
    """A number of an enumeration, its name, and its number in the target."""

    source: str
    name: str | None
    target: str


class Constant(NamedTuple):
    """A number that has a name."""

    name: str
    number: str
    comment: str
    """Its exact value where the number is rounded, and its units; empty if there is none of them."""


class Lookup(NamedTuple):
    """A function that converts an enumeration by name."""

    name: str
    source: str
    """Type of its argument."""
    target: str
    cases: Sequence[Case]


class Table(NamedTuple):
    """Constants for an array whose elements differ."""

    name: str
    type: str
    numbers: Sequence[str]


class Transfer(NamedTuple):
    """A value on its way from a source to a target."""

    parts: Sequence[Part]
    pointer: Pointer
    is_bare: bool
    """Whether it is one number, and not an array or a struct."""
    is_checked: bool
    is_mixed: bool
    """Whether nothing replaces it, and of its numbers some may pass out of range and others may not."""
    constants: Sequence[Constant]
    """Its limits, factors and offsets."""
    lookups: Sequence[Lookup]
    tables: Sequence[Table]

    @property
    def has_arrays(self) -> bool:
        """Whether any part of it is an array."""
        return any(part.length is not None for part in self.parts)

    @property
    def checks_arrays(self) -> bool:
        """Whether any part with a range is an array."""
        return any(part.length is not None and part.condition for part in self.parts)

    @property
    def has_range(self) -> bool:
        """Whether a number can be out of range."""
        return any(part.condition for part in self.parts)

    @property
    def checks_source(self) -> bool:
        """Whether its check reads the source: an empty range does not."""
        return any(part.condition not in ("", "false") for part in self.parts)

    @property
    def passing(self) -> str:
        """The flag that says whether a value may pass where nothing replaces it: every enumeration has a name."""
        return "is_named" if self.is_mixed else "is_within"


def transfer(value: Value, ends: Ends, kinds: Collection[str] = ()) -> Transfer:
    """A value between its ends. `kinds` are the constants that its target gets: `init`, `default`, `replacement`."""
    has_names = {leaf.element.names is not None for leaf in value.leaves if _may_be_outside(leaf)}
    is_mixed = not value.is_replaced and len(has_names) > 1
    parts = [
        _part(number, leaf, ends, is_mixed=is_mixed, is_bare=value.is_bare) for number, leaf in enumerate(value.leaves)
    ]
    return Transfer(
        parts=parts,
        pointer=ends.pointer,
        is_bare=value.is_bare,
        is_checked=value.is_checked,
        is_mixed=is_mixed,
        constants=[each for number, leaf in enumerate(value.leaves) for each in _constants(number, leaf.element, ends)],
        lookups=[*_lookups(value, ends)],
        tables=[*_tables(value, parts, ends, kinds)],
    )


_LARGEST_DENOMINATOR = 10_000
"""Largest denominator of a fraction that says more than its decimal number."""


def _constants(number: int, element: Element, ends: Ends) -> Iterator[Constant]:
    if element.names is not None:
        return
    for kind, text in limits(element).items():
        yield Constant(ends.constant(kind, number), _grouped(text), element.units[0])
    if element.conversion != IDENTITY:
        units = " to ".join(element.units) if all(element.units) else ""
        for kind, text in scaling(element).items():
            exact = element.conversion.factor if kind.startswith("FACTOR") else element.conversion.offset
            is_rounded = Fraction(text.rstrip("F")) != exact and not kind.endswith("REST")
            is_short = exact.denominator <= _LARGEST_DENOMINATOR
            comment = ", ".join(part for part in (str(exact) if is_rounded and is_short else "", units) if part)
            yield Constant(ends.constant(kind, number), _grouped(text), comment)


def _grouped(text: str) -> str:
    return f"({text})" if text.startswith("-") else text


def _may_be_outside(leaf: Leaf) -> bool:
    return leaf.element.names is not None or within("", leaf.element) is not None


def _part(number: int, leaf: Leaf, ends: Ends, *, is_mixed: bool, is_bare: bool) -> Part:
    element, source, known = leaf.element, f"{ends.source}{leaf.source}", f"known_{number}"
    lookup = ""
    if element.names is not None:
        whole = f"({_widest(element)}){source}" if ends.is_read else source
        lookup = f"{_lookup_name(number, ends)}({whole}, &{known})"
    condition = lookup or within(source, element, lambda kind, _: ends.constant(kind, number)) or ""
    init, default, replacement = (_constant(leaf, kind, number, ends) for kind in ("init", "default", "replacement"))
    return Part(
        target=f"{ends.target}{leaf.target}",
        type=element.target.c,
        length=leaf.length,
        put=ends.put if element.is_enumeration else "",
        condition=condition if is_bare or " && " not in condition else f"({condition})",
        flag="is_named" if is_mixed and lookup else "is_within",
        lookup=lookup,
        known=known,
        known_first=literal(leaf.default[0], element.target),
        converted=known if lookup else _converted(number, source, element, default, ends),
        init=init,
        default=default,
        replacement=replacement,
    )


def _widest(element: Element) -> str:
    """Type of an argument that cuts no number off, even if the variable is wider than declared."""
    return "uint64_t" if element.source.name == "uint64" else "int64_t"


def _lookup_name(number: int, ends: Ends) -> str:
    return f"{ends.names}_Named{number or ''}"


def _converted(leaf: int, source: str, element: Element, default: str, ends: Ends) -> str:
    cast = f"({element.source.c}){source}" if ends.is_read and element.is_enumeration else source
    number = converted(cast, element, default, lambda kind, _: ends.constant(kind, leaf))
    target = element.target
    is_copied = element.source == target and element.conversion == IDENTITY
    is_quiet = is_beyond_float(element) and not is_copied  # the conversion has seen to it
    can_be_nan = ends.is_from_code and target.is_floating and element.source.is_floating and not is_quiet
    return f"Sigcat_Quiet{target.c.capitalize()}({number})" if can_be_nan else number


def _constant(leaf: Leaf, kind: str, number: int, ends: Ends) -> str:
    """A constant number; of an array with different ones that of its table."""
    numbers = _numbers(leaf, kind)
    return f"{_table_name(kind, number, ends)}[i]" if _differ(numbers) else literal(numbers[0], leaf.element.target)


def _numbers(leaf: Leaf, kind: str) -> tuple[Number, ...]:
    if kind == "replacement":
        return leaf.replacement or leaf.default
    return leaf.init if kind == "init" else leaf.default


def _differ(numbers: tuple[Number, ...]) -> bool:
    return len({repr(number) for number in numbers}) > 1  # 0.0 and -0.0 differ


def _table_name(kind: str, number: int, ends: Ends) -> str:
    return f"{ends.names}_{kind}_{number}"


def _tables(value: Value, parts: Sequence[Part], ends: Ends, kinds: Collection[str]) -> Iterator[Table]:
    for number, (leaf, part) in enumerate(zip(value.leaves, parts, strict=True)):
        for kind in ("init", "default", "replacement"):
            numbers = _numbers(leaf, kind)
            is_used = kind in kinds or (kind == "default" and part.default in part.converted)  # instead of NaN
            if is_used and _differ(numbers):
                texts = [literal(each, leaf.element.target) for each in numbers]
                yield Table(_table_name(kind, number, ends), part.type, texts)


def _lookups(value: Value, ends: Ends) -> Iterator[Lookup]:
    texts = {number: text for text, number in value.wire.symbols}
    for number, leaf in enumerate(value.leaves):
        element = leaf.element
        if element.names is not None:
            cases = [
                Case(
                    literal(source, element.source),
                    texts.get(target if ends.is_from_code else source),
                    literal(target, element.target),
                )
                for source, target in element.names.items()
            ]
            yield Lookup(_lookup_name(number, ends), _widest(element), element.target.c, cases)


class Way(NamedTuple):
    """A condition, and the number that the target gets under it: `converted`, or a constant."""

    condition: str
    """Empty in the last one."""
    kind: str


def merged(ways: Sequence[Way], value: Transfer) -> tuple[Way, ...]:
    """Ways without conditions whose constants are those of the last way."""
    *others, last = ways
    while others and _all(others[-1].kind, value) == _all(last.kind, value):
        others.pop()
    return (*others, last)


def _all(kind: str, value: Transfer) -> list[str]:
    return [getattr(part, kind) for part in value.parts]
