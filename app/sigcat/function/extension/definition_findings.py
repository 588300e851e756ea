"""Findings of the catalogue's rules about interfaces that a declaration defines."""

from collections.abc import Iterable, Mapping
from functools import cache
from typing import Any, NamedTuple

from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.data import INTERFACE_RULES
from sigcat.findings import Finding
from sigcat.function.document.document import Document, Pointer, Position, pointer_text
from sigcat.function.extension.defined_nodes import DefinedNode, Definitions
from sigcat.rules.compiled import compiled_rules
from sigcat.rules.engine import found_in
from sigcat.rules.rule_set import RuleSet


class DefinitionFindings(NamedTuple):
    """Findings of definitions, and the attributes in which there is one."""

    findings: tuple[Finding, ...] = ()
    attributes: frozenset[Pointer] = frozenset()
    """Pointers of the attributes, and of the nodes where an attribute is missing."""

    def are_about(self, node: DefinedNode, attribute: str) -> bool:
        """Whether one is about an attribute of a node."""
        return (node.pointer(attribute) if attribute in node.values else node.at) in self.attributes


class _Value(NamedTuple):
    """A value of a definition, and the attribute that it belongs to."""

    pointer: Pointer
    attribute: Pointer


def definition_findings(definitions: Definitions, document: Document, catalogue: Catalogue) -> DefinitionFindings:
    """Findings of shipped rules about definitions. `catalogue` has the definitions in it."""
    if not definitions:
        return DefinitionFindings()
    judged = catalogue.written_in({document.name})
    found = [each for each, _ in found_in(catalogue, _rules(), judged) if each.file == document.name]
    values = _values_by_position((*definitions.nodes, *definitions.types), document) if found else {}
    at = [values.get(Position(each.line, each.column), _Value(("define",), ("define",))) for each in found]
    return DefinitionFindings(
        tuple(each._replace(pointer=pointer_text(value.pointer)) for each, value in zip(found, at, strict=True)),
        frozenset(value.attribute for value in at),
    )


@cache
def _rules() -> RuleSet:
    """The shipped rules. Definitions that an overlay has as well define nothing new, which is intended."""
    rules = compiled_rules(INTERFACE_RULES)
    return RuleSet(rule for rule in rules if rule.default and rule.check != "overlay-no-effect")


def _values_by_position(nodes: Iterable[DefinedNode], document: Document) -> Mapping[Position, _Value]:
    """Values by position: findings of the catalogue know positions only."""
    found: dict[Position, _Value] = {}
    for node in nodes:
        found.setdefault(document.position(node.at), _Value(node.at, node.at))
        for attribute, value in node.values.items():
            at = node.pointer(attribute)
            for pointer in (at, *((*at, step) for step in _steps(value))):
                found.setdefault(document.position(pointer), _Value(pointer, at))
    return found


def _steps(value: Any) -> Iterable[int | str]:
    """Indexes of a list or keys of a mapping."""
    return range(len(value)) if isinstance(value, list) else value if isinstance(value, dict) else ()
