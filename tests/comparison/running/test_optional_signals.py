"""A vehicle with optional signals and one without: every platform sends what the simulation sends."""

import shutil
from pathlib import Path

import pytest

from sigcat.cli import main
from sigcat.comparison.report.model import read_report
from tests import needs
from tests.comparison.running.test_platforms import REAL_PARTS
from tests.function.test_optional_signals import CASE, ROOF

PLATFORMS = [
    pytest.param(name, marks=[each for each in REAL_PARTS.get(name, []) if each is not needs.slow])
    for name in ("autosar-adaptive", "autosar-classic", "ros2-cpp", "ros2-py", "fmi")
]


@needs.c_compiler
@pytest.mark.parametrize("vehicle", ["coupe", "truck"])
@pytest.mark.parametrize("platform", PLATFORMS)
def test_every_value_is_that_of_the_simulation(platform: str, vehicle: str, tmp_path: Path, monkeypatch):
    shutil.copytree(CASE, tmp_path / "project")
    monkeypatch.chdir(tmp_path / "project")
    platforms, report = f"simulate,{platform}", "report.json"
    options = ("--trace", "drive.csv", "--no-faults", "--free-run", "0", "--platforms", platforms, "-o", report)
    assert main(["compare", ROOF, "-s", f"vehicle:{vehicle}", *options]) == 0
    (behaviour,) = read_report(Path(report).read_bytes(), report).behaviour
    assert behaviour.values > 0
