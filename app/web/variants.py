"""Hosted catalogues with overlays switched off or instances folded: `interfaces~without.error~folded`.

A variant is named by the address like any other catalogue, so that a link to it shows the same. It is composed from
the layers in memory when it is first asked for.
"""

from collections.abc import Iterable
from functools import lru_cache
from pathlib import PurePath
from typing import NamedTuple

from app.catalogue.compose import unexpanded
from app.catalogue.hosting import Hosted, Library
from app.catalogue.model import Catalogue, Node
from app.catalogue.search import SearchIndex
from app.catalogue.trial import without_overlays
from app.errors import NotFound

_MARK, _FOLDED, _WITHOUT = "~", "folded", "without."


class Choice(NamedTuple):
    """What an id asks for: a hosted catalogue, less some overlays, and whether instances are folded."""

    base: str
    without: frozenset[str] = frozenset()
    is_folded: bool = False

    @property
    def id(self) -> str:
        """The id that asks for this."""
        parts = [self.base, *(f"{_WITHOUT}{name}" for name in sorted(self.without))]
        return _MARK.join([*parts, _FOLDED] if self.is_folded else parts)

    def toggled(self, overlay: str) -> "Choice":
        """With an overlay switched on or off."""
        return self._replace(without=self.without ^ {overlay})

    def folded(self, is_folded: bool) -> "Choice":
        """With instances folded, or one by one."""
        return self._replace(is_folded=is_folded)


def choice_of(catalogue_id: str) -> Choice:
    """What an id asks for. Parts that mean nothing stay with the base, so that it is not found."""
    base, *parts = catalogue_id.split(_MARK)
    unknown = [part for part in parts if part != _FOLDED and not part.startswith(_WITHOUT)]
    without = frozenset(part.removeprefix(_WITHOUT) for part in parts if part.startswith(_WITHOUT))
    return Choice(_MARK.join([base, *unknown]), without, _FOLDED in parts)


def find_hosted(library: Library, catalogue_id: str) -> Hosted:
    """The hosted catalogue or the variant of one with this id. Raises NotFound with the nearest ids."""
    if _MARK not in catalogue_id:
        return library.get(catalogue_id)
    choice = choice_of(catalogue_id)
    base = library.get(choice.base)
    absent = choice.without - set(overlays_of(base.catalogue))
    if absent:
        message = f"Catalogue {choice.base!r} has no overlay {min(absent)!r}."
        raise NotFound(message, (choice._replace(without=choice.without - absent).id,))
    if choice == Choice(choice.base):
        return base
    catalogue, index = _variant(base.catalogue, choice)
    notes = [f"without {name}" for name in sorted(choice.without)] + (["folded"] if choice.is_folded else [])
    title = f"{base.source.title}, {', '.join(notes)}"
    return base._replace(source=base.source._replace(id=choice.id, title=title), catalogue=catalogue, search_index=index)


def overlays_of(catalogue: Catalogue) -> tuple[str, ...]:
    """Names of a catalogue's overlays, in the order in which they apply."""
    return tuple(PurePath(layer.name).stem for layer in catalogue.layers if layer.is_overlay)


def counterpart(catalogue: Catalogue, node: Node | None, target: Catalogue) -> str:
    """Path in `target` of what a node of `catalogue` is there: itself, its definition, its first instance, or above."""
    if node is None:
        return ""
    if node.path in target.nodes:
        return node.path
    if node.template in target.nodes:
        return node.template
    return next((path for path, each in target.nodes.items() if each.template == node.path), "")


def instance_counts(catalogue: Catalogue) -> dict[str, int]:
    """How many places of the tree each branch with instances stands for, by the path of its definition."""
    return _counts(catalogue)


@lru_cache(maxsize=12)
def _variant(base: Catalogue, choice: Choice) -> tuple[Catalogue, SearchIndex]:
    catalogue = without_overlays(base, choice.without) if choice.without else base
    catalogue = unexpanded(catalogue) if choice.is_folded else catalogue
    return catalogue, SearchIndex(catalogue)


@lru_cache(maxsize=8)
def _counts(catalogue: Catalogue) -> dict[str, int]:
    counts: dict[str, int] = {}
    for path in _instantiated(catalogue.nodes.values()):
        counts[path] = counts.get(path, 0) + 1
    return counts


def _instantiated(nodes: Iterable[Node]) -> Iterable[str]:
    """Paths of definitions that stand in several places, once for each place in which it holds something."""
    return (node.template for node in nodes if node.template != node.path or node.definition.is_instance)
