"""FMUs in a comparison: at each communication point an output has what the simulation has sent before it."""

import shlex

import pytest

from scripts.cases import ROOT, RUNS
from sigcat.adapter.toolchain import toolchain
from sigcat.comparison.behaviour import at_points, in_lock_step
from sigcat.comparison.running.runner import Drive, Subject
from sigcat.comparison.running.table import RUNNERS
from sigcat.integration.reading import read_functions
from sigcat.platforms.deployment_file import DEFAULT_DEPLOYMENT
from sigcat.runs.prepare import prepare
from tests.comparison.ecocontrol import DRIVE, subject
from tests.function.shipped import interfaces
from tests.needs import cmake, fmpy

pytestmark = [cmake, fmpy]
SECOND = 10**9


def compared(made, drive, folder):
    """The comparison at the points of the FMU, and its recording."""
    reference, runner = RUNNERS["simulate"], RUNNERS["fmi"]
    expected = reference.play(reference.build(made, folder / "simulate", toolchain()), made, drive)
    found = runner.play(runner.build(made, folder / "fmi", toolchain()), made, drive)
    return in_lock_step(*at_points(expected.sent, found.sent, found.points)), found


def test_ecocontrol_is_that_of_the_simulation(tmp_path):
    behaviour, recording = compared(subject(), Drive(DRIVE, 40 * SECOND), tmp_path)
    assert behaviour.is_equal
    assert {each.name for each in behaviour.outputs} == {each.name for each in subject().prepared.connections.exits}
    assert not recording.last_words
    assert {each.call for each in recording.calls} == {"CoreAcc_Step", "EcoControlMpc_Step"}
    assert recording.supervised


def test_a_drive_begins_with_its_first_row(tmp_path):
    header, *rows = DRIVE.read_text().splitlines()[:3000]
    later = [f"{float(time) + 11.001:.3f},{rest}" for time, rest in (row.split(",", maxsplit=1) for row in rows)]
    (tmp_path / "later.csv").write_text("\n".join([header, *later, ""]))
    behaviour, recording = compared(subject(), Drive(tmp_path / "later.csv", 31 * SECOND), tmp_path)
    assert behaviour.is_equal
    assert recording.points[0] > 11 * SECOND


@pytest.mark.parametrize("name", ["structs_and_queues", "one_function_feeds_another", "windows_that_begin_with_a_mode"])
def test_functions_of_other_sets_are_those_of_the_simulation(name, tmp_path):
    folder = ROOT / RUNS.folder / name
    words = shlex.split((folder / "options").read_text())
    files = [folder / word for word in words[: words.index("--trace")]]
    functions = read_functions([(file.read_bytes(), str(file)) for file in files], interfaces()).functions
    made = Subject(functions, prepare(functions), DEFAULT_DEPLOYMENT)
    behaviour, _ = compared(made, Drive(folder / "trace.csv", SECOND // 2), tmp_path)
    assert behaviour.is_equal
