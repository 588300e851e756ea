"""`sigcat check FILE...`: published functions that a change breaks, before anything is published."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from sigcat.cli.function_options import tree_for_functions
from sigcat.cli.published_files import published_files, read_catalogue, with_overlays
from sigcat.cli.registry_options import (
    add_report,
    add_server,
    posted_files,
    print_report,
    read_registry,
    server_catalogue,
    server_of,
)
from sigcat.cli.tree_options import add_tree_options, place_of
from sigcat.findings import has_errors, in_order

if TYPE_CHECKING:
    from collections.abc import Iterator

    from sigcat.catalogue.model.catalogue import Catalogue
    from sigcat.findings import Finding
    from sigcat.registry.storing.database import Snapshot


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "check",
        help="show which published functions a change breaks",
        description=(
            "Compare files with what published functions rely on, in the vehicle lines in which they run. Nothing is "
            "published."
        ),
        epilog="Exit status: 1 if a published function breaks.",
    )
    parser.add_argument(
        "files", type=Path, nargs="+", metavar="FILE", help="function, overlay, or root .vspec file of a catalogue"
    )
    add_report(parser)
    add_server(parser)
    add_tree_options(parser)
    parser.set_defaults(run=check)


def check(arguments: argparse.Namespace) -> int:
    """Report what breaks; 1 if anything does."""
    server = server_of(arguments)
    if server is not None:
        findings = server.check(posted_files(arguments), server_catalogue(arguments))
    else:
        with read_registry(arguments) as connection:
            findings = tuple(in_order(_findings(arguments, connection)))
    print_report(findings, arguments.format, arguments.output)
    return int(has_errors(findings))


def _findings(arguments: argparse.Namespace, connection: "Snapshot") -> "Iterator[Finding]":
    from sigcat.registry.candidates.candidates import read_functions
    from sigcat.registry.compatibility.breaking import broken_by_catalogue, broken_by_functions
    from sigcat.registry.compatibility.member import file_member

    files = published_files(arguments.files)
    if files.functions:
        named = [(file.read_bytes(), str(file)) for file in files.functions]
        tree = tree_for_functions(with_overlays(arguments, files.overlays), named)
        members = [file_member(each) for each in read_functions(named, tree)]
        yield from (conflict.finding for conflict in broken_by_functions(connection, members))
    for number, file in enumerate(files.overlays):
        tree = _with_overlay(with_overlays(arguments, files.overlays[:number]), file)
        yield from broken_by_catalogue(connection, tree, str(file))
    for file in files.trees:
        yield from broken_by_catalogue(connection, read_catalogue(arguments, file)[1], str(file))


def _with_overlay(arguments: argparse.Namespace, file: Path) -> "Catalogue":
    """The catalogue with an overlay in its present form. Raises InputRefused if it brings errors."""
    from sigcat.catalogue.reading.layers import read_layer
    from sigcat.registry.candidates.candidates import overlay_trial

    layer = read_layer(file, arguments.include_dirs, is_overlay=True)
    return overlay_trial(layer, place_of(arguments, file)).catalogue
