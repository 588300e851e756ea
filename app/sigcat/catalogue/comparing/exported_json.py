"""A catalogue from an exported JSON: what `sigcat export json` and `vspec export json` write, read back.

An export says which units and struct types its nodes have, not what these are, so neither is checked here. It has
lost some attributes (`UNKNOWN`); of an expanded one, the instances are found again by what they share with the
branch above them.

Exports of releases before VSS 5.0 have a `uuid` at each node, by which they are known. They are read as the trees of
that time are: older words as the present ones, and what was not checked then is a warning.
"""

import hashlib
import json
import re
from collections.abc import Collection, Mapping, Sequence
from pathlib import Path
from typing import Any

from yaml.nodes import MappingNode, ScalarNode
from yaml.nodes import Node as YamlNode

from sigcat import codes
from sigcat.catalogue.comparing.changes import ORDER
from sigcat.catalogue.composing.compose import compose
from sigcat.catalogue.composing.instance_names import levels_of_instances
from sigcat.catalogue.composing.older_releases import tolerant, with_present_spellings
from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.catalogue.model.definition import BRANCH, Definition
from sigcat.catalogue.reading.layers import Layer
from sigcat.catalogue.reading.statement import Origin, SourceFile, Statement
from sigcat.catalogue.reading.whole_numbers import whole_number
from sigcat.catalogue.reading.yaml_document import Document, position, read_document
from sigcat.errors import InputRefused
from sigcat.findings import Finding
from sigcat.limits import DEFAULT_LIMITS, Limits

UNKNOWN = frozenset(("arraysize", "aggregate", "uuid", "instances", ORDER))
"""Attributes that are not compared: an export may have lost them or, for `uuid`, have made them from the path.

Of `instances`, the nodes that they made are compared.
"""
_REPEATED = ("type", "description", "comment")
"""Attributes that older exports repeat in the instances of a branch; exports of today repeat all."""
_REFERS_OUTSIDE = frozenset(
    rule.id for rule in (codes.DATATYPE_UNKNOWN, codes.UNIT_UNKNOWN, codes.UNIT_OF_WRONG_DATATYPE, codes.UNITS_MISSING)
)
"""Findings about units and struct types, which an export may not carry along."""
_TYPES = "ComplexDataTypes"
_HALVES = re.compile(r"\\u([dD][89abAB][0-9a-fA-F]{2})\\u([dD][c-fC-F][0-9a-fA-F]{2})|\\u[dD][89a-fA-F][0-9a-fA-F]{2}")
"""A character that JSON escapes as two halves (surrogates), or one half alone, which is not a character."""

Positions = Mapping[str, tuple[int, int]]
Lost = Mapping[str, Mapping[str, Any]]
"""Facts that an export lacks about its nodes, by path, where another tree has them."""

NOTHING_LOST: Lost = {}
_SHAPING: Mapping[str, Any] = {"instantiate": False, "instances_relation": "sibling"}
"""Attributes that decide where instances stand, and are not exported: where they say what they would not by themselves."""


def lost_in_exports(catalogue: Catalogue) -> Lost:
    """Return the facts that an export of this catalogue, or of one like it, lacks for its expansion."""
    written = (node for node in catalogue.nodes.values() if not node.definition.is_instance)
    return {path: lost for node in written if (lost := _shaping(node)) for path in (node.path, node.template)}


def _shaping(node: Node) -> Mapping[str, Any]:
    values = node.definition.values
    return {name: value for name, value in _SHAPING.items() if values.get(name) == value}


def read_export(
    path: Path, overlays: Sequence[Layer] = (), limits: Limits = DEFAULT_LIMITS, lost: Lost = NOTHING_LOST
) -> Catalogue:
    """The catalogue of an exported file. Raises InputRefused if it is not JSON."""
    if path.stat().st_size > limits.file_bytes:
        message = f"The file has {path.stat().st_size:,} bytes; the limit is {limits.file_bytes:,}."
        raise _refused(str(path), codes.FILE_TOO_LARGE.finding(message, str(path)))
    return catalogue_from_export(path.read_bytes(), str(path), overlays, limits, lost)


def catalogue_from_export(
    data: bytes,
    name: str,
    overlays: Sequence[Layer] = (),
    limits: Limits = DEFAULT_LIMITS,
    lost: Lost = NOTHING_LOST,
) -> Catalogue:
    """The catalogue of an export, with its instances expanded. Raises InputRefused if it is not JSON."""
    document = _positions_of(data, name, limits)
    content = _content(data, name)
    if not isinstance(content, dict) or not isinstance(document.root, MappingNode):
        raise _refused(name, codes.NOT_A_MAPPING.finding("The file must be an object of root nodes.", name, 1, 1))
    source = SourceFile(name, "", hashlib.sha256(data).hexdigest())
    reading = _Reading(source, lost)
    pairs = _pairs(document.root)
    types = content.pop(_TYPES, None)
    reading.read_children("", content, document.root)
    base = _layer(source, reading)
    is_older = any("uuid" in statement.values for statement in base.statements)
    layers = [with_present_spellings(base) if is_older else base, *overlays]
    type_layers = []
    if types is not None:
        reading = _Reading(source)
        reading.read_children("", types, pairs[_TYPES][1])
        type_layers.append(_layer(source, reading))
    catalogue = compose(layers, types=type_layers, name=Path(name).stem, limits=limits)
    found = _with_instances_found(catalogue)
    return tolerant(found) if is_older else found


class _Exported(Statement):
    """A node of an export, with a position for each attribute: lines may be far longer than those of a vspec file."""

    __slots__ = ("_position", "_positions")

    def __init__(
        self, path: str, file: SourceFile, values: Mapping[str, Any], position: tuple[int, int], positions: Positions
    ) -> None:
        super().__init__(path, file, values, 0, ())
        self._position = position
        self._positions = positions

    def origin(self, attribute: str = "") -> Origin:
        """Position of the value of `attribute`; of the node's key if the attribute is empty or not here."""
        return Origin(self.file.name, *self._positions.get(attribute, self._position), self.file.overlay)

    def origin_of_key(self, attribute: str) -> Origin:
        """Position of the value: in JSON its key is before it on the same line."""
        return self.origin(attribute)


class _Reading:
    """The statements and findings of one tree of an export."""

    def __init__(self, source: SourceFile, lost: Lost = NOTHING_LOST) -> None:
        self.source = source
        self._lost = lost
        self.statements: list[Statement] = []
        self.findings: list[Finding] = []

    def read_children(self, above: str, children: Any, document: YamlNode) -> None:
        """Read the nodes of an object of nodes by name, and all below them."""
        if not isinstance(children, dict) or not isinstance(document, MappingNode):
            self._wrong(above, document, "The children must be an object of nodes.")
            return
        pairs = _pairs(document)
        for name, values in children.items():
            key, value = pairs[name]
            path = f"{above}.{name}" if above else name
            if isinstance(values, dict) and isinstance(value, MappingNode):
                self._read_node(path, values, key, value, children)
            else:
                self._wrong(path, value, "A node must be an object with `type`.")

    def _read_node(
        self, path: str, values: dict[str, Any], key: YamlNode, document: MappingNode, beside: Collection[str]
    ) -> None:
        pairs = _pairs(document)
        positions = {name: position(value) for name, (_, value) in pairs.items()}
        written = {name: value for name, value in values.items() if name != "children"}
        own = {**self._lost.get(path, {}), **written}
        if _stands_beside_its_instances(own, beside):
            del own["instances"]
        self.statements.append(_Exported(path, self.source, own, position(key), positions))
        if "children" in values:
            self.read_children(path, values["children"], pairs["children"][1])

    def _wrong(self, path: str, document: YamlNode, message: str) -> None:
        self.findings.append(codes.NOT_A_MAPPING.finding(message, self.source.name, *position(document), path))


def _stands_beside_its_instances(values: Mapping[str, Any], beside: Collection[str]) -> bool:
    """Whether the instances that a branch still names were expanded beside it."""
    if values.get("instances_relation") != "sibling" or "instances" not in values:
        return False
    return all(name in beside for name in next(levels_of_instances(values), ()))


def _positions_of(data: bytes, name: str, limits: Limits) -> Document:
    """The document read as YAML, for its positions. YAML reads all of JSON except characters escaped as two halves."""
    if b"\\u" in data:
        data = _HALVES.sub(_whole_character, data.decode("utf-8", "surrogateescape")).encode("utf-8", "surrogateescape")
    document = read_document(data, name, limits)
    if document.findings:
        raise _refused(name, *document.findings)
    return document


def _whole_character(halves: re.Match[str]) -> str:
    if halves[1] is None:
        return "\\uFFFD"
    high, low = int(halves[1], 16), int(halves[2], 16)
    return f"\\U{0x10000 + ((high - 0xD800) << 10) + (low - 0xDC00):08x}"


def _content(data: bytes, name: str) -> Any:
    """The document read as JSON, for its values: YAML reads 1e-05 as text."""
    try:
        return json.loads(data.decode("utf-8-sig"), parse_int=whole_number)
    except json.JSONDecodeError as error:
        finding = codes.NOT_YAML.finding(f"Not valid JSON: {error.msg}.", name, error.lineno, error.colno)
        raise _refused(name, finding) from None
    except ValueError as error:
        raise _refused(name, codes.NOT_A_VALUE.finding(f"A value cannot be read: {error}.", name, 1, 1)) from None


def _refused(name: str, *findings: Finding) -> InputRefused:
    return InputRefused(f"{name} is not an exported tree", findings)


def _pairs(document: MappingNode) -> dict[str, tuple[YamlNode, YamlNode]]:
    """Keys and values by name; of a name that is given twice the last one counts, as in JSON."""
    return {key.value: (key, value) for key, value in document.value if isinstance(key, ScalarNode)}


def _layer(source: SourceFile, reading: _Reading) -> Layer:
    return Layer(source.name, False, (source,), tuple(reading.statements), tuple(reading.findings))


# -- instances ----------------------------------------------------------------------------------------------------


def _with_instances_found(catalogue: Catalogue) -> Catalogue:
    """The catalogue with the definition of each node under the path that it has without the names of instances."""
    known: dict[tuple[int, str, bool], Definition] = {}
    roots = tuple(_found(root, root.template, False, known) for root in catalogue.roots)
    findings = tuple(finding for finding in catalogue.findings if finding.rule not in _REFERS_OUTSIDE)
    return catalogue.with_roots(roots, is_expanded=True).with_findings(findings)


def _found(node: Node, template: str, is_instance: bool, known: dict[tuple[int, str, bool], Definition]) -> Node:
    children = []
    for child in node.children:
        generated = child.definition.is_instance or _repeats(node, child)
        path = template if generated else f"{template}.{child.name}"
        if child.definition.is_instance and child.template != node.template:  # beside its branch, not below it
            path = child.template
        children.append(_found(child, path, generated, known))
    key = (id(node.definition), template, is_instance)
    if key not in known:
        own = node.definition
        known[key] = Definition(template, own.statements, own.values, own.problems, is_instance)
    return Node(node.path, known[key], tuple(children))


def _repeats(node: Node, child: Node) -> bool:
    """Whether a branch is an instance of the one above it: an expansion repeats all that a branch says in each."""
    if not (node.type == child.type == BRANCH and child.children):
        return False
    above, own = _without_uuid(node), _without_uuid(child)
    return own in (above, {name: value for name, value in above.items() if name in _REPEATED})


def _without_uuid(node: Node) -> Mapping[str, Any]:
    return {name: value for name, value in node.values.items() if name != "uuid"}
