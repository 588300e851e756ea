"""Includes of overlays: the branches below which a file is included, and the changes of these branches."""

import re
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

from sigcat.file_kind import ROOT_NAME, ending_of
from sigcat.function.importing.yaml_edits import Edit
from sigcat.migration.changed_text import Outcome, Place, Replacement, undecided
from sigcat.migration.migration import Migration
from sigcat.real_path import real_path
from sigcat.rules.linting.includes import includes_of

_INCLUDE = re.compile(r"^#include[ \t]+\S+[ \t]+(?P<prefix>[\w.]+)", re.MULTILINE)
_DEEPEST = 32


class Included(NamedTuple):
    """Includes of a file by others."""

    prefixes: tuple[str, ...] = ()
    is_of_tree: bool = False
    """Whether it is a part of a whole tree, which is not migrated."""


def included_below(files: Sequence[Path]) -> dict[Path, Included]:
    """Return the included files of a project."""
    includes = {real_path(path): includes_of(path) for path in files if ending_of(path.name) == ".vspec"}
    targets = {real_path(path.parent / name) for path, found in includes.items() for name, _ in found}
    known: dict[Path, Included] = {}
    for path in includes:
        if path not in targets:
            _follow(path, "", path.name == ROOT_NAME, includes, known, 0)
    return known


def _follow(
    path: Path,
    prefix: str,
    is_of_tree: bool,
    includes: dict[Path, tuple[tuple[str, str], ...]],
    known: dict[Path, Included],
    depth: int,
) -> None:
    for name, below in includes.get(path, ()) if depth < _DEEPEST else ():
        target = real_path(path.parent / name)
        here = ".".join(filter(None, (prefix, below)))
        before = known.get(target, Included())
        known[target] = Included(tuple(dict.fromkeys((*before.prefixes, here))), before.is_of_tree or is_of_tree)
        _follow(target, here, is_of_tree, includes, known, depth + 1)


def include_changes(file: str, text: str, prefix: str, migration: Migration) -> Iterator[Outcome]:
    """Yield the changes of the branches that a file includes others below."""
    for match in _INCLUDE.finditer(text):
        branch = match["prefix"]
        path = f"{prefix}.{branch}" if prefix else branch
        fate = migration.fate(path)
        line = text.count("\n", 0, match.start()) + 1
        if not fate.is_certain:
            yield from undecided(path, fate, Place(file, line, match.start("prefix") - match.start() + 1), migration)
        elif fate.path != path:
            target = fate.path.removeprefix(f"{migration.fate(prefix).path}.") if prefix else fate.path
            edit = Edit(match.start("prefix"), match.end("prefix"), target)
            yield Replacement(edit, line, f"`{path}` → `{fate.path}`")
