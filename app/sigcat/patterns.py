"""Regular expressions from others, which may be built to exhaust time or memory: both are bounded."""

import math
import re
import time
from typing import Any

from sigcat.limits import PATTERN_MATCH_SECONDS, PATTERN_PARTS

_TOKENS = r"(?s)\\.|\[\^?\]?(?:\\.|[^\]\\])*\]|\{([0-9]+)[^}]*\}|."
_COUNT = r"\{([^,}]*)"
_UNUSUAL = r"\(\?[^:=!<P]|\[:"
"""Flags, comments and POSIX classes; with them, groups are not counted so simply."""


class BadPattern(Exception):
    """The text is not a regular expression, or one that is too large to compile; its own text says why."""


def compile_bounded(text: str) -> Any:
    """Compile an expression with the `regex` package, whose matches take a `timeout`. Raises BadPattern."""
    import regex  # loaded only where a pattern has something to match; unlike `re` it can stop a match

    if (parts := _parts(text)) > PATTERN_PARTS:
        raise BadPattern(f"it has {parts:,} parts with repetitions written out; the limit is {PATTERN_PARTS:,}")
    try:
        return regex.compile(text)
    except (regex.error, OverflowError, RecursionError, ValueError) as error:
        raise BadPattern(str(error)) from None


class Matching:
    """Matches the patterns of one tree; counts down the time that all of them have together."""

    def __init__(self, seconds: float) -> None:
        self._left = seconds

    def mismatch(self, pattern: str, text: str) -> str:
        """`does not match` or another reason; empty for a match. A text that takes too long may be an attack."""
        if self._left <= 0:
            return "was not checked (earlier patterns took too long) against"
        start = time.thread_time()
        try:
            is_match = compile_bounded(pattern).match(text, timeout=min(PATTERN_MATCH_SECONDS, self._left))
        except TimeoutError:
            return "takes too long to match against"
        except BadPattern as error:
            return f"cannot be matched ({error}) against"
        finally:
            self._left -= time.thread_time() - start
        return "" if is_match else "does not match"


def _parts(text: str) -> int:
    """Return the least number of parts of a compiled expression: the compiler writes the least count of a repetition out."""
    if len(text) > PATTERN_PARTS:
        return len(text)
    if re.search(_UNUSUAL, text):
        return len(text) * math.prod(max(_number(count), 1) for count in re.findall(_COUNT, text))
    groups, last = [0], 0
    for token in re.finditer(_TOKENS, text):
        if token[1]:
            groups[-1] += last * (_number(token[1]) - 1)
        elif token[0] == "(":
            groups.append(0)
        elif token[0] == ")" and len(groups) > 1:
            last = groups.pop() + 1
            groups[-1] += last
        else:
            last = 1
            groups[-1] += 1
    return sum(groups)


def _number(text: str) -> int:
    """The digits of a text as a number, cut to nine of them: more than any limit allows."""
    return int("".join(filter("0123456789".__contains__, text))[:9] or 0)
