"""`python -m bench`: print every figure beside its reference, as a Markdown table."""

import argparse
import os
import platform
import sys
import tempfile
from pathlib import Path

from bench import browser, lint, rows, service
from bench.rows import Bench, Row

ROWS = {**rows.ROWS, **lint.ROWS, **browser.ROWS}
SERVICE = {"service"}
"""All rows of the service are measured together: they share two server processes."""


def main() -> int:
    """Measure what is asked for. No figure makes it fail: machines differ, and a table tells more than a verdict."""
    parser = argparse.ArgumentParser(prog="python -m bench", description=__doc__)
    parser.add_argument(
        "rows", nargs="*", metavar="ROW", help=f"what to measure (default: all of {', '.join(ROWS)}, service)"
    )
    parser.add_argument("--runs", type=int, default=5, help="how often each figure is taken (default: %(default)s)")
    arguments = parser.parse_args()
    unknown = set(arguments.rows) - set(ROWS) - SERVICE
    if unknown:
        parser.error(f"there is no row {', '.join(sorted(unknown))}; there are {', '.join(ROWS)}, service")
    print(_line(Row("work", "sigcat", "reference", "ratio", "wanted")), "|---|---|---|---|---|", sep="\n", flush=True)
    for name in arguments.rows or ROWS:
        if name in SERVICE:
            continue
        with tempfile.TemporaryDirectory(prefix="sigcat-bench-") as folder:
            print(_line(ROWS[name](Bench(Path(folder), max(arguments.runs, 1)))), flush=True)
    if not arguments.rows or SERVICE & set(arguments.rows):
        for row in service.rows(arguments.runs):
            print(_line(Row(*row)), flush=True)
    python = f"Python {platform.python_version()}"
    print(f"\nMedians of {arguments.runs} runs in turn; {python}, {platform.machine()}, {os.cpu_count()} cores.")
    return 0


def _line(row: Row) -> str:
    return f"| {' | '.join(row)} |"


if __name__ == "__main__":
    sys.exit(main())
