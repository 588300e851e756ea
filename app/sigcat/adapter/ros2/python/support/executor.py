"""Executor that runs the callbacks of a node."""

from contextlib import suppress
from typing import Any

from rclpy.exceptions import InvalidHandle
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node
from rclpy.task import Future

try:
    from rclpy.experimental import EventsExecutor
except ImportError:  # Humble and the first releases of rclpy for Jazzy do not have it
    EventsExecutor = None

LONGEST = 3600.0
"""Seconds for which events are waited for at once: without an end, some releases never wake."""


def spin_node(node: Node, failure: Future) -> None:
    """
    Run the callbacks of a node until its context ends, or until `failure` is done.

    Its exception is raised then, as is one of a callback that the executor calls itself.

    An executor of events gets each event, and does not ask every entity each time: that
    takes a fraction of the processor.
    """
    if EventsExecutor is None:
        executor: Any = MultiThreadedExecutor(num_threads=4)
        executor.add_node(node)
        failure.add_done_callback(lambda _: executor.wake())
        while node.context.ok() and not failure.done():
            executor.spin_once()
    else:
        executor = EventsExecutor()
        executor.add_node(node)
        while node.context.ok() and not failure.done():
            with suppress(InvalidHandle):  # an event of a topic that is gone, as after cleaning up
                executor.spin_until_future_complete(failure, LONGEST)
    if failure.done():
        failure.result()


def has_threads(node: Node) -> bool:
    """Answer whether messages are taken while a callback of the node waits for them."""
    return isinstance(node.executor, MultiThreadedExecutor)
