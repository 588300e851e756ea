"""`sigcat init [FOLDER]`: a project to start from, or the project file for a repository that is there."""

import argparse
import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from sigcat.cli.output import write_text
from sigcat.errors import UsageError

if TYPE_CHECKING:
    from collections.abc import Mapping

_SERVERS = ("github", "gitlab")


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "init",
        help="start a project: catalogue, rule, function, hooks and CI",
        description="Write a project that works: sigcat.toml, an overlay with a signal, a rule, a function with C code "
        "and a trace, and hooks for pre-commit. No file is written over.",
    )
    parser.add_argument(
        "folder", nargs="?", type=Path, metavar="FOLDER", help="folder to write into (default: the current folder)"
    )
    parser.add_argument(
        "--ci",
        choices=_SERVERS,
        help="write the pipeline for this server, too; beside a sigcat.toml, only the pipeline",
    )
    parser.add_argument(
        "--from", dest="existing", type=Path, metavar="REPO_FOLDER",
        help="write only the sigcat.toml that fits the trees, overlays, units, functions and rules in this folder "
        "(default of FOLDER: the same folder)",
    )  # fmt: skip
    parser.set_defaults(run=init)


def init(arguments: argparse.Namespace) -> int:
    """Write the files, and say what to do next."""
    folder: Path = arguments.folder or arguments.existing or Path()
    texts = {**_project(arguments, folder), **_pipelines(arguments.ci)}
    taken = [str(folder / name) for name, text in texts.items() if _would_lose(folder / name, text)]
    if taken:
        raise UsageError(f"nothing was written: {', '.join(taken)} {'is' if len(taken) == 1 else 'are'} there already")
    for name, text in texts.items():
        write_text(text, folder / name)
    print("\n".join(str(folder / name) for name in texts))  # after all is written: a full output stops nothing
    run = (
        f"`sigcat lint`, `sigcat simulate --trace {_TRACE}` and `sigcat serve`" if _TRACE in texts else "`sigcat lint`"
    )
    print(f"Try {run}{'' if folder == Path() else f' in {folder}'}.", file=sys.stderr)
    if arguments.ci:
        _tell_source()
    return 0


def _project(arguments: argparse.Namespace, folder: Path) -> "Mapping[str, str]":
    """The files of a project; none where only a pipeline is missing."""
    from sigcat.project.project import FILE_NAME

    if arguments.existing:
        return _existing(arguments.existing, folder)
    texts = _new(folder)
    return {} if arguments.ci and _would_lose(folder / FILE_NAME, texts[FILE_NAME]) else texts


def _would_lose(path: Path, text: str) -> bool:
    """Whether another file is there; one of the same content is left by a run that was interrupted."""
    return os.path.lexists(path) and not (path.is_file() and path.read_bytes() == text.encode())


_TRACE = "functions/cabin_air/trace.csv"


def _new(folder: Path) -> "Mapping[str, str]":
    from sigcat.function.declaration.scaffold import SCHEMA_FILE, schema_text
    from sigcat.project.starting.ci import HOOKS, hooks_text
    from sigcat.project.starting.start import FUNCTION, starting_files

    schema = {f"{FUNCTION}/{SCHEMA_FILE}": schema_text()}
    return {**starting_files(folder.resolve()), **schema, HOOKS: hooks_text()}


def _existing(existing: Path, folder: Path) -> "Mapping[str, str]":
    from sigcat.project.project import FILE_NAME
    from sigcat.project.starting.existing import configuration_of, found_in

    if not existing.is_dir():
        raise UsageError(f"{existing}: there is no such folder")
    return {FILE_NAME: configuration_of(found_in(existing), folder)}


def _pipelines(server: str | None) -> "Mapping[str, str]":
    from sigcat.project.starting.ci import PIPELINES, installed_source, pipeline_text

    return {PIPELINES[server][0]: pipeline_text(server, installed_source())} if server else {}


def _tell_source() -> None:
    from sigcat.project.starting.ci import installed_source, is_from_index

    source = installed_source()
    if is_from_index(source):
        print(
            f"The pipeline installs {source}. If your package index does not have it, set SIGCAT in the pipeline.",
            file=sys.stderr,
        )
