"""What the named files are: trees, overlays, struct types, parts of a tree, function files, rule files.

`sigcat.file_kind` distinguishes vspec files from others; here the files beside one decide what it is. A file that another file of
the same tree includes is a part of that tree. Parts alone are checked by themselves, below the prefix at which their tree
includes them.
"""

import os
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Literal, NamedTuple

from sigcat.errors import NotFound
from sigcat.file_kind import (
    ENDINGS,
    OVERLAY_FOLDERS,
    ROOT_NAME,
    SHIPPED_ROOT,
    TREE_ENDINGS,
    UNIT_NAMES,
    FileKind,
    ending_of,
    file_kind,
    first_names,
    holds_only_structs,
    holds_signal,
    holds_top_level_node,
    root_branch,
    root_name,
)
from sigcat.limits import RECOGNITION_BYTES
from sigcat.names import nearest

Kind = Literal["tree", "overlay", "types", "part", "function", "rules", "vocabulary", "other"]

_SKIPPED = frozenset(("node_modules", "__pycache__", "build", "dist", "site-packages"))
_INCLUDE = rb"^[ \t]*#include[ \t]+(\S+)(?:[ \t]+(\S+))?"
_KINDS: Mapping[FileKind, Kind] = {
    "vspec": "overlay",
    "units": "vocabulary",
    "quantities": "vocabulary",
    "function": "function",
    "function json": "function",
    "rules": "rules",
}
"""What is done with data files; those of other kinds are passed over, unless the user names them."""

_Includes = Mapping[Path, tuple[tuple[str, str], ...]]


class _Look(NamedTuple):
    """What decides about a file beside the file itself: who includes whom, and the tree that the options name."""

    includes: _Includes
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
    paths: Sequence[Path], overlays: Iterable[Path] = (), types: Iterable[Path] = (), base: Path | None = None
) -> tuple[Source, ...]:
    """The files to lint in `paths`, each once. `overlays`, `types` and the tree `base` are known to be such. Raises NotFound."""
    found = _files_in(paths)
    includes = {path: includes_of(path) for path in found if ending_of(path.name) == ".vspec"}
    parts = _parts(includes)
    known: dict[Path, Kind] = {base.resolve(): "tree"} if base is not None else {}
    known.update({path.resolve(): "overlay" for path in overlays})
    known.update({path.resolve(): "types" for path in types})
    look = _Look(includes, base)
    sources = []
    for path, named in found.items():
        kind = known.get(path.resolve()) if known else None
        sources.append(_source(path, named, kind, _above(path, parts), look))
    return tuple(sources)


def _files_in(paths: Sequence[Path]) -> dict[Path, bool]:
    """The files that paths name, and whether they name the file itself; one that is named in two ways once."""
    found: dict[Path, bool] = {}
    names: dict[str, Path] = {}
    for path in paths:
        if not path.is_dir() and not path.is_file():
            raise NotFound(
                f"{path} must be a regular file" if path.exists() else f"{path}: there is no such file or folder"
            )
        for file in walk(path) if path.is_dir() else (path,):
            first = names.setdefault(os.path.abspath(file), file)  # noqa: PTH100 — links stay as they are
            found[first] = found.get(first, False) or file is path
    return found


def walk(folder: Path) -> Iterator[Path]:
    """Files that may be linted in a folder and below it, in order; hidden and generated folders are left out."""
    for here, folders, files in os.walk(folder):
        folders[:] = sorted(f for f in folders if not f.startswith(".") and f not in _SKIPPED)
        for name in sorted(files):
            if not name.startswith(".") and name.lower().endswith(ENDINGS):
                path = Path(here, name)
                if path.is_file():
                    yield path


def includes_of(path: Path) -> tuple[tuple[str, str], ...]:
    """What a vspec file includes, as it is written, with the prefix."""
    data = first_bytes(path)
    if b"include" not in data:
        return ()
    found = [(m[1], m[2] or b"") for m in re.finditer(_INCLUDE, data, re.MULTILINE)]
    if b"includes:" in data:
        found.extend(_listed_includes(data))
    return tuple(
        (_with_suffix(target.decode(errors="replace")), prefix.decode(errors="replace")) for target, prefix in found
    )


def _listed_includes(data: bytes) -> Iterator[tuple[bytes, bytes]]:
    """Targets of `includes:` lists in block style, with the node that they stand under; line by line."""
    node, within = b"", False
    for line in data.splitlines():
        text = line.strip()
        if line[:1] not in (b" ", b"\t", b"#", b""):
            node, within = text.partition(b":")[0].strip(b"\"'"), False
        elif text.startswith(b"includes:"):
            within = True
            for item in text.removeprefix(b"includes:").strip(b" []").split(b","):
                if item.strip(b" \"'"):
                    yield item.strip(b" \"'"), node
        elif within and text.startswith(b"- "):
            yield text[2:].split(b"#")[0].strip(b" \"'"), node
        elif within and text:
            within = text.startswith(b"#")


def first_bytes(path: Path) -> bytes:
    """The bytes of a file, as far as they are needed to recognize it; nothing if it cannot be read.

    A pipe is not opened: reading would wait for it.
    """
    if not path.is_file():
        return b""
    try:
        with path.open("rb") as file:
            return file.read(RECOGNITION_BYTES)
    except (OSError, ValueError):
        return b""


def tree_of(part: Path) -> tuple[Path, str] | None:
    """The nearest tree above a file that includes it, directly or through others, and the prefix at which it does.

    Of several files in one folder the one whose way is the longest counts: it includes the others.
    """
    wanted = part.resolve()
    for folder in list(wanted.parents)[:6]:
        roots = (root for root in sorted(folder.glob("*.vspec")) if root.resolve() != wanted)
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
    for folder in list(near.resolve().parents)[:6]:
        for near_by in (folder / "vspec", folder / "spec", folder):
            candidate = near_by / ROOT_NAME if (near_by / ROOT_NAME).is_file() else _only_tree(near_by, near)
            if candidate is not None:
                return candidate
        if (folder / ".git").exists():
            break
    return None


def types_beside(files: Iterable[Path]) -> tuple[Path, ...]:
    """Files of struct types in the folders of trees and overlays, those left out that a file there includes."""
    beside = [path for folder in dict.fromkeys(f.parent for f in files) for path in sorted(folder.glob("*.vspec"))]
    found = [path for path in beside if is_of_types(path)]
    parts = _parts({path: includes_of(path) for path in found})
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
        included = [_included(target, file, path.parent) for target, _ in includes_of(file)]
        new = {target for target in included if target is not None} - seen
        seen |= new
        waiting.extend(new)
    return found


def _included(target: str, file: Path, root: Path) -> Path | None:
    """The file that an include means: it is looked for beside the root, then beside the file that includes it."""
    return next((path for path in (root / target, file.parent / target) if path.is_file()), None)


def tree_with_root(name: str, overlay: Path) -> Path | None:
    """A tree beside an overlay whose root has a name, units or not."""
    beside = (path for path in sorted(overlay.parent.glob("*.vspec")) if path != overlay)
    return next((path for path in beside if name and root_branch(_bytes_with_root(path)) == name), None)


def overlay_beside_with(path: str, overlay: Path) -> Path | None:
    """A file in the folder of an overlay that writes a node of this path."""
    written = rb"^[\"']?" + re.escape(path.encode()) + rb"[\"']?[ \t]*:"
    beside = (other for other in sorted(overlay.parent.glob("*.vspec")) if other.name != overlay.name)
    return next((other for other in beside if re.search(written, first_bytes(other), re.MULTILINE)), None)


def has_root(path: Path, name: str) -> bool:
    """Whether the root of a tree has a name. One that no file shows may have any."""
    return root_of(path) in (name, "")


def root_of(tree: Path) -> str:
    """The name of the root of a tree; empty if none is found."""
    return root_name(_bytes_with_root(tree))


def _bytes_with_root(path: Path) -> bytes:
    """The first bytes of a tree or overlay; if all that it has are includes, of the first of these that has nodes."""
    seen, waiting = {path}, [path]
    while waiting:
        file = waiting.pop(0)
        data = first_bytes(file)
        if root_name(data):
            return data
        included = [_included(target, file, path.parent) for target, prefix in includes_of(file) if not prefix]
        new = [target for target in included if target is not None and target not in seen]
        seen.update(new)
        waiting.extend(new)
    return b""


def _only_tree(folder: Path, near: Path) -> Path | None:
    if folder.name in OVERLAY_FOLDERS or not _has_units(folder):
        return None
    others = (path for path in sorted(folder.glob("*.vspec")) if path != near.resolve())
    trees = [
        path
        for path in others
        if holds_top_level_node(first_bytes(path)) and not is_of_types(path) and tree_of(path) is None
    ]
    return trees[0] if len(trees) == 1 else None


def _has_units(folder: Path) -> bool:
    return any((folder / name).is_file() for name in UNIT_NAMES)


def _source(path: Path, named: bool, known: Kind | None, above: Path | None, look: _Look) -> Source:
    """`above` is the file of the list that includes this one, directly or through others, and is included by none."""
    if known:
        return Source(path, known, named)
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
    has_units = _has_units(path.parent)
    if _is_in_overlay_folder(path) or (has_units and (path.parent / ROOT_NAME).is_file()):
        return "overlay"
    signs = (has_units, bool(look.includes.get(path)), holds_top_level_node(first_bytes(path)))
    return "tree" if sum(signs) > 1 else "overlay"


def _tree_around(path: Path) -> tuple[Path, str] | None:
    """The tree in whose folder a part stands that nobody includes, since an include is missing, and the root of the tree."""
    names = first_names(first_bytes(path))
    if not holds_top_level_node(first_bytes(path)) or _is_in_overlay_folder(path):
        return None
    tree = default_tree(path)
    if tree is None or tree.parent not in path.resolve().parents:
        return None
    if len(names) == 1 and path.resolve().parent == tree.parent:
        return None  # a tree of its own, beside the other
    root = root_of(tree)
    return (tree, root) if root and root.encode() not in names else None


def _has_own_root(path: Path, base: Path | None) -> bool:
    """Whether a file begins with a root that is not the root of the tree which an overlay here would be made for."""
    own = root_branch(_bytes_with_root(path))
    if not own:
        return False
    below = base or default_tree(path)
    known = root_of(below) if below is not None else SHIPPED_ROOT
    return bool(known) and own != known and not nearest(own, [known])


def _is_in_overlay_folder(path: Path) -> bool:
    """Whether the file is below a folder for overlays; folders above the repository do not count."""
    for folder in Path(os.path.abspath(path)).parents:  # noqa: PTH100 — without `..`, and links as they are
        if folder.name in OVERLAY_FOLDERS:
            return True
        if (folder / ".git").exists():
            break
    return False


def _above(path: Path, parts: Mapping[Path, Path]) -> Path | None:
    """The end of the chain of includers; None for a file that none includes."""
    seen = [path]
    while seen[-1] in parts and parts[seen[-1]] not in seen:
        seen.append(parts[seen[-1]])
    return seen[-1] if len(seen) > 1 else None


def _parts(includes: _Includes) -> dict[Path, Path]:
    """Files of the list that others of it include, each with one that does. Targets are relative to the root's folder or to the file's own.

    Works on texts and asks no file system: a tree has hundreds of includes.
    """
    by_name = {os.path.abspath(path): path for path in includes}  # noqa: PTH100 — texts, see above
    folders = {os.path.dirname(name) for name in by_name}  # noqa: PTH120
    parts: dict[Path, Path] = {}
    for name, path in by_name.items():
        for target, _ in includes[path]:
            folder = os.path.dirname(name)  # noqa: PTH120
            while True:
                candidate = os.path.normpath(f"{folder}/{target}")
                if candidate in by_name and candidate != name:
                    parts.setdefault(by_name[candidate], path)
                    break
                above = os.path.dirname(folder)  # noqa: PTH120
                if above == folder or not any(known.startswith(above) for known in folders):
                    break
                folder = above
    return parts


def _with_suffix(target: str) -> str:
    return target if ending_of(target) else f"{target}{TREE_ENDINGS[0]}"


def _prefix_in(file: Path, wanted: Path, root: Path, prefix: str, seen: set[Path]) -> str | None:
    seen.add(file)
    for target, inner in includes_of(file):
        deeper = ".".join(part for part in (prefix, inner) if part)
        for candidate in dict.fromkeys((root / target, file.parent / target)):
            if not candidate.is_file():
                continue
            if candidate.resolve() == wanted:
                return deeper
            if candidate not in seen and len(seen) < 10_000:
                found = _prefix_in(candidate, wanted, root, deeper, seen)
                if found is not None:
                    return found
            break
    return None


def _kind_of_data(path: Path, *, named: bool) -> Kind:
    """What a YAML or JSON file is. A file that the user named is taken for something, so that it is not passed over."""
    kind = _KINDS.get(file_kind(first_bytes(path), path.name), "other")
    if kind == "other" and named:
        return "function" if ending_of(path.name) == ".json" else "overlay"
    return kind
