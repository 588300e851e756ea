"""The page of a node: the node as the API has it, resolved further for readers."""

import re
from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

from sigcat.api.answers import schemas
from sigcat.api.answers.serializers import node_detail
from sigcat.catalogue.exporting.static_id import static_id
from sigcat.catalogue.hosting.variants import instance_counts, instances_of
from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.function.node_uses import NodeUse, UseBelow, Uses
from sigcat.integration.autosar_names import branch_of, event_name, service_name, short_name
from sigcat.integration.ros2.names import field_name, message_name, topic_name
from sigcat.names import last_name
from sigcat.rules.record import Rule
from sigcat.web.pictures.range_bar import RangeBar, range_bar
from sigcat.web.views.overlay_draft import may_be_overlaid

_ORDER = ("type", "datatype", "unit", "min", "max", "default", "allowed", "enum", "ASILlevel", "description")
_PARTS = re.compile(r"[A-Za-z0-9]+|[^A-Za-z0-9]+")
MOST_CHILDREN = 400
"""Children that a page lists; the tree beside it has them all."""

Names = tuple[tuple[str, str], ...]
"""Names of a node elsewhere: (where, name)."""


class Crumb(NamedTuple):
    """A branch on the way to a node."""

    name: str
    path: str


class NodeView(NamedTuple):
    """A node, ready to be shown."""

    detail: schemas.Node
    crumbs: tuple[Crumb, ...]
    range: RangeBar | None
    attributes: tuple[schemas.Attribute, ...]
    values: Mapping[str, object]
    names: Names
    """The name of the node elsewhere: (where, name)."""
    names_are_patterns: bool
    """Whether the node represents its instances: their names differ at the `*`."""
    uses: tuple[NodeUse, ...]
    """Functions that use the node, or an instance of it where instances are folded."""
    uses_below: tuple[UseBelow, ...]
    """Functions that use nodes below it."""
    instances: int
    """In how many places of the tree the node stands, where instances are folded."""
    child_count: int
    may_be_overlaid: bool
    """Whether an overlay can change the node."""
    field_units: Mapping[str, str]
    """Units of the fields that the interfaces of functions have beside those of VSS."""


def node_view(catalogue: Catalogue, node: Node, field_units: Mapping[str, str], uses: Uses) -> NodeView:
    """Everything that the page of a node shows."""
    detail = node_detail(catalogue, node._replace(children=node.children[:MOST_CHILDREN]))
    used = tuple(uses.of_node.get(node.path, ()))
    values = {attribute.name: attribute.value for attribute in detail.attributes}
    instances = instances_of(catalogue, node.path)
    return NodeView(
        detail,
        tuple(_crumbs(node.path)),
        range_bar(node.values),
        tuple(sorted(detail.attributes, key=lambda attribute: _rank(attribute.name))),
        values,
        _patterns([_names(each, detail, used) for each in _innermost(instances) or (node,)]),
        bool(instances),
        used,
        tuple(uses.below.get(node.path, ())),
        0 if catalogue.is_expanded else instance_counts(catalogue).get(node.path, 0),
        len(node.children),
        may_be_overlaid(catalogue, node),
        field_units,
    )


def field_units_of(rules: Iterable[Rule]) -> dict[str, str]:
    """Units of fields by name, as the rules for interfaces have them: `cycleTime` → `ms`."""
    units: dict[str, str] = {}
    waiting = [rule.options.get("fields") for rule in rules]
    while waiting:
        fields = waiting.pop()
        for name, field in fields.items() if isinstance(fields, Mapping) else ():
            if isinstance(field, Mapping):
                unit = field.get("unit")
                if isinstance(unit, str) and " " not in unit:
                    units[name] = unit
                waiting.append(field.get("fields"))
    return units


def _crumbs(path: str) -> list[Crumb]:
    names = path.split(".")
    return [Crumb(name, ".".join(names[: position + 1])) for position, name in enumerate(names)]


def ordered(names: Iterable[str]) -> tuple[str, ...]:
    """Return names of identifying attributes first, then the rest in the order in which they were written."""
    return tuple(sorted(names, key=_rank))


def _rank(name: str) -> int:
    return _ORDER.index(name) if name in _ORDER else len(_ORDER)


def _names(node: Node, detail: schemas.Node, used: Sequence[NodeUse]) -> Names:
    """The name of a node by each set of rules for names."""
    names = [("VSS path", node.path), ("VISS path", node.path.replace(".", "/"))]
    if detail.interface_name:
        return (("Interface", detail.interface_name), *names, *_names_of_interface(detail.interface_name))
    if not node.is_leaf:
        return (*names, ("ROS 2 message", message_name(node.path.partition(".")[2] or node.path).text))
    return (*names, *_names_of_signal(node.path, used), ("Static id", static_id(node)))


def _innermost(instances: Sequence[Node]) -> list[Node]:
    """Return `Wheel.Left` and `Wheel.Right` of a branch with instances, without the `Wheel` that holds them."""
    deepest = max((each.path.count(".") for each in instances), default=0)
    return [each for each in instances if each.path.count(".") == deepest]


def _patterns(names: Sequence[Names]) -> Names:
    """The names that several nodes have, with a `*` for each part in which they differ. What they share is itself."""
    patterns = ((rows[0][0], _pattern([name for _, name in rows])) for rows in zip(*names, strict=True))
    return tuple((where, pattern) for where, pattern in patterns if pattern != "*")


def _pattern(names: Sequence[str]) -> str:
    """`row1_is_open` and `row2_is_open` → `*_is_open`."""
    first, *others = (_PARTS.findall(name) for name in names)
    if any(len(other) != len(first) for other in others):
        return "*"
    parts = zip(first, *others, strict=True)
    return "".join(same[0] if len(set(same)) == 1 else "*" for same in parts)


def _names_of_signal(path: str, used: Sequence[NodeUse]) -> Names:
    variable = field_name(path.partition(".")[2] or path).text
    provider = next((use.component for use in used if use.verb == "provides"), branch_of(path))
    service, event = service_name(provider), event_name(path)
    return (
        ("C", variable),
        ("C++ (ara::com)", f"{service}Proxy::{event}"),
        ("Python", variable),
        ("ROS 2 topic", topic_name(*path.split("."))),
        ("ROS 2 field", field_name(last_name(path)).text),
        ("SOME/IP event", event),
        ("AUTOSAR", f"{service}/{event}"),
    )


def _names_of_interface(name: str) -> Names:
    variable, event = field_name(name).text, short_name(name)
    return (
        ("C", variable),
        ("C++ (ara::com)", event),
        ("Python", variable),
        ("ROS 2 field", variable),
        ("SOME/IP event", event),
        ("AUTOSAR", event),
    )
