"""Problems of an Integration JSON, with their places; and problems of names."""

import re
from collections.abc import Iterable, Iterator, Mapping
from typing import Protocol

from sigcat.function.document.document import Pointer
from sigcat.integration.autosar_names import LONGEST_SHORT_NAME
from sigcat.integration.checked_document import Problem
from sigcat.names import IDENTIFIER
from sigcat.reserved_words import is_reserved

_C_IDENTIFIER = re.compile(r"[A-Za-z_][A-Za-z0-9_]{0,127}")


class Named(Protocol):
    """An element of the document that has a name."""

    @property
    def name(self) -> str: ...


def names(at: Pointer, listed: Iterable[str]) -> Iterator[Problem]:
    """Names of one list, which is a namespace."""
    yield from _distinct(((*at, index, "Name"), each) for index, each in enumerate(listed))


def names_of(at: Pointer, lists: Mapping[str, Iterable[Named]]) -> Iterator[Problem]:
    """Names of elements of one namespace, in several lists."""
    yield from _distinct(
        ((*at, key, index, "Name"), each.name) for key, listed in lists.items() for index, each in enumerate(listed)
    )


def _distinct(places: Iterable[tuple[Pointer, str]]) -> Iterator[Problem]:
    """Short names, no two of which differ in case alone."""
    seen: dict[str, tuple[Pointer, str]] = {}
    for at, each in places:
        yield from name(at, each)
        first, other = seen.setdefault(each.lower(), (at, each))
        if first != at:
            message = f"{each} must be the name of one thing here; {other} is one already."
            yield Problem(at, message, "Rename it.")


def name(at: Pointer, given: str) -> Iterator[Problem]:
    """A name that is not a short name, or too long for one."""
    if len(given) > LONGEST_SHORT_NAME:
        message = f"{given[:40]}… must have {LONGEST_SHORT_NAME} characters at most, not {len(given)}."
        yield Problem(at, message, "Shorten it.")
    elif not IDENTIFIER.fullmatch(given) or is_reserved(given):
        yield Problem(at, f"A name must be an identifier of C, a letter first, not {given!r}.", "Rename it.")


def identifier(at: Pointer, given: str) -> Iterator[Problem]:
    """Text that becomes a word of C, though it is not a short name."""
    if not _C_IDENTIFIER.fullmatch(given) or is_reserved(given):
        yield Problem(at, f"It must be an identifier of C, and not a keyword, not {given[:60]!r}.", "Rename it.")


def unknown(at: Pointer, what: str, given: str) -> Problem:
    """A reference to nothing."""
    return Problem(at, f"{given[:80]!r} must be a known {what}, and is not.", "Correct the name, or add it.")
