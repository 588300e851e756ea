"""Data and parameters: from a path and what the author adds, to datatype, unit, range and start values."""

from fractions import Fraction
from typing import Any, NamedTuple

from sigcat.catalogue.model.catalogue import Node
from sigcat.catalogue.model.datatypes import DATATYPES, INTEGER_RANGES, element_of, is_array, is_numeric
from sigcat.catalogue.model.interfaces import category_of
from sigcat.function.build.work import Work
from sigcat.function.declaration.declaration import DataItem, ParameterItem
from sigcat.function.document.document import Pointer
from sigcat.function.function_json.conversion import IDENTITY, Linear, as_number, between, same_kind
from sigcat.function.function_json.datatypes import BY_VSS, value_range
from sigcat.function.function_json.types import Symbols, smallest_integer, symbols_of

Item = DataItem | ParameterItem
Range = tuple[Fraction, Fraction]


class Value(NamedTuple):
    """A data interface, resolved. Numbers are physical values in `unit`."""

    node: Node
    reference: str
    unit: str | None
    min: float | None
    max: float | None
    default: float | None
    init: float | None
    conversion: Linear | None
    """From the code's unit to the catalogue's; None where they are the same."""


class _Code(NamedTuple):
    """How the code holds a value, and what the catalogue says of it."""

    item: Item
    at: Pointer
    node: Node
    datatype: str
    unit: str | None
    symbols: Symbols | None
    to_code: Linear
    """From the catalogue's unit to the code's."""
    scale: Linear
    """From the stored value to the physical one."""


def resolve(item: Item, at: Pointer, work: Work) -> Value | None:
    """Everything that the catalogue knows about an item, as the code wants it; None, with findings, if unusable."""
    node = _data_node(item.path, (*at, "path"), work)
    if node is None:
        return None
    symbols = _symbols(item, at, node, work)
    datatype = _datatype(item, at, node, symbols, work)
    if datatype is None:
        return None
    unit, to_code = _unit(item, at, node, work)
    code = _Code(item, at, node, datatype, unit, symbols, to_code, _scale(item, at, work))
    low, high = _range(code, work)
    reference = work.types.reference(datatype, node.template, symbols, node.values.get("arraysize"))
    conversion = None if to_code == IDENTITY else to_code.inverse
    is_sound = low is None or high is None or low <= high
    init = _init(code, low, high, work) if is_sound else None
    return Value(node, reference, unit, _number(low), _number(high), _default(code), init, conversion)


# -- path ---------------------------------------------------------------------------------------------------------


def _data_node(path: str, at: Pointer, work: Work) -> Node | None:
    node = work.catalogue.get(path)
    if node is None:
        _report_unknown(path, at, work)
        return None
    if not node.is_leaf or category_of(path) != "data":
        words = f"{category_of(path)} interface".replace("_", " ")
        what = "a branch" if not node.is_leaf else f"{'an' if words[0] in 'aeiou' else 'a'} {words}"
        fix = _below(node) if not node.is_leaf else "List it under errors, safetyReactions or modes."
        work.report("F011", at, f"{path!r} is {what}, not a data interface.", fix, path)
        return None
    deprecation = node.values.get("deprecation")
    if deprecation:
        work.report("F012", at, f"{path!r} is deprecated: {deprecation}", path=path)
    return node


def _report_unknown(path: str, at: Pointer, work: Work) -> None:
    instance = work.instances.get(path)
    if instance:
        work.report("F010", at, f"{path!r} names no instance.", f"Name one, such as {instance!r}.", path)
        return
    fix = work.hint(path, work.catalogue.nodes)
    work.report(
        "F010", at, f"The catalogue has no signal {path!r}.", fix or "Define it under `define`, or in an overlay.", path
    )


def _below(node: Node) -> str:
    leaves = [leaf.path for leaf in node.walk() if leaf.is_leaf][:3]
    return f"Name a signal below it, such as {', '.join(map(repr, leaves))}." if leaves else ""


# -- datatype -----------------------------------------------------------------------------------------------------


def _symbols(item: Item, at: Pointer, node: Node, work: Work) -> Symbols | None:
    """Names and numbers of an enumeration, as the code has them."""
    symbols = symbols_of(node)
    if item.values is None:
        return symbols
    at = (*at, "values")
    if symbols is None:
        work.report("F026", at, f"{item.path!r} is no enumeration: the catalogue allows no named values.")
        return None
    missing = [name for name in symbols if name not in item.values]
    if missing:
        fix = "Give each allowed value a number here."
        work.report("F026", at, f"No number stands for {', '.join(map(repr, missing))}.", fix)
    for name in item.values:
        if name not in symbols:
            fix = work.hint(name, symbols) or f"The catalogue allows {', '.join(symbols)}."
            work.report("F026", (*at, name), f"{name!r} is not an allowed value.", fix)
    if len(set(item.values.values())) < len(item.values):
        work.report("F026", at, "Two values have the same number.", "Give each value a number of its own.")
    return item.values


def _datatype(item: Item, at: Pointer, node: Node, symbols: Symbols | None, work: Work) -> str | None:
    """VSS datatype in which the code holds the value."""
    own = str(node.values["datatype"])
    wanted = item.datatype
    if wanted is None or wanted == own:
        return _stored(own, symbols)
    problem, fix = _mismatch(own, wanted, symbols, work)
    if problem:
        work.report("F029", (*at, "datatype"), problem, fix, item.path)
        return None
    return wanted


def _stored(own: str, symbols: Symbols | None) -> str:
    """An enumeration of texts is held as the smallest integer that has room for it."""
    if symbols is None or element_of(own) != "string":
        return own
    return smallest_integer(symbols) + ("[]" if is_array(own) else "")


def _mismatch(own: str, wanted: str, symbols: Symbols | None, work: Work) -> tuple[str, str]:
    if element_of(wanted) not in BY_VSS:
        return f"{wanted!r} is no datatype.", work.hint(wanted, BY_VSS)
    if own not in DATATYPES:
        return f"{own} is a struct; the code cannot hold it as {wanted}.", ""
    if is_array(own) != is_array(wanted):
        return f"The catalogue has {own}, which {wanted} cannot hold.", ""
    holds_numbers = element_of(own) != "string" or symbols is not None
    if holds_numbers == (element_of(wanted) == "string"):
        return f"The catalogue has {own}, which {wanted} cannot hold.", ""
    if symbols is not None and element_of(wanted) not in INTEGER_RANGES:
        return f"An enumeration is held in an integer, not in {wanted}.", ""
    return "", ""


# -- unit and scale -----------------------------------------------------------------------------------------------


def _unit(item: Item, at: Pointer, node: Node, work: Work) -> tuple[str | None, Linear]:
    """The code's unit, and the conversion from the catalogue's to it."""
    own = node.values.get("unit")
    own = own if isinstance(own, str) else None
    if item.unit is None:
        return own, IDENTITY
    at = (*at, "unit")
    known = work.catalogue.vocabulary.unit(item.unit)
    if known is None:
        keys = [unit.key for unit in work.catalogue.vocabulary.distinct_units]
        fix = work.hint(item.unit, keys) or (_convertible(own) if own else "")
        work.report("F021", at, f"{item.unit!r} is no unit.", fix, item.path)
        return own, IDENTITY
    if own is None:
        work.report("F021", at, f"{item.path!r} has no unit in the catalogue.", "Remove `unit`.", item.path)
        return None, IDENTITY
    conversion = between(own, known.key)
    if conversion is None:
        work.report("F021", at, f"{own!r} cannot be converted to {known.key!r}.", _convertible(own), item.path)
    return known.key, conversion or IDENTITY


def _convertible(own: str) -> str:
    """A sentence that names the units in which a value of the catalogue's unit can be held."""
    kinds = same_kind(own)
    return f"Use {own!r} or one that it converts to: {', '.join(kinds)}." if kinds else f"Use {own!r}."


def _scale(item: Item, at: Pointer, work: Work) -> Linear:
    if isinstance(item, ParameterItem) or (item.factor is None and item.offset is None):
        return IDENTITY
    if item.factor == 0:
        work.report("F020", (*at, "factor"), "A factor of 0 loses every value.", path=item.path)
        return IDENTITY
    return Linear(_fraction(1 if item.factor is None else item.factor), _fraction(item.offset or 0))


def _fraction(value: Any) -> Fraction:
    """A number as it was written: 0.1 is a tenth, not the nearest double."""
    return Fraction(repr(value))


# -- range --------------------------------------------------------------------------------------------------------


def _range(code: _Code, work: Work) -> tuple[Fraction | None, Fraction | None]:
    """Smallest and largest valid value, in the code's unit."""
    if not (is_numeric(code.datatype) or element_of(code.datatype) == "boolean"):
        return None, None
    own = _own_range(code)
    declared = (code.item.min, code.item.max)
    low, high = (own[i] if given is None else _fraction(given) for i, given in enumerate(declared))
    _check_declared(code, own, work)
    if low is not None and high is not None and low > high:
        message = f"The range from {_shown(low)} to {_shown(high)} is upside down."
        at = code.at if code.item.min is None else (*code.at, "min")
        work.report("F023", at, message, "Exchange `min` and `max`.", code.item.path)
    elif code.symbols is None:
        _check_loss(code, low, high, work)
    _check_symbols(code, work)
    return low, high


def _own_range(code: _Code) -> tuple[Fraction | None, Fraction | None]:
    """The catalogue's range in the code's unit; of an enumeration, the range of its numbers."""
    if code.symbols:
        return Fraction(min(code.symbols.values())), Fraction(max(code.symbols.values()))
    if element_of(str(code.node.values["datatype"])) == "boolean":
        return Fraction(0), Fraction(1)
    bounds = [code.node.values.get(name) for name in ("min", "max")]
    low, high = (None if bound is None else code.to_code(_fraction(bound)) for bound in bounds)
    return (high, low) if code.to_code.factor < 0 else (low, high)


def _check_declared(code: _Code, own: tuple[Fraction | None, Fraction | None], work: Work) -> None:
    """The code may narrow the range of a signal, not widen it."""
    if code.symbols is not None:
        return
    for name, given, bound, sign in (("min", code.item.min, own[0], 1), ("max", code.item.max, own[1], -1)):
        if given is not None and bound is not None and _fraction(given) * sign < bound * sign:
            message = f"`{name}` {given} lies outside the catalogue's range, which ends at {_shown(bound)}."
            work.report("F022", (*code.at, name), message, "Narrow it, or change the catalogue.", code.item.path)


def _check_symbols(code: _Code, work: Work) -> None:
    limits = value_range(element_of(code.datatype))
    for name, number in (code.symbols or {}).items():
        if limits and not limits[0] <= number <= limits[1]:
            message = f"{number}, which stands for {name!r}, does not fit {code.datatype}."
            work.report("F020", (*code.at, "values", name), message, path=code.item.path)


def _check_loss(code: _Code, low: Fraction | None, high: Fraction | None, work: Work) -> None:
    """Refuse a datatype or a scale that cannot hold what the catalogue promises, or promises less than it gives."""
    own = element_of(str(code.node.values["datatype"]))
    stored = element_of(code.datatype)
    if _is_wide(stored, own):
        return
    held, catalogue = _held(stored, code.scale), _converted(_full(own), code.to_code)
    if held is None or catalogue is None:
        return
    is_provided = isinstance(code.item, DataItem) and code.item.role == "provided"
    given = held if is_provided else catalogue
    needed = (given[0] if low is None else low, given[1] if high is None else high)
    for limits, holder in ((held, f"{code.datatype} in the code"), (catalogue, f"{own} in the catalogue")):
        if needed[0] < limits[0] or needed[1] > limits[1]:
            message = (
                f"Values from {_shown(needed[0])} to {_shown(needed[1])} do not fit {holder}, "
                f"which holds {_shown(limits[0])} to {_shown(limits[1])}."
            )
            fix = "Choose a larger datatype or another scale, or narrow the range with `min` and `max`."
            work.report(
                "F020", _first_of(code, ("datatype", "factor", "unit", "max", "min")), message, fix, code.item.path
            )
            return
    is_scaled = getattr(code.item, "factor", None) is not None
    if own in ("float", "double") and stored in INTEGER_RANGES and not is_scaled and not is_provided:
        message = f"The catalogue has {own}; held as {stored} without a factor, fractions are lost."
        work.report("F025", (*code.at, "datatype"), message, "Give a `factor`, such as 0.01.", code.item.path)


def _is_wide(stored: str, own: str) -> bool:
    """Whether the code holds every number that the catalogue's datatype holds, in any usual unit."""
    return stored == "double" or (stored == "float" and own != "double")


def _full(datatype: str) -> Range | None:
    limits = value_range(datatype)
    return (Fraction(limits[0]), Fraction(limits[1])) if limits else None


def _held(stored: str, scale: Linear) -> Range | None:
    return _converted(_full(stored), scale)


def _converted(limits: Range | None, conversion: Linear) -> Range | None:
    if limits is None:
        return None
    ends = sorted(
        (limits[0] * conversion.factor + conversion.offset, limits[1] * conversion.factor + conversion.offset)
    )
    return ends[0], ends[1]


def _first_of(code: _Code, keys: tuple[str, ...]) -> Pointer:
    """The first of these keys that the author wrote, or else the item."""
    written = (key for key in keys if getattr(code.item, key, None) is not None)
    key = next(written, None)
    return (*code.at, key) if key else code.at


# -- start values -------------------------------------------------------------------------------------------------


def _init(code: _Code, low: Fraction | None, high: Fraction | None, work: Work) -> float | None:
    at, given = (*code.at, "init"), code.item.init
    _tell_unheld(code, work)
    if given is None or _is_unheld(code, given):
        return _default(code)
    is_boolean = element_of(str(code.node.values["datatype"])) == "boolean"
    number = None if isinstance(given, bool) and not is_boolean else _as_number(given, code.symbols)
    if number is None:
        kind = "True or false" if is_boolean else "A number"
        fix = f"Use one of {', '.join(code.symbols)}." if code.symbols else f"{kind} belongs here."
        work.report("F024", at, f"{given!r} is no value of {code.item.path!r}.", fix, code.item.path)
        return None
    is_outside = (low is not None and number < low) or (high is not None and number > high)
    if is_outside or (code.symbols and number not in code.symbols.values()):
        message = f"Start value {_shown(number)} is not a valid value of {code.item.path!r}."
        fix = f"Valid values go from {_shown(low)} to {_shown(high)}." if is_outside else ""
        work.report("F024", at, message, fix, code.item.path)
    return as_number(number)


def _tell_unheld(code: _Code, work: Work) -> None:
    """Function JSON has one number as the start value of a signal; a parameter's default it has in any form."""
    default = code.node.values.get("default") if isinstance(code.item, DataItem) else None
    given = default if code.item.init is None else code.item.init
    if _is_unheld(code, given):
        at = code.at if code.item.init is None else (*code.at, "init")
        message = (
            f"The start value {str(given)[:60]!r} of {code.item.path!r} is not carried: Function JSON has numbers only."
        )
        work.report("F017", at, message, "Set it in the code.", code.item.path)


def _is_unheld(code: _Code, given: Any) -> bool:
    """Whether this is a text, or elements of an array, where such is meant."""
    own = str(code.node.values["datatype"])
    if is_array(own):
        return isinstance(given, list)
    return isinstance(given, str) and own == "string" and code.symbols is None


def _default(code: _Code) -> float | None:
    """The catalogue's default, in the code's unit."""
    default = code.node.values.get("default")
    number = _as_number(default, code.symbols)
    if number is None or code.symbols:
        return _number(number)
    return as_number(code.to_code(number))


def _as_number(value: Any, symbols: Symbols | None) -> Fraction | None:
    if isinstance(value, str) and symbols is not None:
        return Fraction(symbols[value]) if value in symbols else None
    if isinstance(value, bool):
        return Fraction(int(value))
    try:
        return _fraction(value) if isinstance(value, int | float) else None
    except ValueError:  # not a finite number
        return None


def _number(value: Fraction | None) -> float | None:
    return None if value is None else as_number(value)


def _shown(value: Fraction | None) -> str:
    return "no limit" if value is None else f"{as_number(value):.12g}" if value.denominator != 1 else _whole(value)


def _whole(value: Fraction) -> str:
    return str(value.numerator) if abs(value) < 10**21 else f"{float(value):.4g}"
