"""A node that cannot take any message. A program for the interpreter that has rclpy."""

from typing import Any

from eco_control_py.core_acc_node import CoreAccNode
from eco_control_py.support.function_node import spin


class Node(CoreAccNode):  # type: ignore[misc]  # generated where the test runs
    """CoreAcc, which refuses what it receives."""

    def hand_over(self, receive: Any, value: Any, *, wakes: bool = False) -> None:
        """Take nothing."""
        raise ValueError("rejected")


spin(Node, [])
