"""Places in texts: the word at a position, the statement of a line, the references of a function file."""

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.model.definition import Definition
from sigcat.catalogue.reading.statement import Statement
from sigcat.errors import SigcatError
from sigcat.function.declaration.declaration import Declared
from sigcat.function.document.document import Document, Pointer
from sigcat.function.function_file import read_function_file
from sigcat.open_files import made_once, read_bytes
from sigcat.real_path import real_path
from sigcat.rules.tree import Tree

_WORD = re.compile(r"[\w.*/%^°-]+")
_KEY = re.compile(r"^\s*(?:- )?[\"']?([\w.-]+)[\"']?\s*:")


class Place(NamedTuple):
    """A part of a line of a file. Lines and columns count from 0."""

    file: Path
    line: int
    start: int
    end: int


class Word(NamedTuple):
    """A word with its columns."""

    text: str
    start: int
    end: int


class Reference(NamedTuple):
    """A text of a function file that names a node of the catalogue."""

    text: str
    place: Place
    role: str


def word_at(line: str, column: int) -> Word:
    """Return the word around a column; an empty one if there is none."""
    for match in _WORD.finditer(line):
        if match.start() <= column <= match.end():
            text = match[0].strip(".-/")
            start = match.start() + match[0].index(text)
            return Word(text, start, start + len(text))
    return Word("", column, column)


def key_of(line: str) -> str:
    """Return the key that a line of YAML has; empty if it has none."""
    match = _KEY.match(line)
    return match[1] if match else ""


def is_same_file(name: str, path: Path) -> bool:
    """Whether the name of a file that was read leads to a path."""
    own = Path(name)
    return own == path or (own.name == path.name and real_path(own) == real_path(path))


def statement_at(catalogue: Catalogue, path: Path, line: int) -> Statement | None:
    """Return the statement of a file that a line (from 0) belongs to."""
    found = None
    for statement in _statements_of(catalogue, path):
        if statement.origin().line <= line + 1 and (found is None or statement.origin().line >= found.origin().line):
            found = statement
    return found


def _statements_of(catalogue: Catalogue, path: Path) -> Iterator[Statement]:
    for layer in catalogue.layers:
        names = {file.name for file in layer.files if is_same_file(file.name, path)}
        if names:
            yield from (statement for statement in layer.statements if statement.file.name in names)


def node_at(tree: Tree, path: Path, line: int, word: Word) -> Definition | None:
    """Return the node that a word names, or whose key has the word."""
    named = named_node(tree, word.text)
    if named is not None:
        return named
    statement = statement_at(tree.catalogue, path, line)
    if statement is None or statement.origin().line != line + 1 or word.text not in statement.path:
        return None
    return tree.resolve(statement.path)


def named_node(tree: Tree, text: str) -> Definition | None:
    """Return the node with a path, or the interface with a name."""
    return (tree.resolve(text) if text else None) or tree.interfaces.get(text)


def references_in(path: Path, tree: Tree) -> Iterator[Reference]:
    """Return the texts of a function file that name a node."""
    document = function_document(path)
    for pointer, text, role in _texts_in(document.value, (), "") if document is not None else ():
        if ("." in text or "_" in text) and named_node(tree, text) is not None:
            at = document.position(pointer)  # type: ignore[union-attr] # there are texts
            yield Reference(text, Place(path, at.line - 1, at.column - 1, at.column - 1 + len(text)), role)


def function_document(path: Path) -> Document | None:
    """Return a function file as it was read; None if it cannot be."""
    try:
        data = read_bytes(path)
        read = made_once(("function", str(path)), data, lambda: read_function_file(data, str(path)))
    except (OSError, SigcatError):
        return None
    return read.document if isinstance(read, Declared) else read


def _texts_in(value: Any, pointer: Pointer, role: str) -> Iterator[tuple[Pointer, str, str]]:
    if isinstance(value, str):
        yield pointer, value, role
    elif isinstance(value, dict):
        own = str(value.get("role") or value.get("Role") or "")
        for key, item in value.items():
            yield from _texts_in(item, (*pointer, key), own)
    elif isinstance(value, list):
        for index, item in enumerate(value):
            yield from _texts_in(item, (*pointer, index), role)


def places_of(definition: Definition) -> Iterator[Place]:
    """Return where a node is written: the tree first, then its overlays."""
    for statement in definition.statements:
        origin = statement.origin()
        if origin.line:
            yield Place(Path(origin.file), origin.line - 1, origin.column - 1, origin.column - 1)
