"""`sigcat schema NAME`."""

import argparse
import json

from sigcat.cli.output import write_text
from sigcat.cli.output_options import add_output
from sigcat.platforms.schemas import SCHEMAS, schema


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "schema",
        help="JSON Schema of a file format",
        description="Write the JSON Schema (2020-12) of a file format, for editors and other programs.",
    )
    parser.add_argument("name", choices=tuple(SCHEMAS), metavar="NAME", help=", ".join(SCHEMAS))
    add_output(parser, "-o", "--output", metavar="FILE", help="write here instead of to standard output")
    parser.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Write the schema."""
    write_text(json.dumps(schema(arguments.name), indent=2, ensure_ascii=False) + "\n", arguments.output)
    return 0
