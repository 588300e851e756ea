"""Rename a node: in the tree, in overlays and in functions."""

import re
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.model.definition import Definition
from sigcat.catalogue.model.interfaces import category_of, interface_name
from sigcat.catalogue.reading.statement import Origin, Statement
from sigcat.errors import UsageError
from sigcat.lsp.places import Place, Word, key_of, node_at, references_in
from sigcat.lsp.warm_project import WarmProject
from sigcat.names import last_name, parent_path
from sigcat.open_files import read_bytes
from sigcat.real_path import real_path
from sigcat.rules.tree import Tree
from sigcat.text_lines import lines_of


class Change(NamedTuple):
    """A new text for a place."""

    place: Place
    text: str


class _Renaming(NamedTuple):
    node: Definition
    name: str
    tree: Tree

    @property
    def depth(self) -> int:
        return self.node.path.count(".")

    @property
    def path(self) -> str:
        return ".".join(filter(None, (parent_path(self.node.path), self.name)))


def renamed(project: WarmProject, path: Path, line: int, word: Word, name: str) -> list[Change]:
    """Return the changes that give a node another name. Raises UsageError if it cannot be renamed."""
    tree = project.tree(path)
    node = node_at(tree, path, line, word)
    if node is None:
        raise UsageError("Nothing to rename here. Place the cursor on the path of a signal or branch.")
    renaming = _Renaming(node, _new_name(node, name, tree), tree)
    _refuse_foreign(node, project.root)
    written = list(_in_layers(tree.catalogue, renaming))
    used = (each for file in project.functions(path) for each in references_in(file, tree))
    changes = [*written, *(c for use in used if (c := _changed(use.text, use.place, renaming)) is not None)]
    return [exact for each in changes if (exact := _exact(each, renaming)) is not None]


def _new_name(node: Definition, name: str, tree: Tree) -> str:
    new = last_name(name)
    above = parent_path(name)
    if above and above != parent_path(node.path):
        raise UsageError(
            f"A rename changes only the name {last_name(node.path)!r} at the end of the path. Keep the rest of the path."
        )
    if not re.fullmatch(r"[A-Za-z][A-Za-z0-9_]*", new):
        raise UsageError(f"{new!r} is not a name. Use letters and digits, as in `IsOpen`.")
    if tree.resolve(".".join(filter(None, (parent_path(node.path), new)))) is not None:
        raise UsageError(f"{new!r} exists. Choose another name.")
    return new


def _refuse_foreign(node: Definition, root: Path) -> None:
    for statement in node.statements:
        if real_path(root) not in real_path(Path(statement.file.name)).parents:
            file = statement.file.name
            raise UsageError(f"{node.path} is defined outside of this folder, in {file}. It cannot be renamed here.")


def _in_layers(catalogue: Catalogue, renaming: _Renaming) -> Iterator[Change]:
    below = f"{renaming.node.path}."
    for layer in catalogue.layers:
        for statement in layer.statements:
            if statement.path == renaming.node.path or _resolves_below(statement.path, below, renaming):
                yield from _key_change(statement, renaming)
            yield from _values_changes(statement, renaming)


def _resolves_below(path: str, below: str, renaming: _Renaming) -> bool:
    return path.startswith(below) or _segment(path, renaming) is not None


def _key_change(statement: Statement, renaming: _Renaming) -> Iterator[Change]:
    origin = statement.origin()
    place = _place(origin, "")
    written = key_of(_line(place)) or statement.path
    segment = _segment(statement.path, renaming)
    if segment is None:
        return
    own = segment - (statement.path.count(".") - written.count("."))
    if own < 0:
        prefix = statement.path.removesuffix(f".{written}")
        raise UsageError(f"{origin.file} is included below {prefix!r}. Rename the include by hand.")
    yield Change(place._replace(end=place.start + len(written)), _with_segment(written, own, renaming.name))


def _values_changes(statement: Statement, renaming: _Renaming) -> Iterator[Change]:
    """Return changes of the values that name the node, such as those of references between interfaces."""
    for attribute, value in statement.values.items():
        for steps, text in _texts(value, ()):
            if attribute == "description" or not ("." in text or "_" in text):
                continue
            origin = statement.origin_within(attribute, steps) if steps else statement.origin(attribute)
            change = _changed(text, _place(origin, text), renaming) if origin is not None else None
            if change is not None:
                yield change


def _texts(value: Any, steps: tuple[int | str, ...]) -> Iterator[tuple[tuple[int | str, ...], str]]:
    if isinstance(value, str):
        yield steps, value
    elif isinstance(value, list):
        for index, item in enumerate(value):
            yield from _texts(item, (*steps, index))


def _changed(text: str, place: Place, renaming: _Renaming) -> Change | None:
    """Return the change of a text that names the node, or one below it."""
    if category_of(renaming.node.path) not in (None, "data") and text == interface_name(renaming.node.path):
        return Change(place, interface_name(renaming.path))
    segment = _segment(text, renaming)
    return Change(place, _with_segment(text, segment, renaming.name)) if segment is not None else None


def _segment(path: str, renaming: _Renaming) -> int | None:
    """Return the number of the name in a path that is the node's, names of instances included."""
    names = path.split(".")
    if last_name(renaming.node.path) not in names:
        return None
    for count in range(renaming.depth + 1, len(names) + 1):
        if names[count - 1] == last_name(renaming.node.path):
            found = renaming.tree.resolve(".".join(names[:count]))
            if found is not None and found.path == renaming.node.path:
                return count - 1
    return None


def _with_segment(path: str, segment: int, name: str) -> str:
    names: Sequence[str] = path.split(".")
    return ".".join((*names[:segment], name, *names[segment + 1 :]))


def _place(origin: Origin, text: str) -> Place:
    return Place(Path(origin.file), origin.line - 1, origin.column - 1, origin.column - 1 + len(text))


def _line(place: Place) -> str:
    lines = lines_of(read_bytes(place.file).decode("utf-8-sig", "replace"))
    return lines[place.line] if 0 <= place.line < len(lines) else ""


def _exact(change: Change, renaming: _Renaming) -> Change | None:
    """Return the change at the text itself, after a quotation mark; None if the text is written in another way."""
    place = change.place
    line = _line(place)
    start = place.start + (line[place.start : place.start + 1] in ('"', "'"))
    own = line[start : start + place.end - place.start]
    is_name = last_name(renaming.node.path) in own
    return Change(place._replace(start=start, end=start + len(own)), change.text) if is_name else None
