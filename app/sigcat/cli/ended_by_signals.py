"""Signals that end a command also end its processes, and remove its temporary files and folders."""

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

_SIGNALS = tuple(getattr(signal, name) for name in ("SIGTERM", "SIGHUP") if hasattr(signal, name))
_interrupts: list[int] = []


@contextmanager
def ended_by_signals() -> Iterator[None]:
    """Within, a signal that ends the command unwinds it, as an interrupt from the keyboard does."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    ending = [number for number in _SIGNALS if signal.getsignal(number) == signal.SIG_DFL]
    for number in ending:
        signal.signal(number, _end)
    try:
        yield
    finally:
        for number in ending:
            signal.signal(number, signal.SIG_DFL)


@contextmanager
def remembering_interrupts() -> Iterator[None]:
    """Within, interrupts from the keyboard are remembered: a library may swallow the exception, as pydantic does while it builds validators."""
    _interrupts.clear()
    is_main = threading.current_thread() is threading.main_thread()
    if not is_main or signal.getsignal(signal.SIGINT) != signal.default_int_handler:
        yield
        return
    signal.signal(signal.SIGINT, _interrupt)
    try:
        yield
    finally:
        if signal.getsignal(signal.SIGINT) == _interrupt:
            signal.signal(signal.SIGINT, signal.default_int_handler)


def was_interrupted() -> bool:
    """Whether an interrupt came since `remembering_interrupts` began."""
    return bool(_interrupts)


def _end(number: int, _: FrameType | None) -> None:
    raise SystemExit(128 + number)


def _interrupt(number: int, _: FrameType | None) -> None:
    _interrupts.append(number)
    raise KeyboardInterrupt
