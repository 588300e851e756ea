"""`sigcat show PATH`: a node with every attribute and where it was written."""

import argparse
from collections.abc import Sequence
from typing import TYPE_CHECKING

from sigcat.cli.tree_options import add_tree_options, read_tree
from sigcat.terminal_text import printable

if TYPE_CHECKING:
    from sigcat.catalogue.model.catalogue import Node


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "show",
        help="show a node: every attribute, and where it was written",
        description="Show a node with every attribute, its origin, and the nodes below it. Of a branch with instances, "
        "the path without their names shows the definition and its instances.",
    )
    parser.add_argument("path", metavar="PATH", help="such as Vehicle.Speed")
    parser.add_argument("--format", choices=("text", "json"), default="text", help="default: %(default)s")
    add_tree_options(parser)
    parser.set_defaults(run=show)


def show(arguments: argparse.Namespace) -> int:
    """Print one node; as JSON it is that of the API. Raises NotFound with paths that may have been meant."""
    from sigcat.catalogue.find_node import find_node

    node, catalogue, instances = find_node(arguments.path, read_tree(arguments))
    if arguments.format == "json":
        from sigcat.api.answers.serializers import node_detail

        print(node_detail(catalogue, node).model_dump_json(indent=2))
    else:
        _print_text(node, instances)
    return 0


def _written(value: object) -> object:
    return "(empty)" if value is None else value


def _print_text(node: "Node", instances: "Sequence[Node]" = ()) -> None:
    print(printable(node.path))
    for name, value in node.values.items():
        for position, (written, origin) in enumerate(reversed(node.definition.history(name))):
            by = f" ({origin.overlay})" if origin.overlay not in ("", origin.file) else ""
            shown = _written(value) if position == 0 else f"was {_written(written)}"
            print(printable(f"  {name if position == 0 else '':14} {shown}  [{origin.file}:{origin.line}{by}]"))
    if node.template != node.path:
        print(printable(f"  {'instance of':14} {node.template}"))
    for position, instance in enumerate(instances):
        print(printable(f"  {'' if position else f'{len(instances)} instances':14} {instance.path}"))
    for child in node.children:
        print(printable(f"  {child.name + ('.' if child.children else ''):28} {child.type}"))
