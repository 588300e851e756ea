"""An overlay to begin with: one that changes a node, or adds one below a branch."""

from collections.abc import Mapping
from typing import Any

from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.catalogue.model.definition import BRANCH
from sigcat.catalogue.model.interfaces import category_of
from sigcat.function.extension.overlay import statement_text

_NEW: Mapping[str, Any] = {
    "type": "sensor",
    "datatype": "float",
    "unit": "percent",
    "description": "What the value means.",
}


def may_be_overlaid(catalogue: Catalogue, node: Node) -> bool:
    """Whether an overlay can change a node: those of struct types it cannot."""
    return node.path.partition(".")[0] == catalogue.roots[0].name


def changing_draft(node: Node) -> str:
    """An overlay with all that a node says now, to be edited."""
    return f"# Change the attributes you need and delete the others.\n{statement_text(node.path, node.values)}"


def adding_draft(catalogue: Catalogue, node: Node) -> str:
    """An overlay that adds a signal below a branch, or beside a signal; of instances, below their definition."""
    branch = node if node.type == BRANCH else catalogue.parent(node) or node
    names = {child.name for child in branch.children}
    name = next(f"New{n or ''}" for n in range(len(names) + 1) if f"New{n or ''}" not in names)
    text = statement_text(f"{branch.template}.{name}", _values_beside(node, branch))
    return f"# Give it its name, and say what it is.\n{text}"


def _values_beside(node: Node, branch: Node) -> Mapping[str, Any]:
    """Return attribute values of an existing error, mode or call as a template of the needed attributes."""
    beside = node if node.is_leaf else next((child for child in branch.children if child.is_leaf), branch)
    return _NEW if category_of(beside.path) in (None, "data") else beside.values
