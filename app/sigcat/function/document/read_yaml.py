"""YAML with positions: bytes in, a document out."""

from collections.abc import Iterator

from yaml.nodes import CollectionNode, MappingNode, Node, ScalarNode, SequenceNode

from sigcat import codes
from sigcat.catalogue.reading.yaml_document import (
    Builder,
    Unbuildable,
    duplicate_keys,
    merged_pairs,
    position,
    read_document,
)
from sigcat.digest import digest_of
from sigcat.findings import Finding
from sigcat.function.document.document import Document, Pointer, Position
from sigcat.function.document.duplicates import duplicate_key
from sigcat.function.document.size import too_crowded
from sigcat.limits import DEFAULT_LIMITS, Limits


def read_yaml(data: bytes, name: str, limits: Limits = DEFAULT_LIMITS) -> Document:
    """Read YAML. A key given twice is a finding, and so is a value that YAML cannot build."""
    crowded = too_crowded(data, name, limits, (b"{", b"[", b"- "))
    if crowded is not None:
        return Document(name, digest_of(data), None, (crowded,), _YamlPositions(None))
    document = read_document(data, name, limits)
    findings = list(document.findings)
    value = None
    if document.root is not None:
        try:
            value = Builder(limits, len(document.text)).value(document.root)
            findings.extend(_duplicates(document.root, name))
        except Unbuildable as error:
            findings.append(codes.NOT_A_VALUE.finding(str(error), name, *position(error.node)))
    if value is None and not findings:
        findings.append(codes.FIELD_MISSING.finding("The file is empty.", name, 1, 1))

    return Document(name, digest_of(data), value, tuple(findings), _YamlPositions(document.root))


class _YamlPositions:
    """Positions of values in YAML. A mapping is indexed when it is first looked into: it may have many keys."""

    def __init__(self, root: Node | None) -> None:
        self._root = root
        self._pairs: dict[int, dict[str, tuple[Node, Node]]] = {}

    def __call__(self, pointer: Pointer, *, of_key: bool = False) -> Position:
        if self._root is None:
            return Position()
        found = position(self._root)
        node = self._root
        for part in pointer:
            step = self._step(node, part)
            if step is None:
                break
            key, node = step
            found = position(key if of_key or isinstance(node, CollectionNode) else node)
        return Position(*found)

    def _step(self, node: Node, part: str | int) -> tuple[Node, Node] | None:
        """The key and the value that a part of a pointer leads to; an item of a sequence is its own key."""
        if isinstance(node, SequenceNode) and isinstance(part, int) and part < len(node.value):
            return node.value[part], node.value[part]
        if not isinstance(node, MappingNode) or not isinstance(part, str):
            return None
        if id(node) not in self._pairs:
            pairs = ((key, value) for key, value in merged_pairs(node) if isinstance(key, ScalarNode))
            self._pairs[id(node)] = {key.value: (key, value) for key, value in pairs}
        return self._pairs[id(node)].get(part)


def _duplicates(root: Node, name: str) -> Iterator[Finding]:
    waiting, seen = [root], set()
    while waiting:
        node = waiting.pop()
        if id(node) in seen or not isinstance(node, CollectionNode):
            continue
        seen.add(id(node))
        if isinstance(node, MappingNode):
            for key, first in duplicate_keys(node):
                yield duplicate_key(key.value, name, Position(*position(key)), Position(*position(first)))
            waiting.extend(value for _, value in node.value)
        else:
            waiting.extend(node.value)
