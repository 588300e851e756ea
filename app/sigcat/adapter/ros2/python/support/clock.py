"""Time, as the core of a node has it: in nanoseconds."""

from threading import Condition
from time import monotonic_ns
from typing import Any, Optional

from builtin_interfaces.msg import Time as TimeMessage
from rclpy.clock import JumpThreshold
from rclpy.duration import Duration
from rclpy.node import Node


class Clock:
    """A clock on which a thread waits until something is due."""

    def __init__(self, node: Node) -> None:
        """Stamp messages with the time of the node."""
        self._node = node
        self._changed = Condition()
        self._is_stopped = False
        self._is_woken = False

    def now(self) -> int:
        """Answer the time of the core."""
        raise NotImplementedError

    def stamp(self) -> TimeMessage:
        """Answer the time for messages."""
        message: TimeMessage = self._node.get_clock().now().to_msg()
        return message

    @property
    def is_stopped(self) -> bool:
        """Answer whether all waiting has been ended."""
        return self._is_stopped

    def has_gone_back(self) -> bool:
        """
        Answer whether the time of messages has gone back since this was asked last.

        That of the core has not: it continues from where it was.
        """
        return False

    def start(self) -> None:
        """Let threads wait again."""
        with self._changed:
            self._is_stopped = False

    def stop(self) -> None:
        """End all waiting."""
        with self._changed:
            self._is_stopped = True
            self._changed.notify_all()

    def wake(self) -> None:
        """End the wait, as something may be due."""
        with self._changed:
            self._is_woken = True
            self._changed.notify_all()

    def wait_until(self, t: int) -> bool:
        """Wait until a time has come or something else may be due; False once it is stopped."""
        with self._changed:
            while not self._is_stopped and not self._is_woken:
                left = self._seconds_until(t)
                if left is not None and left <= 0.0:
                    break
                self._changed.wait(left)
            self._is_woken = False
            return not self._is_stopped

    def _seconds_until(self, t: int) -> Optional[float]:
        """Answer how long to wait for a time; None if that is not known."""
        raise NotImplementedError

    def close(self) -> None:
        """Forget about the node."""


class SteadyClock(Clock):
    """Time that is not set by a simulation."""

    LONGEST = 3600.0
    """Seconds that are waited at once."""

    def now(self) -> int:
        """Answer the time since some moment in the past."""
        return monotonic_ns()

    def _seconds_until(self, t: int) -> Optional[float]:
        return min((t - monotonic_ns()) / 1e9, self.LONGEST)


class SimulatedClock(Clock):
    """Time of the topic /clock; whoever waits is woken whenever it changes."""

    def __init__(self, node: Node) -> None:
        """Hear of every change of the node's time."""
        super().__init__(node)
        self._gone_back = 0
        self._is_back = False
        self._last = self._node_time()
        tick = Duration(nanoseconds=1)
        back = Duration(nanoseconds=-1)
        threshold = JumpThreshold(min_forward=tick, min_backward=back, on_clock_change=True)
        self._jumps = node.get_clock().create_jump_callback(
            threshold, post_callback=self._jumped
        )

    def _jumped(self, _: Any) -> None:
        t = self._node_time()
        if t < self._last:
            self._gone_back += self._last - t
            self._is_back = True
        self._last = t
        self.wake()

    def _node_time(self) -> int:
        return max(int(self._node.get_clock().now().nanoseconds), 0)

    def has_gone_back(self) -> bool:
        """Answer whether it has since this was asked last."""
        was, self._is_back = self._is_back, False
        return was

    def now(self) -> int:
        """Answer the time that /clock had last."""
        return self._node_time() + self._gone_back

    def close(self) -> None:
        """Hear of changes no more."""
        self._jumps.unregister()

    def _seconds_until(self, t: int) -> Optional[float]:
        return 0.0 if self.now() >= t else None


class LockStepClock(Clock):
    """Time that the service `~/step` sets, from 0 on."""

    def __init__(self, node: Node) -> None:
        """Begin at 0."""
        super().__init__(node)
        self._now = 0

    def now(self) -> int:
        """Answer the time that was set last."""
        return self._now

    def set_time(self, t: int) -> None:
        """Set the time."""
        self._now = t

    def stamp(self) -> TimeMessage:
        """Answer the time of the core, so that every run has the same stamps."""
        seconds, nanoseconds = divmod(self._now, 10 ** 9)
        return TimeMessage(sec=seconds, nanosec=nanoseconds)

    def _seconds_until(self, t: int) -> Optional[float]:
        return 0.0 if self._now >= t else None
