"""The export as JSON in parts: the first is there at once, and no more than a branch of it is held.

Byte for byte what `tree_json(tree_data(…))` makes in one piece; a test compares them.
"""

import json
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from sigcat.catalogue.exporting.export_json import tree_data, tree_json
from sigcat.catalogue.model.catalogue import Catalogue, Node

_AT_ONCE = 500
"""Nodes of a branch that are written as one part."""


_PART_BYTES = 64 * 1024
"""Size of a part: each passes from a thread to the event loop, which costs more than to make a hundred nodes."""


def json_parts(catalogue: Catalogue, options: Mapping[str, Any]) -> Iterator[bytes]:
    """The parts: the first piece at once, then parts of about the same size. `options` are as for `_pieces`."""
    pieces = _pieces(catalogue, options)
    yield next(pieces)
    part = bytearray()
    for piece in pieces:
        part += piece
        if len(part) >= _PART_BYTES:
            yield bytes(part)
            part.clear()
    if part:
        yield bytes(part)


def _pieces(catalogue: Catalogue, options: Mapping[str, Any]) -> Iterator[bytes]:
    """The JSON as it is made. `options` are those of the JSON export that say what is written; `pretty` makes it one part."""
    kept = tuple(options.get("extended-attributes", ()))
    wanted = {name: options.get(dashed, False) for name, dashed in _FLAGS.items()}
    if options.get("pretty") or len(catalogue.roots) > 1:
        yield tree_json(tree_data(catalogue, kept, **wanted), pretty=bool(options.get("pretty"))).encode()
        return
    root = catalogue.roots[0]
    writing = _Writing(catalogue, wanted["keep_instances"], _sizes(root))
    own = tree_data(_alone(catalogue, root), kept, **wanted)[root.name]
    yield f"{{{json.dumps(root.name)}: ".encode()
    yield from writing.node(root, own)
    yield b"}"


_FLAGS = {"all_extended": "extend-all-attributes", "keep_instances": "keep-instances"}


class _Writing:
    """Settings of all parts."""

    def __init__(self, catalogue: Catalogue, keep_instances: bool, sizes: Mapping[str, int]) -> None:
        self._catalogue = catalogue
        self._keep_instances = keep_instances
        self._sizes = sizes

    def node(self, node: Node, own: Mapping[str, Any]) -> Iterator[bytes]:
        """A branch with its own attributes and, where `children` is among the sorted keys, what is below."""
        before = b"{"
        for name in sorted({*own, "children"} if node.children else own):
            yield before + f"{json.dumps(name)}: ".encode()
            if name == "children" and node.children:
                yield from self._children(node)
            else:
                yield tree_json(own[name]).encode()
            before = b", "
        yield b"}" if own or node.children else b"{}"

    def _children(self, node: Node) -> Iterator[bytes]:
        before = "{"
        for child in sorted(node.children, key=lambda each: each.name):
            yield f"{before}{json.dumps(child.name)}: ".encode()
            yield from self._child(child)
            before = ", "
        yield b"}"

    def _child(self, child: Node) -> Iterable[bytes]:
        if self._sizes.get(child.path, 0) <= _AT_ONCE:
            return (tree_json(self._data(child)).encode(),)
        return self.node(child, self._data(child._replace(children=())))

    def _data(self, node: Node) -> dict[str, Any]:
        data = tree_data(_alone(self._catalogue, node), all_extended=True, keep_instances=self._keep_instances)
        return dict(data[node.name])


def _alone(catalogue: Catalogue, node: Node) -> Catalogue:
    """A catalogue of one branch; of the root, without what is below."""
    top = node._replace(children=()) if node is catalogue.roots[0] else node
    return Catalogue(catalogue.name, (top,), catalogue.vocabulary, (), (), catalogue.definitions, catalogue.is_expanded)


def _sizes(root: Node) -> dict[str, int]:
    """Nodes in the branches that have more than `_AT_ONCE`; smaller ones are not listed."""
    counts: dict[str, int] = {}
    for node in reversed(list(root.walk())):
        counts[node.path] = 1 + sum(counts.pop(child.path) if counts[child.path] <= _AT_ONCE else counts[child.path]
                                    for child in node.children)  # fmt: skip
    return {path: count for path, count in counts.items() if count > _AT_ONCE}
