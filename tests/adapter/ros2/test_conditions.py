"""Levels of the diagnostics follow what is so at present; simulated time may go back; two nodes of a function live side by side."""

import pytest

from tests.adapter.ros2.built import USUAL, running
from tests.adapter.ros2.other_end import ACTIVATE, CONFIGURE
from tests.needs import ros2
from tests.waiting import wait_until

pytestmark = [ros2, pytest.mark.parametrize("language", USUAL)]

NODE = "core_acc"
CYCLE = (f"{NODE}/cycle50_ms", "eco_control_interfaces/msg/CoreAccCycle50ms")
PROPOSAL = ("eco_control_mpc/cycle500_ms", "eco_control_interfaces/msg/EcoControlMpcCycle500ms")
OK, WARN = 0, 1
OFF = 0
HEARD = {"reliability": "BEST_EFFORT"}


def test_a_quality_that_does_not_fit_is_a_warning_for_as_long_as_it_does_not(language, tmp_path):
    status = f"{NODE}: subscription {PROPOSAL[0]}"
    with running(language, tmp_path, NODE) as peer:
        peer.bring(NODE, CONFIGURE, ACTIVATE)
        peer.advertise(*PROPOSAL, {})
        found = peer.finds(status, lambda found: found["level"] == WARN)
        assert "does not fit" in found["message"]
        begun = found["received"]
        later = peer.finds(status, lambda found: found["received"] >= begun + 4)
        assert later["level"] == WARN
        peer.withdraw(PROPOSAL[0])
        assert peer.finds(status, lambda found: found["level"] == OK)["values"]["incompatible QoS"] == "1"


def test_a_node_whose_mode_excludes_its_calls_misses_no_deadline(language, tmp_path):
    node = "eco_control_mpc"
    status = f"{node}: publisher {PROPOSAL[0]}"
    with running(language, tmp_path, node) as peer:
        peer.bring(node, CONFIGURE, ACTIVATE)
        peer.switch_on(node)
        peer.finds(status, lambda found: int(found["values"]["messages"]) > 0)
        peer.publish(f"{node}/mode_in", {"mode": OFF})
        late = peer.finds(status, lambda found: int(found["values"]["deadline missed"]) > 6)
        assert late["level"] == OK


def test_an_error_that_was_not_tested_is_no_fault(language, tmp_path):
    with running(language, tmp_path, NODE) as peer:
        peer.bring(NODE, CONFIGURE)
        found = peer.finds(f"{NODE}: CoreAcc_BrakePressureTimeout_ErrorSts", lambda found: True)
        assert (found["level"], found["message"]) == (OK, "NOT_TESTED")


def test_when_time_goes_back_the_calls_go_on_with_the_new_time(language, tmp_path):
    with running(language, tmp_path, NODE, arguments=("-p", "use_sim_time:=true")) as peer:
        peer.listen(*CYCLE, HEARD)
        peer.advertise("/clock", "rosgraph_msgs/msg/Clock", {})
        peer.bring(NODE, CONFIGURE, ACTIVATE)
        peer.switch_on(NODE)

        def ticks(first: int) -> None:
            at = iter(range(first, first + 10_000))

            def is_heard() -> bool:
                peer.publish("/clock", {"clock": {"sec": next(at), "nanosec": 0}})
                return any(first <= each["stamp"]["sec"] < first + 10_000 for each in peer.heard(CYCLE[0]))

            wait_until(is_heard, f"calls run from {first} s on")

        ticks(20_000)
        ticks(100)
        assert "the time has gone back" in (tmp_path / "nodes.txt").read_text().lower()


def test_a_second_node_of_a_function_has_topics_below_its_own_name(language, tmp_path):
    with running(language, tmp_path, NODE, arguments=("-r", "__node:=other")) as peer:
        peer.listen("other/cycle50_ms", CYCLE[1], HEARD)
        peer.bring("other", CONFIGURE, ACTIVATE)
        peer.advertise("other/mode_in", "eco_control_interfaces/msg/CoreAccModeIn", {"durability": "TRANSIENT_LOCAL"})
        peer.publish("other/mode_in", {"mode": 2})
        peer.hears("other/cycle50_ms", bool)
