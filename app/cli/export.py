"""`sigcat export FORMAT`."""

import argparse
from pathlib import Path
from typing import Any

from app.cli.output import write_text
from app.cli.tree_options import add_tree_options, read_tree
from app.errors import UsageError


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the command with one sub-command for each format."""
    parser = commands.add_parser("export", help="write a tree in another format")
    formats = parser.add_subparsers(title="formats", metavar="FORMAT", required=True)
    json = formats.add_parser(
        "json",
        help="JSON, as data equal to `vspec export json`",
        description="Compose a tree with its overlays and write it as JSON, as data equal to `vspec export json`.",
    )
    add_tree_options(json)
    _add_json_options(json)
    json.set_defaults(run=export_json)


def _add_json_options(parser: argparse.ArgumentParser) -> None:
    flag = argparse.BooleanOptionalAction
    parser.add_argument("-o", "--output", type=Path, metavar="FILE", help="write here instead of to standard output")
    parser.add_argument(
        "--types-output", type=Path, metavar="FILE", help="write the struct types to a file of their own"
    )
    parser.add_argument(
        "-e", "--extended-attributes", action="append", default=[], metavar="NAME",
        help="extended attribute to keep at the root; may be repeated",
    )  # fmt: skip
    parser.add_argument("--extend-all-attributes", action=flag, default=False, help="keep all extended attributes")
    parser.add_argument("--expand", action=flag, default=True, help="expand instances (default: yes)")
    parser.add_argument("--pretty", action=flag, default=False, help="indent the output")


def export_json(arguments: argparse.Namespace) -> int:
    """Write the tree as JSON."""
    from app.catalogue.definition import CORE_ATTRIBUTES
    from app.catalogue.export_json import tree_data, tree_json

    for name in arguments.extended_attributes:
        if "," in name or name in CORE_ATTRIBUTES:
            raise UsageError(f"-e {name}: name one attribute that VSS does not define")
    catalogue = read_tree(arguments, expanded=arguments.expand)
    data = tree_data(catalogue, arguments.extended_attributes, all_extended=arguments.extend_all_attributes)
    if arguments.types_output is not None:
        types: dict[str, Any] = data.pop("ComplexDataTypes", {})
        write_text(tree_json(types, pretty=arguments.pretty), arguments.types_output)
    write_text(tree_json(data, pretty=arguments.pretty), arguments.output)
    return 0
