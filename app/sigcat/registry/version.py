"""Versions of SemVer 2.0: reading, order, and the part that rises between two of them."""

import re
from functools import total_ordering
from typing import NamedTuple

from sigcat.catalogue.comparing.changelog import Part

_DIGITS = 9
"""Digits of a number."""
_NUMBER = rf"(?:0|[1-9][0-9]{{0,{_DIGITS - 1}}})"
_IDENTIFIER = r"(?:0|[1-9][0-9]*|[0-9]*[A-Za-z-][0-9A-Za-z-]*)"
_VERSION = re.compile(
    rf"({_NUMBER})\.({_NUMBER})\.({_NUMBER})"
    rf"(?:-({_IDENTIFIER}(?:\.{_IDENTIFIER})*))?(?:\+[0-9A-Za-z-]+(?:\.[0-9A-Za-z-]+)*)?"
)
_BEGIN = re.compile(r"(v?)([0-9.]*)(.*)", re.ASCII | re.DOTALL | re.IGNORECASE)
"""Any text: a letter that many write, numbers, and the rest."""
_LONGEST = 100
"""Characters of a version."""


RELEASED = "~"
"""The end of the precedence, as text, of a version that is not a prerelease: it is after the hyphen of these."""


@total_ordering
class Version(NamedTuple):
    """A version. Equal in precedence are those that differ only in build metadata."""

    text: str
    numbers: tuple[int, int, int]
    prerelease: tuple[str, ...]
    key: tuple[object, ...]
    """Value by which versions are in order."""

    @property
    def release(self) -> str:
        """The version without build metadata."""
        return self.text.partition("+")[0]

    @property
    def sort_text(self) -> str:
        """The precedence as text: texts are in the order of their versions."""
        numbers = ".".join(f"{number:09}" for number in self.numbers)
        identifiers = (f"0{len(each):03}{each}" if each.isdigit() else f"1{each}" for each in self.prerelease)
        return f"{numbers}-{'!'.join(identifiers)}!" if self.prerelease else f"{numbers}{RELEASED}"

    def __lt__(self, other: object) -> bool:
        """Order by precedence."""
        assert isinstance(other, Version)
        return self.key < other.key

    def __eq__(self, other: object) -> bool:
        """Compare precedence."""
        return isinstance(other, Version) and self.key == other.key

    def __hash__(self) -> int:
        return hash(self.key)


def version_of(text: str) -> Version | None:
    """Return the version; None if the text is not one."""
    match = _VERSION.fullmatch(text) if len(text) <= _LONGEST and text.isascii() else None
    if match is None:
        return None
    major, minor, patch, prerelease = match.groups()
    numbers, parts = (int(major), int(minor), int(patch)), tuple(prerelease.split(".")) if prerelease else ()
    identifiers = tuple((0, int(each), "") if each.isdigit() else (1, 0, each) for each in parts)
    return Version(text, numbers, parts, (numbers, not parts, identifiers))


class Problem(NamedTuple):
    """The reason why a text is not a version, and what to write."""

    message: str
    fix: str


def version_problem(text: str) -> Problem | None:
    """Return why a text is not a version; None if it is one."""
    if version_of(text) is not None:
        return None
    if len(text) > _LONGEST:
        return Problem(f"A version must have at most {_LONGEST} characters, not {len(text)}.", "Shorten it.")
    _, numbers, rest = _BEGIN.fullmatch(text).groups()  # type: ignore[union-attr]  # matches any text
    parts = [part.lstrip("0") or "0" for part in numbers.split(".") if part]
    if any(len(part) > _DIGITS for part in parts):
        return Problem(f"A number of a version must have at most {_DIGITS} digits: {text!r}.", "Write smaller numbers.")
    nearest = f"{'.'.join([*parts, '0', '0'][:3])}{rest}" if parts else ""
    fix = f"Write {nearest}." if version_of(nearest) is not None else "Write three numbers, such as 1.2.0."
    return Problem(f"A version must be three numbers by SemVer 2.0, such as 1.2.0 or 1.2.0-rc.1, not {text!r}.", fix)


_PARTS: tuple[Part, ...] = ("major", "minor", "patch", "none")


def raised_part(old: Version, new: Version) -> Part:
    """The part that rises. Before 1.0.0 the second number is that of breaking changes, as package managers read it."""
    changed = next((index for index in range(3) if old.numbers[index] != new.numbers[index]), 3)
    if old.numbers[0] == new.numbers[0] == 0 and changed < 3:
        return ("major", "major", "minor")[changed]
    return _PARTS[changed]


def is_enough(raised: Part, needed: Part) -> bool:
    """Whether a version rises by the part that its changes need."""
    return _PARTS.index(raised) <= _PARTS.index(needed)
