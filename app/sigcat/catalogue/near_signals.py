"""Signals that a name in code may mean: `EngSpd`, `brake_pedal_pos`. Its words are compared with those of paths."""

import re
from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache
from itertools import combinations, islice
from math import log2
from typing import NamedTuple

from sigcat.catalogue.abbreviations import ABBREVIATIONS, OF_CODE
from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.catalogue.model.definition import SIGNALS
from sigcat.catalogue.model.interfaces import category_of, function_of
from sigcat.catalogue.search_words import Bits, Words, numbers_in, words_of_paths
from sigcat.names import last_name, parent_path, words

PLACEHOLDER = "TODO"
"""Branch of the paths that the author must choose, such as `Vehicle.TODO.EngSpd`; no tree has it."""

_EMPTY = frozenset(("in", "out", "inp", "outp", "input", "output", "sig", "signal", "val", "value", "raw", "flt", "filt",
                    "meas", "bus", "data", "var", "can", "u", "y", "x"))  # fmt: skip
"""Words without a meaning for the search."""
_MOST_WORDS, _MOST_COMPARED, _SHORTEST_BEGINNING, _SHORTEST_WORD = 6, 200, 3, 3
_LEAST_WEIGHT = 2.0
"""Words that more than a quarter of all paths have say nothing alone, such as that of the root."""


def is_to_be_chosen(path: str) -> bool:
    """Whether a path is a placeholder for one that the author must choose."""
    return last_name(parent_path(path)) == PLACEHOLDER


class Near(NamedTuple):
    """A signal that a name may mean."""

    node: Node
    matched: int
    """Words of the name that the path has."""
    wanted: int
    """Words of the name."""
    beyond: int
    """Words of the path that the name does not have, without the root."""
    beyond_last: int
    """Words among them in the last name."""
    weight: float
    """Weight of the matched words: a word that few paths have weighs more."""
    whole: int
    """Words that match whole words of the path, not their beginnings."""
    shares_word: bool
    """Whether one of these, and the word that it matches, has three letters or more."""

    @property
    def has_all(self) -> bool:
        """Whether the path has every word of the name."""
        return self.matched == self.wanted

    @property
    def rank(self) -> tuple[float, int, int, int, int]:
        """Return the sort key; the best one has the least."""
        return (-self.weight, self.beyond_last, -self.whole, self.beyond, self.node.path.count("."))


class NearSignals:
    """The signals of a catalogue by the words of their paths. Instances of one definition are separate."""

    def __init__(self, catalogue: Catalogue) -> None:
        nodes = list(catalogue.nodes.values())
        self._nodes = nodes
        self._words = Words(words_of_paths(enumerate(nodes)))
        self._signals: Bits = _bits(nodes)

    def near(self, name: str, limit: int = 3) -> tuple[Near, ...]:
        """The signals whose paths have most of the words of a name, best first; none if they have too few of them."""
        having = {word: self._with(word) for word in words_in_code(name)}
        weights = {word: log2(len(self._nodes) / bits.bit_count()) for word, bits in having.items() if bits}
        numbers = islice(_most_common(having, weights), _MOST_COMPARED)
        found = sorted((self._compared(number, having, weights) for number in numbers), key=lambda one: one.rank)
        return tuple(islice(filter(_says_enough, found), limit))

    def _with(self, word: str) -> Bits:
        found: Bits = 0
        for meaning in _meanings(word):
            common = self._signals
            for part in meaning.split():
                common &= self._words.beginning(part)
            found |= common
        return found

    def _compared(self, number: int, wanted: Mapping[str, Bits], weights: Mapping[str, float]) -> Near:
        node = self._nodes[number]
        path, known = _words_of(node.path)
        last = [word.lower() for word in words(last_name(node.path))]
        matched = {word: found for word in wanted if (found := _matching(word, known))}
        covered = frozenset(part for found in matched.values() for name in found.names for part in known[name])
        return Near(
            node,
            len(matched),
            len(wanted),
            sum(word not in covered for word in path),
            sum(word not in covered for word in last),
            sum(weights.get(word, 0.0) for word in matched),
            sum(found.is_whole for found in matched.values()),
            any(
                found.is_whole and min(map(len, (word, *found.names))) >= _SHORTEST_WORD
                for word, found in matched.items()
            ),
        )


def _says_enough(near: Near) -> bool:
    """Whether a path has all words of the name, or half of them and one whole, and these are not those of all paths."""
    return near.weight >= _LEAST_WEIGHT and (near.has_all or (2 * near.matched >= near.wanted and near.whole > 0))


def _most_common(having: Mapping[str, Bits], weights: Mapping[str, float]) -> Iterator[int]:
    """Numbers of signals that have all words, then those that have all but the one that says least, and so on."""
    told: Bits = 0
    for size in range(len(weights), 0, -1):
        chosen = sorted(combinations(weights, size), key=lambda some: -sum(weights[word] for word in some))
        for some in chosen:
            common = -1
            for word in some:
                common &= having[word]
            yield from numbers_in(common & ~told)
            told |= common
        if told:
            return


def _words_of(path: str) -> tuple[Sequence[str], Mapping[str, Sequence[str]]]:
    """The words below the root, without numbers; and what may be matched: each word, and each name whole, as its words."""
    root, *names = path.split(".")
    known: dict[str, Sequence[str]] = {root.lower(): ()}
    listed: list[str] = []
    for name in names:
        parts = [word.lower() for word in words(name) if not word.isdigit()]
        listed += parts
        known |= {name.lower(): parts, **{part: [part] for part in parts}}
    return listed, known


def _bits(nodes: Sequence[Node]) -> Bits:
    mask = bytearray(len(nodes) // 8 + 1)
    for number, node in enumerate(nodes):
        if _may_be_meant(node):
            mask[number >> 3] |= 1 << (number & 7)
    return int.from_bytes(mask, "little")


def _may_be_meant(node: Node) -> bool:
    """Signals that last, without the parameters of functions."""
    is_signal = (
        node.is_leaf and node.type in SIGNALS and category_of(node.path) == "data" and not function_of(node.path)
    )
    return is_signal and not node.values.get("deprecation")


def words_in_code(name: str) -> tuple[str, ...]:
    """The words of a name in code that say what is meant: of `rtU_EngSpd_raw` `eng` and `spd`."""
    found = [word.lower() for word in words(re.sub(r"(?<=[a-z])(?=[A-Z])", "_", name)) if not word.isdigit()]
    meant = [word for word in found if word not in _EMPTY and (len(word) > 1 or word in ABBREVIATIONS)]
    return tuple(dict.fromkeys(meant or found))[:_MOST_WORDS]


@lru_cache(maxsize=4096)
def _meanings(word: str) -> tuple[str, ...]:
    return (word, *ABBREVIATIONS.get(word, ()), *OF_CODE.get(word, ()))


class _Match(NamedTuple):
    """Words of a path that match a word of a name: whole words, or words that begin so."""

    names: tuple[str, ...]
    is_whole: bool


def _matching(word: str, known: Mapping[str, Sequence[str]]) -> _Match | None:
    begun = None
    for meaning in _meanings(word):
        parts = meaning.split()
        if all(part in known for part in parts):
            return _Match(tuple(parts), is_whole=True)
        found = tuple(_begun(part, known) for part in parts)
        if all(found) and begun is None:
            begun = _Match(found, is_whole=False)
    return begun


def _begun(beginning: str, known: Mapping[str, Sequence[str]]) -> str:
    if beginning in known:
        return beginning
    if len(beginning) < _SHORTEST_BEGINNING:
        return ""
    return next((word for word in known if word.startswith(beginning)), "")
