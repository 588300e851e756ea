"""The catalogue without values that are errors: a function is checked against the others."""

from sigcat import codes
from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.catalogue.model.definition import Definition

_OF_THE_RIGHT_KIND = (
    codes.DEFAULT_OUTSIDE_RANGE,
    codes.DEFAULT_NOT_ALLOWED,
    codes.LIMIT_OUTSIDE_DATATYPE,
    codes.UNIT_UNKNOWN,
)
"""Errors of values with which a function is checked nevertheless."""


def sound(catalogue: Catalogue) -> Catalogue:
    """Return the catalogue without attributes whose values are errors, which its findings report; itself if there are none."""
    if not any(_faulty(node.definition) for node in catalogue.nodes.values()):
        return catalogue
    return catalogue.with_roots(tuple(map(sound_node, catalogue.roots)), is_expanded=catalogue.is_expanded)


def _faulty(definition: Definition) -> frozenset[str]:
    errors = (each for each in definition.problems if each.rule.severity == "error")
    return frozenset(each.attribute for each in errors if each.rule not in _OF_THE_RIGHT_KIND)


def sound_node(node: Node) -> Node:
    """Return a node, and those below it, without attributes whose values are errors."""
    definition, faulty = node.definition, _faulty(node.definition)
    if faulty:
        values = {name: value for name, value in definition.values.items() if name not in faulty}
        definition = Definition(
            definition.path, definition.statements, values, definition.problems, definition.is_instance
        )
    return Node(node.path, definition, tuple(map(sound_node, node.children)))
