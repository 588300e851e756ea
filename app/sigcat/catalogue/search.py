"""Search nodes by words, with filters and counts.

Every key press is answered with ranked results and the count of every filter. What is found are sets of numbers of
nodes (`search_words.py`). The numbers are given so that their order is that of the results: signals before branches,
short paths before long ones, then as in the tree; instances of one definition have numbers one after another.
"""

import re
from array import array
from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cached_property, lru_cache, reduce
from itertools import islice, product
from operator import and_
from pathlib import PurePath
from typing import NamedTuple
from weakref import WeakKeyDictionary

from sigcat.asil import level_of
from sigcat.catalogue.exporting.static_id import static_id
from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.catalogue.model.interfaces import category_of
from sigcat.catalogue.search_words import (
    Bits,
    Words,
    bits_of,
    numbers_in,
    words_of_names,
    words_of_paths,
    words_of_texts,
)
from sigcat.errors import UsageError
from sigcat.limits import SEARCH_WORDS
from sigcat.names import nearest, words

FACETS = ("type", "datatype", "unit", "category", "asil", "overlay", "deprecated")


class Hit(NamedTuple):
    """A node that was found, and how many were found that share its definition. It is the first of them."""

    node: Node
    instances: int = 1


class SearchResult(NamedTuple):
    """Hits, best first, and the number of hits for each value of each filter."""

    hits: tuple[Hit, ...]
    total: int
    facets: Mapping[str, Mapping[str, int]]
    words: tuple[str, ...] = ()
    """Words of the search in lower case: those of the text, and those of generated names in it."""
    did_you_mean: tuple[str, ...] = ()
    """Words of the catalogue near a word that is nowhere in it."""
    instead: tuple[str, ...] = ()
    """Texts near one that nothing has, which something has: words put right, taken apart or left out."""

    @property
    def nodes(self) -> tuple[Node, ...]:
        """The nodes of the hits."""
        return tuple(hit.node for hit in self.hits)


_MOST_MENDED, _MOST_TRIED, _MOST_LISTED, _SHORTEST_PART = 8, 12, 4, 3
_STATIC_ID = re.compile(r"0x[0-9a-f]{8}", re.IGNORECASE)
_GENERATED = re.compile(r"[A-Za-z0-9_/:]+")
"""A name that code, a topic or a service may have."""
_SERVICE = re.compile(r".*::|[A-Za-z0-9_]+Service/(?=[^/]+$)")
"""Prefixes of the name of an event: `VehicleChassisServiceProxy::`, `VehicleChassisService/`."""
_ADDED = frozenset(("value", "message", "function"))
"""Words that generated names have beside those of the path: `switch_value`."""


class SearchIndex:
    """The words of one catalogue. Built once for each catalogue; answers are computed, nothing is changed."""

    def __init__(self, catalogue: Catalogue) -> None:
        in_tree = tuple(catalogue.nodes.values())
        groups = _groups(in_tree)
        positions = [position for group in groups for position in group]
        self._nodes = tuple(in_tree[position] for position in positions)
        self._in_tree_order = array("I", sorted(range(len(positions)), key=positions.__getitem__))
        self._everything: Bits = (1 << len(self._nodes)) - 1
        self._signals: Bits = (1 << sum(node.is_leaf for node in self._nodes)) - 1
        self._groups = _Groups([len(group) for group in groups])
        numbered = tuple(zip(self._in_tree_order, in_tree, strict=True))
        self._in_name = Words(words_of_names(numbered))
        self._in_path = Words(words_of_paths(numbered))
        self._in_text = Words(words_of_texts(numbered, catalogue))
        self._facets = {facet: _facet(self._nodes, _FACET_VALUES[facet]) for facet in FACETS}

    def search(
        self,
        text: str = "",
        filters: Mapping[str, str] | None = None,
        *,
        limit: int = 50,
        offset: int = 0,
        each_instance: bool = False,
    ) -> SearchResult:
        """Nodes in which every word of `text` begins a word of the path, the description or the unit.

        `text` may also be a static id, or have generated names in it. `filters` are exact values by facet: type,
        datatype, unit, category, asil, overlay, deprecated (`yes`, `no`). A name that was given whole comes first,
        then matches in the name, the path, the description; without words, all in the order of the tree. Instances
        that share a definition are one hit, unless `each_instance` is set. Raises UsageError for too many words.
        """
        allowed = {facet: self._facets[facet].get(value, 0) for facet, value in (filters or {}).items()}
        chosen = _common(allowed.values(), self._everything)
        wanted, ranks = self._best_reading(text, chosen)
        found = sum(ranks)  # ranks are disjoint: their sum is their union
        unfiltered = sum(self._ranked(wanted, self._everything)) if allowed else found
        shown = found if each_instance else self._groups.touched(found)
        unfiltered = unfiltered if each_instance else self._groups.touched(unfiltered)
        facets = {facet: self._counted(facet, allowed, shown, unfiltered) for facet in self._facets}
        if not found and wanted:
            near, instead = self._near(wanted), self._instead(wanted[:_MOST_MENDED], chosen)
            return SearchResult((), 0, facets, tuple(wanted), near, instead)
        numbers = self._in_order(ranks, found, is_ranked=bool(wanted), each_instance=each_instance)
        page = islice(numbers, offset, offset + limit)
        hits = tuple(Hit(self._nodes[n]) if each_instance else self._hit(n, found) for n in page)
        return SearchResult(hits, shown.bit_count(), facets, tuple(wanted))

    def values_of(self, facet: str) -> Iterable[str]:
        """The values by which a filter finds nodes."""
        return self._facets[facet]

    # -- what is found

    def _best_reading(self, text: str, chosen: Bits) -> tuple[list[str], list[Bits]]:
        """The words that are looked for, and what has them, in ranks."""
        if _STATIC_ID.fullmatch(text.strip()):
            return [text.strip().lower()], [self._with_static_id.get(text.strip().lower(), 0) & chosen]
        wanted = [word for part in text.replace(".", " ").split() for word in self._taken_apart(part)]
        if len(wanted) > SEARCH_WORDS:
            raise UsageError(f"The text to search for must have at most {SEARCH_WORDS} words, not {len(wanted)}.")
        ranks = self._ranked(wanted, chosen)
        without = [word for word in wanted if word not in _ADDED]
        if "_" in text and 0 < len(without) < len(wanted):
            ranks = list(_disjoint([*ranks, *self._ranked(without, chosen)]))
        return wanted, ranks

    def _taken_apart(self, word: str) -> list[str]:
        """A word unchanged if something has it; of a name, its words."""
        is_name = _GENERATED.fullmatch(word) and not self._in_path.knows(word.lower())
        if not is_name or self._in_name.knows(word.lower()) or ("_" not in word and self._in_text.knows(word.lower())):
            return [word.lower()]
        return [part.lower() for part in words(_SERVICE.sub("", word))] or [word.lower()]

    def _ranked(self, wanted: list[str], chosen: Bits) -> list[Bits]:
        """Disjoint sets of matches, best first."""
        in_name = in_path = anywhere = chosen
        last_in_name = 0
        for word in wanted:
            name = self._in_name.beginning(word)
            path = self._in_path.beginning(word) | name
            in_name &= name
            in_path &= path
            anywhere &= path | self._in_text.beginning(word)
            last_in_name = in_path & name
        if not wanted:
            return [chosen]
        called = in_path & self._called(wanted)
        signals = [kind & self._signals for kind in (in_name, last_in_name, in_path, anywhere)]
        return list(_disjoint([called, *signals, in_name, last_in_name, in_path, anywhere]))

    def _called(self, wanted: list[str]) -> Bits:
        """Nodes whose whole name was given, as one word or as the last ones: `Speed`, `wheel speed`."""
        found: Bits = 0
        for position, word in enumerate(wanted):
            found |= self._in_name.called(word) | self._in_name.called("".join(wanted[position:]))
        return found

    @cached_property
    def _with_static_id(self) -> Mapping[str, Bits]:
        """Nodes by static id: computed at the first request, since that takes long for large trees."""
        numbers: defaultdict[str, list[int]] = defaultdict(list)
        for number, node in enumerate(self._nodes):
            numbers[static_id(node).lower()].append(number)
        return {name: bits_of(found) for name, found in numbers.items()}

    # -- what is shown of it

    def _in_order(self, ranks: list[Bits], found: Bits, *, is_ranked: bool, each_instance: bool) -> Iterator[int]:
        """Numbers of nodes in the order of results: of all of them, or of the last of each group of instances."""
        if not is_ranked:
            return self._as_in_the_tree(found, each_instance=each_instance)
        shown = ranks if each_instance else _disjoint(self._groups.touched(rank) for rank in ranks)
        return (number for rank in shown for number in numbers_in(rank))

    def _as_in_the_tree(self, found: Bits, *, each_instance: bool) -> Iterator[int]:
        data = found.to_bytes(len(self._nodes) // 8 + 1, "little")
        seen: set[int] = set()
        for number in self._in_tree_order:
            shown = number if each_instance else self._groups.last_of(number)
            if data[number >> 3] >> (number & 7) & 1 and shown not in seen:
                seen.add(shown)
                yield shown

    def _hit(self, last: int, found: Bits) -> Hit:
        first = self._groups.first_of(last)
        if first == last:
            return Hit(self._nodes[last])
        instances = found >> first & ((1 << last - first + 1) - 1)
        return Hit(self._nodes[first + next(numbers_in(instances))], instances.bit_count())

    def _counted(self, facet: str, allowed: Mapping[str, Bits], found: Bits, unfiltered: Bits) -> dict[str, int]:
        """Counts by value; those of a filter that is set say what each other value would give in its place."""
        others = (bits for other, bits in allowed.items() if other != facet)
        return _counts(self._facets[facet], _common(others, unfiltered) if facet in allowed else found)

    # -- where nothing is found

    def is_known(self, word: str) -> bool:
        """Whether something has a word that begins so, in small letters. Of others near ones are looked for, which takes long."""
        return any(index.knows(word) for index in (self._in_name, self._in_path, self._in_text))

    def _near(self, wanted: list[str]) -> tuple[str, ...]:
        unknown = [word for word in wanted if not self.is_known(word)]
        return tuple(near for word in unknown[:3] for near in nearest(word, self._in_path.words))

    def _instead(self, wanted: list[str], chosen: Bits) -> tuple[str, ...]:
        """Texts with results: with each unknown word put right; failing that, with one word less."""
        corrected = [self._corrected(word) for word in wanted]
        right = [list(each) for each in islice(product(*(each for each in corrected if each)), _MOST_TRIED)]
        fewer = [first[:i] + first[i + 1 :] for first in right[:1] for i in reversed(range(len(first)))]
        for choices in (right, fewer):
            texts = [" ".join(choice) for choice in choices if choice]
            found = [text for text in texts if any(self._ranked(text.split(), chosen))]
            if found:
                return tuple(found[:_MOST_LISTED])
        return ()

    def _corrected(self, word: str) -> tuple[str, ...]:
        """A word itself if it is known; else the nearest ones, or else the two known words that it is made of."""
        if self.is_known(word):
            return (word,)
        parts = ((word[:i], word[i:]) for i in range(_SHORTEST_PART, len(word) - _SHORTEST_PART + 1))
        apart = (f"{one} {two}" for one, two in parts if self.is_known(one) and self.is_known(two))
        return nearest(word, self._in_path.words) or tuple(islice(apart, 1))


_indexes: WeakKeyDictionary[Catalogue, SearchIndex] = WeakKeyDictionary()


def has_index(catalogue: Catalogue) -> bool:
    """Whether the index of a catalogue is built."""
    return catalogue in _indexes


def index_of(catalogue: Catalogue) -> SearchIndex:
    """The index of a catalogue, built when it is first asked for."""
    if catalogue not in _indexes:
        _indexes[catalogue] = SearchIndex(catalogue)
    return _indexes[catalogue]


class _Groups:
    """Numbers one after another in groups, such as the instances of one definition."""

    def __init__(self, sizes: Sequence[int]) -> None:
        self._first = array("I")
        self._last = array("I")
        for size in sizes:
            first = len(self._first)
            self._first.extend([first] * size)
            self._last.extend([first + size - 1] * size)
        self._lasts: Bits = bits_of(sorted(set(self._last)))
        self._others: Bits = ((1 << len(self._last)) - 1) & ~self._lasts

    def first_of(self, number: int) -> int:
        """The first number of a group."""
        return self._first[number]

    def last_of(self, number: int) -> int:
        """The last number of a group, which represents it."""
        return self._last[number]

    def touched(self, found: Bits) -> Bits:
        """The last numbers of the groups of which any number was found.

        Adding ones to all but the last bit of a group carries into its last bit where any of the others is set.
        """
        return ((found & self._others) + self._others | found) & self._lasts


def _groups(nodes: Sequence[Node]) -> list[list[int]]:
    """Positions of nodes that share a definition, signals before branches, short paths before long ones."""
    groups: defaultdict[int, list[int]] = defaultdict(list)
    for position, node in enumerate(nodes):
        groups[id(node.definition)].append(position)
    return sorted(groups.values(), key=lambda group: _place(nodes[group[0]]))


def _place(node: Node) -> tuple[bool, int]:
    return not node.is_leaf, node.path.count(".")


def _facet(nodes: Sequence[Node], value_of: Callable[[Node], str]) -> dict[str, Bits]:
    numbers: defaultdict[str, list[int]] = defaultdict(list)
    for number, node in enumerate(nodes):
        value = value_of(node)
        if value:
            numbers[value].append(number)
    return {value: bits_of(numbers[value]) for value in sorted(numbers)}


@lru_cache(1024)
def overlay_name(overlay: str) -> str:
    """Return the name of an overlay in filters and on pages: that of its file, without folder and suffix."""
    return PurePath(overlay).stem


def _last_overlay(node: Node) -> str:
    statements = reversed(node.definition.statements)
    return next((overlay_name(each.file.overlay) for each in statements if each.file.overlay), "")


_FACET_VALUES: Mapping[str, Callable[[Node], str]] = {
    "type": lambda node: node.type,
    "datatype": lambda node: str(node.values.get("datatype") or ""),
    "unit": lambda node: str(node.values.get("unit") or ""),
    "category": lambda node: category_of(node.path) or "",
    "asil": lambda node: level_of(node.values.get("ASILlevel")) or "",
    "overlay": _last_overlay,
    "deprecated": lambda node: "yes" if node.values.get("deprecation") else "no",
}


def _common(sets: Iterable[Bits], everything: Bits) -> Bits:
    """Return the elements of every set."""
    return reduce(and_, sets, everything)


def _counts(values: Mapping[str, Bits], found: Bits) -> dict[str, int]:
    counts = {value: (bits & found).bit_count() for value, bits in values.items()}
    return {value: count for value, count in counts.items() if count}


def _disjoint(sets: Iterable[Bits]) -> Iterator[Bits]:
    """The sets, each without what one before it has."""
    taken: Bits = 0
    for bits in sets:
        yield bits & ~taken
        taken |= bits
