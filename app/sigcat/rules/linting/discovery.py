"""Kinds of the named files: trees, overlays, struct types, parts of a tree, function files, rule files.

`sigcat.file_kind` distinguishes vspec files from others; here the files beside one decide what it is. A file that another file of
the same tree includes is a part of that tree. Parts alone are checked by themselves, below the prefix at which their tree
includes them.
"""

import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Literal, NamedTuple

from sigcat.errors import NotFound, UsageError
from sigcat.file_kind import (
    C_HEADERS,
    C_SOURCES,
    ENDINGS,
    OVERLAY_FOLDERS,
    ROOT_NAME,
    SHIPPED_ROOT,
    TREE_ENDINGS,
    FileKind,
    ending_of,
    file_kind,
    first_names,
    holds_top_level_node,
    root_branch,
)
from sigcat.names import nearest
from sigcat.open_files import is_file
from sigcat.real_path import real_path
from sigcat.rules.linting.includes import Includes, first_bytes, included_parts, includes_of, topmost
from sigcat.rules.linting.nearby_trees import bytes_with_root, default_tree, has_units, is_of_types, root_of, tree_of

Kind = Literal["tree", "overlay", "types", "part", "function", "rules", "vocabulary", "unreadable", "other"]

_SKIPPED = frozenset(("node_modules", "__pycache__", "build", "dist", "site-packages"))
_NOT_LINTED = {
    **dict.fromkeys((*C_SOURCES, *C_HEADERS), "Name a function file: its lint reads its headers."),
    ".csv": "`sigcat simulate` checks the traces that --trace names.",
}
_KINDS: Mapping[FileKind, Kind] = {
    "vspec": "overlay",
    "units": "vocabulary",
    "quantities": "vocabulary",
    "function": "function",
    "function json": "function",
    "rules": "rules",
}
"""Kinds of data files by format; other kinds are skipped, unless the user names them."""


class _Look(NamedTuple):
    """Facts that decide about a file beside the file itself: includes, and the tree that the options name."""

    includes: Includes
    base: Path | None


class Source(NamedTuple):
    """A file to lint. `tree` and `prefix` are set for a part that is linted alone: who includes it, and where."""

    path: Path
    kind: Kind
    named: bool
    """Whether the user named the file itself, not a folder above it."""
    tree: Path | None = None
    prefix: str = ""


def discover(
    paths: Sequence[Path],
    overlays: Iterable[Path] = (),
    types: Iterable[Path] = (),
    trees: Sequence[Path] = (),
    rules: Iterable[Path] = (),
    vocabulary: Iterable[Path] = (),
) -> tuple[Source, ...]:
    """The files to lint in `paths`, each once. The others are files whose kind is known. Raises NotFound."""
    found = _files_in(paths)
    includes = {path: includes_of(path) for path in found if ending_of(path.name) == ".vspec"}
    parts = included_parts(includes)
    known: dict[Path, Kind] = {real_path(path): "tree" for path in trees}
    known.update({real_path(path): "overlay" for path in overlays})
    known.update({real_path(path): "types" for path in types})
    known.update({real_path(path): "rules" for path in rules})
    known.update({real_path(path): "vocabulary" for path in vocabulary})
    look = _Look(includes, next(iter(trees), None))
    sources = []
    for path, named in found.items():
        kind = known.get(real_path(path)) if known else None
        sources.append(_source(path, named, kind, topmost(path, parts), look))
    return tuple(sources)


def _files_in(paths: Sequence[Path]) -> dict[Path, bool]:
    """The files that paths name, and whether they name the file itself; one that is named in two ways once."""
    found: dict[Path, bool] = {}
    names: dict[str, Path] = {}
    for path in paths:
        if not path.is_dir() and not is_file(path):
            raise NotFound(
                f"{path} must be a regular file" if path.exists() else f"{path}: there is no such file or folder"
            )
        for file in _named_like_files(path) if path.is_dir() else (path,):
            first = names.setdefault(os.path.abspath(file), file)  # noqa: PTH100 — links stay as they are
            found[first] = found.get(first, False) or file is path
    return found


def walk(folder: Path) -> Iterator[Path]:
    """Files that may be linted in a folder and below it, in order; hidden and generated folders are left out.

    Raises OSError for a folder that cannot be read: what is in it would pass unchecked.
    """
    return (path for path in _named_like_files(folder) if path.is_file())


def _named_like_files(folder: Path) -> Iterator[Path]:
    """The files, and what is called like one: links to nothing, pipes, and folders with the name of a tree."""
    for here, folders, files in os.walk(folder, onerror=_refuse):
        folders[:] = sorted(f for f in folders if not f.startswith(".") and f not in _SKIPPED)
        trees = (f for f in folders if ending_of(f) == TREE_ENDINGS[0])
        for name in sorted((*files, *trees)):
            if not name.startswith(".") and name.lower().endswith(ENDINGS):
                yield Path(here, name)


def _refuse(error: OSError) -> None:
    raise error


def _source(path: Path, named: bool, known: Kind | None, above: Path | None, look: _Look) -> Source:
    """`above` is the file of the list that includes this one, directly or through others, and is included by none."""
    if not is_file(path):  # its name is all that is known
        return Source(path, "unreadable" if file_kind(b"", path.name) != "unknown" else "other", named)
    if known:
        return Source(path, known, named)
    if named and (fix := _NOT_LINTED.get(path.suffix.lower())):
        raise UsageError(f"{path} is not a file that lint checks ({', '.join(ENDINGS)}). {fix}")
    if ending_of(path.name) != ".vspec":
        return Source(path, _kind_of_data(path, named=named), named)
    if above is None:
        return _top(path, named, look)
    is_covered = _top(above, named, look).kind != "part"
    tree = None if is_covered else tree_of(path)
    return Source(path, "part", named, *tree) if tree is not None else Source(path, "part", named)


def _top(path: Path, named: bool, look: _Look) -> Source:
    """A vspec file that no other of the list includes."""
    if path.name == ROOT_NAME:
        return Source(path, "tree", named)
    above = tree_of(path)
    if above is not None:
        return Source(path, "part", named, *above)
    around = _tree_around(path)
    if around is not None:
        return Source(path, "part", named, *around)
    return Source(path, _kind_of_top(path, look), named)


def _kind_of_top(path: Path, look: _Look) -> Kind:
    if is_of_types(path):
        return "types"
    if _has_own_root(path, look.base):
        return "tree"
    is_with_units = has_units(path.parent)
    if _is_in_overlay_folder(path) or (is_with_units and (path.parent / ROOT_NAME).is_file()):
        return "overlay"
    signs = (is_with_units, bool(look.includes.get(path)), holds_top_level_node(first_bytes(path)))
    return "tree" if sum(signs) > 1 else "overlay"


def _tree_around(path: Path) -> tuple[Path, str] | None:
    """The tree in whose folder a part is that no file includes, since an include is missing, and the root of the tree."""
    names = first_names(first_bytes(path))
    if not holds_top_level_node(first_bytes(path)) or _is_in_overlay_folder(path):
        return None
    tree = default_tree(path)
    if tree is None or tree.parent not in real_path(path).parents:
        return None
    if len(names) == 1 and real_path(path).parent == tree.parent:
        return None  # a separate tree, next to the other
    root = root_of(tree)
    return (tree, root) if root and root.encode() not in names else None


def _has_own_root(path: Path, base: Path | None) -> bool:
    """Whether a file begins with a root that is not the root of the tree which an overlay here would be made for."""
    own = root_branch(bytes_with_root(path))
    return bool(own) and is_other_root(own, base or default_tree(path))


def is_other_root(own: str, tree: Path | None) -> bool:
    """Whether a root is not that of a tree, or of the shipped one, and not that name misspelled."""
    known = root_of(tree) if tree is not None else SHIPPED_ROOT
    return bool(known) and own != known and not nearest(own, [known])


def _is_in_overlay_folder(path: Path) -> bool:
    """Whether the file is below a folder for overlays; folders above the repository do not count."""
    for folder in Path(os.path.abspath(path)).parents:  # noqa: PTH100 — without `..`, and links as they are
        if folder.name in OVERLAY_FOLDERS:
            return True
        if (folder / ".git").exists():
            break
    return False


def _kind_of_data(path: Path, *, named: bool) -> Kind:
    """Return the kind of a YAML or JSON file. A file that the user named always has one, so that it is not skipped."""
    kind = _KINDS.get(file_kind(first_bytes(path), path.name), "other")
    if kind == "other" and named:
        return "function" if ending_of(path.name) == ".json" else "overlay"
    return kind
