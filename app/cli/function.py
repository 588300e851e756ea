"""`sigcat function build` and `sigcat function validate`."""

import argparse
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from app.cli.output import write_text
from app.cli.tree_options import add_tree_options, read_tree
from app.findings import has_errors

if TYPE_CHECKING:
    from collections.abc import Sequence

    from app.findings import Finding


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the command with its sub-commands."""
    parser = commands.add_parser("function", help="build and check functions")
    actions = parser.add_subparsers(title="actions", metavar="ACTION", required=True)
    building = actions.add_parser(
        "build",
        help="Function JSON of a function.yaml",
        description="Resolve a function.yaml against a catalogue and write its Function JSON.",
    )
    building.add_argument("file", type=Path, metavar="FILE", help="function.yaml")
    building.add_argument("-o", "--output", type=Path, metavar="FILE", help="write here instead of to standard output")
    add_tree_options(building)
    building.set_defaults(run=build)
    validating = actions.add_parser(
        "validate",
        help="check a Function JSON or a function.yaml, from anywhere",
        description="Check a Function JSON or a function.yaml against the model, the conventions and a catalogue.",
    )
    validating.add_argument("file", type=Path, metavar="FILE", help="Function JSON, or function.yaml")
    validating.add_argument("--format", choices=("text", "json"), default="text", help="form of the report")
    add_tree_options(validating)
    validating.set_defaults(run=validate)


def build(arguments: argparse.Namespace) -> int:
    """Write the Function JSON; warnings go to standard error. Raises InputRefused if there are errors."""
    from app.function.build import build_function
    from app.function.model import to_json

    data = arguments.file.read_bytes()
    function, findings = build_function(data, str(arguments.file), read_tree(arguments))
    for finding in findings:
        print(finding.line_of_text, file=sys.stderr)
    write_text(to_json(function).decode("utf-8"), arguments.output)
    return 0


def validate(arguments: argparse.Namespace) -> int:
    """Report findings; 1 if the file cannot be used."""
    from app.function.build import check_function

    findings = check_function(arguments.file.read_bytes(), str(arguments.file), read_tree(arguments))
    _print(findings, arguments.format)
    return int(has_errors(findings))


def _print(findings: "Sequence[Finding]", form: str) -> None:
    from app.rules.report import report, sources_of

    sys.stdout.write(report(findings, form, sources_of(findings), colour=sys.stdout.isatty()))
