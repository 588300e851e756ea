"""The options that say which catalogues a service hosts: a configuration file, and catalogues named one by one."""

import argparse
import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

from sigcat.cli.output import could_not_run
from sigcat.errors import InputRefused, UsageError

if TYPE_CHECKING:
    from collections.abc import Mapping

    from sigcat.api.settings import Settings
    from sigcat.catalogue.hosting.configuration import Configuration, TableReader

SETTINGS = "service"
"""The table of the settings."""


def add_catalogue_options(parser: argparse.ArgumentParser) -> None:
    """Add --config, --catalogue and --watch."""
    group = parser.add_argument_group("the catalogues")
    group.add_argument(
        "--config", type=Path, metavar="FILE",
        help="configuration (default: SIGCAT_CONFIG, or sigcat.toml in this folder, if it is there)",
    )  # fmt: skip
    group.add_argument(
        "--catalogue", action="append", default=[], metavar="ID=TREE[,OVERLAY...]",
        help="host this tree, before the shipped ones (pages open with the first): a .vspec file, a folder, or a pulled "
        "release, with overlays in order; may be repeated",
    )  # fmt: skip
    group.add_argument(
        "--watch", action=argparse.BooleanOptionalAction, help="read files again when they change (default: no)"
    )


def chosen_configuration(arguments: argparse.Namespace) -> "Configuration":
    """The configuration, with `sources` as all catalogues that are to be hosted, the default one first.

    Those of the command line stand before those of the file; shipped ones and pulled releases stand last.
    """
    from sigcat.catalogue.hosting.configuration import Configuration, read_configuration
    from sigcat.catalogue.hosting.sources import pulled_sources, shipped_sources, source_from_option, sources_in_order

    file = _file(arguments.config)
    configuration = read_configuration(file, _readers(arguments)) if file is not None else Configuration()
    named = tuple(source_from_option(text) for text in arguments.catalogue)
    declared = tuple(s for s in configuration.sources if s.id not in {source.id for source in named})
    shipped = (*shipped_sources(), *pulled_sources()) if configuration.has_shipped else ()
    sources = sources_in_order((*named, *declared), shipped)
    if not sources:
        raise UsageError(f"{file}: no catalogue is left to host; declare one, or set shipped = true")
    watching = configuration.is_watching if arguments.watch is None else arguments.watch
    return configuration._replace(sources=sources, is_watching=watching)


def chosen_settings(arguments: argparse.Namespace) -> "tuple[Configuration, Settings]":
    """The catalogues to host and the settings: of the command line, before the environment, before the file.

    Raises UsageError if there is anything wrong with them; the findings are printed.
    """
    try:
        configuration = chosen_configuration(arguments)
        settings = configuration.tables.get(SETTINGS) or _settings({}, None, arguments)
    except InputRefused as error:
        raise could_not_run(error) from None
    return configuration, settings


def _readers(arguments: argparse.Namespace) -> "Mapping[str, TableReader]":
    """Who reads the tables of the file: what is wrong with them is told with all else that is wrong with it."""
    from sigcat.rules.linting.configuration import options_of

    return {SETTINGS: lambda table, file: _settings(table, file, arguments), "lint": options_of}


def _settings(table: "Mapping[str, Any]", file: Path | None, arguments: argparse.Namespace) -> "Settings":
    from sigcat.api.read_settings import read_settings

    named = {name: getattr(arguments, name, None) for name in ("host", "port")}
    return read_settings(table, file=file, options={name: value for name, value in named.items() if value is not None})


def _file(given: Path | None) -> Path | None:
    from sigcat.catalogue.hosting.configuration import FILE_NAME

    if given is not None:
        return given
    if named := os.environ.get("SIGCAT_CONFIG"):
        return Path(named)
    return Path(FILE_NAME) if Path(FILE_NAME).is_file() else None
