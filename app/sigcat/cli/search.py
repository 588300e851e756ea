"""`sigcat search WORD...`: nodes by words of their names, descriptions and units, the best first."""

import argparse
import sys
from typing import TYPE_CHECKING

from sigcat.cli.command_parser import positive
from sigcat.cli.tree_options import add_tree_options, read_tree
from sigcat.names import either
from sigcat.terminal_text import printable

if TYPE_CHECKING:
    from sigcat.catalogue.search import Hit, SearchResult


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "search",
        help="find nodes by words of their names, descriptions and units",
        description="Find nodes in which every word begins a word of the path, the description or the unit. A name that "
        "was generated from a path (C, C++, ROS 2, SOME/IP, AUTOSAR) and a static id find their node, too. Instances of one "
        "definition are one hit: the first of them, and how many there are.",
        epilog="Exit status: 1 if there are none.",
    )
    parser.add_argument("words", nargs="+", metavar="WORD", help="such as: wheel speed")
    parser.add_argument("--type", help="only nodes of this type, such as sensor")
    parser.add_argument("--instances", action="store_true", help="each instance by itself")
    parser.add_argument(
        "--limit", type=positive(int), default=50, metavar="N", help="at most so many (default: %(default)s)"
    )
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
    text, limit = " ".join(arguments.words), arguments.limit
    result = index.search(text, filters, limit=limit, each_instance=arguments.instances)
    if arguments.format == "json":
        print(_json(result.hits))
    else:
        for hit in result.hits:
            print(printable(_line(hit)))
    _say(result)
    return int(not result.total)


def _line(hit: "Hit") -> str:
    node = hit.node
    facts = (node.type, node.values.get("datatype"), node.values.get("unit"))
    instances = f"  ×{hit.instances}" if hit.instances > 1 else ""
    return f"{node.path}  {' '.join(str(fact) for fact in facts if fact)}{instances}"


def _json(hits: "tuple[Hit, ...]") -> str:
    import json

    from sigcat.api.answers.serializers import search_hit

    return json.dumps([search_hit(hit).model_dump(mode="json") for hit in hits], indent=2, ensure_ascii=False)


def _say(result: "SearchResult") -> None:
    if not result.total:
        meant = [repr(text) for text in result.instead or result.did_you_mean]
        near = f" Did you mean {either(meant)}?" if meant else ""
        what = "all of these words" if len(result.words) > 1 else "this word"
        print(f"sigcat: no node has {what}.{near}", file=sys.stderr)
    elif result.total > len(result.hits):
        print(f"sigcat: {len(result.hits):,} of {result.total:,} hits; --limit shows more", file=sys.stderr)
