"""`sigcat registry token`: tokens with which the service lets teams write."""

import argparse
import sys
from typing import TYPE_CHECKING, TypeAlias

from sigcat.cli.project_options import add_project_options
from sigcat.cli.registry_options import registry_of
from sigcat.errors import UsageError
from sigcat.names import did_you_mean
from sigcat.terminal_text import printable

if TYPE_CHECKING:
    from collections.abc import Callable

Actions: TypeAlias = "argparse._SubParsersAction[argparse.ArgumentParser]"  # noqa: SLF001 — argparse has no public name
_SCOPES = ("read", "publish", "approve", "administer")


def add_tokens(actions: Actions) -> None:
    """Add the action with its own actions."""
    parser = actions.add_parser("token", help="make, list and revoke tokens of the service")
    tokens = parser.add_subparsers(title="actions", metavar="ACTION")
    creating = _add(tokens, "create", "make a token, and print it once", create)
    creating.add_argument("name", metavar="NAME", help="name of the token, in the log too")
    creating.add_argument(
        "--scope", action="append", required=True, choices=_SCOPES, metavar="SCOPE",
        help=f"what it may do: {', '.join(_SCOPES)}; may be repeated",
    )  # fmt: skip
    creating.add_argument(
        "--owner", metavar="TEAM", help="publish, approve and record only what this team owns (default: everything)"
    )
    creating.add_argument(
        "--expires", metavar="DATE", default="", help="last day on which it is valid (default: no end)"
    )
    _add(tokens, "list", "list the tokens with their scopes, owners and last days", list_tokens)
    revoking = _add(tokens, "revoke", "refuse a token from now on", revoke)
    revoking.add_argument("name", metavar="NAME", help="name of the token")


def _add(actions: Actions, name: str, text: str, run: "Callable[[argparse.Namespace], int]") -> argparse.ArgumentParser:
    parser = actions.add_parser(name, help=text, description=f"{text[:1].upper()}{text[1:]}.")
    add_project_options(parser)
    parser.set_defaults(run=run)
    return parser


def create(arguments: argparse.Namespace) -> int:
    """Print a new token, of which the registry keeps the hash."""
    if arguments.owner is not None and not arguments.owner.strip():
        raise UsageError("--owner must be the name of a team; without it, the token is for everything")
    registry = registry_of(arguments)
    from sigcat.registry.owners import alike_problem, owners
    from sigcat.registry.reference import date_fault
    from sigcat.registry.storing.database import writing
    from sigcat.registry.storing.entry import is_past
    from sigcat.registry.storing.tokens import create_token

    if not date_fault(arguments.expires) and is_past(arguments.expires):
        raise UsageError(f"--expires must be today or later, not {arguments.expires}")
    with writing(registry.database) as connection:
        if arguments.owner and (problem := alike_problem(connection, arguments.owner)):
            raise UsageError(problem)
        known = owners(connection)
        secret = create_token(connection, arguments.name, arguments.scope, arguments.owner or "", arguments.expires)
    if arguments.owner and arguments.owner not in known and (near := did_you_mean(arguments.owner, known)):
        print(printable(f"warning: {arguments.owner} has published nothing. {near}"), file=sys.stderr)
    print(secret)
    return 0


def list_tokens(arguments: argparse.Namespace) -> int:
    """Print a line for each token."""
    registry = registry_of(arguments)
    from sigcat.registry.storing.database import reading
    from sigcat.registry.storing.tokens import all_tokens

    with reading(registry.database) as connection:
        tokens = all_tokens(connection)
    for each in tokens:
        owner = f", owner {each.owner}" if each.owner else ""
        expires = f", until {each.expires}" if each.expires else ""
        fault = f", {each.fault}" if each.fault else ""
        print(printable(f"{each.name}: {each.scopes.replace('+', ', ')}{owner}{expires}{fault}"))
    return 0


def revoke(arguments: argparse.Namespace) -> int:
    """Revoke a token."""
    registry = registry_of(arguments)
    from sigcat.registry.storing.database import writing
    from sigcat.registry.storing.tokens import revoke_token

    with writing(registry.database) as connection:
        revoke_token(connection, arguments.name)
    print(printable(f"token {arguments.name}: revoked"))
    return 0
