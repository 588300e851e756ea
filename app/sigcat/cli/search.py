"""`sigcat search WORD...`: nodes by words of their names, descriptions and units, the best first."""

import argparse
import sys
from typing import TYPE_CHECKING

from sigcat.cli.tree_options import add_tree_options, read_tree

if TYPE_CHECKING:
    from sigcat.catalogue.model.catalogue import Node
    from sigcat.catalogue.search import SearchResult


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "search",
        help="find nodes by words of their names, descriptions and units",
        description="Find nodes in which every word begins a word of the path, the description or the unit.",
        epilog="Exit status: 1 if there are none.",
    )
    parser.add_argument("words", nargs="+", metavar="WORD", help="such as: wheel speed")
    parser.add_argument("--type", help="only nodes of this type, such as sensor")
    parser.add_argument("--limit", type=int, default=50, metavar="N", help="at most so many (default: %(default)s)")
    parser.add_argument("--format", choices=("text", "json"), default="text", help="default: %(default)s")
    add_tree_options(parser)
    parser.set_defaults(run=search)


def search(arguments: argparse.Namespace) -> int:
    """Print the nodes; what the words may have meant, and how many there are, goes to standard error."""
    from sigcat.catalogue.search import SearchIndex
    from sigcat.catalogue.search_filters import checked_filters

    catalogue = read_tree(arguments)
    index = SearchIndex(catalogue)
    filters = checked_filters({"type": arguments.type}, catalogue, index)
    result = index.search(" ".join(arguments.words), filters, limit=max(arguments.limit, 0))
    if arguments.format == "json":
        print(_json(result.nodes))
    else:
        for node in result.nodes:
            print(_line(node))
    _say(result)
    return int(not result.total)


def _line(node: "Node") -> str:
    facts = (node.type, node.values.get("datatype"), node.values.get("unit"))
    return f"{node.path}  {' '.join(str(fact) for fact in facts if fact)}"


def _json(nodes: "tuple[Node, ...]") -> str:
    import json

    from sigcat.api.answers.serializers import node_summary

    return json.dumps([node_summary(node).model_dump(mode="json") for node in nodes], indent=2, ensure_ascii=False)


def _say(result: "SearchResult") -> None:
    if not result.total:
        meant = [repr(text) for text in result.instead or result.did_you_mean]
        near = f" Did you mean {' or '.join(meant)}?" if meant else ""
        print(f"sigcat: no node has all of these words.{near}", file=sys.stderr)
    elif result.total > len(result.nodes):
        print(f"sigcat: {len(result.nodes):,} of {result.total:,} nodes; --limit shows more", file=sys.stderr)
