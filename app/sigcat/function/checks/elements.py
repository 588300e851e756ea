"""Values of arrays and structs: as many elements as there are, every member, each of its datatype and within its range."""

from collections.abc import Iterator, Mapping
from itertools import islice
from typing import Any, NamedTuple

from sigcat import codes
from sigcat.catalogue.model.datatypes import holds, values_in_words
from sigcat.function.document.document import Pointer
from sigcat.function.document.expression import is_identifier
from sigcat.function.document.problem import Problem, Problems, Subject
from sigcat.function.document.text import Text, json_of
from sigcat.function.document.yaml_words import in_yaml
from sigcat.function.function_json.conversion import is_outside
from sigcat.function.function_json.datatypes.datatype import Datatype, innermost
from sigcat.function.function_json.datatypes.primitive_types import LARGEST_FLOAT, CType, c_type, integer_limits
from sigcat.function.function_json.interfaces.data_interfaces import DataQueue, ParameterInterface, Signal
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.walk import declared_data, parameters
from sigcat.names import did_you_mean

Item = Signal | DataQueue | ParameterInterface
Types = Mapping[str, Datatype]

_FLOAT = CType("floating", 32)
_MOST = 5
"""Elements of one value that are reported."""


class _Limits(NamedTuple):
    low: float | None = None
    high: float | None = None
    is_scaled: bool = False
    """Whether the code holds a number with a factor, so that an integer has fractions."""


class _Misfit(NamedTuple):
    """A part of a value, what it must be, and what it is."""

    at: Pointer
    wanted: str
    given: Any


def check_elements(function: FunctionJson) -> Problems:
    """Every problem of the values of arrays and structs, and of the names of members."""
    types = {datatype.reference: datatype for datatype in function.datatypes}
    for pointer, _, item in (*declared_data(function), *parameters(function)):
        for key in ("InitElements", "DefaultElements"):
            text = getattr(item, "init_elements" if key == "InitElements" else "default_elements", None)
            if text is not None and not _is_text(types.get(item.datatype)):
                yield from _value(text, item, (*pointer, key), types)
        yield from _single(item, pointer, types)
        yield from _members(item, pointer, types)


def _is_text(datatype: Datatype | None) -> bool:
    """Whether a value is one text, which is written as it is."""
    meant = c_type(datatype.c_definition) if datatype is not None and datatype.kind is None else None
    return meant is not None and meant.kind == "text"


def _value(text: Text, item: Item, at: Pointer, types: Types) -> Problems:
    is_default = at[-1] == "DefaultElements"
    subject = Subject("data", item.vss_path or item.name, ("default",) if is_default else ())
    what, cause = ("default", subject) if is_default else ("init", None)  # a wrong default is one of the catalogue
    value = json_of(text)
    if value is None:
        message = f"`{at[-1]}` of {item.name!r} must be JSON, a list or an object."
        yield Problem(codes.START_VALUE_OUT_OF_RANGE, at, message, subject=subject)
        return
    for misfit in islice(_misfits(value, item.datatype, _limits(item), types), _MOST):
        message = f"`{what}{_shown(misfit.at)}` of {item.name!r} must be {misfit.wanted}, not {in_yaml(misfit.given)}."
        yield Problem(codes.START_VALUE_OUT_OF_RANGE, (*at, *misfit.at), message, subject=subject, cause=cause)


def _single(item: Item, pointer: Pointer, types: Types) -> Problems:
    """A number that an integer of the code does not hold, although it is in the range of the signal."""
    datatype = types.get(item.datatype)
    limits = _limits(item)
    integers = _integers(datatype, limits) if datatype is not None and not datatype.symbols else None
    is_float = datatype is not None and not limits.is_scaled and c_type(datatype.c_definition) == _FLOAT
    if item.init_elements is not None or not (integers or is_float):
        return
    wanted = f"one of the {values_in_words('float')}"
    if integers:
        wanted = f"a whole number from {integers[0]} to {integers[1]}"
    for key, what, value in (("InitValue", "init", item.init_value), ("Default", "default", item.default)):
        is_held = _is_number(value, integers, limits) and (not is_float or holds("float", value))
        if value is not None and _is_number(value, None, limits) and not is_held:
            message = f"`{what}` of {item.name!r} must be {wanted}, not {value:g}."
            subject = Subject("data", item.vss_path or item.name, () if what == "init" else ("default",))
            cause = subject if what == "default" else None
            yield Problem(codes.START_VALUE_OUT_OF_RANGE, (*pointer, key), message, subject=subject, cause=cause)


def _limits(item: Item) -> _Limits:
    """The range of the elements. A parameter without one has 0 and 0, as the published schema requires numbers."""
    is_scaled = str(item.factor or 1) not in ("1", "1.0")
    is_open = isinstance(item, ParameterInterface) and item.min == item.max == 0
    return _Limits(None if is_open else item.min, None if is_open else item.max, is_scaled)


def _shown(at: Pointer) -> str:
    """A place within a value: `[3].Speed`."""
    return "".join(f"[{part}]" if isinstance(part, int) else f".{part}" for part in at)


def _misfits(value: Any, reference: str, limits: _Limits, types: Types) -> Iterator[_Misfit]:
    datatype = types.get(reference)
    if datatype is None:
        return
    if datatype.kind == "array":
        yield from _of_array(value, datatype, limits, types)
    elif datatype.kind == "struct":
        yield from _of_struct(value, datatype, types)
    elif not _is_held(value, datatype, limits):
        yield _Misfit((), _wanted(datatype, limits), value)


def _of_array(value: Any, datatype: Datatype, limits: _Limits, types: Types) -> Iterator[_Misfit]:
    if not isinstance(value, list):
        yield _Misfit((), "a list", value)
        return
    if datatype.length is not None and len(value) != datatype.length:
        yield _Misfit((), f"a list of {datatype.length}", value)
    for index, each in enumerate(value):
        for misfit in _misfits(each, datatype.element or "", limits, types):
            yield misfit._replace(at=(index, *misfit.at))


def _of_struct(value: Any, datatype: Datatype, types: Types) -> Iterator[_Misfit]:
    if not isinstance(value, dict):
        yield _Misfit((), "a mapping of members", value)
        return
    fields = {field.name: field for field in datatype.fields or ()}
    lacking = [name for name in fields if name not in value]
    if lacking:
        yield _Misfit((), f"a mapping with {', '.join(lacking)}", value)
    for name, each in value.items():
        field = fields.get(name)
        if field is None:
            yield _Misfit((name,), f"one of the members {', '.join(fields)}", name)
            continue
        for misfit in _misfits(each, field.datatype, _Limits(field.min, field.max), types):
            yield misfit._replace(at=(name, *misfit.at))


def _is_held(value: Any, datatype: Datatype, limits: _Limits) -> bool:
    meant = c_type(datatype.c_definition)
    if meant is None:
        return True
    if meant.kind == "text":
        return isinstance(value, str)
    if datatype.symbols:
        return not isinstance(value, bool) and value in [each.value for each in datatype.symbols]
    if meant.kind == "boolean":
        return isinstance(value, bool) or (isinstance(value, int) and value in (0, 1))
    is_float = meant == _FLOAT and not limits.is_scaled
    return _is_number(value, _integers(datatype, limits), limits) and (not is_float or holds("float", value))


def _is_number(value: Any, integers: tuple[int, int] | None, limits: _Limits) -> bool:
    if isinstance(value, bool) or not isinstance(value, int | float):
        return False
    if integers is not None and not (value == int(value) and integers[0] <= value <= integers[1]):
        return False
    return not is_outside(value, limits.low, limits.high)


def _integers(datatype: Datatype, limits: _Limits) -> tuple[int, int] | None:
    """The range of an integer that holds the number as it is; None for everything else."""
    return None if limits.is_scaled else integer_limits(datatype.c_definition)


def _wanted(datatype: Datatype, limits: _Limits) -> str:
    meant = c_type(datatype.c_definition)
    if datatype.symbols:
        return f"one of {', '.join(each.symbol for each in datatype.symbols)}"
    if meant is not None and meant.kind in ("boolean", "text"):
        return "true or false" if meant.kind == "boolean" else "a text"
    integers = _integers(datatype, limits)
    is_float = meant == _FLOAT and not limits.is_scaled
    full = integers or ((-LARGEST_FLOAT, LARGEST_FLOAT) if is_float and limits[:2] == (None, None) else (None, None))
    ends = [own if own is not None else end for own, end in zip(limits[:2], full, strict=True)]
    low, high = ("" if end is None else f" {word} {end:.12g}" for word, end in zip(("from", "to"), ends, strict=True))
    return f"{'a whole number' if integers else 'a number'}{low}{high}"


# -- members ------------------------------------------------------------------------------------------------------


def _members(item: Item, pointer: Pointer, types: Types) -> Problems:
    """Names in C of members that the struct has, of structs within it too, each one its own."""
    subject = Subject("data", item.vss_path or item.name)
    known = list(_names(innermost(item.datatype, types), types, ()))
    seen: set[tuple[str, str]] = set()
    for index, each in enumerate(item.members or ()):
        at = (*pointer, "Members", index)
        if not known:
            message = f"`members` must be those of a struct; {item.name!r} is none."
            yield Problem(codes.MEMBER_UNFIT, (*pointer, "Members"), message, "Remove them.", subject)
            return
        if each.name not in known:
            message = f"{each.name!r} must be a member of {item.name!r}."
            fix = did_you_mean(each.name, known) or f"Use one of {', '.join(known)}."
            yield Problem(codes.MEMBER_UNFIT, at, message, fix, subject)
        elif not is_identifier(each.member):
            message = f"The member {each.name!r} must have a name of C, not {each.member!r}."
            yield Problem(codes.MEMBER_UNFIT, (*at, "Member"), message, "Use letters, digits and underscores.", subject)
        elif (key := (each.name.rpartition(".")[0], each.member)) in seen:
            message = f"Two members of {item.name!r} have the name {each.member!r} in C."
            yield Problem(codes.MEMBER_UNFIT, at, message, "Give each its own name.", subject)
        else:
            seen.add(key)


def _names(datatype: Datatype | None, types: Types, around: tuple[str, ...]) -> Iterator[str]:
    """Names of the members of a struct, with points between those of structs within it."""
    if datatype is None or datatype.kind != "struct" or datatype.reference in around:
        return
    for field in datatype.fields or ():
        yield field.name
        inner = innermost(field.datatype, types)
        for name in _names(inner, types, (*around, datatype.reference)):
            yield f"{field.name}.{name}"
