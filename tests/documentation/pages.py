"""The pages that people read, and the blocks of code in them."""

import re
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).parents[2]
PAGES = sorted(
    path.relative_to(ROOT).as_posix()
    for pattern in ("*.md", "docs/**/*.md", "interface_rules/*.md", "examples/*/*.md", ".github/*.md")
    for path in ROOT.glob(pattern)
)
assert len(PAGES) > 20
_BLOCK = re.compile(r'^ *```(\w+)(?: title="([^"]+)")?\n(.*?)^ *```$', re.MULTILINE | re.DOTALL)


class Block(NamedTuple):
    """A block of code of a page."""

    language: str
    title: str
    """File that it is; empty where it is none."""
    text: str


def text_of(page: str) -> str:
    """The text of a page."""
    return (ROOT / page).read_text(encoding="utf-8")


def blocks(page: str, language: str = "") -> Iterator[Block]:
    """The blocks of a page, in order."""
    for found, title, text in _BLOCK.findall(text_of(page)):
        if language in ("", found):
            yield Block(found, title, text)


def block(page: str, language: str, beginning: str) -> str:
    """The text of the block that begins so."""
    return next(each.text for each in blocks(page, language) if each.text.startswith(beginning))
