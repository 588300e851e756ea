"""`sigcat diff OLD NEW`: changes between two trees, each with its compatibility class."""

import argparse
import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from sigcat.cli.compared_sides import SIDES, add_sides, changes_between, names_of_sides, read_compared
from sigcat.cli.output import write_bytes
from sigcat.cli.output_options import add_output
from sigcat.names import did_you_mean

if TYPE_CHECKING:
    from collections.abc import Sequence

    from sigcat.catalogue.comparing.changes import Change
    from sigcat.catalogue.comparing.sides import Side

_CLASSES = (
    "breaking",
    "risky",
    "compatible",
    "text",
)  # sigcat.catalogue.comparing.changes has them; it is loaded when it is needed
_BINDINGS = ("path", "json", "protobuf", "ros2", "someip", "c", "graphql", "dds", "ids")  # likewise
_EPILOG = f"""{SIDES}
The classes are explained in docs/reference/compatibility.md. Exit status: 0; 1 with --fail-on if there are such changes.
"""
_FINDINGS = ("github", "gitlab")
"""Formats that build servers read: each change at its line."""


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "diff",
        help="compare two trees and classify breaking changes",
        description="Compare two trees node by node. Each change is breaking, risky, compatible or text only.",
        epilog=_EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    form = parser.add_mutually_exclusive_group()
    form.add_argument(
        "--format",
        choices=("text", "json", "markdown", *_FINDINGS),
        default="text",
        help="form of the report: markdown is a comment of at most 65,000 characters, github annotations, gitlab Code "
        "Quality (default: %(default)s)",
    )
    form.add_argument(
        "--changelog", action="store_true", help="write the entry of a changelog, in the form of keepachangelog.com"
    )
    parser.add_argument(
        "--fail-on", choices=_CLASSES, metavar="CLASS",
        help=f"exit with 1 if a change is as bad as this, or worse: {', '.join(_CLASSES)}",
    )  # fmt: skip
    parser.add_argument(
        "--only", choices=_CLASSES, action="append", default=[], metavar="CLASS",
        help="show changes of this class only; may be repeated",
    )  # fmt: skip
    parser.add_argument(
        "--binding", action="append", type=_bindings, default=[], metavar="NAME,...",
        help=f"classes for software that uses the tree in these forms: {', '.join(_BINDINGS)} (default: whatever the form)",
    )  # fmt: skip
    parser.add_argument(
        "--keep-numbers-of", type=Path, metavar="FILE",
        help="file of `sigcat export protobuf --keep-numbers-of`: the fields in it keep their numbers",
    )  # fmt: skip
    add_output(parser, "-o", "--output", metavar="FILE", help="write here instead of to standard output")
    add_sides(parser)
    parser.set_defaults(run=diff)


def diff(arguments: argparse.Namespace) -> int:
    """Write the changes; 1 if `--fail-on` is met."""
    from sigcat.catalogue.comparing.bindings import for_bindings
    from sigcat.catalogue.comparing.changes import at_least

    old, new = read_compared(arguments, *names_of_sides(arguments))
    bindings = [name for names in arguments.binding for name in names]
    changes = for_bindings(_changes(old, new, arguments.keep_numbers_of), bindings)
    shown = [change for change in changes if not arguments.only or change.compatibility in arguments.only]
    report = _report(shown, len(changes) - len(shown), old, new, arguments)
    write_bytes(report.encode("utf-8", "backslashreplace"), arguments.output)
    bound = arguments.fail_on
    return int(bound is not None and any(at_least(change.compatibility, bound) for change in changes))


def _changes(old: "Side", new: "Side", numbers: Path | None) -> "Sequence[Change]":
    """Compare the sides; `numbers` is the lock with which the old one was exported."""
    changes = changes_between(old, new)
    if numbers is None:
        return changes
    from sigcat.catalogue.comparing.kept_numbers import with_kept_numbers
    from sigcat.catalogue.exporting.field_numbers import read_lock

    return with_kept_numbers(changes, old.catalogue, read_lock(numbers))


def _bindings(text: str) -> list[str]:
    """Names of bindings between commas."""
    names = text.split(",")
    if wrong := [name for name in names if name not in _BINDINGS]:
        hint = did_you_mean(wrong[0], _BINDINGS) or f"choose from {', '.join(_BINDINGS)}"
        raise argparse.ArgumentTypeError(f"unknown binding {wrong[0]!r}: {hint}")
    return names


def _report(changes: "Sequence[Change]", hidden: int, old: "Side", new: "Side", arguments: argparse.Namespace) -> str:
    import json

    from sigcat.catalogue.comparing.diff_report import diff_data, markdown_comment, text_report

    if arguments.changelog:
        return _changelog(changes, new)
    if arguments.format == "json":
        return (
            json.dumps({"old": old.title, "new": new.title, **diff_data(changes)}, indent=2, ensure_ascii=False) + "\n"
        )
    if arguments.format == "markdown":
        return markdown_comment(changes, old.title, new.title, hidden)
    if arguments.format in _FINDINGS:
        return _findings_report(changes, old, new, arguments.format)
    return text_report(changes, is_coloured=arguments.output is None and is_coloured(), hidden=hidden)


def _changelog(changes: "Sequence[Change]", new: "Side") -> str:
    from sigcat.catalogue.comparing.changelog import changelog_entry
    from sigcat.catalogue.comparing.sides import GIT
    from sigcat.catalogue.reading.git_revision import commit_date

    revision = new.title.removeprefix(GIT).partition(":")[0]
    is_revision = new.title.startswith(GIT)
    return changelog_entry(changes, revision, commit_date(revision) if is_revision else "")


def _findings_report(changes: "Sequence[Change]", old: "Side", new: "Side", form: str) -> str:
    from sigcat.catalogue.comparing.change_findings import change_findings
    from sigcat.rules.report import report

    return report(change_findings(changes, old, new), form)


def is_coloured() -> bool:
    """Whether standard output is a terminal that may be coloured (https://no-color.org)."""
    return sys.stdout.isatty() and not os.environ.get("NO_COLOR") and os.environ.get("TERM") != "dumb"
