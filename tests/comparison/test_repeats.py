"""Runs of the platforms whose load is compared are repeated, each with its own recording."""

from pathlib import Path
from typing import Any

import pytest

from sigcat.comparison.compare import Asked, _again
from sigcat.comparison.running.runner import Drive
from sigcat.comparison.telling.report import report_of
from tests.comparison.test_report import material, played


@pytest.mark.parametrize(
    ("name", "runs", "names"),
    [
        ("ros2-cpp", 3, ["free-run-2", "free-run-3"]),
        ("baseline", 2, ["free-run-2"]),
        ("ros2-cpp", 1, []),
        ("autosar-classic", 3, []),
    ],
)
def test_only_the_two_that_are_compared_are_repeated(name, runs, names):
    drives: list[Drive] = []

    def play(built: Any, subject: Any, each: Drive) -> Any:
        drives.append(each)

    drive = Drive(Path("drive.csv"), 10**9, "free run", "free-run")
    nothing: Any = None
    asked = Asked(nothing, nothing, Path(), 0, (), 0, Path(), runs=runs)
    _again(played(name), play, asked, drive)
    assert [each.name for each in drives] == names


def test_each_repetition_has_its_number_in_the_report():
    own = played("ros2-cpp")
    report = report_of(material(own._replace(repeats=(own.lock_step, own.lock_step))))
    runs = [each.run for each in report.processes if each.platform == "ros2-cpp" and not each.is_player]
    assert runs == [0, 1, 2]
