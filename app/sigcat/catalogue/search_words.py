"""Index of nodes by their words, as sets of node numbers.

A set of nodes is an integer with one bit for each node. Union, intersection and counting of 100,000 nodes then take
microseconds.
"""

from array import array
from bisect import bisect_left
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import lru_cache, reduce
from operator import and_

from sigcat.catalogue.abbreviations import ABBREVIATIONS
from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.catalogue.model.interfaces import interface_name
from sigcat.names import parent_path, words

Bits = int
"""A set of nodes: bit n is the node with the number n."""

Numbered = Iterable[tuple[int, Iterable[str]]]
"""Numbers of nodes, each with words of the node."""

_BLOCK = 1024
_LAST = "\U0010ffff"
"""Sorts after every letter: what begins with a prefix sorts before the prefix and this."""
_END = " "
"""Ends a whole name, to distinguish it from the same word in a longer name. No search word has one."""


class Words:
    """Sorted words, and the nodes that have each: their numbers one after another, in the order of the words.

    A prefix is a range of words, so a range of numbers. The set of every block of numbers is known beforehand, so that
    a prefix costs a few unions and the numbers of two broken blocks, however many words and nodes it has.
    """

    def __init__(self, numbered: Numbered) -> None:
        numbers_by_word = _by_word(numbered)
        self.words = sorted(numbers_by_word)
        self._numbers = array("I")
        self._starts = array("I", [0])
        for word in self.words:
            self._numbers.extend(numbers_by_word[word])
            self._starts.append(len(self._numbers))
        whole = len(self._numbers) - len(self._numbers) % _BLOCK
        self._blocks = [bits_of(self._numbers[start : start + _BLOCK]) for start in range(0, whole, _BLOCK)]

    def knows(self, word: str) -> bool:
        """Whether any word begins so, or with the words of an abbreviation."""
        position = bisect_left(self.words, word)
        begins = position < len(self.words) and self.words[position].startswith(word)
        return begins or (word in ABBREVIATIONS and bool(self.beginning(word)))

    def beginning(self, word: str) -> Bits:
        """Nodes with a word that begins so, or with the words of an abbreviation."""
        found = self._with_prefix(word)
        for meaning in ABBREVIATIONS.get(word, ()):
            found |= reduce(and_, map(self._with_prefix, meaning.split()))
        return found

    def called(self, name: str) -> Bits:
        """Nodes with exactly this name, in small letters."""
        return self._exactly(name + _END)

    def _with_prefix(self, prefix: str) -> Bits:
        return self._between(bisect_left(self.words, prefix), bisect_left(self.words, prefix + _LAST))

    def _exactly(self, word: str) -> Bits:
        position = bisect_left(self.words, word)
        is_known = position < len(self.words) and self.words[position] == word
        return self._between(position, position + 1) if is_known else 0

    def _between(self, first_word: int, last_word: int) -> Bits:
        start, end = self._starts[first_word], self._starts[last_word]
        first, last = -(-start // _BLOCK), end // _BLOCK
        if first >= last:
            return bits_of(self._numbers[start:end])
        found = bits_of(self._numbers[start : first * _BLOCK]) | bits_of(self._numbers[last * _BLOCK : end])
        for block in self._blocks[first:last]:
            found |= block
        return found


def words_of_names(numbered: Iterable[tuple[int, Node]]) -> Numbered:
    """Words of each node's own name, the whole of it, and what interfaces and messages made of it are called."""
    for number, node in numbered:
        tokens, name = _name_tokens(node.name), interface_name(node.path)
        if name != node.path:
            tokens = tokens | _name_tokens(name)
        elif not node.is_leaf:
            tokens = tokens | {node.path.partition(".")[2].replace(".", "").lower() + _END}
        yield number, tokens


def words_of_paths(numbered: Iterable[tuple[int, Node]]) -> Numbered:
    """Words of every name of each node's path; parents come before what is below them.

    The label of an instance may have dots (V115): the path above the last one is then no node.
    """
    known: dict[str, frozenset[str]] = {"": frozenset()}
    for number, node in numbered:
        tokens = known.get(parent_path(node.path), frozenset()) | _tokens(node.name)
        if node.children:
            known[node.path] = tokens
        yield number, tokens


def words_of_texts(numbered: Iterable[tuple[int, Node]], catalogue: Catalogue) -> Numbered:
    """Words of description, comment and unit. Instances share a definition: its words are found once."""
    known: dict[int, set[str]] = {}
    for number, node in numbered:
        key = id(node.definition)
        if key not in known:
            known[key] = _text_words(node, catalogue)
        yield number, known[key]


def bits_of(numbers: Sequence[int]) -> Bits:
    """The set of some numbers, in any order."""
    if not numbers:
        return 0
    mask = bytearray(max(numbers) // 8 + 1)
    for number in numbers:
        mask[number >> 3] |= 1 << (number & 7)
    return int.from_bytes(mask, "little")


def numbers_in(bits: Bits) -> Iterator[int]:
    """The numbers of a set, lowest first; a window at a time, so that the first cost little."""
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


@lru_cache(maxsize=8192)
def _tokens(name: str) -> frozenset[str]:
    """Lower-case words of a name, and the whole of it, so that `wheelspeed` finds as `speed` does."""
    return frozenset((name.lower(), *(word.lower() for word in words(name))))


@lru_cache(maxsize=8192)
def _name_tokens(name: str) -> frozenset[str]:
    return frozenset((name.lower() + _END, *(word.lower() for word in words(name))))


def _by_word(numbered: Numbered) -> Mapping[str, Sequence[int]]:
    numbers: defaultdict[str, array[int]] = defaultdict(_no_numbers)
    for number, tokens in numbered:
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
