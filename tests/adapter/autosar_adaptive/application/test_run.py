"""EcoControl as three processes over SOME/IP, in a network of its own, built from what is generated."""

import pytest

from scripts import run_autosar
from tests.adapter.autosar_adaptive.application.test_generate import STRICT
from tests.needs import IS_SLOW_RUN, cmake, own_network

pytestmark = [cmake, own_network]

SECONDS = run_autosar.WHOLE_DRIVE if IS_SLOW_RUN else 60
"""The whole drive has 11,780 steps of CoreAcc."""


@pytest.fixture(scope="module")
def built(tmp_path_factory):
    """EcoControl, compiled; a warning is an error."""
    folder = tmp_path_factory.mktemp("ecocontrol")
    run_autosar.generate_into(folder)
    run_autosar.build(folder, " ".join(STRICT), "-DCMAKE_BUILD_TYPE=None")
    return folder


def test_all_that_is_sent_is_bit_for_bit_what_the_simulation_sends(built):
    recorded = run_autosar.run(built, SECONDS)
    assert run_autosar.differences(recorded, run_autosar.simulated(built, SECONDS)) == []
    assert len(recorded["Vehicle.ADAS.EcoControl.AccelerationRequest"]) >= (SECONDS - 12) * 20


def test_one_other_bit_is_noticed(built):
    recorded = {name: list(values) for name, values in run_autosar.run(built, 10).items()}
    expected = run_autosar.simulated(built, 10)
    assert run_autosar.differences(recorded, expected) == []
    time, value = recorded["Vehicle.ADAS.EcoControl.AccelerationRequest"][3]
    recorded["Vehicle.ADAS.EcoControl.AccelerationRequest"][3] = (time, f"{float(value) + 1e-6}")
    assert len(run_autosar.differences(recorded, expected)) == 1
