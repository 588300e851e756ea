"""`sigcat config`: the settings of the service as they would be used, and new tokens."""

import argparse
import os
from typing import TYPE_CHECKING

from sigcat.cli.catalogue_options import add_catalogue_options, hosted_sources, served_project
from sigcat.cli.tree_options import add_tree_options, tree_options
from sigcat.terminal_text import printable

if TYPE_CHECKING:
    from sigcat.api.settings import Settings
    from sigcat.project.project import Project


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
    parser.add_argument(
        "--show", action="store_true", help="print the project, its catalogues, and where each value comes from"
    )
    add_catalogue_options(parser)
    add_tree_options(parser)
    parser.set_defaults(run=config)


def config(arguments: argparse.Namespace) -> int:
    """Print what was asked for."""
    if arguments.new_token is not None:
        return _new_token(arguments.new_token, arguments.scope or ["read"])
    if arguments.show:
        _show(arguments)
        return 0
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


def _show(arguments: argparse.Namespace) -> None:
    """Print the project and the settings of the service, each value with its origin."""
    from sigcat.api.read_settings import shown
    from sigcat.cli.shown_project import Shown, shown_project

    project, settings = served_project(arguments)
    lines = [Shown("project", str(project.file or "none"), _found(arguments, project))]
    lines += shown_project(project, tree_options(arguments))
    lines += [Shown(f"service.{name}", value, _origin(name, settings, project)) for name, value, _ in shown(settings)]
    width = min(60, max(len(f"{line.name} = {line.value}") for line in lines))
    for line in lines:
        text = f"{line.name} = {line.value}"
        print(printable(f"{text:{width}}  # {line.origin}" if line.origin else text))


def _found(arguments: argparse.Namespace, project: "Project") -> str:
    """Return why this project is used."""
    if project.file is None:
        return "--isolated" if arguments.isolated else "no sigcat.toml in this folder or above it"
    if arguments.config is not None:
        return "--config"
    return "SIGCAT_CONFIG" if os.environ.get("SIGCAT_CONFIG") else "found upwards"


def _origin(name: str, settings: "Settings", project: "Project") -> str:
    """Return where a setting of the service comes from."""
    from sigcat.api.read_settings import PREFIX

    variable = f"{PREFIX}{name.upper()}"
    if name not in settings.model_fields_set:
        return "default"
    return variable if variable in os.environ else project.line("service", 0, name)


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
