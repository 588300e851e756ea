"""The options that name what is written. Nothing is written over a source of the project, what the command reads, or wrote just before."""

import argparse
import os
from collections.abc import Iterable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

from sigcat.errors import InputRefused, UsageError

FORMATS = ("text", "json", "github", "gitlab", "sarif", "junit")
"""Forms of a report of findings."""
_STANDARD_OUTPUT = Path("-")


def add_output(parser: argparse._ActionsContainer, *names: str, **named: Any) -> None:
    """Add an option that names a file or a folder to write."""
    parser.add_argument(*names, type=Path, action=Output, **named)


def add_outputs(parser: argparse._ActionsContainer, *names: str, **named: Any) -> None:
    """Add an option that names a file to write, and may be repeated."""
    parser.add_argument(*names, type=Path, action=Outputs, default=[], **named)


def name_output(arguments: argparse.Namespace, name: str, path: Path) -> None:
    """Set an option to what is written, as if it had been given."""
    setattr(arguments, name, path)
    arguments.outputs = {**outputs_of(arguments), name: path}


def outputs_of(arguments: argparse.Namespace) -> dict[str, Path]:
    """Files to write, by the names of the options."""
    outputs: dict[str, Path] = getattr(arguments, "outputs", {})
    return outputs


def refuse_overwriting(
    arguments: argparse.Namespace, read: Iterable[str | Path] = (), written: Iterable[Path] = ()
) -> None:
    """Raise UsageError if a source of the project or a file that is read would be written, or one file twice.

    `read` and `written` are files that the arguments do not name: included ones, those in a folder.
    """
    named = outputs_of(arguments)
    outputs = [path for path in named.values() if path != _STANDARD_OUTPUT]
    written = tuple(written)
    if not (outputs or written):
        return
    inputs = {_identity(Path(path)) for path in (*_inputs(arguments, named), *read)} - {None}
    for path in (*outputs, *written):
        if _identity(path) in inputs:
            raise UsageError(f"{path} is read by this command and would be lost: name another file to write")
    for path in outputs:
        if path.is_file() and (kind := _kind_of_source(path)):
            raise UsageError(f"{path} is {kind}, which people write, and would be lost: name another file to write")
    if twice := _twice([*outputs, *written]):
        raise UsageError(f"{twice} is named for two results: name a file for each")


class Output(argparse.Action):
    """Action of an option that names a file or a folder to write."""

    def __call__(
        self, _parser: argparse.ArgumentParser, arguments: argparse.Namespace, value: Any, _option: str | None = None
    ) -> None:
        """Keep the path, beside those of the other outputs: it is not read."""
        name_output(arguments, self.dest, value)


class Outputs(argparse.Action):
    """Action of an option that names several files."""

    def __call__(
        self, _parser: argparse.ArgumentParser, arguments: argparse.Namespace, value: Any, _option: str | None = None
    ) -> None:
        """Keep the path, beside those before it."""
        listed = [*getattr(arguments, self.dest), value]
        setattr(arguments, self.dest, listed)
        name = self.dest if len(listed) == 1 else f"{self.dest} {len(listed)}"
        arguments.outputs = {**outputs_of(arguments), name: value}


def _inputs(arguments: argparse.Namespace, outputs: dict[str, Path]) -> Iterator[Path]:
    for name, value in vars(arguments).items():
        if name not in outputs:
            yield from (path for path in (value if isinstance(value, list) else [value]) if isinstance(path, Path))


def _kind_of_source(path: Path) -> str:
    """The kind of a file that no command makes: code, a declared function, or a file that a project names; else empty."""
    from sigcat.file_kind import file_kind
    from sigcat.function.c_project.files import HEADERS, SOURCES
    from sigcat.limits import RECOGNITION_BYTES

    if path.suffix.lower() in HEADERS | SOURCES:
        return "C or C++ code"
    with path.open("rb") as file:
        if file_kind(file.read(RECOGNITION_BYTES), path.name) == "function":
            return "a function"
    return "a file of a project" if _identity(path) in map(_identity, _project_files(path)) else ""


def _project_files(path: Path) -> Iterator[Path]:
    """The files that the project around a file names, if there is one that can be read."""
    from sigcat.project.find_project import nearest_project
    from sigcat.project.read_project import read_project

    file = nearest_project(path.parent)
    if file is None:
        return
    yield file
    with suppress(InputRefused, UsageError):  # its faults are reported where it is used
        project = read_project(file)
        yield from project.files
        for source in project.catalogues:
            yield from (*source.overlays, *source.types)


def _identity(path: Path) -> tuple[int, int] | None:
    """Return the identity of a regular file, however it is spelled, and through links; None for all else."""
    try:
        status = path.stat()
        return (status.st_dev, status.st_ino) if path.is_file() else None
    except (OSError, ValueError):
        return None


def _twice(outputs: list[Path]) -> Path | None:
    """The output of which the second text would replace the first; a device takes both, and a folder many files."""
    known: set[object] = set()
    for path in outputs:
        if path.exists() and not path.is_file():
            continue
        place = _identity(path) or os.path.realpath(path)
        if place in known:
            return path
        known.add(place)
    return None
