"""`sigcat simulate FUNCTION... --trace TRACE -o OUT`."""

import argparse
import sys
from contextlib import ExitStack, contextmanager, suppress
from functools import cache, partial
from pathlib import Path
from typing import TYPE_CHECKING

from sigcat.cli.command_parser import positive
from sigcat.cli.ended_by_signals import ended_by_signals
from sigcat.cli.function_options import add_functions, functions_of, tree_for_functions
from sigcat.cli.output import make_folder, opened, print_findings, write_text
from sigcat.cli.output_options import FORMATS, add_output, add_outputs
from sigcat.cli.reported import reported
from sigcat.cli.trace_options import add_trace, trace_of
from sigcat.cli.tree_options import add_tree_options
from sigcat.errors import InputRefused, UsageError, existing_file

if TYPE_CHECKING:
    import ctypes
    from collections.abc import Callable, Collection, Iterable, Iterator
    from typing import BinaryIO

    from sigcat.adapter.toolchain import Toolchain
    from sigcat.findings import Finding
    from sigcat.runs.expecting.expect import Expected
    from sigcat.runs.prepare import Prepared
    from sigcat.runs.recording.trace_file import Trace
    from sigcat.runs.running.rows import Block
    from sigcat.runs.simulate import Settings, Simulated, Take
    from sigcat.runs.stored_file import Stored, StoredFile
    from sigcat.runs.written import Form


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "simulate",
        help="run functions with a recorded trace",
        description=(
            "Build functions with their C sources, run them in simulated time with a recorded trace, as fast as possible, "
            "and write what they send. It takes gcc, clang, or the compiler of the package ziglang."
        ),
    )
    add_functions(parser)
    add_trace(parser)
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
        "--stored", type=Path, metavar="FILE",
        help="what the functions keep, as JSON: parameters and counts of errors; read if it is there, and written at the end",
    )  # fmt: skip
    parser.add_argument(
        "--expect",
        type=Path,
        metavar="EXPECTED",
        help="compare the outputs with those of this CSV file; exit 1 if they differ",
    )
    parser.add_argument(
        "--tolerance", action="append", default=[], metavar="[NAME=]NUMBER",
        help="accepted difference of numbers: 0.01, or a share of the expected value, 1%%; of one output with its NAME",
    )  # fmt: skip
    add_output(parser, "--differences", metavar="FILE", help="an .svg of the first differences from --expect")
    add_output(parser, "--junit", metavar="FILE", help="a JUnit report with a test case for each output of --expect")
    add_output(
        parser,
        "--coverage",
        metavar="FOLDER",
        help="write the coverage of the functions' code here, as Cobertura XML and HTML",
    )
    parser.add_argument(
        "--memory-limit", type=positive(int), default=2048, metavar="MIB",
        help="memory that the functions may allocate (default: %(default)s)",
    )  # fmt: skip
    parser.add_argument(
        "--output-limit", type=positive(int), default=1024, metavar="MIB",
        help="what the functions may print, and write to one file (default: %(default)s)",
    )  # fmt: skip
    parser.add_argument(
        "--fmu", type=Path, metavar="FILE",
        help="run this FMU (FMI 2.0 or 3.0, co-simulation) instead of functions; columns of the trace are its inputs",
    )  # fmt: skip
    parser.add_argument(
        "--step",
        type=positive(float),
        metavar="MS",
        help="communication step of --fmu (default: the one that it proposes)",
    )
    parser.add_argument(
        "--sandbox", action="store_true", help="run the functions in bubblewrap: without the network and without files"
    )
    add_output(parser, "--report", metavar="FILE", help="write what is found here, too")
    parser.add_argument("--format", choices=FORMATS, default="json", help="form of the report (default: %(default)s)")
    parser.add_argument(
        "--memory", action="store_true", help="say how much state and stack the core of each function takes"
    )
    add_tree_options(parser)
    parser.set_defaults(run=simulate)


def simulate(arguments: argparse.Namespace) -> int:
    """Run the functions, and write a report of the findings if `--report` asks for one."""
    with reported(arguments.report, arguments.format) as found, ended_by_signals():
        return _simulate(arguments, found)


def _simulate(arguments: argparse.Namespace, found: "list[Finding]") -> int:
    """Write what the functions send, also if they do not come to the end: then InputRefused is raised."""
    from sigcat.adapter.toolchain import toolchain
    from sigcat.runs.simulate import NO_INPUTS
    from sigcat.runs.simulate import simulate as run
    from sigcat.runs.stored_file import EMPTY, stored_text
    from sigcat.runs.written import check_plotted, echoes, form_of, signals_of

    if arguments.fmu is not None:
        return _play_fmu(arguments)
    if arguments.step is not None:
        raise UsageError("--step is the step of an FMU: it needs --fmu FILE.")
    listed = _forms(arguments)
    tools = toolchain()
    _check(arguments, tools)
    prepared, trace, paths = _prepared(arguments, found)
    if trace is None and arguments.duration is None:
        raise UsageError(NO_INPUTS)
    check_plotted(arguments.plot, signals_of(prepared, trace))
    expected = _expected(arguments, prepared, paths, found)
    stored = _stored(arguments.stored, prepared) if arguments.stored is not None else EMPTY
    settings = _settings(arguments, stored.values)._replace(echoes=echoes([form for _, form in listed]))
    with ExitStack() as files:

        def begin() -> "list[Form]":
            forms = [
                form_of(
                    form,
                    files.enter_context(_opened(path, lambda: simulated.stop is not None)),
                    prepared,
                    trace,
                    arguments.plot,
                )
                for path, form in listed
            ]
            return [*forms, expected] if expected else forms

        simulated = _written(partial(run, prepared, trace, settings, tools), begin)
    _print_and_keep(simulated.findings, found)
    for each in simulated.memory:
        print(each.text, file=sys.stderr)
    if expected is not None:
        _write_differences(arguments, expected, prepared, str(simulated.stop or ""))
    if simulated.stop is not None:
        raise simulated.stop
    if arguments.stored is not None:
        write_text(stored_text(simulated.kept, prepared.connections.members, stored.others), arguments.stored)
    if expected is not None:
        _refuse_differences(arguments.expect, expected)
    return 0


class _StoppedError(Exception):
    """A run that did not come to its end, whose output is discarded."""


@contextmanager
def _opened(path: Path | None, is_stopped: "Callable[[], bool]") -> "Iterator[BinaryIO]":
    """Open an output. A file that is there is replaced only if the run comes to its end."""
    is_there = path is not None and path.is_file()
    with suppress(_StoppedError), opened(path) as file:
        yield file
        if is_there and is_stopped():
            print(f"sigcat: {path} stays as it was: the run did not come to its end.", file=sys.stderr)
            raise _StoppedError


def _written(run: "Callable[[Take], Simulated]", begin: "Callable[[], list[Form]]") -> "Simulated":
    """Give each block of rows to the outputs. They begin with the first one: a build that fails writes nothing."""
    begun = cache(begin)

    def take(block: "Block", library: "ctypes.CDLL | None") -> None:
        for form in begun():
            form.take(block, library)

    simulated = run(take)
    for form in begun():
        form.finish()
    return simulated


def _check(arguments: argparse.Namespace, tools: "Toolchain") -> None:
    """Raise UsageError for what cannot be done here."""
    from sigcat.runs.building.coverage import check_coverage
    from sigcat.runs.running.sandbox import check_sandbox

    if arguments.expect is None and (arguments.tolerance or arguments.differences or arguments.junit):
        raise UsageError("--tolerance, --differences and --junit need --expect FILE")
    if arguments.coverage is not None:
        check_coverage(tools)
        make_folder(arguments.coverage)
    if arguments.sandbox:
        check_sandbox()


def _expected(
    arguments: argparse.Namespace, prepared: "Prepared", paths: "Collection[str]", found: "list[Finding]"
) -> "Expected | None":
    """Return the comparison of the run with a file, if one is given."""
    from sigcat.runs.expecting.expect import Expected

    if arguments.expect is None:
        return None
    expected = Expected(existing_file(arguments.expect), prepared, paths, arguments.tolerance)
    _print_and_keep(expected.trace.findings, found)
    return expected


def _write_differences(arguments: argparse.Namespace, expected: "Expected", prepared: "Prepared", stop: str) -> None:
    from sigcat.runs.expecting.reports import differences_svg, junit

    if arguments.junit is not None:
        write_text(junit(expected.columns, str(arguments.expect), stop), arguments.junit)
    if arguments.differences is not None:
        write_text(differences_svg(expected.columns, prepared.connections.units), arguments.differences)


def _refuse_differences(file: Path, expected: "Expected") -> None:
    """Say that all is as expected. Raises InputRefused if it is not, and UsageError if nothing was compared."""
    from sigcat.runs.expecting.reports import findings_of, summary

    if not any(each.total for each in expected.columns):
        raise UsageError(
            f"{file} has no value of an output: nothing was compared. Write what is expected, as a run with -o does."
        )
    text = summary(expected.columns, str(file))
    if findings := findings_of(expected.columns, expected.trace):
        raise InputRefused(text, findings)
    print(f"sigcat: {text}", file=sys.stderr)


def _forms(arguments: argparse.Namespace) -> "list[tuple[Path | None, str]]":
    """The files to write, and their forms. Raises UsageError."""
    from sigcat.runs.written import CSV, FORMS, SVG

    for path in arguments.output:
        _refuse_trace(path)
    forms: list[tuple[Path | None, str]] = [(path, path.suffix.lower()) for path in arguments.output]
    for path, form in forms:
        if form not in FORMS and str(path) != "-":
            raise UsageError(f"{path} must end in {', '.join(FORMS[:-1])} or {FORMS[-1]}, which tell its format")
    has_picture = any(form == SVG for _, form in forms)
    if has_picture and not arguments.plot:
        raise UsageError("pass `--plot NAME`, a signal for the picture")
    if arguments.plot and not has_picture:
        raise UsageError("name a file for the picture: -o FILE.svg")
    return [(path, form or CSV) for path, form in forms] or [(None, CSV)]


def _refuse_trace(path: Path) -> None:
    """Raise UsageError for a trace, which people write: a run has the column of calls, a trace need not."""
    from sigcat.file_kind import RUN_COLUMNS
    from sigcat.function.hosted_runs import recorded_columns

    if path.suffix.lower() == ".csv" and path.is_file():
        columns = recorded_columns(path)
        if columns and columns[: len(RUN_COLUMNS)] != RUN_COLUMNS:
            raise UsageError(f"{path} is a trace and would be lost: name another file to write")


def _prepared(
    arguments: argparse.Namespace, found: "list[Finding]"
) -> "tuple[Prepared, Trace | None, Collection[str]]":
    """The functions and the trace; what is found in them goes to standard error."""
    from sigcat.integration.reading import read_functions
    from sigcat.runs.prepare import prepare

    sources = [(path.read_bytes(), str(path)) for path in functions_of(arguments)]
    catalogue = tree_for_functions(arguments, sources)
    functions, findings = read_functions(sources, catalogue)
    _print_and_keep(findings, found)
    prepared = prepare(functions)
    _print_and_keep(prepared.findings, found)
    paths = (*catalogue.nodes, *catalogue.interfaces)
    if arguments.trace is None:
        return prepared, None, paths
    known = prepared.known_columns(paths)
    trace = trace_of(arguments, known, prepared)
    _print_and_keep(trace.findings, found)
    return prepared, trace, paths


def _print_and_keep(findings: "Iterable[Finding]", found: "list[Finding]") -> None:
    told = tuple(findings)
    print_findings(told)
    found += told


def _stored(path: Path, prepared: "Prepared") -> "StoredFile":
    """Return the stored values of a file, which need not exist. Raises UsageError."""
    from sigcat.runs.stored_file import EMPTY, read_stored

    if not path.exists():
        return EMPTY
    return read_stored(existing_file(path).read_bytes(), str(path), prepared.numbers.kept, prepared.connections.members)


def _settings(arguments: argparse.Namespace, stored: "Stored") -> "Settings":
    from sigcat.runs.recording.times import NANOSECONDS
    from sigcat.runs.simulate import MIB, Settings

    duration = None if arguments.duration is None else round(arguments.duration * NANOSECONDS)
    return Settings(
        duration, arguments.ignition_cycle, arguments.step_limit, stored, tells_memory=arguments.memory,
        memory_limit=arguments.memory_limit * MIB, output_limit=arguments.output_limit * MIB,
        is_sandboxed=arguments.sandbox, coverage=arguments.coverage,
    )  # fmt: skip


def _play_fmu(arguments: argparse.Namespace) -> int:
    """Play the trace to an FMU, and write its outputs as CSV."""
    from sigcat.players.fmu import Limits, columns_of, played, read_fmu
    from sigcat.runs.recording.csv_file import csv_header, csv_lines

    _refuse_beside_fmu(arguments)
    fmu = read_fmu(existing_file(arguments.fmu))
    step = fmu.step if arguments.step is None else round(arguments.step * 1e6)
    duration = None if arguments.duration is None else round(arguments.duration * 1e9)
    columns = columns_of(fmu)
    (output, *more) = arguments.output or [None]
    if more or (output is not None and output.suffix.lower() != ".csv"):
        raise UsageError("--fmu writes one CSV file: -o OUT.csv.")
    limits = Limits(arguments.step_limit, arguments.memory_limit)
    rows = played(fmu, existing_file(arguments.trace), step, duration, limits)
    with opened(output) as file:
        file.write(csv_header(columns).encode())
        for line in csv_lines(rows, columns):
            file.write(line.encode())
    return 0


def _refuse_beside_fmu(arguments: argparse.Namespace) -> None:
    """Raise UsageError for what a run of functions has, and that of an FMU does not."""
    if arguments.trace is None:
        raise UsageError("--fmu needs a trace: --trace TRACE.")
    given = {
        "functions": arguments.functions, "--deployment": arguments.deployment, "--plot": arguments.plot,
        "--stored": arguments.stored, "--expect": arguments.expect, "--coverage": arguments.coverage,
        "--sandbox": arguments.sandbox, "--memory": arguments.memory, "--report": arguments.report,
    }  # fmt: skip
    beside = [name for name, value in given.items() if value]
    if beside:
        raise UsageError(f"--fmu runs an FMU alone, without {beside[0]}.")
