"""The shipped tree and its units, parsed once and kept the way Python keeps compiled modules.

To parse its files takes longer than to lint an overlay over them. Their bytes are read all the same, and what is kept is
found by the digest of these bytes: a file that changed in any way is parsed. Files with findings are not kept.
"""

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from sigcat import findings
from sigcat.catalogue.reading import statement, vspec_file, whole_numbers, yaml_document
from sigcat.catalogue.reading.statement import SourceFile, Statement
from sigcat.catalogue.reading.vspec_file import Include, VspecFile
from sigcat.compiled_values import read_values, stamp_of, write_values
from sigcat.data import ROOT_FILE
from sigcat.real_path import real_path

CODE = tuple(Path(str(module.__file__)) for module in (statement, vspec_file, yaml_document, whole_numbers, findings))
"""Modules that decide the values read from a file."""
FOLDER = Path(__file__).parent
"""The folder of cached files."""
TREE = "tree"
"""The name under which the tree is kept."""

Kept = Mapping[str, Any]
"""Statements and includes of files, by the digest of the file."""


def is_shipped(root: Path) -> bool:
    """Whether a file is the root of the shipped tree."""
    return root.name == ROOT_FILE.name and real_path(root) == real_path(ROOT_FILE)


def compiled_files(name: str = TREE) -> Kept:
    """Return the stored values of shipped files under a name; nothing if they were not read before."""
    return read_values(FOLDER, name, stamp_of(CODE)) or {}


def compiled_file(source: SourceFile, kept: Kept) -> VspecFile | None:
    """A file as it was parsed before; None if it was not, or is another one by now."""
    found = kept.get(source.digest)
    if found is None:
        return None
    statements, includes = found
    return VspecFile(
        source,
        tuple([Statement.unpacked(source, *each) for each in statements]),
        tuple(map(Include._make, includes)),
        (),
    )


def keep(files: Iterable[VspecFile], kept: Kept, name: str = TREE) -> None:
    """Keep shipped files under a name, unless all of them are."""
    sound = [file for file in files if not file.findings]
    if any(file.source.digest not in kept for file in sound):
        values = {
            each.source.digest: ([s.packed() for s in each.statements], [*map(tuple, each.includes)]) for each in sound
        }
        write_values(FOLDER, name, stamp_of(CODE), values)
