"""The options that name a tree, spelled as those of `vspec export`."""

import argparse
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from app.errors import InputRefused, UsageError
from app.findings import has_errors

if TYPE_CHECKING:
    from app.catalogue.model import Catalogue


def add_tree_options(parser: argparse.ArgumentParser) -> None:
    """Add -s, -l, -I, -u, -q and -t. Without -s, the tree that sigcat ships is meant."""
    group = parser.add_argument_group("the tree")
    group.add_argument(
        "-s",
        "--vspec",
        type=Path,
        metavar="TREE",
        help="root .vspec file, a folder with one, or a pulled release such as v5.0 (default: the shipped tree)",
    )
    add_many(group, "-l", "--overlays", "overlay, applied in the order given")
    add_many(group, "-I", "--include-dirs", "folder in which included files are looked for too", "FOLDER")
    add_many(group, "-u", "--units", "units (default: units.yaml beside the tree)")
    add_many(group, "-q", "--quantities", "quantities (default: quantities.yaml beside the tree)")
    add_many(group, "-t", "--types", "struct types")


def add_many(group: argparse._ArgumentGroup, short: str, name: str, text: str, metavar: str = "FILE") -> None:
    """Add an option that names files and may be repeated."""
    group.add_argument(
        short, name, type=Path, action="append", default=[], metavar=metavar, help=f"{text}; may be repeated"
    )


def read_tree(arguments: argparse.Namespace, *, expanded: bool = True) -> "Catalogue":
    """The catalogue that the options name. Its warnings go to standard error; errors raise InputRefused."""
    from app.catalogue.compose import read_catalogue

    spec, units, overlays = tree_files(arguments)
    catalogue = read_catalogue(
        spec,
        overlays,
        include_dirs=arguments.include_dirs,
        units=units,
        quantities=arguments.quantities,
        types=arguments.types,
        expanded=expanded,
        is_release=bool(named_release(arguments)),
    )
    if has_errors(catalogue.findings):
        raise InputRefused("the tree has errors; nothing was done", catalogue.findings)
    for finding in catalogue.findings:
        print(finding.line_of_text, file=sys.stderr)
    return catalogue


def tree_files(arguments: argparse.Namespace) -> tuple[Path, tuple[Path, ...], tuple[Path, ...]]:
    """Root file, units and overlays that the options name, or those that sigcat ships."""
    from app.catalogue.sources import shipped_sources

    for path in (*arguments.overlays, *arguments.units, *arguments.quantities, *arguments.types):
        if not path.is_file():
            raise UsageError(f"{path}: there is no such file")
    if arguments.vspec is not None:
        return _root(arguments.vspec), tuple(arguments.units), tuple(arguments.overlays)
    shipped = shipped_sources()[0]
    return shipped.spec, (*shipped.units, *arguments.units), (*shipped.overlays, *arguments.overlays)


def named_release(arguments: argparse.Namespace) -> str:
    """The pulled release that -s names; empty for a file, a folder, or the shipped tree."""
    tree: Path | None = arguments.vspec
    return str(tree) if tree is not None and not tree.exists() else ""


def _root(tree: Path) -> Path:
    """The root file that -s names: a file, the one in a folder, or that of a pulled release."""
    from app.catalogue.sources import source_of_tree

    if not tree.exists() and (tree.suffix in (".vspec", ".yaml", ".yml") or len(tree.parts) > 1):
        raise UsageError(f"{tree}: there is no such file")
    return source_of_tree(str(tree)).spec
