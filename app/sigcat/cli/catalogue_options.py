"""The options that say which catalogues a service hosts: a configuration file, and catalogues named one by one."""

import argparse
import os
from pathlib import Path
from typing import TYPE_CHECKING

from sigcat.errors import UsageError

if TYPE_CHECKING:
    from sigcat.catalogue.hosting.configuration import Configuration


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
    configuration = read_configuration(file, ("service", "lint")) if file is not None else Configuration()
    named = tuple(source_from_option(text) for text in arguments.catalogue)
    declared = tuple(s for s in configuration.sources if s.id not in {source.id for source in named})
    shipped = (*shipped_sources(), *pulled_sources()) if configuration.has_shipped else ()
    sources = sources_in_order((*named, *declared), shipped)
    if not sources:
        raise UsageError(f"{file}: no catalogue is left to host; declare one, or set shipped = true")
    watching = configuration.is_watching if arguments.watch is None else arguments.watch
    return configuration._replace(sources=sources, is_watching=watching)


def _file(given: Path | None) -> Path | None:
    from sigcat.catalogue.hosting.configuration import FILE_NAME

    if given is not None:
        return given
    if named := os.environ.get("SIGCAT_CONFIG"):
        return Path(named)
    return Path(FILE_NAME) if Path(FILE_NAME).is_file() else None
