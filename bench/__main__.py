"""`python -m bench`: print every figure beside its reference, as a Markdown table."""

import argparse
import os
import platform
import sys
import tempfile
from collections.abc import Iterator, Sequence
from itertools import chain
from pathlib import Path

from bench import (
    browser,
    comparison,
    core,
    cycles,
    gateway,
    language_server,
    lint,
    registry,
    ros2,
    rows,
    service,
    simulation,
    stored_run,
    transport,
    vehicles,
    wall_clock,
)
from bench.rows import Bench, Missing, Row

ROWS = {
    **rows.ROWS, **vehicles.ROWS, **lint.ROWS, **language_server.ROWS, **core.ROWS, **stored_run.ROWS, **simulation.ROWS, **gateway.ROWS, **comparison.ROWS, **transport.ROWS, **cycles.ROWS, **ros2.ROWS, **registry.ROWS,
    **browser.ROWS,
}  # fmt: skip
SERVICE = {"service"}
"""All rows of the service are measured together: they share two server processes."""


def main() -> int:
    """Measure what is asked for. No figure makes it fail: machines differ, and a table tells more than a verdict."""
    arguments = _arguments()
    # commands are measured with modules compiled, as installed ones are
    os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
    lines = []
    for line in _table(arguments.rows, arguments.runs):
        print(line, flush=True)
        lines.append(line)
    if arguments.write is not None:
        text = arguments.write.read_text(encoding="utf-8")
        arguments.write.write_text(_with_table(text, "\n".join(lines)), encoding="utf-8")
    return 0


def _arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="python -m bench", description=__doc__)
    parser.add_argument(
        "rows", nargs="*", metavar="ROW", help=f"what to measure (default: all of {', '.join(ROWS)}, service)"
    )
    parser.add_argument("--runs", type=int, default=5, help="how often each figure is taken (default: %(default)s)")
    parser.add_argument("--write", type=Path, metavar="FILE", help="put the table between the bench marks of this file")
    arguments = parser.parse_args()
    unknown = set(arguments.rows) - set(ROWS) - SERVICE
    if unknown:
        parser.error(f"there is no row {', '.join(sorted(unknown))}; there are {', '.join(ROWS)}, service")
    return arguments


def _table(names: Sequence[str], runs: int) -> Iterator[str]:
    """The lines of the table, each as soon as it is measured, and below them what was measured on."""
    yield "| Work | sigcat | Reference | Ratio | Target | Pass |"
    yield "|---|---|---|---|---|---|"
    for name in (name for name in names or ROWS if name not in SERVICE):
        with tempfile.TemporaryDirectory(prefix="sigcat-bench-") as folder:
            try:
                yield _line(ROWS[name](Bench(Path(folder), max(runs, 1))))
            except Missing as missing:
                print(f"sigcat: the row {name} is left out for want of {missing}", file=sys.stderr)
    if not names or SERVICE & set(names):
        yield from (_line(Row(*row)) for row in chain(service.rows(runs), wall_clock.rows(runs)))
    machine = f"Python {platform.python_version()}, {platform.machine()}, {os.cpu_count()} cores"
    yield f"\nMedians of {runs} runs in turn; {machine}."


def _with_table(text: str, table: str) -> str:
    before, begin, rest = text.partition("<!-- bench -->")
    _, end, after = rest.partition("<!-- /bench -->")
    if not (begin and end):
        raise SystemExit("The file has no place for the table: <!-- bench --> and <!-- /bench -->.")
    return f"{before}{begin}\n{table}\n{end}{after}"


def _line(row: Row) -> str:
    passed = "yes" if row.is_met else "**no**"
    return f"| {' | '.join(row[:-1])} | {passed} |"


if __name__ == "__main__":
    sys.exit(main())
