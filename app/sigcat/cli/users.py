"""`sigcat users PATH`."""

import argparse
from typing import TYPE_CHECKING

from sigcat.cli.registry_options import add_server, read_registry, server_catalogue, server_of
from sigcat.cli.tree_options import add_tree_options, read_tree
from sigcat.terminal_text import printable

if TYPE_CHECKING:
    from sigcat.registry.users import User, Users


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "users",
        help="list the published functions that use a signal, a type, an error or a mode",
        description=(
            "List the users of a path or of the nodes below it, and what follows from them: a signal sets an error, an "
            "error a safety reaction, also in other functions. The path of a definition has the users of its instances in the "
            "catalogue."
        ),
    )
    parser.add_argument("path", metavar="PATH", help="path of a node, or name of an interface")
    parser.add_argument(
        "--all", action="store_true", help="all versions (default: those in vehicle lines, and the newest ones)"
    )
    parser.add_argument("--format", choices=("text", "json"), default="text", help="default: %(default)s")
    add_server(parser)
    add_tree_options(parser)
    parser.set_defaults(run=users)


def users(arguments: argparse.Namespace) -> int:
    """Print the users. Without any, this is said on standard output, too."""
    found = _found(arguments)
    if arguments.format == "json":
        import json

        print(json.dumps(_data(found), indent=2, ensure_ascii=False))
        return 0
    for user in found.users:
        print(printable(_line(user)))
    if found.more:
        print(f"{found.more} more are not shown")
    if not found.users:
        print(printable(f"No published function uses {arguments.path}."))
    return 0


def _found(arguments: argparse.Namespace) -> "Users":
    """The answer of the service or of the database."""
    server = server_of(arguments)
    if server is not None:
        over = server_catalogue(arguments)
        return server.users_of(arguments.path, is_complete=arguments.all, catalogue=over)
    with read_registry(arguments) as connection:
        from sigcat.registry.users import users_in

        return users_in(connection, arguments.path, read_tree(arguments), is_complete=arguments.all)


def _line(user: "User") -> str:
    published, use = user.published, user.use
    parts = [
        f"{published.reference} {use.verb} {use.element}",
        f"call {use.call}" if use.call else "",
        f"C variable {use.variable}" if use.variable else "",
        f"through {' → '.join((*user.through, use.via) if use.via else user.through)}"
        if user.through or use.via
        else "",
        f"owner {published.owner}",
        f"in line {', '.join(user.lines)}" if user.lines else "in no line",
    ]
    return ", ".join(filter(None, parts))


def _data(found: "Users") -> dict[str, object]:
    return {
        "users": [
            {
                "function": user.published.name, "version": user.published.version, "owner": user.published.owner,
                "state": user.published.state, "lines": user.lines, "through": user.through, **user.use._asdict(), "values": dict(user.use.values),
            }
            for user in found.users
        ],
        "more": found.more,
    }  # fmt: skip
