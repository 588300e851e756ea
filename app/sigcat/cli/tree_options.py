"""The options that name a tree, spelled as those of `vspec export`."""

import argparse
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from sigcat.cli.output_options import refuse_overwriting
from sigcat.errors import InputRefused, existing_file
from sigcat.findings import has_errors

if TYPE_CHECKING:
    from sigcat.catalogue.hosting.source import Source
    from sigcat.catalogue.model.catalogue import Catalogue


def add_tree_options(parser: argparse.ArgumentParser) -> None:
    """Add -s, -l, -I, -u, -q and -t. Without -s, the tree that sigcat ships is meant."""
    group = parser.add_argument_group("the tree")
    group.add_argument(
        "-s",
        "--vspec",
        type=Path,
        metavar="TREE",
        help="root .vspec file, a tree in JSON, a folder with one, a pulled release such as v5.0, or vss: the shipped tree alone "
        "(default: the shipped tree with its overlays)",
    )
    add_many(group, "-l", "--overlays", "overlay, applied in the order given")
    add_vocabulary_options(group)


def add_vocabulary_options(group: argparse._ArgumentGroup) -> None:
    """Add -I, -u, -q and -t: what a tree refers to."""
    add_many(group, "-I", "--include-dirs", "folder in which included files are looked for too", "FOLDER")
    add_many(group, "-u", "--units", "units (default: units.yaml beside the tree)")
    add_many(group, "-q", "--quantities", "quantities (default: quantities.yaml beside the tree)")
    add_many(group, "-t", "--types", "struct types (default: those beside the tree, where a folder is named)")


def add_many(group: argparse._ArgumentGroup, short: str, name: str, text: str, metavar: str = "FILE") -> None:
    """Add an option that names files and may be repeated."""
    group.add_argument(
        short, name, type=Path, action="append", default=[], metavar=metavar, help=f"{text}; may be repeated"
    )


def add_dbc(group: argparse._ActionsContainer, text: str) -> None:
    """Add --dbc, which may be repeated."""
    group.add_argument("--dbc", type=Path, action="append", default=[], metavar="FILE", help=f"{text}; may be repeated")


def read_tree(arguments: argparse.Namespace, *, expanded: bool = True, for_export: bool = False) -> "Catalogue":
    """The catalogue that the options name. Its warnings go to standard error; errors raise InputRefused.

    `for_export`: an error with which vss-tools exports a tree is a warning.
    """
    from sigcat.catalogue.exporting.stopping import with_exported_errors_as_warnings
    from sigcat.catalogue.hosting.source import load

    catalogue = load(tree_source(arguments), expanded=expanded)
    refuse_overwriting(arguments, (file.name for file in catalogue.files))
    catalogue = with_exported_errors_as_warnings(catalogue) if for_export else catalogue
    if has_errors(catalogue.findings):
        raise InputRefused("the tree has errors; nothing was done", catalogue.findings)
    for finding in catalogue.findings:
        print(finding.line_of_text, file=sys.stderr)
    return catalogue


def tree_source(arguments: argparse.Namespace) -> "Source":
    """The tree that the options name, or the one that sigcat ships; `release` is set where -s names one."""
    from sigcat.catalogue.hosting.sources import shipped_sources, source_of_tree

    for path in (*arguments.overlays, *arguments.units, *arguments.quantities, *arguments.types):
        existing_file(path)
    source = source_of_tree(str(arguments.vspec)) if arguments.vspec is not None else shipped_sources()[0]
    return source._replace(
        id=source.spec.stem,
        overlays=(*source.overlays, *arguments.overlays),
        units=(*source.units, *arguments.units),
        quantities=(*source.quantities, *arguments.quantities),
        types=tuple(arguments.types) or source.types,
        include_dirs=tuple(arguments.include_dirs),
    )
