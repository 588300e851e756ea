"""Find the node that a path means: itself, the definition of instances, or near paths."""

from typing import NamedTuple

from sigcat.catalogue.composing.compose import unexpanded
from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.catalogue.search import index_of
from sigcat.errors import NotFound
from sigcat.names import nearest

_LETTERS_OF_A_PART = 2


class Found(NamedTuple):
    """A node, the catalogue that has it, and its instances where it is their definition."""

    node: Node
    catalogue: Catalogue
    """With instances folded where the node is a definition."""
    instances: tuple[Node, ...] = ()


def find_node(text: str, catalogue: Catalogue) -> Found:
    """Return the node at a path, with dots or slashes. Raises NotFound with paths that may have been meant."""
    path = text.replace("/", ".").strip(".")
    node = catalogue.get(path)
    if node is not None:
        return Found(node, catalogue)
    if path in catalogue.definitions:
        folded = unexpanded(catalogue)
        if node := folded.get(path):
            instances = tuple(each for each in catalogue.nodes.values() if each.template == path)
            return Found(node, folded, instances)
        origin = catalogue.definitions[path].origin("delete")
        raise NotFound(f"unknown node {text!r}: it is removed at {origin.file}:{origin.line}", ())
    near = _near(path, catalogue)
    hint = f" Did you mean {' or '.join(near)}?" if near else ""
    raise NotFound(f"unknown node {text!r}.{hint}", near)


def _near(path: str, catalogue: Catalogue) -> tuple[str, ...]:
    """Return the nearest paths, or else nodes that have the words, or words that are near."""
    near = nearest(path, dict.fromkeys((*catalogue.nodes, *catalogue.definitions)))
    if near or not path.strip():
        return near
    index = index_of(catalogue)
    found = index.search(path, limit=3)
    corrected = [text for text in found.instead if len(text.split()) == len(found.words)]
    if corrected:
        found = index.search(corrected[0], limit=3)
    return tuple(node.path for node in found.nodes if all(_is_near(word, node.path) for word in found.words))


def _is_near(word: str, path: str) -> bool:
    """Whether a word that was found says anything: parts of a code, such as `co`, `2` and `x`, are in many texts."""
    return len(word) > _LETTERS_OF_A_PART or word in path.lower()
