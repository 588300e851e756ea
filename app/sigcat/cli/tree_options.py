"""The options that name a tree, spelled as those of `vspec export`."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from sigcat.cli.output import print_findings
from sigcat.cli.output_options import refuse_overwriting
from sigcat.cli.project_options import add_project_options, project_of
from sigcat.errors import InputRefused, UsageError, existing_file, without_signals
from sigcat.findings import has_errors
from sigcat.real_path import real_path

if TYPE_CHECKING:
    from collections.abc import Sequence

    from sigcat.catalogue.comparing.trial import OverlayPlace
    from sigcat.catalogue.model.catalogue import Catalogue
    from sigcat.project.chosen_tree import TreeOptions


def add_tree_options(parser: argparse.ArgumentParser) -> None:
    """Add -s, -l, -I, -u, -q and -t, and the options of the project. Without -s, its first catalogue is meant, or the shipped one."""
    group = parser.add_argument_group("the tree")
    group.add_argument(
        "-s",
        "--vspec",
        type=Path,
        metavar="TREE",
        help="catalogue of the project, vehicle:ID, root .vspec file, a tree in JSON, a folder with one, a pulled release such as v5.0, "
        "or vss: the shipped tree alone (default: the first catalogue of the project, the tree near the overlays of -l, or the shipped tree with its overlays)",
    )
    add_many(group, "-l", "--overlays", "overlay, applied in the order given, after those of the catalogue")
    add_vocabulary_options(group)
    add_project_options(group)


def add_vocabulary_options(group: argparse._ArgumentGroup) -> None:
    """Add -I, -u, -q and -t: what a tree refers to."""
    add_many(group, "-I", "--include-dirs", "folder in which included files are looked for too", "FOLDER")
    add_many(group, "-u", "--units", "units, added to those of the tree")
    add_many(group, "-q", "--quantities", "quantities, added to those of the tree")
    add_many(group, "-t", "--types", "struct types (default: those beside the tree, where a folder is named)")


def add_many(group: argparse._ArgumentGroup, short: str, name: str, text: str, metavar: str = "FILE") -> None:
    """Add an option that names files and may be repeated."""
    group.add_argument(
        short, name, type=Path, action="append", default=[], metavar=metavar, help=f"{text}; may be repeated"
    )


def add_dbc(group: argparse._ActionsContainer, text: str) -> None:
    """Add --dbc, which may be repeated."""
    group.add_argument("--dbc", type=Path, action="append", default=[], metavar="FILE", help=f"{text}; may be repeated")


def read_tree(
    arguments: argparse.Namespace,
    *,
    expanded: bool = True,
    for_export: bool = False,
    for_units: bool = False,
    below: Path | None = None,
) -> "Catalogue":
    """The catalogue that the options name. Its warnings go to standard error; errors raise InputRefused.

    `for_export`: an error with which vss-tools exports a tree does not refuse it. `for_units`: only an error of a units
    file does. `below`: an overlay that is left out, with those after it.
    """
    from sigcat.catalogue.exporting.stopping import stops_export
    from sigcat.catalogue.hosting.source import load
    from sigcat.project.chosen_tree import chosen_tree

    project = project_of(arguments)
    source = chosen_tree(project, tree_options(arguments))
    if below is not None:
        source = source._replace(overlays=_around(source.overlays, below)[0])
    is_of_project = source.vehicle is not None or source.id in (each.id for each in project.catalogues)
    catalogue = load(source if is_of_project else source._replace(id=source.spec.stem), expanded=expanded)
    refuse_overwriting(arguments, (*project.files, *(file.name for file in catalogue.files)))
    findings = catalogue.vocabulary.findings if for_units else catalogue.findings
    refused = any(map(stops_export, findings)) if for_export else has_errors(findings)
    if refused:
        raise InputRefused("the tree has errors; nothing was done", findings)
    if is_of_project and not catalogue.has_signals and below is None:
        raise UsageError(without_signals(source.spec))
    print_findings(findings)
    return catalogue


def place_of(arguments: argparse.Namespace, overlay: Path) -> "OverlayPlace":
    """The place of an overlay in the catalogue that the options name: on top, unless the catalogue has it."""
    from sigcat.catalogue.comparing.trial import OverlayPlace
    from sigcat.catalogue.reading.layers import read_layer
    from sigcat.project.chosen_tree import chosen_tree

    base = read_tree(arguments, below=overlay)
    source = chosen_tree(project_of(arguments), tree_options(arguments))
    later = _around(source.overlays, overlay)[1]
    return OverlayPlace(base, tuple(read_layer(each, source.include_dirs, is_overlay=True) for each in later))


def _around(overlays: "Sequence[Path]", overlay: Path) -> "tuple[tuple[Path, ...], tuple[Path, ...]]":
    """The overlays before and after one; all are before one that is not among them."""
    places = [number for number, each in enumerate(overlays) if real_path(each) == real_path(overlay)]
    first = places[0] if places else len(overlays)
    return tuple(overlays[:first]), tuple(overlays[first + 1 :])


def tree_options(arguments: argparse.Namespace) -> "TreeOptions":
    """The tree and the files that the options name. Raises UsageError where a file does not exist."""
    from sigcat.project.chosen_tree import TreeOptions

    for path in (*arguments.overlays, *arguments.units, *arguments.quantities, *arguments.types):
        existing_file(path)
    tree = getattr(arguments, "vspec", None)
    return TreeOptions(
        None if tree is None else str(tree),
        tuple(arguments.overlays),
        tuple(arguments.include_dirs),
        tuple(arguments.units),
        tuple(arguments.quantities),
        tuple(arguments.types),
    )
