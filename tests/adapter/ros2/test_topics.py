"""Topics as others see them: what does not fit is counted and told, and who comes back is heard again."""

import pytest

from tests.adapter.ros2.built import USUAL, preloaded, running, workspace
from tests.adapter.ros2.other_end import ACTIVATE, CONFIGURE, Peer, peer
from tests.needs import ros2
from tests.waiting import wait_until

pytestmark = [ros2, pytest.mark.parametrize("language", USUAL)]

NODE = "core_acc"
SPEED = ("vehicle/speed", "eco_control_interfaces/msg/Speed")
PROPOSAL = ("eco_control_mpc/cycle500_ms", "eco_control_interfaces/msg/EcoControlMpcCycle500ms")
TIMEOUT = ("core_acc/proposal_timeout", "eco_control_interfaces/msg/ErrorStatus")
WARN = 1
PASSED, FAILED = 0, 1


def test_a_publisher_that_does_not_fit_is_counted_and_told(language, tmp_path):
    """The proposal is required within 1.5 s, which a publisher without a promise does not offer."""
    status = f"{NODE}: subscription {PROPOSAL[0]}"
    with running(language, tmp_path, NODE) as peer:
        peer.bring(NODE, CONFIGURE, ACTIVATE)
        assert peer.finds(status, lambda found: True)["values"]["incompatible QoS"] == "0"
        peer.advertise(*PROPOSAL, {})
        assert peer.finds(status, lambda found: found["values"]["incompatible QoS"] == "1")["worst"] == WARN
        peer.withdraw(PROPOSAL[0])
        peer.advertise(*PROPOSAL, {"deadline": 1.5})
        wait_until(lambda: peer.takers(PROPOSAL[0]), "the one that fits is taken")
        while peer.finds(status, lambda found: True)["values"]["messages"] == "0":
            peer.publish(PROPOSAL[0], {"acceleration_proposal": 1.0})  # before the node knows the other, it is lost
        peer.finds(status, lambda found: found["values"]["deadline missed"] != "0")


HANGS_ON_DEADLINES = """
#include <dlfcn.h>
#include <unistd.h>

struct Event
{
  const char * implementation;
  void * data;
  int type;
};

extern "C" int rmw_take_event(const Event * event, void * info, bool * is_taken)
{
  while (event->type == 1 || event->type == 7) {  // RMW_EVENT_REQUESTED_ and _OFFERED_DEADLINE_MISSED
    pause();
  }
  using Take = int (*)(const Event *, void *, bool *);
  return reinterpret_cast<Take>(dlsym(RTLD_NEXT, "rmw_take_event"))(event, info, is_taken);
}
"""


def test_missed_deadlines_are_counted_without_their_events(language, tmp_path, monkeypatch):
    """Taking one can wait forever for a thread of the middleware, and so can the receiver of the node."""
    workspace()
    monkeypatch.setenv("LD_PRELOAD", str(preloaded(HANGS_ON_DEADLINES, tmp_path)))
    status = f"{NODE}: subscription {PROPOSAL[0]}"
    with running(language, tmp_path, NODE) as peer:
        peer.bring(NODE, CONFIGURE, ACTIVATE)
        peer.advertise(*PROPOSAL, {"deadline": 1.5})

        def told(name: str) -> int:
            return int(peer.finds(status, lambda found: True)["values"][name])

        def is_taken_after(messages: int) -> bool:
            peer.publish(PROPOSAL[0], {"acceleration_proposal": 1.0})
            return told("messages") > messages

        wait_until(lambda: is_taken_after(0), "a proposal is taken")
        wait_until(lambda: told("deadline missed") > 0, "a deadline is missed")
        before = told("messages")
        wait_until(lambda: is_taken_after(before), "a proposal is taken after a deadline was missed")


def test_a_publisher_that_is_gone_and_comes_back_is_heard_again(language, tmp_path):
    status = f"{NODE}: subscription {SPEED[0]}"
    with running(language, tmp_path, NODE) as peer:
        peer.bring(NODE, CONFIGURE, ACTIVATE)
        sent = 0
        for _ in range(3):
            before = sent
            peer.advertise(*SPEED, {})
            while int(peer.finds(status, lambda found: True)["values"]["messages"]) <= before:
                peer.publish(SPEED[0], {"speed": 30.0})  # best effort: before the two know each other, it is lost
                sent += 1
            peer.withdraw(SPEED[0])


def sends_until(node: Peer, sender: Peer, is_right) -> None:
    """Proposals, until what the node tells of their time-out is right."""

    def is_told() -> bool:
        sender.publish(PROPOSAL[0], {"acceleration_proposal": 1.0})
        heard = node.heard(TIMEOUT[0])
        return bool(heard) and is_right(heard[-1]["status"])

    wait_until(is_told, "the time-out is logged")


def test_a_publisher_that_is_killed_is_an_error_of_the_core_which_heals_with_its_return(language, tmp_path):
    """SIGKILL: the middleware reports nothing, and only the core's own timeout detects it."""
    with running(language, tmp_path, NODE) as node:
        node.listen(*TIMEOUT, {"durability": "TRANSIENT_LOCAL"})
        node.bring(NODE, CONFIGURE, ACTIVATE)
        node.switch_on(NODE)
        with peer(node.variables) as sender:
            sender.advertise(*PROPOSAL, {"deadline": 1.5})
            sends_until(node, sender, lambda status: status == PASSED)
        node.hears(TIMEOUT[0], lambda heard: heard[-1]["status"] == FAILED)
        with peer(node.variables) as sender:
            sender.advertise(*PROPOSAL, {"deadline": 1.5})
            sends_until(node, sender, lambda status: status == PASSED)


def test_what_the_middleware_drops_is_counted(language, tmp_path):
    """The last value is all that the core wants, so the queue of the middleware has one place."""
    status = f"{NODE}: subscription {SPEED[0]}"
    with running(language, tmp_path, NODE) as node:
        node.bring(NODE, CONFIGURE, ACTIVATE)

        def told(*names: str) -> int:
            values = node.finds(status, lambda found: True)["values"]
            return sum(int(values[name]) for name in names)

        def is_taken() -> bool:
            node.publish(SPEED[0], {"speed": 30.0})
            return told("messages") > 0

        node.advertise(*SPEED, {})
        wait_until(is_taken, "the speed is taken")
        node.finds(status, lambda found: float(found["values"]["rate [Hz]"]) == 0)  # all of them are counted
        before, sent = told("messages", "skipped"), 0
        while told("skipped") == 0:
            for _ in range(100):
                node.publish(SPEED[0], {"speed": 30.0})
            sent += 100
        wait_until(lambda: told("messages", "skipped") == before + sent, "each message was taken or skipped")
