"""Static ids of nodes: the 32-bit FNV-1 hash by which `vspec export id` identifies a signal."""

from collections.abc import Mapping
from typing import Any

from sigcat.catalogue.model.catalogue import Node

_OFFSET = 2166136261
_PRIME = 16777619
_WORD = 0xFFFFFFFF


def static_id(node: Node, *, case_sensitive: bool = False) -> str:
    """The id of a node."""
    return static_id_of(node.path, node.values, case_sensitive=case_sensitive)


def static_id_of(path: str, values: Mapping[str, Any], *, case_sensitive: bool = False) -> str:
    """The id as `0x` and eight hexadecimal digits; a `constUID` counts as it is written.

    The hash is taken over path (or the first path that the node was once known as), unit, datatype, type, allowed
    values and range. So it changes when their meaning changes, and is the same for equal trees.
    """
    fixed = values.get("constUID")
    if fixed:
        return str(fixed)
    text = _identity(path, values)
    return f"0x{fnv1((text if case_sensitive else text.lower()).encode('utf-8', 'surrogatepass')):08X}"


def fnv1(data: bytes) -> int:
    """Fowler–Noll–Vo hash, variant 1, 32 bits."""
    number = _OFFSET
    for byte in data:
        number = (number * _PRIME & _WORD) ^ byte
    return number


def _identity(path: str, values: Mapping[str, Any]) -> str:
    """Return the hashed text. Its spelling, with commas missing, is that of vss-tools."""
    former = values.get("fka")
    name = (former[0] if isinstance(former, list) else former) if former else path
    unit, datatype, allowed = (values.get(key) or "" for key in ("unit", "datatype", "allowed"))
    low, high = ("" if values.get(key) is None else values[key] for key in ("min", "max"))
    kind = values.get("type") or ""
    return f"{name}: unit: {unit}, datatype: {datatype}, type: {kind}allowed: {allowed}min: {low}max: {high}"
