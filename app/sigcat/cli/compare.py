"""`sigcat compare SET --platforms P,P --trace TRACE -o REPORT`."""

import argparse
import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from sigcat.cli.command_parser import positive
from sigcat.cli.ended_by_signals import ended_by_signals
from sigcat.cli.function_options import deployment_of, project_functions
from sigcat.cli.output import make_folder, print_findings, write_bytes, write_text
from sigcat.cli.output_options import add_outputs
from sigcat.cli.project_options import project_of
from sigcat.cli.tree_options import add_dbc, add_tree_options, read_tree
from sigcat.errors import InputRefused, UsageError, existing_file
from sigcat.names import did_you_mean
from sigcat.temporary_files import temporary_folder

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from sigcat.catalogue.model.catalogue import Catalogue
    from sigcat.comparison.can_drive import Carried
    from sigcat.comparison.compare import Asked
    from sigcat.comparison.compared_set import ComparedSet
    from sigcat.comparison.faults.scenario import Scenario
    from sigcat.comparison.report.model import Report
    from sigcat.comparison.running.runner import Subject

_FORMS = (".md", ".json", ".html")
FREE_RUN = 20.0
"""Seconds of free run by default."""


def add_parser(commands: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "compare",
        help="run functions on every platform, and compare behaviour, timing, load and effort",
        description=(
            "Build functions for each platform, play one drive to all of them, hold every value against the simulation, and "
            "report behaviour, timing, load and effort. A platform that is not installed is left out."
        ),
        epilog=(
            "Exit status: 0 every value is equal on every platform that was played to; 1 a value differs, or a platform cannot "
            "be built or did not come to its end; 2 nothing could be compared. The simulation alone, if that is what --platforms names, is measured."
        ),
    )
    parser.add_argument(
        "functions",
        type=Path,
        nargs="*",
        metavar="SET",
        help="folder with a compare.yaml, or function.yaml, or Function JSON (default: the functions of the project)",
    )
    parser.add_argument(
        "--platforms", metavar="P,P", help="which, separated by commas (default: all that are installed)"
    )
    parser.add_argument(
        "--trace",
        type=Path,
        metavar="TRACE",
        help="the drive, as CSV, MCAP, a bag of ROS 2 or a log of CAN (default: that of compare.yaml)",
    )
    add_dbc(parser, "CAN database (DBC) of such a log")
    parser.add_argument(
        "--deployment",
        type=Path,
        metavar="FILE",
        help="what differs from the defaults of the platforms (default: that of the set, or of the project)",
    )
    faults = parser.add_mutually_exclusive_group()
    faults.add_argument("--faults", type=Path, metavar="FILE", help="faults to inject (default: those of compare.yaml)")
    faults.add_argument("--no-faults", action="store_true", help="inject none")
    parser.add_argument(
        "--duration", type=positive(float), metavar="SECONDS", help="how much of the drive (default: all of it)"
    )
    parser.add_argument(
        "--free-run", type=float, default=FREE_RUN, metavar="SECONDS",
        help="how long each platform keeps its own time as well; 0: not at all (default: %(default)g)",
    )  # fmt: skip
    parser.add_argument(
        "--runs", type=positive(int), default=1, metavar="NUMBER",
        help="runs of the nodes whose load is compared with that of nodes written by hand, for its spread (default: %(default)s)",
    )  # fmt: skip
    add_outputs(
        parser, "-o", "--output", metavar="REPORT",
        help="a folder for the report in every form, or a file: .md, .json or .html; may be repeated",
    )  # fmt: skip
    parser.add_argument(
        "--keep", type=Path, metavar="FOLDER", help="keep build files in FOLDER (default: a temporary folder)"
    )
    add_tree_options(parser)
    parser.set_defaults(run=compare)


def compare(arguments: argparse.Namespace) -> int:
    """Compare, and write the report; how far it is goes to standard error."""
    from sigcat.comparison.report.markdown import markdown

    _check_outputs(arguments.output)
    if not 0 <= arguments.free_run <= 3600:
        raise UsageError(f"--free-run must be from 0 to 3600 seconds, not {arguments.free_run:g}")
    try:
        with ended_by_signals():
            report = _compared(arguments)
    except (KeyboardInterrupt, SystemExit):
        _tell("Interrupted: all processes were ended, and no report was written.")
        raise
    except InputRefused as refused:  # 1 says that a value differs
        print_findings(refused.findings)
        raise UsageError(str(refused)) from None
    for path in arguments.output:
        _write(report, path)
    if not arguments.output:
        write_text(markdown(report), None)
    else:
        for target in report.targets:
            told = "; ".join(each for each in (target.measured, target.note * (not target.holds)) if each)
            print(f"{target.what}: {target.verdict}. {told}".rstrip(". "), file=sys.stderr)
    if not report.behaviour and set(_platforms(arguments.platforms)) != {report.reference}:
        _tell("Nothing was compared: no platform but the simulation was played to.")
        return 2
    return 0 if report.is_equal else 1


def _compared(arguments: argparse.Namespace) -> "Report":
    from sigcat.adapter.toolchain import toolchain
    from sigcat.comparison.compare import compare as run
    from sigcat.comparison.telling.report import report_of

    tools = toolchain()
    if arguments.keep is not None:
        make_folder(arguments.keep)
        return report_of(run(_asked(arguments, arguments.keep.absolute()), tools, _tell))
    with temporary_folder("sigcat-compare-") as folder:
        return report_of(run(_asked(arguments, Path(folder)), tools, _tell))


def _tell(text: str) -> None:
    print(text, file=sys.stderr, flush=True)


def _asked(arguments: argparse.Namespace, folder: Path) -> "Asked":
    from sigcat.comparison.compare import Asked
    from sigcat.comparison.compared_set import read_compared
    from sigcat.runs.recording.mcap_trace import as_csv
    from sigcat.runs.recording.ros2_bag import is_bag
    from sigcat.runs.recording.times import NANOSECONDS

    platforms = _platforms(arguments.platforms)
    compared = read_compared(arguments.functions or project_functions(arguments))
    trace = arguments.trace or compared.trace
    if trace is None:
        raise UsageError("pass `--trace TRACE`, the drive to play to the functions")
    tree = read_tree(arguments)
    subject = _subject(arguments, compared, tree)
    if is_bag(trace):
        trace = _converted_bag(trace, folder, subject)
    carried = _carried(arguments, compared, existing_file(trace), tree, folder)
    trace = carried.trace if carried else as_csv(trace, folder)
    first, last = _span(existing_file(trace), subject)
    end = last if arguments.duration is None else min(last, first + round(arguments.duration * NANOSECONDS))
    free = min(end, round(arguments.free_run * NANOSECONDS))
    if 0 < free <= first:
        _tell(
            f"No free run: the drive begins at {first / NANOSECONDS:.10g} s. `sigcat gateway --from-zero` writes one that begins at 0."
        )
        free = 0
    faults = None if arguments.no_faults else arguments.faults or compared.faults
    named = _scenarios(faults, trace, subject) if faults else ()
    scenarios, notes = tuple(each for each in named if each.end <= end), tuple(_beyond(named, end))
    translation = carried.translation_ns if carried else ()
    runs = arguments.runs
    return Asked(
        compared, subject, trace.absolute(), end, platforms, free, folder, scenarios, translation, notes, runs, first
    )


def _converted_bag(bag: Path, folder: Path, subject: "Subject") -> Path:
    """Return a bag of ROS 2 as a drive in CSV."""
    from sigcat.runs.bag_columns import bag_columns
    from sigcat.runs.recording.ros2_bag import bag_as_csv

    drive, mapped = folder / f"{bag.name}.csv", bag_columns(subject.deployment, subject.prepared.connections)
    for note in bag_as_csv(bag, drive, subject.prepared.known_in_drive, mapped):
        _tell(note.line_of_text)
    return drive


def _beyond(scenarios: "Iterable[Scenario]", end: int) -> "Iterator[str]":
    """Yield the faults that are not injected, as the drive ends before them."""
    names = [each.name for each in scenarios if each.end > end]
    if names:
        note = f"Faults that are left out, as they end after {end / 1e9:g} s, where the drive does: {', '.join(names)}."
        _tell(note)
        yield note


def _carried(
    arguments: argparse.Namespace, compared: "ComparedSet", trace: Path, tree: "Catalogue", folder: Path
) -> "Carried | None":
    """Return the trace of a CAN log; other columns come from the trace of the set."""
    from sigcat.comparison.can_drive import carry
    from sigcat.gateway.logs.read import is_log

    if not is_log(trace):
        if arguments.dbc:
            raise UsageError(f"--dbc is for a log of CAN, and {trace} is none")
        return None
    _tell(f"Gateway: {trace}")
    carried = carry(
        trace,
        [existing_file(path) for path in arguments.dbc or project_of(arguments).dbc],
        tree,
        compared.trace,
        folder,
    )
    print_findings(carried.findings)
    for line in carried.counts:
        _tell(line)
    return carried


def _scenarios(path: Path, trace: Path, subject: "Subject") -> "tuple[Scenario, ...]":
    """The faults of a file. Raises InputRefused with their errors."""
    from sigcat.comparison.faults.drives import read_texts
    from sigcat.comparison.faults.reading import read_scenarios

    calls = [call.interface for call in subject.prepared.numbers.calls if call]
    functions = [member.name for member in subject.prepared.connections.members]
    columns = read_texts(trace).columns
    shapes = subject.prepared.known_columns(()).received
    return read_scenarios(existing_file(path).read_bytes(), str(path), columns, calls, functions, shapes)


def _platforms(text: str | None) -> tuple[str, ...]:
    """Return the named platforms; all without a name. Raises UsageError."""
    from sigcat.comparison.running.table import RUNNERS

    if text is None:
        return tuple(RUNNERS)
    names = tuple(dict.fromkeys(name.strip() for name in text.split(",") if name.strip()))
    for name in names:
        if name not in RUNNERS:
            meant = did_you_mean(name[:80], RUNNERS)
            raise UsageError(f"--platforms: {name[:80]!r} must be one of {', '.join(RUNNERS)}. {meant}".rstrip(". "))
    if not names:
        raise UsageError(f"--platforms must name some of {', '.join(RUNNERS)}")
    return names


def _subject(arguments: argparse.Namespace, compared: "ComparedSet", tree: "Catalogue") -> "Subject":
    from sigcat.comparison.running.runner import Subject
    from sigcat.integration.reading import read_functions
    from sigcat.platforms.deployment_file import DEFAULT_DEPLOYMENT, deployment_of_file
    from sigcat.runs.prepare import prepare

    read, findings = read_functions([(path.read_bytes(), str(path)) for path in compared.functions], tree)
    functions = tuple(sorted(read, key=lambda function: function.name))  # as on platforms: by name, not by file
    prepared = prepare(functions)
    print_findings((*findings, *prepared.findings))
    path = deployment_of(arguments, compared.deployment)
    deployment = deployment_of_file(path, os.environ) if path else DEFAULT_DEPLOYMENT
    return Subject(functions, prepared, deployment)


def _span(trace: Path, subject: "Subject") -> tuple[int, int]:
    """Times of the first and the last row of a trace, which is read once to see that it can be. Raises InputRefused."""
    from sigcat.runs.recording.trace_file import moments, open_trace

    opened = open_trace(trace, subject.prepared.known_in_drive)
    print_findings(opened.findings)
    if not opened.taken:
        raise UsageError(f"{trace} has no column that one of the functions receives: there is nothing to play")
    first = last = -1
    for row in moments(opened):
        first, last = row.time if first < 0 else first, row.time
    if last <= first:
        raise UsageError(f"{trace} has no rows after its beginning: there is nothing to play")
    return first, last


# -- what is written ----------------------------------------------------------------------------------------------


def _check_outputs(paths: "Iterable[Path]") -> None:
    """Before anything is built."""
    for path in paths:
        if path.suffix and path.suffix.lower() not in _FORMS:
            raise UsageError(f"{path} must be a folder, or end in {', '.join(_FORMS[:-1])} or {_FORMS[-1]}")
        make_folder(path.parent if path.suffix else path)


def _write(report: "Report", path: Path) -> None:
    files = [path] if path.suffix else [path / f"comparison{form}" for form in _FORMS]
    for file in files:
        write_bytes(_form(report, file.suffix.lower()), file)


def _form(report: "Report", form: str) -> bytes:
    from sigcat.comparison.report.html import html_page
    from sigcat.comparison.report.markdown import markdown
    from sigcat.comparison.report.model import to_json

    if form == ".json":
        return to_json(report)
    return (html_page(report) if form == ".html" else markdown(report)).encode()
