"""`sigcat show PATH`: a node with every attribute and where it was written."""

import argparse
from collections.abc import Sequence
from typing import TYPE_CHECKING

from sigcat.cli.tree_options import add_tree_options, read_tree
from sigcat.errors import NotFound
from sigcat.names import nearest

if TYPE_CHECKING:
    from sigcat.catalogue.model.catalogue import Catalogue, Node


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "show",
        help="show a node: every attribute, and where it was written",
        description="Show a node with every attribute, where it was written, and what stands below it. Of a branch with instances, "
        "the path without their names shows the definition and its instances.",
    )
    parser.add_argument("path", metavar="PATH", help="such as Vehicle.Speed")
    parser.add_argument("--format", choices=("text", "json"), default="text", help="default: %(default)s")
    add_tree_options(parser)
    parser.set_defaults(run=show)


def show(arguments: argparse.Namespace) -> int:
    """Print one node; as JSON it is that of the API. Raises NotFound with paths that may have been meant."""
    from sigcat.catalogue.composing.compose import unexpanded

    catalogue = read_tree(arguments)
    path = arguments.path.replace("/", ".").strip(".")
    instances = _instances(path, catalogue)
    if instances:
        catalogue = unexpanded(catalogue)
    node = catalogue.get(path)
    if node is None:
        near = _meant(path, catalogue)
        hint = f" Did you mean {' or '.join(near)}?" if near else ""
        raise NotFound(f"there is no node {arguments.path!r}.{hint}", near)
    if arguments.format == "json":
        from sigcat.api.answers.serializers import node_detail

        print(node_detail(catalogue, node).model_dump_json(indent=2))
    else:
        _print_text(node, instances)
    return 0


def _instances(path: str, catalogue: "Catalogue") -> "tuple[Node, ...]":
    """The nodes that a definition stands for, where it is no node itself."""
    if path in catalogue.nodes or path not in catalogue.definitions:
        return ()
    return tuple(node for node in catalogue.nodes.values() if node.template == path)


def _meant(path: str, catalogue: "Catalogue") -> tuple[str, ...]:
    """The nearest paths, or else nodes that have the words."""
    from sigcat.catalogue.search import SearchIndex

    near = nearest(path, dict.fromkeys((*catalogue.nodes, *catalogue.definitions)))
    return near or tuple(node.path for node in SearchIndex(catalogue).search(path, limit=3).nodes if path.strip())


def _print_text(node: "Node", instances: "Sequence[Node]" = ()) -> None:
    print(node.path)
    for name, value in node.values.items():
        for position, (written, origin) in enumerate(reversed(node.definition.history(name))):
            by = f" ({origin.overlay})" if origin.overlay else ""
            shown = value if position == 0 else f"was {written}"
            print(f"  {name if position == 0 else '':14} {shown}  [{origin.file}:{origin.line}{by}]")
    if node.template != node.path:
        print(f"  {'instance of':14} {node.template}")
    for position, instance in enumerate(instances):
        print(f"  {'' if position else f'{len(instances)} instances':14} {instance.path}")
    for child in node.children:
        print(f"  {child.name + ('.' if child.children else ''):28} {child.type}")
