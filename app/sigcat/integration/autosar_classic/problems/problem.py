"""Problems of an Integration JSON, with their places; and problems of names."""

import re
from collections.abc import Iterable, Iterator

from pydantic import BaseModel

from sigcat.function.document.document import Pointer
from sigcat.integration.autosar_classic.problems.names_table import NAMESPACES, REFERENCES, SINGLE_NAMES
from sigcat.integration.autosar_names import LONGEST_SHORT_NAME
from sigcat.integration.grouping import grouped
from sigcat.integration.problem import Problem
from sigcat.integration.references import places, unknown_names
from sigcat.names import IDENTIFIER
from sigcat.reserved_words import is_reserved

_C_IDENTIFIER = re.compile(r"[A-Za-z_][A-Za-z0-9_]{0,127}")


def names_of(model: BaseModel) -> Iterator[Problem]:
    """Problems of all names: each is a short name, no two of a space differ in case alone, and each reference leads to one."""
    for path in SINGLE_NAMES:
        for at, given in places(model, path):
            yield from name(at, given)
    for space in NAMESPACES:
        names = (place for path in space for place in places(model, f"{path}/*/Name"))
        for within in grouped(names, lambda place: place[0][:-3]).values():
            yield from _distinct(within)
    yield from unknown_names(model, REFERENCES)


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
