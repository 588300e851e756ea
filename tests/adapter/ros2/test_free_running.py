"""Nodes that run by their own clocks, for five minutes: what is missed or lost is counted and told."""

import time
from functools import partial

from tests.adapter.ros2.built import running
from tests.adapter.ros2.other_end import ACTIVATE, CONFIGURE
from tests.needs import ros2, slow
from tests.waiting import wait_until

pytestmark = [ros2, slow]

SECONDS = 300
CYCLE = 0.05
SPEED = ("vehicle/speed", "eco_control_interfaces/msg/Speed")


def counted(status, *names):
    return sum(int(status["values"][name]) for name in names)


def has_counted(least, status):
    return counted(status, "steps", "missed") >= least


def test_each_cycle_is_a_step_or_is_told_as_missed(tmp_path):
    with running("C++", tmp_path, "core_acc", "eco_control_mpc") as peer:
        before = time.monotonic()
        for node in ("eco_control_mpc", "core_acc"):
            peer.bring(node, CONFIGURE, ACTIVATE)
            peer.switch_on(node)
        begin = time.monotonic()
        peer.advertise(*SPEED, {"reliability": "BEST_EFFORT"})
        wait_until(lambda: peer.takers(SPEED[0]) == 2, "both take the speed")
        sent = 0
        while time.monotonic() < begin + SECONDS:
            peer.publish(SPEED[0], {"speed": float(sent % 100)})
            sent += 1
            time.sleep(CYCLE)
        for name, cycle in (("core_acc: CoreAcc_Step", CYCLE), ("eco_control_mpc: EcoControlMpc_Step", 10 * CYCLE)):
            due = (time.monotonic() - begin) / cycle
            status = peer.finds(name, partial(has_counted, due))
            assert counted(status, "steps", "missed") <= (time.monotonic() - before) / cycle + 1, status
        for node in ("core_acc", "eco_control_mpc"):
            peer.finds(f"{node}: subscription {SPEED[0]}", lambda found: counted(found, "messages", "skipped") == sent)
