"""`sigcat show PATH`: a node with every attribute and where it was written."""

import argparse
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from sigcat.cli.tree_options import add_tree_options, read_tree
from sigcat.terminal_text import printable

if TYPE_CHECKING:
    from sigcat.catalogue.model.catalogue import Catalogue, Node
    from sigcat.migration.node_history import NodeHistory


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "show",
        help="show a node: every attribute, and where it was written",
        description="Show a node with every attribute, its origin, and the nodes below it. Of a branch with instances, "
        "the path without their names shows the definition and its instances.",
    )
    parser.add_argument("path", metavar="PATH", help="such as Vehicle.Speed")
    parser.add_argument(
        "--history", action="store_true",
        help="show what happened to the node in the pulled releases: where it was added, changed, moved and removed",
    )  # fmt: skip
    parser.add_argument("--format", choices=("text", "json"), default="text", help="default: %(default)s")
    add_tree_options(parser)
    parser.set_defaults(run=show)


def show(arguments: argparse.Namespace) -> int:
    """Print one node; as JSON it is that of the API. Raises NotFound with paths that may have been meant."""
    from sigcat.catalogue.find_node import find_node

    tree = read_tree(arguments)
    node, catalogue, instances = find_node(arguments.path, tree)
    if arguments.history:
        _show_history(node.path, instances, tree, arguments.format)
    elif arguments.format == "json":
        from sigcat.api.answers.serializers import node_detail

        print(node_detail(catalogue, node).model_dump_json(indent=2))
    else:
        _print_text(node, instances)
    return 0


def _written(value: object) -> object:
    return "(empty)" if value is None else value


def _show_history(path: str, instances: "Sequence[Node]", tree: "Catalogue", form: str) -> None:
    from sigcat.catalogue.hosting.source import load
    from sigcat.catalogue.hosting.sources import pulled_sources, shipped_sources
    from sigcat.migration.node_history import instance_of, node_history, official_releases

    sources = [source for source in (*pulled_sources(), *shipped_sources()) if not source.overlays]
    history = node_history(
        instance_of(path, instances), tree, official_releases((source, load(source)) for source in sources)
    )
    if form == "json":
        from sigcat.api.answers.serializers import history_schema

        print(history_schema(history).model_dump_json(indent=2))
    else:
        for line in _history_lines(history):
            print(printable(line))


def _history_lines(history: "NodeHistory") -> "Iterator[str]":
    from sigcat.migration.node_history import event_text

    yield history.path
    if not history.release:
        yield "  The tree does not say which release of VSS it is made of (Vehicle.VersionVSS): releases were not compared."
    for event in history.events:
        yield f"  {event_text(event, history)}"
        for change in event.attributes:
            yield f"    {change.name:14} {_said(change.old)} -> {_said(change.new)}  [{change.compatibility}]"
        if event.note:
            yield f"    {event.note}"
    if history.release and history.missing:
        missing = ", ".join(history.missing)
        yield f"  Not here: {missing}. `sigcat pull v{history.missing[-1]}` adds one."


def _said(value: object) -> str:
    return "none" if value is None else str(value)


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
