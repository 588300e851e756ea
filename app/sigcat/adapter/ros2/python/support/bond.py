"""The bond of a node with its lifecycle manager: heartbeats while the node is active."""

from typing import Any, Optional

from .function_node import FunctionNode

try:
    from bondpy.bondpy import Bond
except ImportError:  # nodes without it send no heartbeats
    Bond = None

PERIOD = 0.1
"""Seconds between two heartbeats."""
FOR_EVER = 1e6
"""Seconds without a heartbeat of the manager after which a bond ends: the manager watches the node."""


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

    def _stop(self) -> None:
        if self._bond is not None:
            self._bond.shutdown()
            # It leaves the executor a subscription whose messages it would take for those of others.
            self.destroy_subscription(self._bond.sub)
            self.destroy_publisher(self._bond.pub)
            self._bond = None
        super()._stop()
