"""Run the reference tools of tests/reference_tools.py, and write their results into docs/explanation/trust.md: `make trust`."""

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
from tests.reference_tools import REFERENCE_TOOLS, ReferenceTool

ROOT = Path(__file__).parents[1]
_ROS2 = ROOT / "requirements-ros2.txt"
PAGE = ROOT / "docs" / "explanation" / "trust.md"
_INTRODUCTION = """# Conformance

sigcat's output is tested with third-party tools. This page lists them, with the results of the last run of `make trust`, which writes it.
"""
_LIMITS = """
A check is one comparison: an export, a file, a page, a request. What is not tested yet is listed under
[Where it ends](why-sigcat.md#where-it-ends). `make test` and `make real` use the same tools, with fewer repetitions, before each change.

Documents as attacks: a function.yaml, a deployment file, Function JSON and the four Integration JSON have 2,120 fields with strings.
Each is tried with 24 payloads in the files of every generator: 95,040 combinations of field, payload and generator. A payload is refused
with a finding at its field, or it is free text, in which libclang, CMake, Python, expat, a reader of YAML and rosidl find no code. In the
JSON documents, fields with a type also have the most dangerous values that the type accepts, with the same result. The models are walked,
so a new field is included. `.venv/bin/pytest tests/adapter/hostile tests/adapter/test_hostile_text.py` runs all of them, as a part of `make real`.

By hand, on 2026-11-28: no registry has rclcpp, so tests of nodes in C++ use a [subset](../../tests/adapter/ros2/rclcpp_subset/README.md). Built
from source on the wheels of `make ros2`, these replaced it: rclcpp, rclcpp_lifecycle and rclcpp_components 28.1.6, bondcpp 4.0.0 (branch ros2),
the lifecycle manager of Nav2 1.3.13, and rosbag2 0.26.5.

- Nodes of EcoControl and of a second set of three functions (arrays, structs, queues, calls on events, a method, bonds) compile with all of their
  warnings as errors.
- 84 tests of `tests/adapter/ros2` pass, half of them with running nodes: lock step, life cycle, parameters, executors, components, ends of
  processes. One more is about the subset itself.
- `sigcat compare` plays a drive with bursts to the second set in lock step: 0 of 689 values differ from the simulation.
- The second set runs twice in two namespaces, by both launch files, and in an isolated component container. The manager configures and activates its
  nodes, gets their bonds, and finds a killed one after 4.1 s. Limits of the manager are under [launch](../how-to/ros2.md#build-test-run).
- A bag in MCAP that `ros2 bag record` wrote is a trace: 325 values of eight topics of free-running nodes are those of `sigcat simulate`, 0 differ.
"""

Result = Mapping[str, Any]


def main() -> int:
    """Run the tests of the reference tools, or read the results of a run; write the page. The exit status is that of the tests."""
    parser = argparse.ArgumentParser(prog="python -m scripts.trust", description=__doc__)
    parser.add_argument(
        "tools",
        nargs="*",
        metavar="TOOL",
        help=f"run only these, and keep the results of the others: {', '.join(REFERENCE_TOOLS)}",
    )
    parser.add_argument(
        "--results", type=Path, metavar="FILE", help="read the output of `pytest --results FILE`; default: run it"
    )
    arguments = parser.parse_args()
    file, tools = arguments.results, frozenset(arguments.tools)
    if unknown := tools - REFERENCE_TOOLS.keys():
        parser.error(f"unknown tool {', '.join(sorted(unknown))}; use one of {', '.join(REFERENCE_TOOLS)}")
    status, results = (0, json.loads(file.read_bytes())) if file else _run(tools)
    if tools:
        new = [result for result in results if result["tool"] in tools]
        results = [*new, *(each for each in results_of(PAGE.read_text("utf-8")) if each["tool"] not in tools)]
    PAGE.write_text(page(results, datetime.now(UTC).strftime("%Y-%m-%d")), encoding="utf-8")
    return status


def _run(tools: Collection[str]) -> tuple[int, Sequence[Result]]:
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "results.json"
        command = [sys.executable, "-m", "pytest", "-n", "auto", "-m", "reference_tool", "--results", str(file)]
        status = subprocess.run([*command, *_files(tools)], cwd=ROOT, check=False).returncode
        return status, json.loads(file.read_bytes())


def _files(tools: Collection[str]) -> Sequence[str]:
    """Return the files of tests that use some tools; none for all tools."""
    mark = re.compile(rf'@checked_with\(\s*"({"|".join(map(re.escape, tools))})"')
    files = (ROOT / "tests").rglob("test_*.py")
    return [str(file) for file in files if tools and mark.search(file.read_text("utf-8"))]


def results_of(text: str) -> Sequence[Result]:
    """Return the results on a page."""
    names = {tool.name: key for key, tool in REFERENCE_TOOLS.items()}
    rows = [row.removeprefix("| ").removesuffix(" |").split(" | ") for row in text.splitlines() if row.startswith("| ")]
    return [
        {"tool": names[name], "requirement": requirement, **_outcome(part)}
        for name, _, requirement, counted in rows if name in names
        for part in counted.split(", ")
    ]  # fmt: skip


_OUTCOME = re.compile(r"(?P<count>[0-9,]+)(?: (?P<outcome>\w+))?")


def _outcome(text: str) -> Mapping[str, Any]:
    match = _OUTCOME.fullmatch(text)
    assert match, text
    return {"outcome": match["outcome"] or "passed", "count": int(match["count"].replace(",", ""))}


def page(results: Sequence[Result], day: str) -> str:
    """Return the page, of results as tests/reference_tools.py writes them."""
    rows = [
        "| Tool | Version | Requirement | Checks |",
        "|---|---|---|---|",
        *(_row(tool, requirement, found) for (tool, requirement), found in _grouped(results)),
    ]
    last = f"\nLast run: {day}, sigcat {__version__}, {_total(results):,} checks passed.\n"
    return "\n".join([_INTRODUCTION, *rows, last.rstrip("\n"), _LIMITS])


def _grouped(results: Sequence[Result]) -> Iterable[tuple[tuple[str, str], Mapping[str, int]]]:
    """Yield counts by outcome for each tool and requirement, in the order of the tools."""
    order = list(REFERENCE_TOOLS)
    key = itemgetter("tool", "requirement")
    by_tool = sorted(results, key=lambda result: (order.index(result["tool"]), result["requirement"]))
    for names, found in groupby(by_tool, key):
        yield names, {result["outcome"]: result["count"] for result in found}


def _row(tool: str, requirement: str, found: Mapping[str, int]) -> str:
    return f"| {REFERENCE_TOOLS[tool].name} | {_version(REFERENCE_TOOLS[tool])} | {requirement} | {_counted(found)} |"


def _version(tool: ReferenceTool) -> str:
    try:
        return version(tool.distribution) if tool.distribution else ""
    except PackageNotFoundError:  # it is in the environment of ROS 2
        pinned = re.search(rf"^{tool.distribution}==(\S+)", _ROS2.read_text(encoding="utf-8"), re.MULTILINE)
        return pinned[1] if pinned else ""


def _counted(found: Mapping[str, int]) -> str:
    """`12`, `11, 1 failed`: those that did not pass are always listed."""
    others = [f"{count:,} {outcome}" for outcome, count in found.items() if outcome != "passed"]
    return ", ".join([f"{found.get('passed', 0):,}", *others])


def _total(results: Sequence[Result]) -> int:
    return sum(result["count"] for result in results if result["outcome"] == "passed")


if __name__ == "__main__":
    sys.exit(main())
