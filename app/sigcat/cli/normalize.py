"""`sigcat normalize FUNCTION... --trace TRACE -o NORMALIZED`."""

import argparse

from sigcat.cli.function_options import add_functions, functions_of
from sigcat.cli.output import print_findings, write_lines
from sigcat.cli.output_options import add_output
from sigcat.cli.trace_options import add_trace, trace_of
from sigcat.cli.tree_options import add_tree_options, read_tree


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "normalize",
        help="write a trace as numbers, for players and the test RTE",
        description=(
            "Check a trace, and write it as the players of AUTOSAR adaptive and ROS 2 and the test RTE of AUTOSAR Classic "
            "read it: CSV with times in ns and numbers only."
        ),
    )
    add_functions(parser)
    add_trace(parser, is_required=True)
    add_output(parser, "-o", "--output", metavar="NORMALIZED", help="write here instead of standard output")
    add_tree_options(parser)
    parser.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Write the normalized trace, which appears whole or not at all."""
    from sigcat.integration.reading import read_functions
    from sigcat.runs.normalize import normalize, with_codes
    from sigcat.runs.prepare import prepare

    sources = [(path.read_bytes(), str(path)) for path in functions_of(arguments)]
    catalogue = read_tree(arguments)
    functions, findings = read_functions(sources, catalogue)
    print_findings(findings)
    prepared = prepare(functions)
    print_findings(prepared.findings)
    known = with_codes(prepared.known_columns((*catalogue.nodes, *catalogue.interfaces)), prepared)
    trace = trace_of(arguments, known, prepared)
    print_findings(trace.findings)
    write_lines(normalize(trace, prepared), arguments.output)
    return 0
