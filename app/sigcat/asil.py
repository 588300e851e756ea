"""Automotive Safety Integrity Levels (ISO 26262): QM, then A to D. Their order, and how they may be spelled."""

from collections.abc import Mapping
from typing import Literal, get_args

Level = Literal["QM", "A", "B", "C", "D"]

LEVELS: tuple[Level, ...] = get_args(Level)
"""From the least to the most demanding."""

_PREFIXES = ("", "ASIL ", "ASIL-", "ASIL_")
_SPELLINGS: Mapping[str, Level] = {
    spelling: level
    for index, level in enumerate(LEVELS)
    for implemented in (level, *(f"{level}({original})" for original in LEVELS[index:]))
    for prefix in _PREFIXES
    for spelling in (f"{prefix}{implemented}", f"{prefix}{implemented}".lower())
}
"""`B`, `ASIL B`, `ASIL-B` and `ASIL_B`, all of them in small letters too; and the same of decomposed levels: `B(D)` is
implemented to B, as its part of a D (ISO 26262-9). No level is decomposed into a higher one."""


def level_of(text: object) -> Level | None:
    """The level that a text spells; None for every other text, and for other values."""
    return _SPELLINGS.get(text) if isinstance(text, str) else None


def rank(level: Level) -> int:
    """Order of a level: QM is 0, D is 4."""
    return LEVELS.index(level)


def is_above(level: Level | None, other: Level | None) -> bool:
    """Whether one level demands more than another. A level that is not stated is not compared."""
    return level is not None and other is not None and rank(level) > rank(other)
