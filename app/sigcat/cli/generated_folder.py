"""The folder that files are generated into. Existing files are replaced only if sigcat wrote them and they are unchanged.

A function that left the set leaves no files behind.
"""

import argparse
import os
from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from sigcat import __version__
from sigcat.cli.output import make_folder, write_bytes
from sigcat.cli.output_options import add_output
from sigcat.digest import digest_of
from sigcat.errors import UsageError

if TYPE_CHECKING:
    from sigcat.adapter.files import GeneratedFile

LIST = ".sigcat-generated"
"""In the folder: the files that sigcat has written there, each with its generator and the SHA-256 of its content."""
_HEAD = f"# Written by `sigcat generate` of sigcat {__version__}, which replaces these files and no others. Keep it with them.\n"


class _Entry(NamedTuple):
    """A file of the list."""

    generator: str
    digest: str


def add_folder(parser: argparse.ArgumentParser) -> None:
    """Add the options that say where the files go."""
    add_output(parser, "-o", "--output", required=True, metavar="DIR", help="folder to write to")
    help_text = "replace files of these names that sigcat has not written, or that were changed since"
    parser.add_argument("--force", action="store_true", help=help_text)


def paths_in(folder: Path, files: "Sequence[GeneratedFile]") -> list[Path]:
    """Everything that is written into the folder."""
    return [*(folder / file.name for file in files), folder / LIST]


def write_generated(
    files: "Sequence[GeneratedFile]", folder: Path, generator: str, *, is_whole: bool, force: bool
) -> None:
    """Write the files of a generator; if they are all of its files, remove files that it wrote there before.

    The folder is created. Raises UsageError, before anything is written, if something would be lost that
    sigcat has not written.
    """
    make_folder(folder)
    known = _listed(folder)
    others = [folder / file.name for file in files if _would_lose(folder / file.name, file, known.get(file.name))]
    if others and not force:
        raise UsageError(_refusal(others))
    written = {file.name: _Entry(generator, digest_of(file.data)) for file in files}
    left = {name: entry for name, entry in known.items() if name not in written and (folder / name).is_file()}
    gone = {name for name, entry in left.items() if is_whole and entry.generator == generator}
    for parent in sorted({(folder / file.name).parent for file in files}):
        parent.mkdir(parents=True, exist_ok=True)
    write_bytes(
        _list_of({**{name: entry for name, entry in left.items() if name not in gone}, **written}), folder / LIST
    )
    for file in files:
        write_bytes(file.data, folder / file.name)
    for name in gone:
        _remove(folder, name, left[name])


def _would_lose(path: Path, file: "GeneratedFile", entry: _Entry | None) -> bool:
    """Whether the file differs from the one that is written now, and from the one written before."""
    if not os.path.lexists(path) or path.is_dir():
        return False
    same = (digest_of(file.data), entry.digest if entry else "")
    return not path.is_file() or digest_of(path.read_bytes()) not in same


def _remove(folder: Path, name: str, entry: _Entry) -> None:
    """Remove a file, and folders that are empty without it; one that was changed is no longer ours, and stays."""
    path = folder / name
    if path.is_symlink() or digest_of(path.read_bytes()) != entry.digest:
        return
    path.unlink()
    with suppress(OSError):  # the first one that is not empty
        for above in Path(name).parents[:-1]:
            (folder / above).rmdir()


def _refusal(others: Sequence[Path]) -> str:
    more = f" (and {len(others) - 1} more)" if len(others) > 1 else ""
    return (
        f"{others[0]}{more} is not a file that `sigcat generate` wrote, or was changed since ({LIST} lists them): "
        "name another folder, or replace it with --force"
    )


def _listed(folder: Path) -> Mapping[str, _Entry]:
    """Return the listed files by name; nothing without a list. Names lead nowhere else."""
    try:
        text = (folder / LIST).read_text("utf-8", errors="replace")
    except OSError:
        return {}
    rows = [line.split(" ", 2) for line in text.splitlines() if not line.startswith("#")]
    return {row[2]: _Entry(row[0], row[1]) for row in rows if len(row) == 3 and _is_below(row[2])}


def _is_below(name: str) -> bool:
    return not Path(name).is_absolute() and ".." not in Path(name).parts


def _list_of(entries: Mapping[str, _Entry]) -> bytes:
    rows: Iterable[str] = (f"{entry.generator} {entry.digest} {name}\n" for name, entry in sorted(entries.items()))
    return (_HEAD + "".join(rows)).encode()
