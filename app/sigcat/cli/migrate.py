"""`sigcat migrate OLD NEW [PATH...]`: rewrite a project for another release."""

import argparse
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from sigcat.cli.compared_sides import SIDES, add_options_of_sides, changes_between, read_compared
from sigcat.cli.output import print_findings, write_text
from sigcat.cli.output_options import add_output, refuse_overwriting
from sigcat.cli.project_options import project_of
from sigcat.errors import UsageError

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from sigcat.catalogue.comparing.sides import Side
    from sigcat.migration.changed_text import Migrated

_EPILOG = f"""{SIDES}
Certain changes are made; what a person must decide is a finding. Exit status: 0 if nothing is left to decide; 1 if
something is, or with --check if a file would change.
"""


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "migrate",
        help="rewrite overlays, functions and traces for another release",
        description="Rewrite the files of a project for another tree: moved paths, units with their numbers, datatypes, "
        "labels of instances and names of releases. Everything else keeps its bytes.",
        epilog=_EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("old", metavar="OLD", help="side that the files are written for")
    parser.add_argument("new", metavar="NEW", help="side to rewrite them for")
    parser.add_argument(
        "paths", nargs="*", type=Path, metavar="PATH", help="files and folders (default: the folder of the project)"
    )
    form = parser.add_mutually_exclusive_group()
    form.add_argument("--dry-run", action="store_true", help="show the changes as a diff, and write nothing")
    form.add_argument("--check", action="store_true", help="write nothing, and exit with 1 if a file would change")
    parser.add_argument("--accept-guesses", action="store_true", help="apply moves that are only probable")
    parser.add_argument(
        "--choose", action="append", default=[], metavar="OLD=NEW", help="new path of a node; may be repeated"
    )
    parser.add_argument(
        "--table", action="append", default=[], type=Path, metavar="FILE",
        help="table of moves instead of the shipped ones; several are applied in order",
    )  # fmt: skip
    add_output(parser, "--report", metavar="FILE", help="write what changed as Markdown")
    add_output(parser, "--write-table", metavar="FILE", help="write the moves between both sides as a table, and stop")
    add_options_of_sides(parser)
    parser.set_defaults(run=migrate)


def migrate(arguments: argparse.Namespace) -> int:
    """Migrate files; 1 if something is left to decide, or would change with --check."""
    from sigcat.migration.migrate import Options, migratable, migrated_files
    from sigcat.migration.report import markdown, summary

    sides = read_compared(arguments, arguments.old, arguments.new)
    project = project_of(arguments)
    named = next((path if path.is_dir() else path.parent for path in arguments.paths), Path())
    folder = project.file.parent if project.file is not None else named
    refuse_overwriting(arguments, migratable(arguments.paths or [folder]))
    if arguments.write_table is not None:
        return _write_table(sides, arguments.write_table)
    options = Options(tuple(arguments.table), _choices(arguments.choose), arguments.accept_guesses)
    files, records = migrated_files(arguments.paths or [folder], folder, sides, options)
    if arguments.report is not None:
        write_text(markdown(files, sides[0].title, sides[1].title), arguments.report)
    if arguments.dry_run:
        sys.stdout.write("".join(file.diff for file in files))
    elif not arguments.check:
        _write(files, records)
    print_findings(tuple(finding for file in files for finding in file.findings))
    print(summary(files), file=sys.stderr)
    is_left = any(finding.severity != "info" for file in files for finding in file.findings)
    return int(is_left or (arguments.check and any(file.is_changed for file in files)))


def _write(files: "Sequence[Migrated]", records: "Mapping[Path, bytes]") -> None:
    from sigcat.migration.writing import write_all

    write_all({Path(file.file): file.after for file in files if file.is_changed} | dict(records))


def _choices(texts: "Sequence[str]") -> "Mapping[str, str]":
    """Return the chosen paths. Raises UsageError for a text that is not two paths."""
    choices = {}
    for text in texts:
        old, sign, new = text.partition("=")
        if not (old and sign and new):
            raise UsageError(f"--choose {text}: write the old and the new path, as in --choose Vehicle.A=Vehicle.B")
        choices[old] = new
    return choices


def _write_table(sides: "tuple[Side, Side]", output: Path) -> int:
    from sigcat.migration.migration import table_of
    from sigcat.migration.table import release_of, table_text

    names = [release_of(side.catalogue) or side.title for side in sides]
    write_text(table_text(table_of(changes_between(*sides), *names)), output)
    return 0
