"""Automotive Safety Integrity Levels (ISO 26262): QM, then A to D."""

import re

LEVELS = ("QM", "A", "B", "C", "D")

_SPELLINGS = re.compile(r"(?:ASIL[ _-]?)?(QM|[A-D])(?:\s*\((?:ASIL[ _-]?)?(?:QM|[A-D])\))?", re.IGNORECASE)
"""Also `ASIL B`, `qm`, and decomposed levels: `B(D)` counts as B, the level that is implemented."""


def level_of(text: str | None) -> str | None:
    """The level that a text means, or None if it means none."""
    match = _SPELLINGS.fullmatch(text.strip()) if text else None
    return match[1].upper() if match else None


def rank(level: str | None) -> int:
    """Order of a level: QM is 0, D is 4; no level ranks as QM."""
    return LEVELS.index(level) if level in LEVELS else 0
