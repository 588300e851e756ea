"""`sigcat generate core FUNCTION... -o DIR`."""

import argparse
import sys
from pathlib import Path

from sigcat.cli.output import write_bytes
from sigcat.cli.output_options import add_output, make_folder, refuse_overwriting
from sigcat.cli.tree_options import add_tree_options, read_tree
from sigcat.errors import existing_file


def add_kind(kinds: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the sub-command."""
    one = kinds.add_parser(
        "core",
        help="the core of adapters, for every platform",
        description=(
            "Write the core of the adapter of each function in C: what is received, checked, converted, supervised and "
            "sent, independent of any platform."
        ),
    )
    one.add_argument("functions", type=Path, nargs="+", metavar="FUNCTION", help="function.yaml or Function JSON")
    add_output(one, "-o", "--output", required=True, metavar="DIR", help="folder to write to")
    add_tree_options(one)
    one.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Write the files; findings go to standard error. Raises InputRefused if a function cannot be used."""
    from sigcat.adapter.core.cores import cores
    from sigcat.integration.reading import read_functions

    sources = [(existing_file(path).read_bytes(), str(path)) for path in arguments.functions]
    functions, findings = read_functions(sources, read_tree(arguments))
    files, warnings = cores(functions)
    for finding in (*findings, *warnings):
        print(finding.line_of_text, file=sys.stderr)
    refuse_overwriting(arguments, written=[arguments.output / file.name for file in files])
    make_folder(arguments.output)
    for file in files:
        write_bytes(file.data, arguments.output / file.name)
    return 0
