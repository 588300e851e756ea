"""The documentation: chapters rendered from the Markdown files of sigcat, and a search in them."""

import posixpath
import re
from collections.abc import Iterator, Sequence
from functools import lru_cache
from typing import NamedTuple
from urllib.parse import quote

from markdown_it import MarkdownIt
from markdown_it.renderer import RendererHTML
from markdown_it.token import Token
from markupsafe import Markup, escape

from sigcat.data import DOCUMENTATION

INDEX = "README.md"
_PARTS = {"tutorial": "Learn", "how-to": "Do", "reference": "Look up", "explanation": "Understand"}
_OF_RULES = "reference/rules/"
_MARK = re.compile(r"^<!-- .* -->$", re.MULTILINE)
"""Marks around generated parts of a file."""
_TITLE = re.compile(r'title="([^"]*)"')
_MOST_HITS = 5
_LONG = 19_000
"""Characters of a chapter whose sections are folded: it would be taller than one reads at once."""


class Section(NamedTuple):
    """A heading of a chapter with the text below it."""

    chapter: str
    level: int
    title: str
    anchor: str
    words: str
    """The chapter's title, the heading and the text, in lower case."""


class Chapter(NamedTuple):
    """A page of the documentation."""

    title: str
    sections: tuple[Section, ...]
    body: Markup


@lru_cache(maxsize=1)
def files() -> frozenset[str]:
    """Paths of the files of the documentation, relative to its folder."""
    found = (path for path in DOCUMENTATION.rglob("*") if path.is_file())
    return frozenset(path.relative_to(DOCUMENTATION).as_posix() for path in found)


@lru_cache(maxsize=1)
def contents() -> tuple[tuple[str, tuple[tuple[str, str], ...]], ...]:
    """The table of contents: parts with the path and title of each chapter. The page of a rule has no entry."""
    chapters = sorted(name for name in files() if name.endswith(".md") and _is_listed(name))
    return tuple(
        (title, tuple((name, _sections(name)[0].title) for name in chapters if name.startswith(f"{part}/")))
        for part, title in _PARTS.items()
    )


def search(text: str) -> Sequence[Section]:
    """The sections that have all words of a text, those with the words in their heading first."""
    words = text.lower().split()
    if not words:
        return ()
    found = [section for section in _every_section() if all(word in section.words for word in words)]
    found.sort(key=lambda section: (not all(word in section.title.lower() for word in words), section.level))
    return found[:_MOST_HITS]


def _is_listed(name: str) -> bool:
    return not name.startswith(_OF_RULES) or name == f"{_OF_RULES}{INDEX}"


@lru_cache(maxsize=1)
def _every_section() -> tuple[Section, ...]:
    return tuple(section for name in sorted(files()) if name.endswith(".md") for section in _sections(name))


@lru_cache(maxsize=1_000)
def _sections(name: str) -> tuple[Section, ...]:
    return tuple(_sections_of(name, _markdown().parse(_text_of(name))))


def _text_of(name: str) -> str:
    return _MARK.sub("", (DOCUMENTATION / name).read_text("utf-8"))


def _sections_of(name: str, tokens: Sequence[Token]) -> Iterator[Section]:
    starts = [number for number, token in enumerate(tokens) if token.type == "heading_open"]
    chapter = _text(tokens[starts[0] + 1]) if starts else name
    for start, end in zip(starts, [*starts[1:], len(tokens)], strict=True):
        title = _text(tokens[start + 1])
        text = " ".join(token.content for token in tokens[start:end] if token.type in ("inline", "fence"))
        yield Section(name, int(tokens[start].tag[1:]), title, _anchor(title), f"{chapter} {text}".lower())


def _text(heading: Token) -> str:
    return "".join(child.content for child in heading.children or () if child.type in ("text", "code_inline"))


def _anchor(title: str) -> str:
    """The anchor of a heading, as GitHub makes it."""
    return re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")


@lru_cache(maxsize=32)
def chapter_at(name: str, base: str) -> Chapter:
    """A chapter of `files()`; its links lead to pages below `base`."""
    markdown, text = _markdown(), _text_of(name)
    tokens = markdown.parse(text)
    sections = tuple(_sections_of(name, tokens))
    headings = (token for token in tokens if token.type == "heading_open")
    for heading, section in zip(headings, sections, strict=True):
        heading.attrSet("id", section.anchor)
    for token in tokens:
        _lead_on(token.children or [], name, base)
    shown = list(_folded(tokens)) if len(text) > _LONG else tokens
    body = Markup(markdown.renderer.render(shown, markdown.options, {}))  # noqa: S704 - HTML in Markdown is escaped
    return Chapter(sections[0].title if sections else name, sections, body)


def _folded(tokens: Sequence[Token]) -> Iterator[Token]:
    """Yield the tokens with each section folded. Its anchor is within: a link to it, or to a part of it, opens it."""
    is_open, anchor = False, ""
    for token in tokens:
        if token.type == "heading_open" and token.tag == "h2":
            anchor = str(token.attrs.pop("id"))
            yield _html(f'{_END if is_open else ""}<details class="section"><summary>')
            is_open = True
        yield token
        if token.type == "heading_close" and token.tag == "h2":
            yield _html(f'</summary><div id="{escape(anchor)}">')
    if is_open:
        yield _html(_END)


_END = "</div></details>"


def _html(text: str) -> Token:
    return Token("html_block", "", 0, content=text)


def _lead_on(children: Sequence[Token], name: str, base: str) -> None:
    """Turn the links of a chapter to files into addresses; those to files that are not served become plain text."""
    is_dropped = False
    for token in children:
        if token.type == "link_open":
            address = _address(str(token.attrGet("href")), name, base)
            is_dropped = address is None
            if address is not None:
                token.attrSet("href", address)
        elif token.type == "image":
            token.attrSet("src", _address(str(token.attrGet("src")), name, base) or "")
        if is_dropped and token.type in ("link_open", "link_close"):
            token.tag = "span"
            token.attrs = {}
        is_dropped = is_dropped and token.type != "link_close"


def _address(target: str, name: str, base: str) -> str | None:
    if re.match(r"[a-z]+:|#", target):
        return target
    file, _, anchor = target.partition("#")
    path = posixpath.normpath(posixpath.join(posixpath.dirname(name), file))
    if path not in files():
        return None
    address = f"{base}/openapi.json" if path == "reference/openapi.json" else f"{base}/docs/{quote(path)}"
    return f"{address}#{anchor}" if anchor else address


def _markdown() -> MarkdownIt:
    markdown = MarkdownIt("commonmark", {"html": False}).enable("table")
    markdown.add_render_rule("fence", _fence)
    markdown.add_render_rule("code_inline", _code)
    markdown.add_render_rule("table_open", _table_open)
    markdown.add_render_rule("table_close", _table_close)
    return markdown


def _fence(_renderer: RendererHTML, tokens: Sequence[Token], index: int, _options: object, _env: object) -> str:
    """A block of code that can be scrolled by keyboard, below the name of its file."""
    file = _TITLE.search(tokens[index].info)
    caption = Markup('<p class="origin">{}</p>').format(file[1]) if file else ""
    return f'{caption}<pre tabindex="0"><code>{escape(tokens[index].content)}</code></pre>\n'


_JOINT = re.compile(r"(?<=\w)[_./](?=\w)")


def _code(_renderer: RendererHTML, tokens: Sequence[Token], index: int, _options: object, _env: object) -> str:
    """Code in a sentence, such as a long name: a line may break behind its joints, and nowhere else."""
    return f"<code>{_JOINT.sub(lambda joint: f'{joint[0]}<wbr>', escape(tokens[index].content))}</code>"


def _table_open(_renderer: RendererHTML, tokens: Sequence[Token], index: int, _options: object, _env: object) -> str:
    number = sum(token.type == "table_open" for token in tokens[: index + 1])
    return f'<div class="scroll" tabindex="0" role="region" aria-label="Table {number}"><table class="wide">'


def _table_close(*_: object) -> str:
    return "</table></div>"
