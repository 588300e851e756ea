"""Finds a call that does not end in time, while it runs."""

from threading import Condition, Thread
from typing import Callable, Optional


class Watch:
    """A thread that has the core supervised when a call runs for too long, until it has ended."""

    def __init__(self, supervise: Callable[[], None]) -> None:
        """Watch nothing yet."""
        self._supervise = supervise
        self._changed = Condition()
        self._longest: Optional[float] = None
        self._is_stopped = False
        self._thread = Thread(target=self._run, daemon=True)
        self._thread.start()

    def begin(self, longest: Optional[int]) -> None:
        """Watch a call, which should take so many nanoseconds at most."""
        with self._changed:
            self._longest = None if longest is None else longest / 1e9 + 0.001
            self._changed.notify_all()

    def end(self) -> None:
        """Watch it no more."""
        self.begin(None)

    def stop(self) -> None:
        """End the thread."""
        with self._changed:
            self._is_stopped = True
            self._changed.notify_all()
        self._thread.join()

    def _run(self) -> None:
        while self._is_late():
            self._supervise()

    def _is_late(self) -> bool:
        """Wait until a call is late; False once it is stopped."""
        with self._changed:
            while not self._is_stopped:
                watched = self._longest
                has_changed = self._changed.wait(watched)
                if not has_changed and self._longest == watched:
                    return True
            return False
