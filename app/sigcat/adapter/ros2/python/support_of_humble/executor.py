"""What runs the callbacks of a node."""

from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node


def spin_node(node: Node, *, offers_methods: bool) -> None:
    """Run the callbacks of a node until its context ends, whether or not a method has to wait."""
    executor = MultiThreadedExecutor(num_threads=4)
    executor.add_node(node)
    executor.spin()


def has_threads(node: Node) -> bool:
    """Answer whether messages are taken while a callback of the node waits for them."""
    return isinstance(node.executor, MultiThreadedExecutor)
