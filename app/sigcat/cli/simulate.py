"""`sigcat simulate FUNCTION... --trace TRACE -o OUT`."""

import argparse
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from sigcat.cli.command_parser import positive
from sigcat.cli.output import write_text
from sigcat.cli.output_options import add_output
from sigcat.cli.tree_options import add_tree_options, read_tree
from sigcat.errors import existing_file

if TYPE_CHECKING:
    from sigcat.runs.simulate import Settings


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "simulate",
        help="run functions with a recorded trace",
        description=(
            "Build functions with their C sources, run them in simulated time with a recorded trace, as fast as it goes, "
            "and write what they send. It takes gcc, clang, or the compiler of the package ziglang."
        ),
    )
    parser.add_argument("functions", type=Path, nargs="+", metavar="FUNCTION", help="function.yaml or Function JSON")
    parser.add_argument("--trace", type=Path, metavar="TRACE", help="what the functions receive, as CSV")
    add_output(parser, "-o", "--output", metavar="OUT", help="write here instead of to standard output: CSV")
    parser.add_argument(
        "--duration", type=positive(float), metavar="SECONDS", help="how long to run (default: to the end of the trace)"
    )
    parser.add_argument(
        "--ignition-cycle", type=positive(int), default=1, metavar="N", help="number of the ignition cycle (default: 1)"
    )
    parser.add_argument(
        "--step-limit", type=positive(float), default=10.0, metavar="SECONDS",
        help="how long a call may take before the run is stopped (default: 10)",
    )  # fmt: skip
    add_tree_options(parser)
    parser.set_defaults(run=simulate)


def simulate(arguments: argparse.Namespace) -> int:
    """Run the functions and write what they send, also if they do not come to the end: then InputRefused is raised."""
    from sigcat.adapter.toolchain import toolchain
    from sigcat.integration.reading import read_functions
    from sigcat.runs.prepare import prepare
    from sigcat.runs.recording.csv_file import csv_text
    from sigcat.runs.recording.trace_file import open_trace
    from sigcat.runs.simulate import simulate as run

    tools = toolchain()
    catalogue = read_tree(arguments)
    sources = [(existing_file(path).read_bytes(), str(path)) for path in arguments.functions]
    functions, findings = read_functions(sources, catalogue)
    prepared = prepare(functions)
    trace = None
    if arguments.trace is not None:
        known = prepared.known_columns((*catalogue.nodes, *catalogue.interfaces))
        trace = open_trace(existing_file(arguments.trace), known)
    for finding in (*findings, *prepared.findings, *(trace.findings if trace else ())):
        print(finding.line_of_text, file=sys.stderr)
    simulated = run(prepared, trace, _settings(arguments), tools)
    for finding in simulated.findings:
        print(finding.line_of_text, file=sys.stderr)
    write_text(csv_text(simulated.rows, prepared.columns), arguments.output)
    if simulated.stop is not None:
        raise simulated.stop
    return 0


def _settings(arguments: argparse.Namespace) -> "Settings":
    from sigcat.runs.recording.times import NANOSECONDS
    from sigcat.runs.simulate import Settings

    duration = None if arguments.duration is None else round(arguments.duration * NANOSECONDS)
    return Settings(duration, arguments.ignition_cycle, arguments.step_limit)
