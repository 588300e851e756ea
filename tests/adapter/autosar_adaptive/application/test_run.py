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


@pytest.fixture(scope="module")
def sent(built):
    """What the processes have sent, and what the simulation sends."""
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
