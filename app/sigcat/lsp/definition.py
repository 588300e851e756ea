"""Find where the word under the cursor is defined: a node, a unit, a C variable, a C function or a file."""

import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from sigcat.catalogue.model.definition import Definition
from sigcat.lsp.places import (
    Place,
    Word,
    function_document,
    key_of,
    named_node,
    node_at,
    places_of,
    references_in,
)
from sigcat.lsp.warm_project import WarmProject, is_function
from sigcat.open_files import read_bytes
from sigcat.text_lines import lines_of

_CODE_KEYS = ("variable", "symbol")


def definition_places(project: WarmProject, path: Path, lines: list[str], line: int, word: Word) -> list[Place]:
    """Return where a word is defined, the tree before its overlays."""
    if is_function(path):
        if key_of(lines[line]) in _CODE_KEYS:
            return _in_code(path, word, lines[line])
        if named := _code_file(path, word.text):
            return [Place(named, 0, 0, 0)]
    tree = project.tree(path)
    if key_of(lines[line]) == "unit" and (unit := tree.catalogue.vocabulary.unit(word.text)) is not None:
        return [Place(Path(unit.origin.file), unit.origin.line - 1, unit.origin.column - 1, unit.origin.column - 1)]
    node = node_at(tree, path, line, word)
    return list(places_of(node)) if node is not None else []


def reference_places(project: WarmProject, path: Path, _lines: list[str], line: int, word: Word) -> list[Place]:
    """Return where a node is written, and where functions name it."""
    tree = project.tree(path)
    node = node_at(tree, path, line, word)
    if node is None:
        return []
    uses = (each for file in project.functions(path) for each in references_in(file, tree))
    return [*places_of(node), *(use.place for use in uses if _is(named_node(tree, use.text), node))]


def _is(found: Definition | None, node: Definition) -> bool:
    return found is not None and found.path == node.path


def code_files(path: Path) -> list[Path]:
    """Return the headers of a function file, then its sources."""
    document = function_document(path)
    code = _code_of(document.value) if document is not None else {}
    folders = [path.parent, *(path.parent / str(each) for each in _list(code, "includeFolders", "IncludeFolders"))]
    named = [*_list(code, "headers", "Headers"), *_list(code, "sources", "Sources")]
    found = (folder / str(name) for name in named for folder in folders)
    return [file for file in dict.fromkeys(found) if file.is_file()]


def _code_of(value: Any) -> Mapping[str, Any]:
    code = (value.get("code") or value.get("Code")) if isinstance(value, dict) else None
    return code if isinstance(code, dict) else {}


def _list(code: Mapping[str, Any], *names: str) -> list[Any]:
    return next((value for name in names if isinstance(value := code.get(name), list)), [])


def _code_file(path: Path, text: str) -> Path | None:
    return next((file for file in code_files(path) if text and str(file).endswith(f"/{text}")), None)


def _in_code(path: Path, word: Word, line: str) -> list[Place]:
    """Return where the C code declares a name: of `a.b.c`, each part with its own declarations."""
    name = re.escape(word.text.split(".")[0] if key_of(line) == "symbol" else word.text.split(".")[-1].split("[")[0])
    after = r"\s*\(" if key_of(line) == "symbol" else r"\s*(?:\[[^\]]*\]\s*)*[;,=]"
    pattern = re.compile(rf"^\s*[A-Za-z_][\w \t*,]*?[ \t*](?P<name>{name}){after}")
    return list(_matches(code_files(path), pattern)) if name else []


def _matches(files: list[Path], pattern: re.Pattern[str]) -> Iterator[Place]:
    for file in files:
        for number, line in enumerate(lines_of(read_bytes(file).decode("utf-8", "replace"))):
            match = pattern.match(line)
            if match is not None and "return " not in line:
                yield Place(file, number, *match.span("name"))
