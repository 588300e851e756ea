"""EcoControl as three processes over SOME/IP, in a separate network, built from generated code."""

import pytest

from scripts import run_autosar
from scripts.recordings import WHOLE_DRIVE
from tests.adapter.autosar_adaptive.application.test_generate import STRICT
from tests.adapter.autosar_adaptive.bench.building import THREADS
from tests.needs import IS_SLOW_RUN, cmake, own_network, slow

pytestmark = [cmake, own_network]

SECONDS = WHOLE_DRIVE if IS_SLOW_RUN else 60
"""The whole drive has 11,780 steps of CoreAcc."""


@pytest.fixture(scope="module")
def built(tmp_path_factory):
    """EcoControl, compiled; a warning is an error."""
    folder = tmp_path_factory.mktemp("ecocontrol")
    run_autosar.generate_into(folder)
    run_autosar.build(folder, " ".join(STRICT), "-DCMAKE_BUILD_TYPE=None")
    return folder


@pytest.fixture(scope="module")
def sent(built):
    """Values that the processes have sent, and those that the simulation sends."""
    return run_autosar.run(built, SECONDS), run_autosar.simulated(built, SECONDS)


def test_all_that_is_sent_is_bit_for_bit_what_the_simulation_sends(sent):
    recorded, expected = sent
    assert run_autosar.differences(recorded, expected) == []
    assert len(recorded["Vehicle.ADAS.EcoControl.AccelerationRequest"]) >= (SECONDS - 12) * 20


def test_one_other_bit_is_noticed(sent):
    recorded, expected = sent
    name = "Vehicle.ADAS.EcoControl.AccelerationRequest"
    (time, value), *others = recorded[name]
    changed = {**recorded, name: [(time, f"{float(value) + 1e-6}"), *others]}
    assert len(run_autosar.differences(changed, expected)) == 1


@slow
def test_threads_of_the_applications_are_in_order(tmp_path, monkeypatch):
    """ThreadSanitizer is quiet in all three processes, and what they send is the same."""
    flags = " ".join(THREADS)
    reports = tmp_path / "reports"
    monkeypatch.setenv("TSAN_OPTIONS", f"log_path={reports}:exitcode=0")
    run_autosar.generate_into(tmp_path)
    run_autosar.build(tmp_path, f"-O1 -g {flags}", f"-DCMAKE_C_FLAGS=-O1 -g {flags}", "-DCMAKE_BUILD_TYPE=None")
    recorded = run_autosar.run(tmp_path, 30)
    assert [file.read_text() for file in tmp_path.glob("reports.*")] == []
    assert run_autosar.differences(recorded, run_autosar.simulated(tmp_path, 30)) == []
