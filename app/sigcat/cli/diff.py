"""`sigcat diff OLD NEW`: what changed between two trees, and whom it breaks."""

import argparse
import os
import sys
from typing import TYPE_CHECKING

from sigcat.cli.output import write_bytes
from sigcat.cli.output_options import add_output, refuse_overwriting
from sigcat.cli.project_options import add_project_options, project_of
from sigcat.cli.tree_options import add_many, add_vocabulary_options, tree_options

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from sigcat.catalogue.comparing.changes import Change
    from sigcat.catalogue.comparing.sides import Side
    from sigcat.project.project import Project

_CLASSES = (
    "breaking",
    "risky",
    "compatible",
    "text",
)  # sigcat.catalogue.comparing.changes has them; it is loaded when it is needed
_SIDES = """A side is
  a catalogue               of the project, by its id
  a folder                  the tree in or below it
  a .vspec file             the tree of which it is the root
  a .json file              an exported tree
  git:REVISION[:PATH]       a revision of the repository around the current folder
  a name                    a release, pulled or shipped (`sigcat releases`)
each with its own overlays, if any: TREE+OVERLAY+OVERLAY.

The classes are explained in docs/reference/compatibility.md. Exit status: 0; 1 with --fail-on if there are such changes.
"""


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "diff",
        help="what changed between two trees, and whom it breaks",
        description="Compare two trees node by node. Each change is breaking, risky, compatible or text only.",
        epilog=_SIDES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("old", metavar="OLD", help="side that software was written against")
    parser.add_argument("new", metavar="NEW", help="side that it is to run with")
    parser.add_argument(
        "--format",
        choices=("text", "json", "markdown"),
        default="text",
        help="form of the report (default: %(default)s)",
    )
    parser.add_argument(
        "--fail-on", choices=_CLASSES, metavar="CLASS",
        help=f"exit with 1 if a change is as bad as this, or worse: {', '.join(_CLASSES)}",
    )  # fmt: skip
    parser.add_argument(
        "--only", choices=_CLASSES, action="append", default=[], metavar="CLASS",
        help="show changes of this class only; may be repeated",
    )  # fmt: skip
    add_output(parser, "-o", "--output", metavar="FILE", help="write here instead of to standard output")
    _add_options_of_both(parser)
    parser.set_defaults(run=diff)


def _add_options_of_both(parser: argparse.ArgumentParser) -> None:
    group = parser.add_argument_group("for both sides")
    add_many(group, "-l", "--overlays", "overlay, applied in the order given, after those of the side")
    add_vocabulary_options(group)
    add_project_options(group)


def diff(arguments: argparse.Namespace) -> int:
    """Write the changes; 1 if `--fail-on` is met."""
    from sigcat.catalogue.comparing.changes import at_least
    from sigcat.catalogue.comparing.diff import compare

    project = project_of(arguments)
    old, new = _sides(arguments, project)
    refuse_overwriting(arguments, (*project.files, *_files(arguments.old, old), *_files(arguments.new, new)))
    changes = compare(old.catalogue, new.catalogue, old.unknown | new.unknown)
    shown = [change for change in changes if not arguments.only or change.compatibility in arguments.only]
    report = _report(shown, len(changes) - len(shown), old.title, new.title, arguments)
    write_bytes(report.encode("utf-8", "backslashreplace"), arguments.output)
    bound = arguments.fail_on
    return int(bound is not None and any(at_least(change.compatibility, bound) for change in changes))


def _sides(arguments: argparse.Namespace, project: "Project") -> "tuple[Side, Side]":
    from sigcat.catalogue.comparing.sides import Options, read_sides
    from sigcat.catalogue.hosting.sources import release_source

    given = tree_options(arguments)
    options = Options(
        given.overlays,
        (*project.include_dirs, *given.include_dirs),
        (*project.units, *given.units),
        (*project.quantities, *given.quantities),
        (*project.types, *given.types),
        {source.id: source for source in project.catalogues},
    )
    return read_sides(arguments.old, arguments.new, release_source, options)


def _files(name: str, side: "Side") -> "Iterator[str]":
    """The files that a side was read from."""
    from sigcat.catalogue.reading.joined_paths import split_paths

    yield from split_paths(name, "+")
    yield from (file.name for file in side.catalogue.files)


def _report(changes: "Sequence[Change]", hidden: int, old: str, new: str, arguments: argparse.Namespace) -> str:
    import json

    from sigcat.catalogue.comparing.diff_report import diff_data, markdown_report, text_report

    if arguments.format == "json":
        return json.dumps({"old": old, "new": new, **diff_data(changes)}, indent=2, ensure_ascii=False) + "\n"
    if arguments.format == "markdown":
        return markdown_report(changes, old, new, hidden)
    return text_report(changes, is_coloured=arguments.output is None and is_coloured(), hidden=hidden)


def is_coloured() -> bool:
    """Whether standard output is a terminal that may be coloured (https://no-color.org)."""
    return sys.stdout.isatty() and not os.environ.get("NO_COLOR") and os.environ.get("TERM") != "dumb"
