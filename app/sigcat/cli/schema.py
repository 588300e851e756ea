"""`sigcat schema NAME`."""

import argparse
import json
from pathlib import Path

from sigcat.cli.output import write_text


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the command."""
    names = ("deployment", "function", "function-declaration", "integration-autosar-adaptive", "integration-ros2")
    parser = commands.add_parser(
        "schema",
        help="JSON Schema of a file format",
        description="Write the JSON Schema (2020-12) of a file format, for editors and other programs.",
    )
    parser.add_argument("name", choices=names, metavar="NAME", help=", ".join(names))
    parser.add_argument("-o", "--output", type=Path, metavar="FILE", help="write here instead of to standard output")
    parser.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Write the schema."""
    from sigcat.integration.schemas import schema

    write_text(json.dumps(schema(arguments.name), indent=2, ensure_ascii=False) + "\n", arguments.output)
    return 0
