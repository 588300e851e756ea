"""Search nodes by words, with filters and counts.

Sets of nodes are integers with one bit for each node, in tree order. Union, intersection and counting of 100,000
nodes then take microseconds, so that every key press can be answered with ranked results and the count of every filter.
"""

from bisect import bisect_left
from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import reduce
from operator import and_
from pathlib import PurePath
from typing import NamedTuple

from app.catalogue.interfaces import category_of
from app.catalogue.model import Catalogue, Node
from app.names import nearest, words

Bits = int
"""A set of nodes: bit n stands for the n-th node of the catalogue."""

FACETS = ("type", "datatype", "unit", "category", "asil", "overlay", "deprecated")


class SearchResult(NamedTuple):
    """Nodes that match, best first, and how many match each value of each filter."""

    nodes: tuple[Node, ...]
    total: int
    facets: Mapping[str, Mapping[str, int]]
    did_you_mean: tuple[str, ...]
    """Words of the catalogue near a word that is nowhere in it."""


class _Vocabulary(NamedTuple):
    """Sorted words, and the nodes in which each stands."""

    words: list[str]
    bits: list[Bits]

    def with_prefix(self, prefix: str) -> Bits:
        """Nodes with a word that begins with `prefix`."""
        found = 0
        position = bisect_left(self.words, prefix)
        while position < len(self.words) and self.words[position].startswith(prefix):
            found |= self.bits[position]
            position += 1
        return found

    def exactly(self, word: str) -> Bits:
        """Nodes with exactly this word."""
        position = bisect_left(self.words, word)
        return self.bits[position] if position < len(self.words) and self.words[position] == word else 0


class SearchIndex:
    """The words of one catalogue. Built once for each catalogue; answers are computed, nothing is changed."""

    def __init__(self, catalogue: Catalogue) -> None:
        self._nodes = tuple(catalogue.nodes.values())
        self._everything: Bits = (1 << len(self._nodes)) - 1
        self._in_name = _index(self._nodes, lambda node: _tokens(node.name))
        self._in_path = _index(self._nodes, lambda node: _tokens(node.path))
        self._in_text = _text_index(self._nodes, catalogue)
        self._facets = {facet: _facet(self._nodes, _FACET_VALUES[facet]) for facet in FACETS}

    def search(
        self, text: str = "", filters: Mapping[str, str] | None = None, *, limit: int = 50, offset: int = 0
    ) -> SearchResult:
        """Nodes in which every word of `text` begins a word of the path, the description or the unit.

        `filters` are exact values by facet: type, datatype, unit, category, asil, overlay, deprecated (`yes`, `no`).
        A name matches before a path, a path before a description; then tree order.
        """
        wanted = [word.lower() for word in text.replace(".", " ").split()]
        allowed = {facet: self._facets[facet].get(value, 0) for facet, value in (filters or {}).items()}
        ranks = self._ranked(wanted, _common(allowed.values(), self._everything))
        found = sum(ranks)  # ranks are disjoint: their sum is their union
        total = found.bit_count()
        nodes = tuple(self._nodes[number] for number in _first(ranks, offset, limit))
        unfiltered = sum(self._ranked(wanted, self._everything)) if allowed else found
        facets = {facet: self._counted(facet, allowed, found, unfiltered) for facet in self._facets}
        return SearchResult(nodes, total, facets, () if total else self._near(wanted))

    def _counted(self, facet: str, allowed: Mapping[str, Bits], found: Bits, unfiltered: Bits) -> dict[str, int]:
        """Counts by value; those of a filter that is set say what each other value would give in its place."""
        others = (bits for other, bits in allowed.items() if other != facet)
        return _counts(self._facets[facet], _common(others, unfiltered) if facet in allowed else found)

    def _ranked(self, wanted: list[str], chosen: Bits) -> list[Bits]:
        """Disjoint sets of matches, best first."""
        in_name = in_path = exact = anywhere = chosen
        last_in_name = 0
        for word in wanted:
            name, path = self._in_name.with_prefix(word), self._in_path.with_prefix(word)
            in_name &= name
            exact &= self._in_name.exactly(word)
            in_path &= path
            anywhere &= path | self._in_text.with_prefix(word)
            last_in_name = in_path & name
        ranks: list[Bits] = []
        taken = 0
        for matches in (exact, in_name, last_in_name, in_path, anywhere):
            ranks.append(matches & ~taken)
            taken |= matches
        return ranks

    def _near(self, wanted: list[str]) -> tuple[str, ...]:
        unknown = [word for word in wanted if not (self._in_path.with_prefix(word) | self._in_text.with_prefix(word))]
        return tuple(near for word in unknown[:3] for near in nearest(word, self._in_path.words))


def _tokens(name: str) -> set[str]:
    """Lower-case words of a path, and its whole names, so that `wheelspeed` finds as `speed` does."""
    tokens = set()
    for part in name.split("."):
        tokens.add(part.lower())
        tokens.update(word.lower() for word in words(part))
    return tokens


def _index(nodes: tuple[Node, ...], tokens_of: Callable[[Node], set[str]]) -> _Vocabulary:
    numbers: defaultdict[str, list[int]] = defaultdict(list)
    for number, node in enumerate(nodes):
        for token in tokens_of(node):
            numbers[token].append(number)
    ordered = sorted(numbers)
    return _Vocabulary(ordered, [_bits(numbers[word]) for word in ordered])


def _text_index(nodes: tuple[Node, ...], catalogue: Catalogue) -> _Vocabulary:
    """Words of description, comment and unit. Instances share a definition: its words are found once."""
    numbers: defaultdict[int, list[int]] = defaultdict(list)
    definitions = {}
    for number, node in enumerate(nodes):
        numbers[id(node.definition)].append(number)
        definitions[id(node.definition)] = node
    by_word: defaultdict[str, Bits] = defaultdict(int)
    for key, node in definitions.items():
        bits = _bits(numbers[key])
        for word in _text_words(node, catalogue):
            by_word[word] |= bits
    ordered = sorted(by_word)
    return _Vocabulary(ordered, [by_word[word] for word in ordered])


def _text_words(node: Node, catalogue: Catalogue) -> set[str]:
    parts = [str(node.values.get(name) or "") for name in ("description", "comment", "unit", "datatype", "type")]
    unit = catalogue.unit(node)
    if unit is not None:
        parts.append(unit.name)
    return {word.strip(".,;:()[]'\"").lower() for part in parts for word in part.split()} - {""}


def _bits(numbers: list[int]) -> Bits:
    if len(numbers) == 1:
        return 1 << numbers[0]
    mask = bytearray(numbers[-1] // 8 + 1)
    for number in numbers:
        mask[number >> 3] |= 1 << (number & 7)
    return int.from_bytes(mask, "little")


def _facet(nodes: tuple[Node, ...], value_of: Callable[[Node], str]) -> dict[str, Bits]:
    numbers: defaultdict[str, list[int]] = defaultdict(list)
    for number, node in enumerate(nodes):
        value = value_of(node)
        if value:
            numbers[value].append(number)
    return {value: _bits(numbers[value]) for value in sorted(numbers)}


def overlay_name(overlay: str) -> str:
    """What an overlay is called in filters and on pages: the name of its file, without folder and suffix."""
    return PurePath(overlay).stem


def _last_overlay(node: Node) -> str:
    statements = reversed(node.definition.statements)
    return next((overlay_name(each.file.overlay) for each in statements if each.file.overlay), "")


_FACET_VALUES: Mapping[str, Callable[[Node], str]] = {
    "type": lambda node: node.type,
    "datatype": lambda node: str(node.values.get("datatype") or ""),
    "unit": lambda node: str(node.values.get("unit") or ""),
    "category": lambda node: category_of(node.path) or "",
    "asil": lambda node: str(node.values.get("ASILlevel") or ""),
    "overlay": _last_overlay,
    "deprecated": lambda node: "yes" if node.values.get("deprecation") else "no",
}


def _common(sets: Iterable[Bits], everything: Bits) -> Bits:
    """What is in every set."""
    return reduce(and_, sets, everything)


def _counts(values: Mapping[str, Bits], found: Bits) -> dict[str, int]:
    counts = {value: (bits & found).bit_count() for value, bits in values.items()}
    return {value: count for value, count in counts.items() if count}


def _first(ranks: list[Bits], offset: int, limit: int) -> Iterator[int]:
    """Numbers of the nodes from `offset` on, in order of rank and then of the tree."""
    for rank in ranks:
        count = rank.bit_count()
        if offset >= count:
            offset -= count
            continue
        for number in _numbers(rank):
            if offset:
                offset -= 1
                continue
            if limit <= 0:
                return
            limit -= 1
            yield number


def _numbers(bits: Bits) -> Iterator[int]:
    """Positions of the set bits, lowest first; a window at a time, so that the first cost little."""
    window, base = 4096, 0
    mask = (1 << window) - 1
    while bits:
        part = bits & mask
        while part:
            low = part & -part
            yield base + low.bit_length() - 1
            part ^= low
        bits >>= window
        base += window
