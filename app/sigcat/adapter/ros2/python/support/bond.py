"""The bond of a node with its lifecycle manager: heartbeats while the node is active."""

from typing import Any, Optional

from rclpy.duration import Duration

from .function_node import FunctionNode

try:
    from bondpy.bondpy import Bond
except ImportError:  # nodes without it send no heartbeats
    Bond = None

PERIOD = 0.1
"""Seconds between two heartbeats."""
FOR_EVER = 1e6
"""Seconds without a heartbeat of the manager that end a bond: the manager watches the node."""
ANSWER = 0.1
"""Seconds for which a node that ends waits for its manager, as in bondcpp."""


class BondedNode(FunctionNode):
    """A node that its lifecycle manager watches."""

    _bond: Optional[Any] = None

    def _start_calls(self) -> None:
        super()._start_calls()
        if Bond is not None:
            self._bond = Bond(self, 'bond', self.get_name())
            self._bond.heartbeat_period = PERIOD
            self._bond.heartbeat_timeout = FOR_EVER
            self._bond.start()

    def prepare_end(self) -> None:
        """Tell the manager that the node ends."""
        bond, self._bond = self._bond, None
        if bond is not None:
            bond.break_bond()
            bond.wait_until_broken(Duration(seconds=ANSWER))
            bond.is_shutdown = True  # it publishes nothing afterwards

    def _stop(self) -> None:
        bond, self._bond = self._bond, None
        if bond is not None and self.context.ok():
            bond.shutdown()
            # It leaves the executor a subscription, whose messages it would take for others.
            self.destroy_subscription(bond.sub)
            self.destroy_publisher(bond.pub)
        elif bond is not None:
            bond.is_shutdown = True
        super()._stop()
