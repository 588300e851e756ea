"""`sigcat try OVERLAY`: what an overlay would make of a tree, before it becomes part of one."""

import argparse
from typing import TYPE_CHECKING, Any

from sigcat.cli.closed_streams import input_bytes
from sigcat.cli.diff import is_coloured
from sigcat.cli.tree_options import add_tree_options, place_of, read_tree
from sigcat.errors import UsageError, existing_file
from sigcat.file_kind import holds_function
from sigcat.findings import has_errors
from sigcat.terminal_text import printable

if TYPE_CHECKING:
    from sigcat.catalogue.comparing.trial import Trial
    from sigcat.catalogue.model.catalogue import Node


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "try",
        help="try an overlay: resulting nodes, findings and changes",
        description="Apply an overlay to a tree and show the result: findings, changes, nodes. Stores nothing. An overlay of the "
        "project is applied at its place, below the overlays after it.",
        epilog="Exit status: 1 if the overlay brings errors.",
    )
    parser.add_argument("overlay", metavar="OVERLAY", help="overlay file; - for standard input")
    parser.add_argument("--format", choices=("text", "json"), default="text", help="default: %(default)s")
    add_tree_options(parser)
    parser.set_defaults(run=try_overlay)


def try_overlay(arguments: argparse.Namespace) -> int:
    """Show what the overlay would do; 1 if it brings errors."""
    trial = _trial(arguments)
    if arguments.format == "json":
        import json

        print(json.dumps(_data(trial), indent=2, ensure_ascii=False))
    else:
        _print_text(trial)
    return int(has_errors(trial.findings))


def _trial(arguments: argparse.Namespace) -> "Trial":
    """Try the overlay over the tree; at its place, if it is one of the project's."""
    from sigcat.catalogue.comparing import trial
    from sigcat.catalogue.reading.layers import read_layer

    if arguments.overlay == "-":
        return trial.try_overlay(read_tree(arguments), input_bytes(), "standard input")
    path = existing_file(arguments.overlay)
    if holds_function(path.read_bytes()):
        raise UsageError(f"{path} is a function file, not an overlay: run `sigcat function validate` on it")
    layer = read_layer(path, arguments.include_dirs, is_overlay=True)
    return trial.try_layer(place_of(arguments, path), layer)


def _print_text(trial: "Trial") -> None:
    from sigcat.catalogue.comparing.diff_report import text_report

    for finding in trial.findings:
        print(finding.line_of_text)
    if trial.changes or not has_errors(trial.findings):  # what could not be read shows no differences
        print(text_report(trial.changes, is_coloured=is_coloured()), end="")
    for node in trial.nodes:
        print(f"\n{printable(node.path)}")
        for name, value in node.values.items():
            print(f"  {printable(name):14} {printable(str(value))}")


def _data(trial: "Trial") -> dict[str, Any]:
    from sigcat.catalogue.comparing.diff_report import diff_data

    return {
        "nodes": [_node_data(node) for node in trial.nodes],
        "findings": [finding._asdict() for finding in trial.findings],
        **diff_data(trial.changes),
    }


def _node_data(node: "Node") -> dict[str, Any]:
    from sigcat.catalogue.comparing.diff_report import plain

    return {"path": node.path, "values": plain(dict(node.values))}
