"""Line numbers of matches in a text, counted once from its start to its end."""

import re
from collections.abc import Iterable, Iterator


def numbered(text: str, matches: Iterable[re.Match[str]]) -> Iterator[tuple[int, re.Match[str]]]:
    """Each match with the line at which it starts, from 1. `matches` are in the order of the text."""
    line, counted = 1, 0
    for match in matches:
        line, counted = line + text.count("\n", counted, match.start()), match.start()
        yield line, match
