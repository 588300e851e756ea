"""Datatypes of a function: VSS datatype, reference on the wire, and C. One row for each.

References are spelled as in the published Function JSON (`DT_UInt8`, `DT_Bool`); C definitions are those of
<stdint.h> and <stdbool.h>, so that their width is the same on every platform.
"""

import re
from typing import NamedTuple

from sigcat.catalogue.model.datatypes import INTEGER_RANGES


class Primitive(NamedTuple):
    """One datatype in each of its spellings."""

    vss: str
    reference: str
    c: str


PRIMITIVES = (
    Primitive("boolean", "DT_Bool", "bool"),
    Primitive("uint8", "DT_UInt8", "uint8_t"),
    Primitive("int8", "DT_SInt8", "int8_t"),
    Primitive("uint16", "DT_UInt16", "uint16_t"),
    Primitive("int16", "DT_SInt16", "int16_t"),
    Primitive("uint32", "DT_UInt32", "uint32_t"),
    Primitive("int32", "DT_SInt32", "int32_t"),
    Primitive("uint64", "DT_UInt64", "uint64_t"),
    Primitive("int64", "DT_SInt64", "int64_t"),
    Primitive("float", "DT_Float32", "float"),
    Primitive("double", "DT_Float64", "double"),
    Primitive("string", "DT_String", "char *"),
)
BY_VSS = {row.vss: row for row in PRIMITIVES}
BY_REFERENCE = {row.reference: row for row in PRIMITIVES}

LARGEST_FLOAT = 3.4028234663852886e38
LARGEST_DOUBLE = 1.7976931348623157e308


def value_range(vss: str) -> tuple[float, float] | None:
    """Smallest and largest number that a VSS datatype holds; None if it holds no numbers."""
    if vss in INTEGER_RANGES:
        return INTEGER_RANGES[vss]
    if vss == "boolean":
        return (0, 1)
    largest = {"float": LARGEST_FLOAT, "double": LARGEST_DOUBLE}.get(vss)
    return (-largest, largest) if largest else None


class CType(NamedTuple):
    """Meaning of a C definition: unsigned, signed, floating, boolean or text, and its bits (0: not fixed)."""

    kind: str
    bits: int


_EXACT = re.compile(r"(u?)int(?:_least|_fast)?(8|16|32|64)_t|([us])int(8|16|32|64)")
_FLOATING = {"float": 32, "float32": 32, "float32_t": 32, "double": 64, "float64": 64, "float64_t": 64}
_BOOLEANS = frozenset(("bool", "_Bool", "boolean"))
_INTEGER_WORDS = frozenset(("signed", "unsigned", "char", "short", "int", "long"))
_SIZES = (
    (("char",), 8), (("short",), 16), (("int", "short"), 16), (("int",), 32), ((), 32),
    (("long",), 0), (("int", "long"), 0), (("long", "long"), 64), (("int", "long", "long"), 64),
)  # fmt: skip


def c_type(definition: str) -> CType | None:
    """Meaning of a C definition of a primitive datatype, or None if C has no such type."""
    text = " ".join(definition.replace("*", " * ").split())
    if text in _FLOATING:
        return CType("floating", _FLOATING[text])
    if text in _BOOLEANS:
        return CType("boolean", 8)
    if text in ("char *", "const char *"):
        return CType("text", 0)
    match = _EXACT.fullmatch(text)
    if match:
        is_unsigned = match[1] == "u" or match[3] == "u"
        return CType("unsigned" if is_unsigned else "signed", int(match[2] or match[4]))
    return CType("floating", 0) if text == "long double" else _c_integer(text.split())


def integer_limits(definition: str) -> tuple[int, int] | None:
    """Smallest and largest number of a C type for integers or booleans; None if it is another one, or has no fixed width."""
    meant = c_type(definition)
    if meant is None or meant.bits == 0 or meant.kind == "floating":
        return None
    if meant.kind == "boolean":
        return 0, 1
    half = 2 ** (meant.bits - 1)
    return (-half, half - 1) if meant.kind == "signed" else (0, 2 * half - 1)


def _c_integer(words: list[str]) -> CType | None:
    signs = [word for word in words if word in ("signed", "unsigned")]
    rest = tuple(sorted(word for word in words if word not in signs))
    bits = dict(_SIZES).get(rest)
    if not words or not _INTEGER_WORDS.issuperset(words) or len(signs) > 1 or bits is None:
        return None
    return CType("unsigned" if signs == ["unsigned"] else "signed", bits)


_REFERENCE = re.compile(r"DT_(UInt|SInt|Int|Float|Bool|Boolean|Double|String)(8|16|32|64)?")
_REFERENCE_KINDS = {
    "UInt": "unsigned", "SInt": "signed", "Int": "signed", "Float": "floating", "Double": "floating",
    "Bool": "boolean", "Boolean": "boolean", "String": "text",
}  # fmt: skip


def reference_type(reference: str) -> CType | None:
    """Meaning of the name of a primitive reference: `DT_SInt64` → signed, 64 bits."""
    match = _REFERENCE.fullmatch(reference)
    if match is None:
        return None
    default = {"Double": 64, "Bool": 8, "Boolean": 8}.get(match[1], 0)
    return CType(_REFERENCE_KINDS[match[1]], int(match[2] or default))


def proposed_reference(meant: CType) -> str:
    """The usual reference for the meaning of a C definition: floating, 64 bits → `DT_Float64`."""
    prefix = {"unsigned": "DT_UInt", "signed": "DT_SInt", "floating": "DT_Float"}.get(meant.kind)
    if prefix is None:
        return "DT_Bool" if meant.kind == "boolean" else "DT_String"
    return f"{prefix}{meant.bits or 32}"


def agree(promised: CType, actual: CType) -> bool:
    """Whether a reference may be used for a C definition. A boolean may be held in an unsigned byte."""
    if promised.kind == "boolean" and actual == CType("unsigned", 8):
        return True
    return promised.kind == actual.kind and (promised.bits == actual.bits or 0 in (promised.bits, actual.bits))
