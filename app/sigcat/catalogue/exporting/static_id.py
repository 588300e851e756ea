"""Static ids of nodes: the 32-bit FNV-1 hash by which `vspec export id` identifies a signal."""

from sigcat.catalogue.model.catalogue import Node

_OFFSET = 2166136261
_PRIME = 16777619
_WORD = 0xFFFFFFFF


def static_id(node: Node, *, case_sensitive: bool = False) -> str:
    """The id as `0x` and eight hexadecimal digits; a `constUID` counts as it is written.

    The hash is taken over path (or the first path that the node was once known as), unit, datatype, type, allowed
    values and range. So it changes when their meaning changes, and is the same for equal trees.
    """
    fixed = node.values.get("constUID")
    if fixed:
        return str(fixed)
    text = _identity(node)
    return f"0x{fnv1((text if case_sensitive else text.lower()).encode('utf-8', 'surrogatepass')):08X}"


def fnv1(data: bytes) -> int:
    """Fowler–Noll–Vo hash, variant 1, 32 bits."""
    number = _OFFSET
    for byte in data:
        number = (number * _PRIME & _WORD) ^ byte
    return number


def _identity(node: Node) -> str:
    """What is hashed. Its spelling, with commas missing, is that of vss-tools."""
    values = node.values
    former = values.get("fka")
    name = (former[0] if isinstance(former, list) else former) if former else node.path
    unit, datatype, allowed = (values.get(key) or "" for key in ("unit", "datatype", "allowed"))
    low, high = ("" if values.get(key) is None else values[key] for key in ("min", "max"))
    return f"{name}: unit: {unit}, datatype: {datatype}, type: {node.type}allowed: {allowed}min: {low}max: {high}"
