"""An independent implementation of DDS reads and writes the topics of a node."""

import json
import subprocess
from pathlib import Path

import pytest

from scripts import ros2_environment
from tests.adapter.ros2.built import USUAL, running
from tests.adapter.ros2.other_end import ACTIVATE, CONFIGURE
from tests.needs import ros2
from tests.reference_tools import checked_with

pytestmark = ros2

PROGRAM = Path(__file__).with_name("cyclonedds_program.py")


@checked_with("cyclonedds", "Topics of the nodes are read and written by another implementation of DDS")
@pytest.mark.parametrize("language", USUAL)
def test_cyclonedds_is_heard_and_hears(language, tmp_path):
    with running(language, tmp_path, "eco_control_mpc") as peer:
        peer.bring("eco_control_mpc", CONFIGURE, ACTIVATE)
        peer.switch_on("eco_control_mpc")
        command = [str(ros2_environment.PYTHON), str(PROGRAM)]
        done = subprocess.run(command, env=peer.variables, capture_output=True, text=True, check=False, timeout=60)
        assert done.returncode == 0, done.stderr
        heard = json.loads(done.stdout)
        assert heard["proposal"] == pytest.approx(-20.0)
        assert heard["reaction"] == 0
        status = peer.finds(
            "eco_control_mpc: subscription vehicle/speed", lambda status: status["values"]["messages"] == "3"
        )
        assert status["values"]["incompatible QoS"] == "0"
