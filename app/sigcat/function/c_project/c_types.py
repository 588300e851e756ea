"""The VSS datatype of a C type: by a well-known name of any width, else by what the compiler says."""

import re

from sigcat.function.c_project.declarations import CType

_NAMED = {
    "boolean_T": "boolean", "boolean": "boolean", "bool": "boolean", "_Bool": "boolean", "Boolean": "boolean",
    "real_T": "double", "real64_T": "double", "time_T": "double", "float64": "double", "float64_t": "double",
    "real32_T": "float", "float32": "float", "float32_t": "float",
    "char_T": "int8", "byte_T": "uint8", "uchar_T": "uint8",
}  # fmt: skip
"""Names whose type in C says less, or another thing on another machine."""
_SIZED = re.compile(r"(?P<sign>u|s|)int_?(?P<bits>8|16|32|64)(?:_T|_t)?", re.ASCII)


def vss_datatype(kind: CType) -> str:
    """The datatype of a number or an enumeration; empty if it holds none of VSS."""
    for name in kind.names:
        if name in _NAMED:
            return _NAMED[name]
        if sized := _SIZED.fullmatch(name):
            return f"{'u' if sized['sign'] == 'u' else ''}int{sized['bits']}"
    if kind.kind == "enumeration":
        return _computed(kind.sort, kind.bits) if kind.bits else "int32"
    if kind.kind != "number":
        return ""
    return _computed(kind.sort, kind.bits)


def _computed(sort: str, bits: int) -> str:
    if sort == "boolean":
        return "boolean"
    if sort == "floating":
        return {32: "float", 64: "double"}.get(bits, "")
    return f"{'u' if sort == 'unsigned' else ''}int{bits}" if bits in (8, 16, 32, 64) else ""
