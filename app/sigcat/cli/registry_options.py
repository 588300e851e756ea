"""The registry of the project that a command is in, and how its answers are printed."""

import argparse
import os
import re
import sys
from contextlib import contextmanager
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, TypeAlias

from sigcat.cli.output import write_text
from sigcat.cli.output_options import FORMATS, add_output
from sigcat.cli.project_options import add_project_options, project_of
from sigcat.cli.published_files import published_files, read_catalogue
from sigcat.errors import UsageError
from sigcat.limits import REGISTRY_ROWS
from sigcat.project.project import ServerUrl
from sigcat.terminal_text import printable

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

    from sigcat.findings import Finding
    from sigcat.project.project import Project, RegistrySettings
    from sigcat.registry.access.access import Access, Change
    from sigcat.registry.access.remote import Server
    from sigcat.registry.storing.database import Snapshot
    from sigcat.registry.storing.ledger import Registry

Actions: TypeAlias = "argparse._SubParsersAction[argparse.ArgumentParser]"  # noqa: SLF001 — argparse has no public name
KINDS = ("function", "overlay", "catalogue")
_HOW_TO = 'the project has no registry: add a table [registry] with `database = "registry.db"` to sigcat.toml'
_NOT_OVER_HTTP = "this command runs where the database of the registry is, and [registry] names a server"


def registry_of(arguments: argparse.Namespace) -> "Registry":
    """Return the registry of the project. Raises UsageError if it has none, or if the extra is missing."""
    project = project_of(arguments)
    settings = project.registry
    if settings is None:
        raise UsageError(_NOT_OVER_HTTP if project.registry_server else _HOW_TO)
    _load_packages(settings)
    from sigcat.registry.storing.ledger import Registry

    return Registry(settings.database, settings.key)


def add_server(parser: argparse.ArgumentParser) -> None:
    """Add --server."""
    parser.add_argument(
        "--server",
        metavar="URL",
        help="service with the registry; its token is in SIGCAT_TOKEN (default: that of the project)",
    )


def server_of(arguments: argparse.Namespace) -> "Server | None":
    """Return the service that has the registry; None if it is a database. Raises UsageError for an address that is not one."""
    address = project_of(arguments).registry_server if arguments.server is None else arguments.server
    if not address:
        return None
    from sigcat.project.read_project import SERVER

    if not re.fullmatch(SERVER, address):
        raise UsageError(f"--server must be an address such as https://signals.example, not {address[:80]!r}")
    with needing_extra():
        from sigcat.registry.access.remote import Server
    token = os.environ.get("SIGCAT_TOKEN", "").strip()
    if not (token.isascii() and token.isprintable()):
        raise UsageError("the token in SIGCAT_TOKEN must be printable ASCII; its value is not shown")
    return Server(address, token)


def server_catalogue(arguments: argparse.Namespace) -> str:
    """Return the hosted catalogue that the options name. Raises UsageError for files: the service reads none of them."""
    if arguments.overlays or arguments.units or arguments.quantities or arguments.types or arguments.include_dirs:
        raise UsageError(
            "a service checks files over a catalogue that it hosts: name one with `-s ID`, and pass no files of it"
        )
    return "" if arguments.vspec is None else str(arguments.vspec)


def posted_files(arguments: argparse.Namespace) -> "tuple[tuple[bytes, str], ...]":
    """Return content and name of each file; a tree is sent with all files of its catalogue. Raises UsageError."""
    files = published_files(arguments.files)
    named = tuple((file.read_bytes(), str(file)) for file in (*files.functions, *files.overlays))
    return (*named, *(_sent(arguments, file) for file in files.trees))


def _sent(arguments: argparse.Namespace, tree: Path) -> tuple[bytes, str]:
    """The document of a catalogue, and its name."""
    from sigcat.registry.candidates.catalogue_files import ENDING, document_of

    source, catalogue = read_catalogue(arguments, tree)
    return document_of(source, catalogue), f"{tree}{ENDING}"


def hosted_registry(project: "Project") -> "RegistrySettings | None":
    """Return the registry of a project that is served; None if it has none.

    A missing extra or key is reported, and the rest is served.
    """
    settings = project.registry
    try:
        if settings is not None:
            _load_packages(settings)
        if settings is not None and settings.key is not None:
            from sigcat.registry.storing.signing import signature_of

            signature_of("", settings.key)  # better reported now than with the first change
        if settings is not None and isinstance(settings.database, Path) and not settings.database.exists():
            print(f"sigcat: {settings.database} does not exist: the registry is empty", file=sys.stderr)
    except UsageError as error:
        print(f"sigcat: the registry is not served: {error}", file=sys.stderr)
        return None
    return settings


def _load_packages(settings: "RegistrySettings") -> None:
    """Import what a registry needs. Raises UsageError if its extra is missing."""
    with needing_extra():
        import_module("sigcat.registry.storing.ledger")
        if isinstance(settings.database, ServerUrl):
            import_module("psycopg")
        if settings.key is not None:
            import_module("sigcat.registry.storing.signing")


@contextmanager
def needing_extra() -> "Iterator[None]":
    """Report packages that are missing in the block. Raises UsageError."""
    try:
        yield
    except ModuleNotFoundError as error:
        if (error.name or "").partition(".")[0] not in ("sqlalchemy", "alembic", "cryptography", "psycopg"):
            raise
        extra = "registry-postgresql" if error.name == "psycopg" else "registry"
        raise UsageError(f"a registry needs the extra `{extra}`: run `pip install 'sigcat[{extra}]'`") from None


@contextmanager
def read_registry(arguments: argparse.Namespace) -> "Iterator[Snapshot]":
    """One state of the registry, to read. Raises UsageError if nothing is in it."""
    registry = registry_of(arguments)
    from sigcat.registry.access.local import reading_published

    with reading_published(registry) as connection:
        yield connection


def access_of(arguments: argparse.Namespace) -> "Access":
    """Access to the registry, wherever it is. Raises UsageError if the project has none."""
    server = server_of(arguments)
    if server is not None:
        return server
    registry = registry_of(arguments)
    from sigcat.registry.access.local import Local

    return Local(registry)


def add_action(
    actions: Actions, name: str, text: str, run: "Callable[[argparse.Namespace], int]"
) -> argparse.ArgumentParser:
    """Add an action of `sigcat registry`, and return its parser."""
    parser = actions.add_parser(name, help=text, description=f"{text[:1].upper()}{text[1:]}.")
    add_project_options(parser)
    parser.set_defaults(run=run)
    return parser


def add_version(parser: argparse.ArgumentParser) -> None:
    """Add the argument that names a version."""
    parser.add_argument("version", metavar="NAME@V", help="published version")
    parser.add_argument("--kind", choices=KINDS, default="function", help="default: %(default)s")


def done(text: str, change: "Change") -> int:
    """Print what was changed."""
    print(printable(text))
    print_head(change)
    return 0


def add_report(parser: argparse.ArgumentParser) -> None:
    """Add --format and --output of a report of findings."""
    parser.add_argument("--format", choices=FORMATS, default="text", help="form of the report (default: %(default)s)")
    add_output(parser, "-o", "--output", metavar="FILE", help="write the report here")


def print_head(change: "Change") -> None:
    """Print the hash of the last entry, if the log is signed: whoever keeps it can prove later that none is missing."""
    if change.is_signed:
        print(f"head of the log: {change.head}", file=sys.stderr)


def print_more(count: int) -> None:
    """Say how many of so many rows are not shown."""
    if count > REGISTRY_ROWS:
        print(f"{count - REGISTRY_ROWS} more are not shown", file=sys.stderr)


def print_report(findings: "Sequence[Finding]", form: str, output: "Path | None" = None) -> None:
    """Print findings as `sigcat lint` does."""
    from sigcat.data import INTERFACE_RULES
    from sigcat.rules.compiled import compiled_rules
    from sigcat.rules.report import report, sources_of

    kept = findings[:REGISTRY_ROWS]
    rules = tuple(compiled_rules(INTERFACE_RULES)) if form == "sarif" else ()
    print_more(len(findings))
    write_text(report(kept, form, sources_of(kept), rules), output)
