"""Search nodes by words, with filters and counts.

Sets of nodes are integers with one bit for each node, in tree order. Union, intersection and counting of 100,000
nodes then take microseconds, so that every key press can be answered with ranked results and the count of every filter.
"""

from array import array
from bisect import bisect_left
from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import lru_cache, reduce
from itertools import islice, product
from operator import and_
from pathlib import PurePath
from typing import NamedTuple

from sigcat.asil import level_of
from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.catalogue.model.interfaces import category_of
from sigcat.names import nearest, parent_path, words

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
    instead: tuple[str, ...] = ()
    """Texts near one that nothing has, which something has: words put right, taken apart or left out."""


class _Words:
    """Sorted words, and the nodes that have each: their numbers one after another, in the order of the words.

    A prefix is a range of words, so a range of numbers. The set of every block of numbers is known beforehand, so that
    a prefix costs a few unions and the numbers of two broken blocks, however many words and nodes it has.
    """

    def __init__(self, numbers_by_word: Mapping[str, Sequence[int]]) -> None:
        self.words = sorted(numbers_by_word)
        self._numbers = array("I")
        self._starts = array("I", [0])
        for word in self.words:
            self._numbers.extend(numbers_by_word[word])
            self._starts.append(len(self._numbers))
        whole = len(self._numbers) - len(self._numbers) % _BLOCK
        self._blocks = [_bits(self._numbers[start : start + _BLOCK]) for start in range(0, whole, _BLOCK)]

    def with_prefix(self, prefix: str) -> Bits:
        """Nodes with a word that begins with `prefix`."""
        return self._between(bisect_left(self.words, prefix), bisect_left(self.words, prefix + _LAST))

    def exactly(self, word: str) -> Bits:
        """Nodes with exactly this word."""
        position = bisect_left(self.words, word)
        is_known = position < len(self.words) and self.words[position] == word
        return self._between(position, position + 1) if is_known else 0

    def _between(self, first_word: int, last_word: int) -> Bits:
        start, end = self._starts[first_word], self._starts[last_word]
        first, last = -(-start // _BLOCK), end // _BLOCK
        if first >= last:
            return _bits(self._numbers[start:end])
        found = _bits(self._numbers[start : first * _BLOCK]) | _bits(self._numbers[last * _BLOCK : end])
        for block in self._blocks[first:last]:
            found |= block
        return found


_MOST_MENDED, _MOST_TRIED, _MOST_LISTED, _SHORTEST_PART = 8, 12, 4, 3
_BLOCK = 1024
_LAST = "\U0010ffff"
"""Sorts after every letter: what begins with a prefix sorts before the prefix and this."""


class SearchIndex:
    """The words of one catalogue. Built once for each catalogue; answers are computed, nothing is changed."""

    def __init__(self, catalogue: Catalogue) -> None:
        self._nodes = tuple(catalogue.nodes.values())
        self._everything: Bits = (1 << len(self._nodes)) - 1
        self._in_name = _Words(_by_word(_tokens(node.name) for node in self._nodes))
        self._in_path = _Words(_by_word(_path_tokens(self._nodes)))
        self._in_text = _Words(_by_word(_text_tokens(self._nodes, catalogue)))
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
        if total or not wanted:
            return SearchResult(nodes, total, facets, ())
        chosen = _common(allowed.values(), self._everything)
        return SearchResult(nodes, total, facets, self._near(wanted), self._instead(wanted[:_MOST_MENDED], chosen))

    def values_of(self, facet: str) -> Iterable[str]:
        """The values by which a filter finds nodes."""
        return self._facets[facet]

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

    def _is_known(self, word: str) -> bool:
        return bool(self._in_path.with_prefix(word) | self._in_text.with_prefix(word))

    def _near(self, wanted: list[str]) -> tuple[str, ...]:
        unknown = [word for word in wanted if not self._is_known(word)]
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
        if self._is_known(word):
            return (word,)
        parts = ((word[:i], word[i:]) for i in range(_SHORTEST_PART, len(word) - _SHORTEST_PART + 1))
        apart = (f"{one} {two}" for one, two in parts if self._is_known(one) and self._is_known(two))
        return nearest(word, self._in_path.words) or tuple(islice(apart, 1))


@lru_cache(maxsize=8192)
def _tokens(name: str) -> frozenset[str]:
    """Lower-case words of a name, and the whole of it, so that `wheelspeed` finds as `speed` does."""
    return frozenset((name.lower(), *(word.lower() for word in words(name))))


def _path_tokens(nodes: Iterable[Node]) -> Iterator[frozenset[str]]:
    """Tokens of every name of each node's path."""
    known: dict[str, frozenset[str]] = {"": frozenset()}
    for node in nodes:  # parents first
        tokens = known[parent_path(node.path)] | _tokens(node.name)
        if node.children:
            known[node.path] = tokens
        yield tokens


def _text_tokens(nodes: Iterable[Node], catalogue: Catalogue) -> Iterator[set[str]]:
    """Words of description, comment and unit. Instances share a definition: its words are found once."""
    known: dict[int, set[str]] = {}
    for node in nodes:
        key = id(node.definition)
        if key not in known:
            known[key] = _text_words(node, catalogue)
        yield known[key]


def _by_word(tokens_of_nodes: Iterable[Iterable[str]]) -> Mapping[str, Sequence[int]]:
    numbers: defaultdict[str, array[int]] = defaultdict(_no_numbers)
    for number, tokens in enumerate(tokens_of_nodes):
        for token in tokens:
            numbers[token].append(number)
    return numbers


def _no_numbers() -> "array[int]":
    return array("I")


def _text_words(node: Node, catalogue: Catalogue) -> set[str]:
    parts = [str(node.values.get(name) or "") for name in ("description", "comment", "unit", "datatype", "type")]
    unit = catalogue.unit(node)
    if unit is not None:
        parts += [unit.name, "".join(filter(str.isalnum, unit.key))]  # also `kmh`
    return {word.strip(".,;:()[]'\"").lower() for part in parts for word in part.split()} - {""}


def _bits(numbers: Sequence[int]) -> Bits:
    if not numbers:
        return 0
    mask = bytearray(max(numbers) // 8 + 1)
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
    "asil": lambda node: level_of(node.values.get("ASILlevel")) or "",
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
