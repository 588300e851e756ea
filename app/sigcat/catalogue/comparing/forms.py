"""Effects of a change on generated forms: what a binding's type, number or name of a node depends on."""

from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any, NamedTuple

from sigcat.catalogue.comparing.changes import ORDER, Change
from sigcat.catalogue.exporting.static_id import static_id_of
from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.catalogue.model.datatypes import element_of, is_array
from sigcat.catalogue.model.definition import BRANCH, STRUCT
from sigcat.catalogue.model.vocabulary import Unit, Vocabulary
from sigcat.names import last_name, parent_path

Values = Mapping[str, Any]

_PROTOBUF: Mapping[str, str] = {
    **dict.fromkeys(("uint8", "uint16", "uint32", "int8", "int16", "int32"), "varint of 32 bits"),
    **dict.fromkeys(("uint64", "int64"), "varint of 64 bits"),
}
"""Types that read each other's bytes; every other datatype has its own."""
_GRAPHQL: Mapping[str, str] = {"double": "float"}
_DDS: Mapping[str, str] = {"int8": "uint8"}


class Trees(NamedTuple):
    """Both sides of a comparison, and what all changes need of them."""

    old: Catalogue
    new: Catalogue
    ignored: frozenset[str]
    """Attributes that one side cannot know, and `order` if it cannot know the order of nodes."""
    branches: frozenset[str]
    """Names of the branches of the old side."""


def trees(old: Catalogue, new: Catalogue, ignored: frozenset[str]) -> Trees:
    """Return both sides."""
    return Trees(old, new, ignored, frozenset(_branch_names(old.nodes.values())))


def with_effects(change: Change, both: Trees) -> Change:
    """Add the effects that the change has at any of its paths."""
    effects = dict.fromkeys(effect for pair in _pairs(change) for effect in _effects(change, *pair, both))
    return change._replace(effects=tuple(effects)) if effects else change


def orders(before: Node, after: Node) -> tuple[list[str], list[str]]:
    """Names of the children that both nodes have, in the order of each."""
    old, new = ([child.name for child in node.children] for node in (before, after))
    if old == new:
        return old, new
    return [name for name in old if name in new], [name for name in new if name in old]


def _pairs(change: Change) -> Iterator[tuple[str, str]]:
    """The paths of the change in the old tree and in the new one."""
    former = change.former_paths or change.paths
    yield from zip(former, change.paths, strict=True)


def _effects(change: Change, before: str, after: str, both: Trees) -> Iterator[str]:
    for path in (*((after,) if change.kind == "added" else ()), *change.came):
        yield from _of_new_node(both.new.nodes[path], both)
    old, new = both.old.nodes.get(before), both.new.nodes.get(after)
    if change.kind in ("moved", "changed") and old and new:
        yield from _of_values(old, new, both)
    if any(attribute.rule == "reordered" for attribute in change.attributes):
        yield "fields-renumbered"
        if change.type == STRUCT:
            yield "properties-reordered"


def _of_new_node(node: Node, both: Trees) -> Iterator[str]:
    above = parent_path(node.path)
    before, after = both.old.nodes.get(above), both.new.nodes.get(above)
    if before and after:
        if ORDER in both.ignored:
            yield "position-unknown"
        elif _is_before_others(node, before, after):
            yield "added-before"
        if node.is_leaf and any(child.is_leaf for child in before.children):
            yield "added-beside"
    if not both.branches.isdisjoint(_branch_names(node.walk())):
        yield "name-shared"


def _is_before_others(node: Node, before: Node, after: Node) -> bool:
    """Whether the branch had a child that is behind the new node now."""
    kept = {child.name for child in before.children}
    names = [child.name for child in after.children]
    return any(name in kept for name in names[names.index(node.name) :])


def _branch_names(nodes: Iterable[Node]) -> Iterator[str]:
    """Names of branches; instances have the name of their branch."""
    return (last_name(node.template) for node in nodes if node.type == BRANCH)


def _of_values(before: Node, after: Node, both: Trees) -> Iterator[str]:
    if _id_of(before) != _id_of(after) or (before.path != after.path and _is_followed(before, after)):
        yield "id-changed"
    if not (before.is_leaf and after.is_leaf):
        return
    old, new = _known(before.values, both.ignored), _known(after.values, both.ignored)
    yield from (effect for effect, type_of in _TYPES.items() if type_of(old) != type_of(new))
    if old.get("unit") is not None and new.get("unit") is None:
        yield "unit-dropped"
    if _are_of_two_quantities(both.old.unit(before), both.new.unit(after), both.new.vocabulary):
        yield "unit-quantity"
    if _has_labels(old) and _has_labels(new):
        yield from _of_labels(old["allowed"], new["allowed"])


def _are_of_two_quantities(old: Unit | None, new: Unit | None, vocabulary: Vocabulary) -> bool:
    """Whether two units have quantities that the new vocabulary tells apart: releases before 4.1 named some otherwise."""
    if old is None or new is None:
        return False
    known = vocabulary.unit(old.key)
    present = known if known is not None and known.name.lower() == old.name.lower() else old
    return present.quantity.lower() != new.quantity.lower()


def _known(values: Values, ignored: frozenset[str]) -> Values:
    return {name: value for name, value in values.items() if name not in ignored} if ignored else values


def _of_labels(old: list[Any], new: list[Any]) -> Iterator[str]:
    is_removed = any(label not in new for label in old)
    is_renumbered = any(label in new and new.index(label) != number for number, label in enumerate(old))
    if is_removed:
        yield "label-removed"
    if is_renumbered:
        yield "label-renumbered"
    if is_removed or is_renumbered:
        yield "enumeration-renumbered"


def _has_labels(values: Values) -> bool:
    """Whether the value is one of some texts."""
    return isinstance(values.get("allowed"), list) and element_of(str(values["datatype"])) == "string"


def _id_of(node: Node) -> str:
    return static_id_of(node.path, node.values)


def _is_followed(before: Node, after: Node) -> bool:
    """Whether a branch moved with nodes whose ids do not name their former path."""
    kept = {child.name: child for child in after.children}
    pairs = ((child, kept[child.name]) for child in before.children if child.name in kept)
    return any(_id_of(old) != _id_of(new) or _is_followed(old, new) for old, new in pairs)


# -- the type of a signal in each binding --------------------------------------------------------------------------


def _in_protobuf(values: Values) -> tuple[str, bool]:
    datatype = str(values["datatype"])
    element = element_of(datatype)
    return "enumeration" if _has_labels(values) else _PROTOBUF.get(element, element), is_array(datatype)


def _in_ros2(values: Values) -> tuple[str, bool, Any]:
    datatype = str(values["datatype"])
    return element_of(datatype), is_array(datatype), values.get("arraysize")


def _as_member(values: Values) -> tuple[str, bool, Any]:
    element, *length = _in_ros2(values)
    return ("enumeration" if _has_labels(values) else element, *length)


def _in_graphql(values: Values) -> tuple[str, bool]:
    datatype = str(values["datatype"])
    element = element_of(datatype)
    return "enumeration" if values.get("allowed") else _GRAPHQL.get(element, element), is_array(datatype)


def _in_dds(values: Values) -> tuple[str, bool]:
    if _has_labels(values):
        return "enumeration", False
    datatype = str(values["datatype"])
    element = element_of(datatype)
    return _DDS.get(element, element), is_array(datatype) or values.get("arraysize") is not None


_TYPES: Mapping[str, Callable[[Values], object]] = {
    "retyped-protobuf": _in_protobuf,
    "retyped-ros2": _in_ros2,
    "retyped-member": _as_member,
    "retyped-graphql": _in_graphql,
    "retyped-dds": _in_dds,
}
"""By effect, the type of a signal; the effect is there where the types differ."""
