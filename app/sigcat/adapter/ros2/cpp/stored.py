"""What is stored: learned parameters, and the counts of errors."""

from collections.abc import Iterator
from typing import NamedTuple

from sigcat.adapter.core.plan import CorePlan, Parameter
from sigcat.adapter.ros2.cpp.layout import function, scope
from sigcat.adapter.ros2.plan import NodePlan
from sigcat.adapter.text_filters import c_string


class StoredLeaf(NamedTuple):
    """A number of a learned parameter, or an array of numbers: its key, and where it is in the value."""

    key: str
    place: str


def stored_leaves(parameter: Parameter, node: NodePlan) -> tuple[StoredLeaf, ...]:
    """The lines of a parameter in the file: one for each number or array of numbers."""
    wire, key = parameter.value.wire, node.stored_keys[parameter.variable]
    if not wire.is_struct:
        return (StoredLeaf(key, ""),)
    indexes = [""] if wire.length is None else [f"[{i}]" for i in range(wire.length)]
    return tuple(
        StoredLeaf(f"{key}{index}{path}", f"{index}{path}") for index in indexes for path in _paths(wire.c, node.core)
    )


def _paths(struct: str, core: CorePlan) -> Iterator[str]:
    known = {each.name: each for each in core.structs}
    for field in known[struct].fields:
        if field.c not in known:
            yield f".{field.name}"
            continue
        indexes = [""] if field.length is None else [f"[{i}]" for i in range(field.length)]
        for index in indexes:
            yield from (f".{field.name}{index}{rest}" for rest in _paths(field.c, core))


def storage_functions(node: NodePlan) -> list[str]:
    """Reading at the start, writing at the end; calibration is never written."""
    return [_load(node), _store(node)] if node.is_stored else []


def _load(node: NodePlan) -> str:
    core = node.core.type_name
    return function(f"{core}_Stored load(Storage & storage)", [
        "storage.load();",
        f"{core}_Stored stored{{}};",
        'stored.has_cycle = storage.read("ignition_cycle", stored.ignition_cycle);',
        *(f"storage.read_counts({c_string(each.error.named.name)}, stored.{each.error.named.name});" for each in node.monitors),
        *(_read(each, node) for each in node.learned),
        scope("if (!storage.is_good())", ["storage.set_aside();", f"stored = {core}_Stored{{}};"]),
        "return stored;",
    ])  # fmt: skip


def _read(parameter: Parameter, node: NodePlan) -> str:
    place = f"stored.{parameter.named.name}"
    reads = [
        f"storage.read({c_string(leaf.key)}, {place}.value{leaf.place})" for leaf in stored_leaves(parameter, node)
    ]
    if len(reads) == 1:
        return f"{place}.is_there = {reads[0]};"
    return "\n".join(
        [f"{place}.is_there = true;", *(f"{place}.is_there = {each} && {place}.is_there;" for each in reads)]
    )


def _store(node: NodePlan) -> str:
    return function(f"void store(const {node.core.type_name}_Stored & stored, Storage & storage)", [
        'storage.write("ignition_cycle", stored.ignition_cycle);',
        *(f"storage.write_counts({c_string(each.error.named.name)}, stored.{each.error.named.name});" for each in node.monitors),
        *(_written(each, node) for each in node.learned),
        "storage.save();",
    ])  # fmt: skip


def _written(parameter: Parameter, node: NodePlan) -> str:
    place = f"stored.{parameter.named.name}"
    writes = [
        f"storage.write({c_string(leaf.key)}, {place}.value{leaf.place});" for leaf in stored_leaves(parameter, node)
    ]
    return scope(f"if ({place}.is_there)", writes)
