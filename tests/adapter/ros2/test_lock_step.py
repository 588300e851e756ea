"""EcoControl's recorded drive, played in lock step to nodes over DDS: nothing is lost, and every bit is that of the simulation."""

import pytest

from scripts import recordings, run_ros2
from tests.adapter.ros2.built import LANGUAGES, player, workspace
from tests.needs import IS_SLOW_RUN, ros2

pytestmark = ros2

SECONDS = recordings.WHOLE_DRIVE if IS_SLOW_RUN else 20
"""The whole drive has 11,780 steps of CoreAcc, and the player fails if a message is lost."""
REQUEST = "Vehicle.ADAS.EcoControl.AccelerationRequest"


@pytest.fixture(scope="module")
def expected(tmp_path_factory):
    """Values that the simulation sends."""
    return recordings.simulated(tmp_path_factory.mktemp("simulated") / "out.csv", SECONDS)


@pytest.mark.parametrize("language", LANGUAGES)
def test_all_that_is_sent_is_bit_for_bit_what_the_simulation_sends(language, expected, tmp_path):
    sent = run_ros2.play(workspace(), player(), LANGUAGES[language], tmp_path, SECONDS)
    assert run_ros2.differences(sent, expected) == []
    assert len(sent[REQUEST]) >= (SECONDS - 12) * 20


def test_one_other_bit_and_one_other_time_are_noticed(expected):
    (time, value), *others = expected[REQUEST]
    for other in ((time, f"{float(value) + 1e-6}"), (time + 1, value)):
        assert len(run_ros2.differences({**expected, REQUEST: [other, *others]}, expected)) == 1
