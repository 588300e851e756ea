"""What the page of a node shows: the node as the API has it, resolved further for readers."""

from collections.abc import Iterable, Mapping
from typing import NamedTuple

from app.api import schemas
from app.api.presenting import node_detail
from app.catalogue.model import Catalogue, Node
from app.catalogue.static_id import static_id
from app.integration.autosar_names import event_name, short_name
from app.integration.names import field_name, message_name
from app.rules.record import Rule
from app.web.range_bar import RangeBar, range_bar
from app.web.shelf import Use, uses
from app.web.variants import instance_counts

_ORDER = ("type", "datatype", "unit", "min", "max", "default", "allowed", "enum", "ASILlevel", "description")
MOST_CHILDREN = 400
"""Children that a page lists; the tree beside it has them all."""


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
    names: tuple[tuple[str, str], ...]
    """The name of the node elsewhere: (where, name)."""
    uses: tuple[Use, ...]
    """Shipped functions that use the node, or an instance of it where instances are folded."""
    instances: int
    """In how many places of the tree the node stands, where instances are folded."""
    child_count: int
    field_units: Mapping[str, str]
    """Units of the fields that the interfaces of functions have beside those of VSS."""


def node_view(catalogue: Catalogue, node: Node, field_units: Mapping[str, str]) -> NodeView:
    """Everything that the page of a node shows."""
    detail = node_detail(catalogue, node._replace(children=node.children[:MOST_CHILDREN]))
    values = {attribute.name: attribute.value for attribute in detail.attributes}
    return NodeView(
        detail,
        tuple(_crumbs(node.path)),
        range_bar(node.values),
        _ordered(detail.attributes),
        values,
        _names(node, detail),
        _uses(catalogue, node),
        0 if catalogue.is_expanded else instance_counts(catalogue).get(node.path, 0),
        len(node.children),
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


def _uses(catalogue: Catalogue, node: Node) -> tuple[Use, ...]:
    found = uses(catalogue)
    return tuple(found.get(node.path, ()))


def _crumbs(path: str) -> list[Crumb]:
    names = path.split(".")
    return [Crumb(name, ".".join(names[: position + 1])) for position, name in enumerate(names)]


def _ordered(attributes: list[schemas.Attribute]) -> tuple[schemas.Attribute, ...]:
    """What identifies a signal first, then the rest in the order in which it was written."""
    rank = {name: position for position, name in enumerate(_ORDER)}
    return tuple(sorted(attributes, key=lambda attribute: rank.get(attribute.name, len(rank))))


def _names(node: Node, detail: schemas.Node) -> tuple[tuple[str, str], ...]:
    names = [("VSS path", node.path), ("VISS path", node.path.replace(".", "/"))]
    if detail.interface_name:
        return (("Interface", detail.interface_name), *names, ("AUTOSAR", short_name(detail.interface_name)))
    if not node.is_leaf:
        return (*names, ("ROS 2 message", message_name(node.path.partition(".")[2] or node.path).text))
    below_root = node.path.partition(".")[2] or node.path
    return (
        *names,
        ("C, C++, Python", field_name(below_root).text),
        ("ROS 2 field", field_name(node.name).text),
        ("SOME/IP event", event_name(node.path)),
        ("AUTOSAR", event_name(node.path)),
        ("Static id", static_id(node)),
    )
