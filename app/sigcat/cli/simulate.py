"""`sigcat simulate FUNCTION... --trace TRACE -o OUT`."""

import argparse
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from sigcat.cli.command_parser import positive
from sigcat.cli.output import write_bytes
from sigcat.cli.output_options import add_outputs
from sigcat.cli.tree_options import add_tree_options, read_tree
from sigcat.errors import UsageError, existing_file

if TYPE_CHECKING:
    from collections.abc import Iterable

    from sigcat.findings import Finding
    from sigcat.runs.prepare import Prepared
    from sigcat.runs.recording.trace_file import Trace
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
    add_outputs(
        parser, "-o", "--output", metavar="OUT",
        help="write here instead of CSV to standard output: .csv, .mcap, or .svg by its ending; may be repeated",
    )  # fmt: skip
    parser.add_argument(
        "--plot", nargs="+", action="extend", default=[], metavar="NAME",
        help="signals that an .svg shows, received or sent: paths, or names of interfaces",
    )  # fmt: skip
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
    parser.add_argument(
        "--memory", action="store_true", help="say how much state and stack the core of each function takes"
    )
    add_tree_options(parser)
    parser.set_defaults(run=simulate)


def simulate(arguments: argparse.Namespace) -> int:
    """Run the functions and write what they send, also if they do not come to the end: then InputRefused is raised."""
    from sigcat.adapter.toolchain import toolchain
    from sigcat.runs.simulate import simulate as run
    from sigcat.runs.written import check_plotted, signals_of, written

    forms = _forms(arguments)
    tools = toolchain()
    prepared, trace = _prepared(arguments)
    check_plotted(arguments.plot, signals_of(prepared, trace))
    simulated = run(prepared, trace, _settings(arguments), tools)
    _print(simulated.findings)
    for each in simulated.memory:
        print(each.text, file=sys.stderr)
    for path, form in forms:
        write_bytes(written(form, simulated, prepared, trace, arguments.plot), path)
    if simulated.stop is not None:
        raise simulated.stop
    return 0


def _forms(arguments: argparse.Namespace) -> "list[tuple[Path | None, str]]":
    """The files to write, and their forms. Raises UsageError."""
    from sigcat.runs.written import CSV, FORMS, SVG

    forms: list[tuple[Path | None, str]] = [(path, path.suffix.lower()) for path in arguments.output]
    for path, form in forms:
        if form not in FORMS and str(path) != "-":
            raise UsageError(f"{path} must end in {', '.join(FORMS[:-1])} or {FORMS[-1]}: that says what is written")
    has_picture = any(form == SVG for _, form in forms)
    if has_picture and not arguments.plot:
        raise UsageError("say with --plot NAME what the picture shows")
    if arguments.plot and not has_picture:
        raise UsageError("name a file for the picture: -o FILE.svg")
    return [(path, form or CSV) for path, form in forms] or [(None, CSV)]


def _prepared(arguments: argparse.Namespace) -> "tuple[Prepared, Trace | None]":
    """The functions and the trace; what is found in them goes to standard error."""
    from sigcat.integration.reading import read_functions
    from sigcat.runs.prepare import prepare
    from sigcat.runs.recording.trace_file import open_trace

    catalogue = read_tree(arguments)
    sources = [(existing_file(path).read_bytes(), str(path)) for path in arguments.functions]
    functions, findings = read_functions(sources, catalogue)
    _print(findings)
    prepared = prepare(functions)
    _print(prepared.findings)
    if arguments.trace is None:
        return prepared, None
    known = prepared.known_columns((*catalogue.nodes, *catalogue.interfaces))
    trace = open_trace(existing_file(arguments.trace), known)
    _print(trace.findings)
    return prepared, trace


def _print(findings: "Iterable[Finding]") -> None:
    for finding in findings:
        print(finding.line_of_text, file=sys.stderr)


def _settings(arguments: argparse.Namespace) -> "Settings":
    from sigcat.runs.recording.times import NANOSECONDS
    from sigcat.runs.simulate import Settings

    duration = None if arguments.duration is None else round(arguments.duration * NANOSECONDS)
    return Settings(duration, arguments.ignition_cycle, arguments.step_limit, tells_memory=arguments.memory)
