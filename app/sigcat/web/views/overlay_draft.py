"""Nodes that an overlay can change or add, and the values of a new one."""

from collections.abc import Mapping
from typing import Any

from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.catalogue.model.definition import BRANCH
from sigcat.catalogue.model.interfaces import category_of

_NEW: Mapping[str, Any] = {
    "type": "sensor",
    "datatype": "float",
    "unit": "percent",
    "description": "What the value means.",
}


def may_be_overlaid(catalogue: Catalogue, node: Node) -> bool:
    """Whether an overlay can change a node: those of struct types it cannot."""
    return node.path.partition(".")[0] == catalogue.roots[0].name


def new_node(catalogue: Catalogue, node: Node) -> tuple[str, Mapping[str, Any]]:
    """A free path below a branch, or beside a signal, and values to begin with; of instances, below their definition."""
    branch = node if node.type == BRANCH else catalogue.parent(node) or node
    names = {child.name for child in branch.children}
    name = next(f"New{n or ''}" for n in range(len(names) + 1) if f"New{n or ''}" not in names)
    return f"{branch.template}.{name}", _values_beside(node, branch)


def _values_beside(node: Node, branch: Node) -> Mapping[str, Any]:
    """Return attribute values of an existing error, mode or call as a template of the needed attributes."""
    beside = node if node.is_leaf else next((child for child in branch.children if child.is_leaf), branch)
    return _NEW if category_of(beside.path) in (None, "data") else beside.values
