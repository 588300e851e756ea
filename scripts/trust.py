"""Ask the judges of tests/judges.py, and write what they said into docs/explanation/trust.md: `make trust`."""

import argparse
import json
import subprocess
import sys
import tempfile
from collections.abc import Iterable, Mapping, Sequence
from datetime import UTC, datetime
from importlib.metadata import version
from itertools import groupby
from operator import itemgetter
from pathlib import Path
from typing import Any

from sigcat import __version__
from tests.judges import JUDGES, Judge

ROOT = Path(__file__).parents[1]
PAGE = ROOT / "docs" / "explanation" / "trust.md"
_INTRODUCTION = """# Who says so

Tests that an author writes ask what the author thought of. What sigcat says of trees, functions and ARXML is therefore put before
judges that others wrote. This page is written by `make trust`, which asks them all, and has what they said in the last run.
"""
_LIMITS = """
A judgement is one comparison: an export, a file, a page, a request. What no test asked is not in the table; what nobody could judge
yet is [said where it ends](why-sigcat.md#where-it-ends). `make test` asks the same judges, with fewer repetitions, before
each change.
"""

Verdict = Mapping[str, Any]


def main() -> int:
    """Run the judged tests, or take what a run wrote; write the page. The exit status is that of the tests."""
    parser = argparse.ArgumentParser(prog="python -m scripts.trust", description=__doc__)
    parser.add_argument(
        "--verdicts", type=Path, metavar="FILE", help="what `pytest --verdicts FILE` wrote; else run it"
    )
    file = parser.parse_args().verdicts
    status, verdicts = (0, json.loads(file.read_bytes())) if file else _asked()
    PAGE.write_text(page(verdicts, datetime.now(UTC).strftime("%Y-%m-%d")), encoding="utf-8")
    return status


def _asked() -> tuple[int, Sequence[Verdict]]:
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "verdicts.json"
        command = [sys.executable, "-m", "pytest", "-n", "auto", "-m", "judge", "--verdicts", str(file)]
        status = subprocess.run(command, cwd=ROOT, check=False).returncode
        return status, json.loads(file.read_bytes())


def page(verdicts: Sequence[Verdict], day: str) -> str:
    """The page, of verdicts as tests/judges.py writes them."""
    rows = [
        "| who | version | what holds | judgements |",
        "|---|---|---|---|",
        *(_row(judge, question, found) for (judge, question), found in _grouped(verdicts)),
    ]
    last = f"\nLast run: {day}, sigcat {__version__}, {_total(verdicts):,} judgements.\n"
    return "\n".join([_INTRODUCTION, *rows, last.rstrip("\n"), _LIMITS])


def _grouped(verdicts: Sequence[Verdict]) -> Iterable[tuple[tuple[str, str], Mapping[str, int]]]:
    """Counts by outcome for each judge and question, in the order of the judges."""
    order = list(JUDGES)
    key = itemgetter("judge", "question")
    by_judge = sorted(verdicts, key=lambda verdict: (order.index(verdict["judge"]), verdict["question"]))
    for names, found in groupby(by_judge, key):
        yield names, {verdict["outcome"]: verdict["count"] for verdict in found}


def _row(judge: str, question: str, found: Mapping[str, int]) -> str:
    return f"| {JUDGES[judge].name} | {_version(JUDGES[judge])} | {question} | {_counted(found)} |"


def _version(judge: Judge) -> str:
    return version(judge.distribution) if judge.distribution else ""


def _counted(found: Mapping[str, int]) -> str:
    """`12`, `11, 1 failed`: those that did not pass are never left out."""
    others = [f"{count:,} {outcome}" for outcome, count in found.items() if outcome != "passed"]
    return ", ".join([f"{found.get('passed', 0):,}", *others])


def _total(verdicts: Sequence[Verdict]) -> int:
    return sum(verdict["count"] for verdict in verdicts if verdict["outcome"] == "passed")


if __name__ == "__main__":
    sys.exit(main())
