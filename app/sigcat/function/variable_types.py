"""Types of variables in C, compared with the datatypes that are declared for them."""

import re
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from typing import NamedTuple

from sigcat.function.c_project.c_types import vss_datatype
from sigcat.function.c_project.declarations import Constant, CType, Member, Record
from sigcat.function.function_json.datatypes.datatype import Datatype, TypeField
from sigcat.function.function_json.variables import CodeVariable
from sigcat.names import did_you_mean, words

_SIZED = re.compile(r"(?P<unsigned>u?)int(?P<bits>8|16|32|64)_t")
_FLOATING = {"float": 32, "double": 64}
_ENUMERATION = 32
"""Bits of an enumeration of the usual size."""
_DEEPEST = 16
_CORRECT = "Correct the code, or the datatype."
_PLAIN = "Use a plain number type of C, or convert the value in the code."

_Limits = tuple[Fraction | None, Fraction | None]
"""Smallest and largest number that a variable gets; None where nothing limits it."""


class Seen(NamedTuple):
    """A variable in the headers."""

    type: CType | None
    """None of a function and of a bit field."""
    value: CType | None
    """Type of its value."""
    is_bit_field: bool
    width: int | None = None
    """Bits of a bit field, where they are known."""


class Types(NamedTuple):
    """Types that both sides refer to, and how values of a variable are compared."""

    datatypes: Mapping[str, Datatype]
    records: Mapping[str, Record]
    constants: Mapping[str, tuple[Constant, ...]]
    """Constants of the enumerations of the code."""
    members: Mapping[str, str]
    """Names of members in the code, by their names in the catalogue."""
    is_read: bool
    """Whether the adapter reads the variable: it may then be narrower than declared."""
    is_cpp: bool
    """Whether a reference looks like a pointer."""
    is_replaced: bool
    """Whether a value outside the declared limits is replaced."""


class Misfit(NamedTuple):
    """A difference between a variable and its declaration, and its fix."""

    message: str
    fix: str


class _Part(NamedTuple):
    """A variable, or a part of one, and the datatype that is declared for it."""

    expression: str
    datatype: Datatype
    types: Types
    path: tuple[str, ...] = ()
    """Names of the members that lead to it, in the catalogue."""


def _misfit(expression: str, wanted: str, has: str, fix: str = _CORRECT) -> Misfit:
    return Misfit(f"{expression!r} must {wanted}; the header has {has}.", fix)


def misfits(variable: CodeVariable, seen: Seen, types: Types) -> Iterator[Misfit]:
    """Yield the differences of a variable. A queue needs an array with room for its values."""
    expression, datatype, found = variable.expression, types.datatypes.get(variable.datatype or ""), seen.type
    if found is None:
        yield from _of_value(variable, seen, datatype, types)
        return
    kind, count = found.target, variable.elements
    if count and kind.kind == "array" and kind.of:
        if kind.length and kind.length < count:
            yield _misfit(expression, f"have at least {count} elements", f"{kind.length}")
        kind = kind.of
    is_text = datatype is not None and datatype.vss_datatype == "string"
    is_array = datatype is not None and datatype.kind == "array"
    if datatype is None and kind.kind in ("array", "record", "other"):  # a number that both sides agree on
        yield _misfit(expression, f"be {variable.c_type or 'an integer'}", _shown(kind))
    elif found.kind == "pointer" and (is_array or not (count or is_text or types.is_cpp)):
        yield _misfit(expression, f"be {_expected(datatype)}", "a pointer")
    elif datatype is not None:
        yield from _differences(_Part(expression, datatype, types), kind)


def _expected(datatype: Datatype | None) -> str:
    if datatype is not None and datatype.kind == "array":
        return f"an array of {datatype.length}" if datatype.length else "an array"
    return "a struct" if datatype is not None and datatype.kind == "struct" else "one value"


def _of_value(variable: CodeVariable, seen: Seen, datatype: Datatype | None, types: Types) -> Iterator[Misfit]:
    """Yield the difference of an expression without the type of a variable: a bit field, or a function."""
    if seen.value is None:
        return
    if seen.is_bit_field:
        if datatype is not None:
            part = _Part(variable.expression, datatype, types)
            yield from _of_bit_field(part, seen.value, seen.width, variable.limits)
    elif seen.value.kind == "pointer" and (datatype is None or _is_number(datatype)):
        yield _misfit(variable.expression, "be one value", "a function")


def _of_bit_field(part: _Part, kind: CType, width: int | None, limits: _Limits) -> Iterator[Misfit]:
    """Yield the difference of a bit field and a number: its kind, or that it has too few bits."""
    expression, datatype, types, _ = part
    declared, wanted = _number(datatype), f"be {datatype.c_definition}"
    if kind.kind in ("number", "enumeration") and declared is not None and declared.sort == "floating":
        yield _misfit(expression, wanted, "a bit field")
        return
    if width is None or kind.sort not in ("signed", "unsigned", "boolean"):
        return
    has = _Number("signed" if kind.sort == "signed" else "unsigned", 1 if kind.sort == "boolean" else width)
    shown = f"a bit field of {width} {'bit' if width == 1 else 'bits'} ({kind.name})"
    if types.is_read:
        if declared is not None and not has.fits(declared):
            yield _misfit(expression, wanted, shown)
        return
    least, most = _numbers(datatype, declared, limits if types.is_replaced else (None, None))
    if not (has.holds(least) and has.holds(most)):
        fix = "limit the value with `min`, `max` and `rangeErrorAction`" if declared else "correct the numbers"
        if not declared and has.sort == "signed" and least >= 0:
            fix = "make it unsigned"
        yield _misfit(expression, f"hold {least} to {most}", shown, f"Widen the bit field, or {fix}.")


def _numbers(datatype: Datatype, declared: "_Number | None", limits: _Limits) -> tuple[int, int]:
    """The smallest and the largest number that a variable of a datatype has to hold."""
    numbers = [each.value for each in datatype.symbols or ()]
    if numbers or declared is None:
        return (min(numbers, default=0), max(numbers, default=1))
    least, most = limits
    lowest, highest = declared.ends
    return (
        lowest if least is None else max(lowest, round(least)),
        highest if most is None else min(highest, round(most)),
    )


def _is_number(datatype: Datatype) -> bool:
    return datatype.kind is None and datatype.vss_datatype != "string"


class _Number(NamedTuple):
    """Kind and size of a number."""

    sort: str
    bits: int

    def fits(self, other: "_Number") -> bool:
        """Whether every number of this type is one of another type."""
        is_widened = (self.sort, other.sort) == ("unsigned", "signed") and self.bits < other.bits
        return is_widened or (self.sort == other.sort and self.bits <= other.bits)

    def holds(self, number: int) -> bool:
        """Whether a whole number is one of this type."""
        least, most = self.ends
        return self.sort not in ("signed", "unsigned") or least <= number <= most

    @property
    def ends(self) -> tuple[int, int]:
        """The smallest and the largest number of an integer type."""
        if self.sort == "signed":
            return (-(1 << self.bits - 1), (1 << self.bits - 1) - 1)
        return (0, (1 << self.bits) - 1)


def _differences(part: _Part, kind: CType) -> Iterator[Misfit]:
    expression, datatype, types, path = part
    if len(path) > _DEEPEST:
        return
    if datatype.kind == "array":
        yield from _of_array(part, kind)
    elif datatype.kind == "struct":
        if kind.kind in ("number", "array", "enumeration", "pointer"):
            yield _misfit(expression, f"be {_expected(datatype)}", _shown(kind))
        elif kind.key in types.records and types.records[kind.key].is_complete:
            yield from _of_members(part, types.records[kind.key])
    elif kind.kind in ("array", "record", "pointer") and datatype.vss_datatype != "string":
        yield _misfit(expression, f"be {_expected(datatype)}", _shown(kind))
    elif kind.kind == "other" and not types.is_cpp:  # of C++ it may be a class that converts itself
        yield _misfit(expression, f"be {datatype.c_definition}", kind.name, _PLAIN)
    elif kind.kind == "enumeration":
        yield from _of_enumeration(part, kind)
        yield from _of_constants(part, types.constants.get(kind.key, ()))
    elif kind.kind == "number" and "char" not in kind.names[-1:]:
        yield from _of_number(part, kind)


def _of_array(part: _Part, kind: CType) -> Iterator[Misfit]:
    expression, datatype, types, _ = part
    if kind.kind in ("number", "record"):
        yield _misfit(expression, f"be {_expected(datatype)}", _shown(kind))
    elif kind.kind == "array" and kind.of:
        if not datatype.length:
            message = f"The length of {expression!r} must be known; the datatype has none, and the header {kind.length or 'none'}."
            yield Misfit(message, f"Set `arraysize: {kind.length or 'COUNT'}` of the signal.")
        if datatype.length and kind.length and datatype.length != kind.length:
            yield _misfit(expression, f"have {datatype.length} elements", f"{kind.length}")
        element = types.datatypes.get(datatype.element or "")
        if element is not None and element.kind != "array":
            yield from _differences(part._replace(expression=f"{expression}[0]", datatype=element), kind.of)


def _shown(kind: CType) -> str:
    if kind.kind == "array":
        return f"an array of {kind.length}"
    if kind.kind == "pointer":
        return "a pointer"
    return f"the struct {kind.name}".rstrip() if kind.kind == "record" else kind.name


def _of_members(part: _Part, record: Record) -> Iterator[Misfit]:
    known = {member.name: member for member in record.members}
    for field in part.datatype.fields or ():
        path = (*part.path, field.name)
        name = part.types.members.get(".".join(path), field.name)
        expression, member = f"{part.expression}.{name}", known.get(name)
        if member is None:
            has = f"the struct of the header has {', '.join(known) or 'none'}"
            fix = (
                f"{did_you_mean(name, known)} Name the member of the code with `members`, or correct the code.".lstrip()
            )
            yield Misfit(f"{part.expression!r} must have the member {name!r}; {has}.", fix)
        elif member.is_const and not part.types.is_read:
            yield _misfit(expression, "be a member that the adapter can write", "a constant")
        elif (datatype := part.types.datatypes.get(field.datatype)) is not None:
            yield from _of_member(_Part(expression, datatype, part.types, path), member, field)


def _of_member(part: _Part, member: Member, field: TypeField) -> Iterator[Misfit]:
    if member.width is None:
        yield from _differences(part, member.type)
    else:
        least, most = (None if each is None else Fraction(each) for each in (field.min, field.max))
        yield from _of_bit_field(part, member.type, member.width, (least, most))


def _of_enumeration(part: _Part, kind: CType) -> Iterator[Misfit]:
    """Yield the difference of an enumeration of C and a number: its size, or that it holds no fractions."""
    declared, bits = _number(part.datatype), kind.bits or _ENUMERATION
    is_narrow = declared is not None and (bits > declared.bits if part.types.is_read else bits < declared.bits)
    if declared is not None and (declared.sort == "floating" or is_narrow):
        yield _misfit(part.expression, f"be {part.datatype.c_definition}", f"an enumeration of {bits} bits")


def _of_constants(part: _Part, constants: Sequence[Constant]) -> Iterator[Misfit]:
    """Yield names whose number is not that of the one constant that ends with the same words: of `ECO`, it is `M_ECO`."""
    for each in part.datatype.symbols or ():
        ending = _words(each.symbol)
        same = [constant for constant in constants if _words(constant.name)[-len(ending) :] == ending]
        if len(same) == 1 and same[0].value != each.value:
            message = f"{part.expression!r} must have {each.symbol} as {same[0].value}, the number of {same[0].name} in the header, not as {each.value}."
            yield Misfit(message, "Correct `values`, or the code.")


def _words(name: str) -> list[str]:
    return [word.lower() for word in words(name)]


def _of_number(part: _Part, kind: CType) -> Iterator[Misfit]:
    expression, datatype, types, _ = part
    has, declared = _Number(kind.sort, kind.bits), _number(datatype)
    if declared is None:
        if has.sort == "floating" and datatype.vss_datatype != "string":
            yield _misfit(expression, "be an integer", kind.name, "Correct the code.")
        elif unheld := [each for each in datatype.symbols or () if not has.holds(each.value)]:
            wanted = f"hold {unheld[0].value}, the number of {unheld[0].symbol}"
            yield _misfit(expression, wanted, kind.name, "Correct the number, or the code.")
    elif not (has.fits(declared) if types.is_read else declared.fits(has)):
        fix = f"Give `datatype: {vss_datatype(kind)}`, or correct the code."
        yield _misfit(expression, f"be {datatype.c_definition}", kind.name, fix)


def _number(datatype: Datatype) -> _Number | None:
    """The number that a datatype is; None for a flag, an enumeration or anything else."""
    if datatype.kind is not None:
        return None
    if datatype.c_definition in _FLOATING:
        return _Number("floating", _FLOATING[datatype.c_definition])
    match = _SIZED.fullmatch(datatype.c_definition)
    return _Number("unsigned" if match["unsigned"] else "signed", int(match["bits"])) if match else None
