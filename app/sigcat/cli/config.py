"""`sigcat config`: the settings of the service as they would be used, and new tokens."""

import argparse

from sigcat.cli.catalogue_options import add_catalogue_options, hosted_sources, served_project
from sigcat.cli.project_options import add_project_options


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "config",
        help="print the settings of the service, or make a token",
        description="Print the settings as `sigcat serve` would use them: [service] of sigcat.toml, and over it the "
        "environment, where body_bytes is SIGCAT_BODY_BYTES. Exit status: 2 if they cannot be used.",
    )
    parser.add_argument("--new-token", metavar="NAME", help="make a token, print it and what to put into `tokens`")
    parser.add_argument(
        "--scope", action="append", default=[], metavar="SCOPE",
        help="what the new token may do: read, reload; may be repeated (default: read)",
    )  # fmt: skip
    add_catalogue_options(parser)
    add_project_options(parser)
    parser.set_defaults(run=config)


def config(arguments: argparse.Namespace) -> int:
    """Print what was asked for."""
    if arguments.new_token is not None:
        return _new_token(arguments.new_token, arguments.scope or ["read"])
    from sigcat.api.read_settings import shown

    project, settings = served_project(arguments)
    print("[service]")
    for name, value, description in shown(settings):
        print(f"# {description}\n{name} = {value}")
    for source in hosted_sources(arguments, project):
        print(f"\n# catalogue {source.id}: {source.spec}")
    for folder in project.functions:
        print(f"\n# functions: {folder}")
    return 0


def _new_token(name: str, scopes: list[str]) -> int:
    from sigcat.api.tokens import new_token
    from sigcat.errors import UsageError

    try:
        secret, token = new_token(name, scopes)
    except ValueError as error:
        raise UsageError(str(error)) from None
    print(f"# give this to the client; it is shown once\n{secret}\n\n# put this into [service] of sigcat.toml")
    print(f'tokens = ["{token}"]')
    return 0
