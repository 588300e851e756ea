"""Signals that end a command also end its processes, and remove its temporary files and folders."""

import signal
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FrameType
from typing import Any

_SIGNALS = tuple(getattr(signal, name) for name in ("SIGTERM", "SIGHUP") if hasattr(signal, name))
_interrupts: list[int] = []


@contextmanager
def ended_by_signals() -> Iterator[None]:
    """Within, a signal that ends the command unwinds it, as an interrupt from the keyboard does."""
    ending = [number for number in _SIGNALS if _replaced(number, signal.SIG_DFL, _end)]
    try:
        yield
    finally:
        for number in ending:
            signal.signal(number, signal.SIG_DFL)


@contextmanager
def remembering_interrupts() -> Iterator[None]:
    """Within, interrupts from the keyboard are remembered: a library may swallow the exception, as pydantic does while it builds validators."""
    _interrupts.clear()
    _replaced(signal.SIGINT, signal.default_int_handler, _interrupt)
    try:
        yield
    finally:
        _replaced(signal.SIGINT, _interrupt, signal.default_int_handler)


def was_interrupted() -> bool:
    """Whether an interrupt came since `remembering_interrupts` began."""
    return bool(_interrupts)


def _replaced(number: int, old: Any, new: Callable[[int, FrameType | None], Any]) -> bool:
    """Replace one handler of a signal by another. Return False where it is not there, and in threads, which have none."""
    if signal.getsignal(number) != old:
        return False
    try:
        signal.signal(number, new)
    except ValueError:  # the thread is not the main one
        return False
    return True


def _end(number: int, _: FrameType | None) -> None:
    raise SystemExit(128 + number)


def _interrupt(number: int, _: FrameType | None) -> None:
    _interrupts.append(number)
    raise KeyboardInterrupt
