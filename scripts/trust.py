"""Ask the judges of tests/judges.py, and write what they said into docs/explanation/trust.md: `make trust`."""

import argparse
import json
import re
import subprocess
import sys
import tempfile
from collections.abc import Collection, Iterable, Mapping, Sequence
from datetime import UTC, datetime
from importlib.metadata import PackageNotFoundError, version
from itertools import groupby
from operator import itemgetter
from pathlib import Path
from typing import Any

from sigcat import __version__
from tests.judges import JUDGES, Judge

ROOT = Path(__file__).parents[1]
_ROS2 = ROOT / "requirements-ros2.txt"
PAGE = ROOT / "docs" / "explanation" / "trust.md"
_INTRODUCTION = """# Conformance

sigcat's output is tested with third-party tools. This page lists them, with the results of the last run of `make trust`, which writes it.
"""
_LIMITS = """
A check is one comparison: an export, a file, a page, a request. What is not tested yet is listed under
[Where it ends](why-sigcat.md#where-it-ends). `make test` and `make real` use the same tools, with fewer repetitions, before each change.

Documents as attacks: a function.yaml, a deployment file, Function JSON and the three Integration JSON have 1,885 fields with strings.
Each is tried with 24 payloads in the files of every generator: 84,840 combinations of field, payload and generator. A payload is refused
with a finding at its field, or it is free text, in which libclang, CMake, Python, expat, a reader of YAML and rosidl find no code. In the
JSON documents, fields with a type also have the most dangerous values that the type accepts, with the same result. The models are walked,
so a new field is included. `.venv/bin/pytest tests/adapter/hostile tests/adapter/test_hostile_text.py` runs all of them, as a part of `make real`.
"""

Verdict = Mapping[str, Any]


def main() -> int:
    """Run the judged tests, or take what a run wrote; write the page. The exit status is that of the tests."""
    parser = argparse.ArgumentParser(prog="python -m scripts.trust", description=__doc__)
    parser.add_argument(
        "judges",
        nargs="*",
        metavar="JUDGE",
        help=f"ask these alone, and keep what the others said: {', '.join(JUDGES)}",
    )
    parser.add_argument(
        "--verdicts", type=Path, metavar="FILE", help="what `pytest --verdicts FILE` wrote; else run it"
    )
    arguments = parser.parse_args()
    file, judges = arguments.verdicts, frozenset(arguments.judges)
    if judges - JUDGES.keys():
        parser.error(f"there is no judge {', '.join(sorted(judges - JUDGES.keys()))}; there are {', '.join(JUDGES)}")
    status, verdicts = (0, json.loads(file.read_bytes())) if file else _asked(judges)
    if judges:
        said = [verdict for verdict in verdicts if verdict["judge"] in judges]
        verdicts = [*said, *(each for each in verdicts_of(PAGE.read_text("utf-8")) if each["judge"] not in judges)]
    PAGE.write_text(page(verdicts, datetime.now(UTC).strftime("%Y-%m-%d")), encoding="utf-8")
    return status


def _asked(judges: Collection[str]) -> tuple[int, Sequence[Verdict]]:
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "verdicts.json"
        command = [sys.executable, "-m", "pytest", "-n", "auto", "-m", "judge", "--verdicts", str(file)]
        status = subprocess.run([*command, *_files(judges)], cwd=ROOT, check=False).returncode
        return status, json.loads(file.read_bytes())


def _files(judges: Collection[str]) -> Sequence[str]:
    """The files whose tests ask some judges; all if none is named."""
    mark = re.compile(rf'@judged_by\(\s*"({"|".join(map(re.escape, judges))})"')
    files = (ROOT / "tests").rglob("test_*.py")
    return [str(file) for file in files if judges and mark.search(file.read_text("utf-8"))]


def verdicts_of(text: str) -> Sequence[Verdict]:
    """What a page says, as verdicts."""
    names = {judge.name: key for key, judge in JUDGES.items()}
    rows = [row.removeprefix("| ").removesuffix(" |").split(" | ") for row in text.splitlines() if row.startswith("| ")]
    return [
        {"judge": names[name], "question": question, **_outcome(part)}
        for name, _, question, counted in rows if name in names
        for part in counted.split(", ")
    ]  # fmt: skip


_OUTCOME = re.compile(r"(?P<count>[0-9,]+)(?: (?P<outcome>\w+))?")


def _outcome(text: str) -> Mapping[str, Any]:
    match = _OUTCOME.fullmatch(text)
    assert match, text
    return {"outcome": match["outcome"] or "passed", "count": int(match["count"].replace(",", ""))}


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
    try:
        return version(judge.distribution) if judge.distribution else ""
    except PackageNotFoundError:  # it is in the environment of ROS 2
        pinned = re.search(rf"^{judge.distribution}==(\S+)", _ROS2.read_text(encoding="utf-8"), re.MULTILINE)
        return pinned[1] if pinned else ""


def _counted(found: Mapping[str, int]) -> str:
    """`12`, `11, 1 failed`: those that did not pass are never left out."""
    others = [f"{count:,} {outcome}" for outcome, count in found.items() if outcome != "passed"]
    return ", ".join([f"{found.get('passed', 0):,}", *others])


def _total(verdicts: Sequence[Verdict]) -> int:
    return sum(verdict["count"] for verdict in verdicts if verdict["outcome"] == "passed")


if __name__ == "__main__":
    sys.exit(main())
