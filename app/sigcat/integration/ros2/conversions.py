"""From the variables of the code to the values of the catalogue, and back."""

from collections.abc import Mapping, Sequence
from fractions import Fraction

from sigcat import codes
from sigcat.function.function_json.conversion import IDENTITY, Linear, as_decimal, as_number, of_text
from sigcat.function.function_json.datatypes.datatype import Datatype, EnumerationValue
from sigcat.function.function_json.datatypes.primitive_types import value_range
from sigcat.function.function_json.interfaces.data_interfaces import DataQueue, ParameterInterface, Signal
from sigcat.integration.datatypes import Spelling
from sigcat.integration.finding_collector import FindingCollector, Subject
from sigcat.integration.ros2.messages.field_types import FieldType, c_definition, code_type, symbols_of
from sigcat.integration.ros2.model import Conversion, SymbolMap

_FLOATING = ("float", "double")


def to_catalogue(
    item: Signal | DataQueue | ParameterInterface, interface: Subject, findings: FindingCollector
) -> Linear:
    """From the number in the code to the value in the catalogue's unit."""
    return _linear(item.factor, item.offset, interface, findings).then(physical(item, interface, findings))


def physical(item: Signal | DataQueue | ParameterInterface, interface: Subject, findings: FindingCollector) -> Linear:
    """From the value in the code's unit to the value in the catalogue's."""
    return _linear(item.conversion_factor, item.conversion_offset, interface, findings)


def conversion(
    name: str, field: str, reference: str, kind: FieldType, linear: Linear, table: Mapping[str, Datatype],
    written: str, *, is_outgoing: bool, has_number: bool = False, is_named: bool = False,
) -> Conversion | None:  # fmt: skip
    """The conversion between a variable and a field, or None if they are the same. `written`: the field's datatype.

    `linear` leads from the variable to the field. `has_number`: the message has the number of an enumeration and its text. `is_named`: names are
    listed where numbers are the same, too.
    """
    result = written if is_outgoing else c_definition(reference, table)
    code = code_type(reference, table)
    if kind.element is None or code is None:
        return Conversion(name=name, return_type=result, field=field, kind="Members")
    own = symbols_of(reference, table)
    if kind.symbols and (kind.is_text or is_named or set(own) != set(kind.symbols)):
        maps = _symbol_maps(own, kind, has_number=has_number or not kind.is_text)
        return Conversion(name=name, return_type=result, field=field, kind="Symbols", symbols=maps)
    if linear == IDENTITY and code.vss == kind.element.vss:
        return None
    way = linear if is_outgoing else linear.inverse
    target, source = (kind.element, code) if is_outgoing else (code, kind.element)
    return Conversion(
        name=name,
        return_type=result,
        field=field,
        kind="Cast" if way == IDENTITY else "Linear",
        factor=None if way == IDENTITY else as_decimal(way.factor),
        offset=None if way == IDENTITY else as_decimal(way.offset),
        rounding="Nearest" if _rounds(source, target, way) else None,
        saturates=_narrows(source, target, way) or None,
    )


def _symbol_maps(own: Sequence[EnumerationValue], kind: FieldType, *, has_number: bool) -> tuple[SymbolMap, ...]:
    """From the numbers of the code to texts and numbers of the message, by name."""
    sent = {symbol.symbol: symbol.value for symbol in kind.symbols}
    return tuple(
        SymbolMap(text=each.symbol, value=each.value, number=sent.get(each.symbol) if has_number else None)
        for each in own
    )


def converted(value: float | None, linear: Linear) -> float | None:
    """A number, converted exactly."""
    return None if value is None else as_number(linear(Fraction(repr(value))))


def _rounds(source: Spelling, target: Spelling, way: Linear) -> bool:
    is_integer = target.vss not in _FLOATING
    return is_integer and (source.vss in _FLOATING or way.factor.denominator != 1 or way.offset.denominator != 1)


def _narrows(source: Spelling, target: Spelling, way: Linear) -> bool:
    """Whether some value of the source's datatype does not fit the target's."""
    given, held = value_range(source.vss), value_range(target.vss)
    if given is None or held is None:
        return False
    ends = sorted((way(given[0]), way(given[1])))
    return ends[0] < Fraction(held[0]) or ends[1] > Fraction(held[1])


def _linear(factor: object, offset: object, interface: Subject, findings: FindingCollector) -> Linear:
    if factor is None and offset is None:
        return IDENTITY
    written = (str(missing if given is None or given == "" else given) for given, missing in ((factor, 1), (offset, 0)))
    numbers = [of_text(text) for text in written]
    if numbers[0] is None or numbers[1] is None or numbers[0] == 0:
        message = (
            f"{interface}: the factor must be a non-zero number and the offset a number, not {factor!r} and {offset!r}."
        )
        findings.report(codes.CONVERSION_NOT_A_NUMBER, message, interface, "Correct them in the function.")
        return IDENTITY
    return Linear(numbers[0], numbers[1])
