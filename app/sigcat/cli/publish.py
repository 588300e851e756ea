"""`sigcat publish FILE...`: functions, overlays and catalogues as versions in the registry."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from sigcat.cli.function_options import tree_for_functions
from sigcat.cli.published_files import PublishedFiles, published_files, read_catalogue, with_overlays
from sigcat.cli.registry_approvals import print_decisions
from sigcat.cli.registry_options import (
    add_server,
    posted_files,
    print_head,
    registry_of,
    server_catalogue,
    server_of,
)
from sigcat.cli.tree_options import add_tree_options, place_of
from sigcat.errors import UsageError

if TYPE_CHECKING:
    from collections.abc import Iterator

    from sigcat.registry.access.access import Change
    from sigcat.registry.candidates.candidate import Candidate
    from sigcat.registry.publish import Receipt


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "publish",
        help="publish functions, overlays and catalogues in the registry",
        description=(
            "Publish files as versions in the registry of the project: all of them, or none. A published version never "
            "changes: the same bytes again change nothing, and other bytes are refused."
        ),
        epilog="Exit status: 1 if a version is pending, because owners of functions that it breaks must approve it.",
    )
    parser.add_argument(
        "files", type=Path, nargs="+", metavar="FILE", help="function, overlay, or root .vspec file of a catalogue"
    )
    parser.add_argument(
        "--version", metavar="V", default="", help="version of SemVer 2.0 (default: that of the function file)"
    )
    parser.add_argument("--owner", metavar="TEAM", help="owner of an overlay or a catalogue")
    parser.add_argument("--draft", action="store_true", help="publish a draft, which may change")
    add_server(parser)
    add_tree_options(parser)
    parser.set_defaults(run=publish)


def publish(arguments: argparse.Namespace) -> int:
    """Publish the files, and print each version. Raises InputRefused with every reason."""
    receipt, change = _published(arguments)
    for outcome in receipt.outcomes:
        print(outcome.sentence)
        print_decisions(outcome.approvals)
    print_head(change)
    return int(any(outcome.status == "pending" for outcome in receipt.outcomes))


def _published(arguments: argparse.Namespace) -> "tuple[Receipt, Change]":
    """Publish with the service or the database, and return what became of the files."""
    if arguments.owner is not None and not arguments.owner.strip():
        raise UsageError("--owner must be the name of a team; without it, the version has no owner")
    files = published_files(arguments.files)
    if (files.overlays or files.trees) and not arguments.version:
        raise UsageError("an overlay or a catalogue has no version: pass `--version V`")
    server = server_of(arguments)
    if server is not None:
        return server.publish(
            posted_files(arguments), arguments.version, arguments.owner or "",
            is_draft=arguments.draft, catalogue=server_catalogue(arguments),
        )  # fmt: skip
    registry = registry_of(arguments)
    from sigcat.registry.access.access import Change
    from sigcat.registry.publish import publish as publish_candidates

    receipt = publish_candidates(registry, tuple(_candidates(arguments, files)), is_draft=arguments.draft)
    return receipt, Change(receipt.head, is_signed=registry.key is not None)


def _candidates(arguments: argparse.Namespace, files: PublishedFiles) -> "Iterator[Candidate]":
    from sigcat.catalogue.reading.layers import read_layer
    from sigcat.registry.candidates.candidates import (
        catalogue_candidate,
        function_candidates,
        overlay_candidate,
        read_functions,
    )
    from sigcat.registry.candidates.catalogue_files import content_of_files, files_of

    if files.functions:
        named = [(file.read_bytes(), str(file)) for file in files.functions]
        tree = tree_for_functions(with_overlays(arguments, files.overlays), named)
        yield from function_candidates(read_functions(named, tree), arguments.version)
    for number, file in enumerate(files.overlays):
        place = place_of(with_overlays(arguments, files.overlays[:number]), file)
        layer = read_layer(file, arguments.include_dirs, is_overlay=True)
        yield overlay_candidate(layer, file.read_bytes(), place, arguments.version, arguments.owner or "")
    for file in files.trees:
        _, catalogue = read_catalogue(arguments, file)
        content = content_of_files(files_of(catalogue))
        yield catalogue_candidate(catalogue, content, arguments.version, arguments.owner or "")
