"""Includes between files, read from their first bytes alone."""

import os
import re
from collections.abc import Iterator, Mapping
from pathlib import Path

from sigcat.file_kind import TREE_ENDINGS, ending_of
from sigcat.limits import RECOGNITION_BYTES
from sigcat.open_files import open_text

_INCLUDE = rb"^[ \t]*#include[ \t]+(\S+)(?:[ \t]+(\S+))?"
Includes = Mapping[Path, tuple[tuple[str, str], ...]]
"""Includes of each file, as they are written, with the prefix."""


def includes_of(path: Path) -> tuple[tuple[str, str], ...]:
    """Yield the includes of a vspec file, as they are written, with the prefix."""
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
    text = open_text(path)
    if text is not None or not path.is_file():
        return (text or b"")[:RECOGNITION_BYTES]
    try:
        with path.open("rb") as file:
            return file.read(RECOGNITION_BYTES)
    except (OSError, ValueError):
        return b""


def included_file(target: str, file: Path, root: Path) -> Path | None:
    """The file that an include means: it is looked for beside the root, then beside the file that includes it."""
    return next((path for path in (root / target, file.parent / target) if path.is_file()), None)


def included_parts(includes: Includes) -> dict[Path, Path]:
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


def topmost(path: Path, parts: Mapping[Path, Path]) -> Path | None:
    """The end of the chain of includers; None for a file that none includes."""
    seen = [path]
    while seen[-1] in parts and parts[seen[-1]] not in seen:
        seen.append(parts[seen[-1]])
    return seen[-1] if len(seen) > 1 else None


def _with_suffix(target: str) -> str:
    return target if ending_of(target) else f"{target}{TREE_ENDINGS[0]}"
