"""What is wrong with an Integration JSON, and where; and what is wrong with names."""

from collections.abc import Iterable, Iterator

from sigcat.function.document.document import Pointer
from sigcat.integration.autosar_names import LONGEST_SHORT_NAME
from sigcat.integration.checked_document import Problem
from sigcat.integration.reserved_words import CPP_KEYWORDS
from sigcat.names import IDENTIFIER


def names(at: Pointer, listed: Iterable[str]) -> Iterator[Problem]:
    """Names of one namespace: short names, no two of which differ in case alone."""
    seen: dict[str, tuple[int, str]] = {}
    for index, each in enumerate(listed):
        yield from name((*at, index, "Name"), each)
        first, other = seen.setdefault(each.lower(), (index, each))
        if first != index:
            message = f"{each} must be the name of one thing here; {other} is one already."
            yield Problem((*at, index, "Name"), message, "Rename it.")


def name(at: Pointer, given: str) -> Iterator[Problem]:
    """A name that is no short name, or too long for one."""
    if len(given) > LONGEST_SHORT_NAME:
        message = f"{given[:40]}… must have {LONGEST_SHORT_NAME} characters at most, not {len(given)}."
        yield Problem(at, message, "Shorten it.")
    elif not IDENTIFIER.fullmatch(given) or given in CPP_KEYWORDS:
        yield Problem(at, f"A name must be an identifier of C, a letter first, not {given!r}.", "Rename it.")


def unknown(at: Pointer, what: str, given: str) -> Problem:
    """A reference to nothing."""
    return Problem(at, f"{given[:80]!r} must be a known {what}, and is not.", "Correct the name, or add it.")
