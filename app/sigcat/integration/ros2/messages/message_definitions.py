"""Definitions of existing messages, as `.msg` files have them, and where a path such as `header.stamp` leads in them."""

import re
from collections.abc import Mapping
from typing import NamedTuple

from sigcat.function.function_json.datatypes.primitive_types import value_range
from sigcat.integration.datatypes import SPELLINGS, Spelling

_TYPE = r"(?P<type>[A-Za-z]\w*(?:/[A-Za-z]\w*)?)(?:<=\d{1,9})?(?P<array>\[(?:<=)?\d{0,9}\])?"
_FIELD = re.compile(rf"{_TYPE}\s+(?P<name>[a-z]\w*)(?:\s+(?P<default>\S.*))?", re.ASCII)
_CONSTANT = re.compile(rf"{_TYPE}\s+(?P<name>[A-Z]\w*)\s*=\s*(?P<value>.*)", re.ASCII)
_STEP = re.compile(r"([a-z]\w*)(?:\[(\d{1,9})\])?", re.ASCII)
_FIXED = re.compile(r"\[(\d+)\]")
_OLD = {"byte": "uint8", "char": "uint8"}
PRIMITIVES: Mapping[str, Spelling] = {row.ros2: row for row in SPELLINGS}
HEADER, TIME = "std_msgs/Header", "builtin_interfaces/Time"
_KNOWN = {TIME: "int32 sec\nuint32 nanosec"}
"""Definitions that are always known."""


class MessageError(Exception):
    """A message or field that does not exist or cannot be read."""


class Definition(NamedTuple):
    """A message."""

    fields: Mapping[str, "Field"]
    constants: Mapping[str, str]


class Field(NamedTuple):
    """A field as its message writes it."""

    type: str
    """A primitive, or a message with its package: `geometry_msgs/Vector3`."""
    array: str = ""
    """`[36]`, `[]` or `[<=5]`."""

    @property
    def element(self) -> Spelling | None:
        """Its primitive, or that of its elements; None for a message, and what the catalogue has no datatype for."""
        return PRIMITIVES.get(_OLD.get(self.type, self.type))

    @property
    def length(self) -> int | None:
        """Elements of an array of a fixed length."""
        match = _FIXED.fullmatch(self.array)
        return int(match[1]) if match else None


class Definitions:
    """The texts of messages by their names, `geometry_msgs/Twist`."""

    def __init__(self, texts: Mapping[str, str]) -> None:
        self._texts = {short_name(name): text for name, text in {**_KNOWN, **texts}.items()}
        self._read: dict[str, Definition] = {}

    def message(self, name: str) -> Definition:
        """A message. Raises MessageError if it does not exist or cannot be read."""
        if name not in self._read:
            if name not in self._texts:
                raise MessageError(f"The message {name} is not found")
            self._read[name] = parsed(name, self._texts[name])
        return self._read[name]

    def field(self, message: str, path: str) -> Field:
        """The field of a path below a message: `linear.x`, `covariance[0]`. Raises MessageError if there is none."""
        field, at = Field(message), message
        for step in path.split("."):
            if field.array or field.element is not None:
                raise MessageError(f"{at} has no fields")
            field = self._step(field.type, step, at)
            at = f"{at}.{step}"
        return field

    def stamp(self, message: str) -> str | None:
        """The path of its time: that of its header, or its own; None if it has none."""
        for name, field in self.message(message).fields.items():
            if field.type == HEADER and not field.array:
                return f"{name}.stamp"
        return next((name for name, field in self.message(message).fields.items() if field == Field(TIME)), None)

    def _step(self, message: str, step: str, at: str) -> Field:
        match = _STEP.fullmatch(step)
        fields = self.message(message).fields
        field = fields.get(match[1]) if match else None
        if field is None or match is None:
            raise MessageError(f"{at} has no field {step!r}: its fields are {', '.join(fields)}")
        if match[2] is None:
            return field
        if field.length is None or int(match[2]) >= field.length:
            raise MessageError(f"{at}.{match[1]} has no element {match[2]}: only arrays of a fixed length have numbers")
        return field._replace(array="")


def short_name(name: str) -> str:
    """`geometry_msgs/msg/Twist` → `geometry_msgs/Twist`."""
    return name.replace("/msg/", "/")


def parsed(name: str, text: str) -> Definition:
    """The definition of a message from its text. Raises MessageError for a line that is not a field or constant."""
    package = name.partition("/")[0]
    fields: dict[str, Field] = {}
    constants: dict[str, str] = {}
    for number, line in enumerate(text.splitlines(), 1):
        code = line.partition("#")[0].strip()
        constant, field = _CONSTANT.fullmatch(line.strip()), _FIELD.fullmatch(code)
        if constant:
            constants[constant["name"]] = constant["value"].strip()
        elif field:
            fields[field["name"]] = Field(_full(field["type"], package), field["array"] or "")
        elif code:
            raise MessageError(f"Line {number} of {name} is not a field: {code[:60]!r}")
    return Definition(fields, constants)


def _full(type_: str, package: str) -> str:
    if type_ == "Header":
        return HEADER
    is_own = "/" not in type_ and type_[:1].isupper()
    return f"{package}/{type_}" if is_own else short_name(type_)


def named_types(text: str, name: str) -> tuple[str, ...]:
    """Messages that a message has fields of; empty if its text cannot be read."""
    try:
        fields = parsed(name, text).fields.values()
    except MessageError:
        return ()
    return tuple(dict.fromkeys(field.type for field in fields if "/" in field.type))


def holds(element: Spelling, value: object) -> bool:
    """Whether a primitive can have a value of a document."""
    if element.vss == "string":
        return isinstance(value, str)
    if isinstance(value, bool) or element.vss == "boolean":
        return isinstance(value, bool) and element.vss == "boolean"
    if not isinstance(value, int | float):
        return False
    limits = value_range(element.vss)
    is_whole = element.vss in ("float", "double") or value == int(value)
    return is_whole and limits is not None and limits[0] <= value <= limits[1]
