"""A node that asks itself for its state and cannot take the answer; its argument says whether its executor has threads.

A program for the interpreter that has rclpy.
"""

import sys
from typing import Any

from eco_control_py.core_acc_node import CoreAccNode
from eco_control_py.support import executor
from eco_control_py.support.function_node import spin
from lifecycle_msgs.srv import GetState


class Node(CoreAccNode):  # type: ignore[misc]  # generated where the test runs
    """CoreAcc, with a timer that asks."""

    def __init__(self) -> None:
        super().__init__()
        client = self.use(GetState, "~/get_state")
        self.create_timer(0.1, lambda: self.ask(client, GetState.Request(), self.refuse))

    def refuse(self, response: Any, time: int) -> None:
        """Take no answer; a service without a server is not an error."""
        if response is not None:
            raise ValueError("rejected")


if sys.argv[1] == "True":
    executor.EventsExecutor = None
spin(Node, [])
