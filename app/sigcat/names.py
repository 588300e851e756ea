"""Names: the only casing code, and the search for names that were probably meant."""

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from itertools import takewhile
from math import inf

from sigcat.limits import COMPARED_NAMES

IDENTIFIER = re.compile(r"[A-Za-z][A-Za-z0-9_]{0,127}")
"""Names of elements in AUTOSAR."""
_MUCH_FARTHER = 12.0
_SHORT, _LEAST_OF_PARTS = 4, 50.0
_CAMEL_WORD = r"[A-Z]+(?=[A-Z][a-z])|[A-Z]?[a-z]+|[A-Z]+|[0-9]+"


def words(name: str) -> list[str]:
    """Words of a CamelCase, snake_case or dotted name: `ABSIsActive` → `ABS`, `Is`, `Active`."""
    return re.findall(_CAMEL_WORD, name)


def camel_case(name: str) -> str:
    """CamelCase with the capitals of abbreviations kept: `wheel_speed` → `WheelSpeed`."""
    parts = re.split(r"[^A-Za-z0-9]+", name)
    return "".join(part[:1].upper() + part[1:] for part in parts)


def snake_case(name: str) -> str:
    """lower_snake_case: `ABSIsActive` → `abs_is_active`; digits stay with the word before them."""
    joined = "_".join(words(name)).lower()
    return re.sub(r"_(?=[0-9])", "", joined)


def screaming_snake_case(name: str) -> str:
    """UPPER_SNAKE_CASE, as in VSS's enumeration keys."""
    return snake_case(name).upper()


def parent_path(path: str) -> str:
    """Path of the branch above: `A.B.C` → `A.B`; empty for a root."""
    return path.rpartition(".")[0]


def is_well_formed(path: str, most: int) -> bool:
    """Whether a dotted path has no empty name, and at most so many names."""
    names = path.split(".")
    return "" not in names and len(names) <= most


def last_name(path: str) -> str:
    """Last name of a dotted path: `A.B.C` → `C`."""
    return path.rpartition(".")[2]


def either(choices: Iterable[object]) -> str:
    """Names or numbers as a choice: `QM, A or B`."""
    *others, last = map(str, choices)
    return f"{', '.join(others)} or {last}" if others else last


def with_article(noun: str) -> str:
    """A noun behind its article: `branch` → `a branch`, `actuator` → `an actuator`."""
    return f"{'an' if noun[:1].lower() in ('a', 'e', 'i', 'o', 'u') else 'a'} {noun}"


def nearest(name: str, candidates: Iterable[str], limit: int = 3, cutoff: float = 75.0) -> tuple[str, ...]:
    """The candidates that `name` was probably meant to be, best first; case does not count.

    `cutoff` is the least similarity, from 0 to 100. What is much farther off than the best is not meant. Long paths are
    all alike in their beginnings: the parts that differ must be alike, too. Where nothing is near, a name that was cut short is completed: `v5` to `v5.0`.
    """
    from rapidfuzz import fuzz, process  # loaded only when something is wrong: start-up stays quick

    if not may_compare(0):
        return ()
    choices = {candidate: candidate.lower() for candidate in candidates}
    may_compare(len(choices))
    found = process.extract(name.lower(), choices, scorer=fuzz.ratio, limit=limit, score_cutoff=cutoff)
    matches = [match for match in found if _differ_little(name.lower(), match[0])]
    near = tuple(key for _, score, key in matches if score >= matches[0][1] - _MUCH_FARTHER)
    return near or _completed(name.lower(), choices, limit)


def _differ_little(name: str, candidate: str) -> bool:
    """Whether two dotted names end alike, or the parts that differ are alike; of short ones, all but one letter."""
    from rapidfuzz import fuzz
    from rapidfuzz.distance import OSA

    if "." in name and last_name(name) == last_name(candidate):
        return True
    part, other = _without_shared_beginning(name.split("."), candidate.split("."))
    if not part or not other or part in other:
        return True
    if max(len(part), len(other)) <= _SHORT:
        return OSA.distance(part, other) <= 1
    return fuzz.ratio(part, other) >= _LEAST_OF_PARTS


def _without_shared_beginning(parts: list[str], others: list[str]) -> tuple[str, str]:
    """Both names without the parts that they begin with alike."""
    start = sum(1 for _ in takewhile(lambda pair: pair[0] == pair[1], zip(parts, others, strict=False)))
    return ".".join(parts[start:]), ".".join(others[start:])


class _Budget:
    """Comparisons of names that a piece of work may still make."""

    def __init__(self, left: float) -> None:
        self.left = left


_comparisons: ContextVar[_Budget] = ContextVar("comparisons")
_UNBOUNDED = _Budget(inf)


@contextmanager
def bounded_proposals(comparisons: int = COMPARED_NAMES) -> Iterator[None]:
    """Within it, names are compared about so often in all; later errors are still found, without a proposal.

    A piece of work within another one, such as one file of several, has no more than is left of that.
    """
    around = _comparisons.get(_UNBOUNDED)
    given = min(around.left, comparisons)
    inner = _Budget(given)
    token = _comparisons.set(inner)
    try:
        yield
    finally:
        around.left -= given - inner.left
        _comparisons.reset(token)


def may_compare(names: int) -> bool:
    """Whether this piece of work may compare a name with so many others; they count."""
    budget = _comparisons.get(_UNBOUNDED)
    is_left = budget.left > 0
    budget.left -= names
    return is_left


def _completed(beginning: str, choices: Mapping[str, str], limit: int) -> tuple[str, ...]:
    """The candidates that begin so, if they are few."""
    found = tuple(key for key, lowered in choices.items() if lowered.startswith(beginning))
    return found if len(beginning) > 1 and len(found) <= limit else ()


def did_you_mean(name: str, candidates: Iterable[str]) -> str:
    """A sentence that proposes the nearest names, or nothing."""
    return question(nearest(name, candidates))


def did_you_mean_last(name: str, last_names: Mapping[str, str]) -> str:
    """A sentence that proposes the names whose last names, given by name, are near; or nothing."""
    near = nearest(name, last_names.values())
    return question(tuple(full for last in near for full, own in last_names.items() if own == last)[:3])


def question(near: Sequence[str]) -> str:
    """A sentence that proposes names; or nothing, if there are none."""
    return f"Did you mean {' or '.join(repr(candidate) for candidate in near)}?" if near else ""
