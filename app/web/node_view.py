"""What the page of a node shows: the node as the API has it, resolved further for readers."""

from collections.abc import Mapping
from typing import NamedTuple

from app.api import schemas
from app.api.presenting import node_detail
from app.catalogue.model import Catalogue, Node
from app.names import snake_case
from app.web.range_bar import RangeBar, range_bar

_ORDER = ("type", "datatype", "unit", "min", "max", "default", "allowed", "enum", "ASILlevel", "description")


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


def node_view(catalogue: Catalogue, node: Node) -> NodeView:
    """Everything that the page of a node shows."""
    detail = node_detail(catalogue, node)
    values = {attribute.name: attribute.value for attribute in detail.attributes}
    return NodeView(
        detail,
        tuple(_crumbs(node.path)),
        range_bar(node.values),
        _ordered(detail.attributes),
        values,
        _names(node, detail),
    )


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
        names.insert(0, ("Interface", detail.interface_name))
    if node.is_leaf:
        below_root = node.path.removeprefix(f"{node.path.partition('.')[0]}.")
        names += [("C, Python", snake_case(below_root)), ("ROS 2 field", snake_case(node.name))]
    return tuple(names)
