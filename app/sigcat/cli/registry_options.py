"""The registry of the project that a command is in, and how its answers are printed."""

import argparse
import sys
from contextlib import contextmanager
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, TypeAlias

from sigcat.cli.output import write_text
from sigcat.cli.output_options import FORMATS, add_output
from sigcat.cli.project_options import add_project_options, project_of
from sigcat.errors import UsageError
from sigcat.limits import REGISTRY_ROWS
from sigcat.project.project import ServerUrl
from sigcat.terminal_text import printable

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

    from sigcat.findings import Finding
    from sigcat.project.project import Project, RegistrySettings
    from sigcat.registry.storing.database import Snapshot
    from sigcat.registry.storing.ledger import Registry

Actions: TypeAlias = "argparse._SubParsersAction[argparse.ArgumentParser]"  # noqa: SLF001 — argparse has no public name
KINDS = ("function", "overlay", "catalogue")
_HOW_TO = 'the project has no registry: add a table [registry] with `database = "registry.db"` to sigcat.toml'


def registry_of(arguments: argparse.Namespace) -> "Registry":
    """Return the registry of the project. Raises UsageError if it has none, or if the extra is missing."""
    settings = project_of(arguments).registry
    if settings is None:
        raise UsageError(_HOW_TO)
    _load_packages(settings)
    from sigcat.registry.storing.ledger import Registry

    return Registry(settings.database, settings.key)


def hosted_registry(project: "Project") -> "RegistrySettings | None":
    """Return the registry of a project that is served; None if it has none. A missing extra is reported, and the rest served."""
    settings = project.registry
    try:
        if settings is not None:
            _load_packages(settings)
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
    """One state of the registry, to read. Raises UsageError if nothing is in it: then no answer would mean anything."""
    registry = registry_of(arguments)
    from sigcat.registry.storing.database import reading
    from sigcat.registry.storing.ledger import head

    with reading(registry.database) as connection:
        if head(connection) is None:
            raise UsageError(
                f"nothing is published in {registry.database}: run `sigcat publish` or `sigcat registry import`"
            )
        yield connection


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


def done(registry: "Registry", text: str, head: str) -> int:
    """Print what was changed."""
    print(printable(text))
    print_head(registry, head)
    return 0


def add_report(parser: argparse.ArgumentParser) -> None:
    """Add --format and --output of a report of findings."""
    parser.add_argument("--format", choices=FORMATS, default="text", help="form of the report (default: %(default)s)")
    add_output(parser, "-o", "--output", metavar="FILE", help="write the report here")


def print_head(registry: "Registry", head: str) -> None:
    """Print the hash of the last entry, if the log is signed: whoever keeps it can prove later that none is missing."""
    if registry.key is not None:
        print(f"head of the log: {head}", file=sys.stderr)


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
