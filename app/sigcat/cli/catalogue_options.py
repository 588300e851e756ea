"""The options that say which catalogues a service hosts: those of the project, and catalogues named one by one."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING, Any

from sigcat.cli.output import could_not_run
from sigcat.cli.project_options import project_of
from sigcat.errors import InputRefused, UsageError

if TYPE_CHECKING:
    from collections.abc import Mapping

    from sigcat.api.settings import Settings
    from sigcat.catalogue.hosting.source import Source
    from sigcat.project.project import Project

SETTINGS = "service"
"""The table of the settings."""


def add_catalogue_options(parser: argparse.ArgumentParser) -> None:
    """Add --catalogue and --watch."""
    group = parser.add_argument_group("the catalogues")
    group.add_argument(
        "--catalogue", action="append", default=[], metavar="ID=TREE[,OVERLAY...]",
        help="host this tree, before the shipped ones (pages open with the first): a .vspec file, a folder, or a pulled "
        "release, with overlays in order; may be repeated",
    )  # fmt: skip
    group.add_argument(
        "--watch", action=argparse.BooleanOptionalAction, help="read files again when they change (default: no)"
    )


def hosted_sources(arguments: argparse.Namespace, project: "Project") -> "tuple[Source, ...]":
    """Return the catalogues to host, the default one first: those of the options, of the project, shipped and pulled ones.

    Raises UsageError if there is none.
    """
    from sigcat.catalogue.hosting.sources import pulled_sources, shipped_sources, source_from_option, sources_in_order
    from sigcat.project.chosen_tree import with_additions

    named = tuple(with_additions(source_from_option(text), project) for text in arguments.catalogue)
    declared = tuple(s for s in project.catalogues if s.id not in {source.id for source in named})
    shipped = (*shipped_sources(), *pulled_sources()) if project.has_shipped_catalogues else ()
    if not project.catalogues:
        shipped = tuple(with_additions(source, project) for source in shipped)
    sources = sources_in_order((*named, *declared), shipped)
    if not sources:
        raise UsageError(f"{project.file}: no catalogue is left to host; declare one, or set shipped = true")
    return sources


def served_project(arguments: argparse.Namespace) -> "tuple[Project, Settings]":
    """Return the project and the settings of the service: of the options, before the environment, before the file.

    Raises UsageError if there is anything wrong with them; the findings are printed.
    """
    project = project_of(arguments, readers={SETTINGS: lambda table, file: _settings(table, file, arguments)})
    if arguments.watch is not None:
        project = project._replace(is_watching=arguments.watch)
    try:
        settings = project.tables.get(SETTINGS) or _settings({}, None, arguments)
    except InputRefused as error:
        raise could_not_run(error) from None
    return project, settings


def read_again(arguments: argparse.Namespace, file: Path) -> "Project":
    """Return the project of a file that has changed since. Raises InputRefused or UsageError."""
    from sigcat.project.read_project import read_project

    return read_project(file, {SETTINGS: lambda table, place: _settings(table, place, arguments)})


def _settings(table: "Mapping[str, Any]", file: Path | None, arguments: argparse.Namespace) -> "Settings":
    from sigcat.api.read_settings import read_settings

    named = {name: getattr(arguments, name, None) for name in ("host", "port")}
    return read_settings(table, file=file, options={name: value for name, value in named.items() if value is not None})
