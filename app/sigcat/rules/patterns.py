"""Regular expressions of rules: quick for those that sigcat ships, bounded in time for those of others.

A rule file of a company may hold an expression that takes exponential time. Such expressions run in the `regex`
package with a time limit for each match; the first match that exceeds it ends the rule for the whole run.
"""

import re
from collections.abc import Callable
from typing import NamedTuple

from sigcat.limits import PATTERN_MATCH_SECONDS
from sigcat.patterns import BadPattern, compile_bounded


class SlowPattern(Exception):
    """A match took longer than the limit."""

    def __init__(self, pattern: str) -> None:
        super().__init__(pattern)
        self.pattern = pattern


class Pattern(NamedTuple):
    """A compiled expression: whether it matches the whole of a text, and whether it is found in one."""

    text: str
    matches: Callable[[str], object]
    found: Callable[[str], object]


def compile_pattern(text: str, *, trusted: bool) -> Pattern:
    """Compile an expression. Raises BadPattern."""
    return _quick(text) if trusted else _bounded(text)


def compile_exception(text: str | None, *, trusted: bool) -> Callable[[str], object]:
    """Return a pattern for texts that a rule leaves to another one; none without an expression. Raises BadPattern."""
    return compile_pattern(text, trusted=trusted).found if text is not None else lambda _text: None


def _quick(text: str) -> Pattern:
    try:
        compiled = re.compile(text)
    except (re.error, OverflowError, RecursionError) as error:
        raise BadPattern(f"Pattern {text!r} is not a regular expression: {error}") from None
    return Pattern(text, compiled.fullmatch, compiled.search)


def _bounded(text: str) -> Pattern:
    try:
        compiled = compile_bounded(text)
    except BadPattern as error:
        raise BadPattern(f"Pattern {text!r} is not a regular expression: {error}") from None

    def limited(match: Callable[..., object]) -> Callable[[str], object]:
        def attempt(subject: str) -> object:
            try:
                return match(subject, timeout=PATTERN_MATCH_SECONDS)
            except TimeoutError:
                raise SlowPattern(text) from None

        return attempt

    return Pattern(text, limited(compiled.fullmatch), limited(compiled.search))
