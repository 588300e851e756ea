"""An exception in a thread of a C++ node is logged and stays there: the node continues, and so do others in its process.

A library that comes before that of the core throws in its place.
"""

from contextlib import contextmanager

from scripts import run_ros2
from sigcat.players.ros2_domain import own_domain
from tests.adapter.ros2.built import NODES, preloaded, variables, workspace
from tests.adapter.ros2.other_end import ACTIVATE, CLEANUP, CONFIGURE, DEACTIVATE, peer
from tests.needs import ros2
from tests.waiting import wait_until

pytestmark = ros2

NODE = "eco_control_mpc"
THROWS = """#include <stdexcept>
extern "C" void EcoControlMpc_Adapter_{function}() {{ throw std::runtime_error("no more bread"); }}
"""
SPEED = ("vehicle/speed", "eco_control_interfaces/msg/Speed")


@contextmanager
def throwing(function, folder):
    """The node, in which a function of the core throws; the peer, and the number of log entries of a text."""
    library, told = preloaded(THROWS.format(function=function), folder), folder / "told.txt"
    built = workspace()
    with own_domain() as number:
        own = variables(built, number, folder)
        node = [built.prefix / "lib/eco_control" / NODES[NODE]]
        with run_ros2.started([node], {**own, "LD_PRELOAD": str(library)}, told), peer(own) as other:
            other.bring(NODE, CONFIGURE, ACTIVATE)
            yield other, lambda text: told.read_text().count(text)
            assert other.state(NODE) == "active"
            other.bring(NODE, DEACTIVATE, CLEANUP)


def test_a_call_that_throws_ends_the_calls(tmp_path):
    with throwing("SetInput_Step", tmp_path) as (other, told):
        other.switch_on(NODE)
        wait_until(lambda: told("The calls have ended: no more bread"), "it is logged")
        status = other.finds(f"{NODE}: scheduling", lambda found: found["message"])
        assert status["message"] == "the calls have ended: see the log"


def test_a_message_that_throws_is_left_out_and_the_next_one_is_received(tmp_path):
    with throwing("Receive_EgoSpd", tmp_path) as (other, told):
        other.advertise(*SPEED, {"reliability": "BEST_EFFORT"})
        wait_until(lambda: other.takers(SPEED[0]) == 1, "it takes the speed")
        other.publish(SPEED[0], {"speed": 1.0})
        wait_until(lambda: told("A message was not taken: no more bread") == 1, "it is logged")
        other.publish(SPEED[0], {"speed": 2.0})
        wait_until(lambda: told("A message was not taken: no more bread") == 2, "the next one, too")
