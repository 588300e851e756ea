"""The tree, the struct types and the overlays near a file."""

from collections.abc import Iterable
from pathlib import Path

from sigcat.file_kind import (
    OVERLAY_FOLDERS,
    ROOT_NAME,
    UNIT_NAMES,
    holds_only_structs,
    holds_signal,
    holds_top_level_node,
    root_branch,
    root_name,
)
from sigcat.real_path import real_path
from sigcat.rules.linting.includes import first_bytes, included_file, included_parts, includes_of


def tree_of(part: Path) -> tuple[Path, str] | None:
    """The nearest tree above a file that includes it, directly or through others, and the prefix at which it does.

    Of several files in one folder the one whose way is the longest counts: it includes the others.
    """
    wanted = real_path(part)
    for folder in list(wanted.parents)[:6]:
        roots = (root for root in _vspec_files(folder) if real_path(root) != wanted)
        found = [
            (root, prefix) for root in roots if (prefix := _prefix_in(root, wanted, folder, "", set())) is not None
        ]
        if found:
            return max(found, key=lambda pair: (pair[1].count("."), len(pair[1]), pair[0].name == ROOT_NAME))
        if (folder / ".git").exists():
            break
    return None


def default_tree(near: Path) -> Path | None:
    """The tree that an overlay is made for, where no option names it: `vspec/` or `spec/` beside the overlays, or above.

    It has the usual name, or it is the only tree in a folder with units.
    """
    for folder in list(real_path(near).parents)[:6]:
        for near_by in (folder / "vspec", folder / "spec", folder):
            candidate = near_by / ROOT_NAME if (near_by / ROOT_NAME).is_file() else _only_tree(near_by, near)
            if candidate is not None:
                return candidate
        if (folder / ".git").exists():
            break
    return None


def types_beside(files: Iterable[Path]) -> tuple[Path, ...]:
    """Files of struct types in the folders of trees and overlays, those left out that a file there includes."""
    beside = [path for folder in dict.fromkeys(f.parent for f in files) for path in _vspec_files(folder)]
    found = [path for path in beside if is_of_types(path)]
    parts = included_parts({path: includes_of(path) for path in found})
    return tuple(path for path in found if path not in parts)


def is_of_types(path: Path) -> bool:
    """Whether a file holds struct types and no signals, itself or by what it includes."""
    found = False
    seen, waiting = {path}, [path]
    while waiting:
        file = waiting.pop()
        data = first_bytes(file)
        if holds_signal(data):
            return False
        found = found or holds_only_structs(data)
        included = [included_file(target, file, path.parent) for target, _ in includes_of(file)]
        new = {target for target in included if target is not None} - seen
        seen |= new
        waiting.extend(new)
    return found


def tree_with_root(name: str, overlay: Path) -> Path | None:
    """A tree beside an overlay whose root has a name, units or not."""
    beside = (path for path in _vspec_files(overlay.parent) if path != overlay)
    return next((path for path in beside if name and root_branch(bytes_with_root(path)) == name), None)


def has_root(path: Path, name: str) -> bool:
    """Whether the root of a tree has a name. One that no file shows may have any."""
    return root_of(path) in (name, "")


def root_of(tree: Path) -> str:
    """The name of the root of a tree; empty if none is found."""
    return root_name(bytes_with_root(tree))


def bytes_with_root(path: Path) -> bytes:
    """The first bytes of a tree or overlay; if all that it has are includes, of the first of these that has nodes."""
    seen, waiting = {path}, [path]
    while waiting:
        file = waiting.pop(0)
        data = first_bytes(file)
        if root_name(data):
            return data
        included = [included_file(target, file, path.parent) for target, prefix in includes_of(file) if not prefix]
        new = [target for target in included if target is not None and target not in seen]
        seen.update(new)
        waiting.extend(new)
    return b""


def _vspec_files(folder: Path) -> list[Path]:
    """In the order of their names. A link that leads nowhere, or to itself, is none."""
    return [path for path in sorted(folder.glob("*.vspec")) if path.is_file()]


def _only_tree(folder: Path, near: Path) -> Path | None:
    if folder.name in OVERLAY_FOLDERS or not has_units(folder):
        return None
    others = (path for path in _vspec_files(folder) if path != real_path(near))
    trees = [
        path
        for path in others
        if holds_top_level_node(first_bytes(path)) and not is_of_types(path) and tree_of(path) is None
    ]
    return trees[0] if len(trees) == 1 else None


def has_units(folder: Path) -> bool:
    return any((folder / name).is_file() for name in UNIT_NAMES)


def _prefix_in(file: Path, wanted: Path, root: Path, prefix: str, seen: set[Path]) -> str | None:
    seen.add(file)
    for target, inner in dict.fromkeys(includes_of(file)):
        deeper = ".".join(part for part in (prefix, inner) if part)
        for candidate in dict.fromkeys((root / target, file.parent / target)):
            if not candidate.is_file():
                continue
            if real_path(candidate) == wanted:
                return deeper
            if candidate not in seen and len(seen) < 10_000:
                found = _prefix_in(candidate, wanted, root, deeper, seen)
                if found is not None:
                    return found
            break
    return None
