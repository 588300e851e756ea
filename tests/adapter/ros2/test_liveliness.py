"""A publisher that is silent for longer than its lease is counted, and told in the diagnostics."""

import json
from functools import cache

import pytest

from tests.adapter.ros2.built import LANGUAGES, running
from tests.adapter.ros2.generated import ECOCONTROL, files
from tests.adapter.ros2.other_end import ACTIVATE, CONFIGURE, DEACTIVATE
from tests.needs import ros2, slow
from tests.waiting import wait_until

pytestmark = [ros2, slow, pytest.mark.parametrize("language", LANGUAGES)]

NODE = "core_acc"
PROPOSAL = ("eco_control_mpc/cycle500_ms", "eco_control_interfaces/msg/EcoControlMpcCycle500ms")
WARN = 1


@cache
def leased():
    """EcoControl, whose proposal has to be there every second, or its publisher is taken for dead."""
    document = json.loads(ECOCONTROL.read_bytes())
    topics = [topic for call in document["CommunicationList"] for topic in call["ROSTopicList"]]
    for topic in topics:
        if topic["TopicName"] == PROPOSAL[0]:
            topic["QualityOfService"] |= {"Liveliness": "manual_by_topic", "LeaseDuration": 1000}
    return files(json.dumps(document).encode())


def test_a_publisher_that_falls_silent_is_counted(language, tmp_path):
    status = f"{NODE}: subscription {PROPOSAL[0]}"
    with running(language, tmp_path, NODE, made=leased) as peer:
        peer.bring(NODE, CONFIGURE, ACTIVATE)
        peer.advertise(*PROPOSAL, {"deadline": 1.0, "liveliness": "MANUAL_BY_TOPIC", "lease": 1.0})

        def is_taken() -> bool:
            peer.publish(PROPOSAL[0], {"acceleration_proposal": 1.0})
            return int(peer.finds(status, lambda found: True)["values"]["messages"]) > 0

        wait_until(is_taken, "the proposal is taken")  # best effort: before the two know each other, it is lost
        lost = peer.finds(status, lambda found: int(found["values"]["liveliness lost"]) > 0)
        assert lost["worst"] == WARN


def test_a_node_that_falls_silent_tells_it_of_itself(language, tmp_path):
    """It publishes no more once it is deactivated."""
    status = f"eco_control_mpc: publisher {PROPOSAL[0]}"
    with running(language, tmp_path, "eco_control_mpc", made=leased) as peer:
        peer.bring("eco_control_mpc", CONFIGURE, ACTIVATE)
        peer.switch_on("eco_control_mpc")
        peer.finds(status, lambda found: int(found["values"]["messages"]) > 0)
        peer.bring("eco_control_mpc", DEACTIVATE)
        peer.finds(status, lambda found: int(found["values"]["liveliness lost"]) > 0)
