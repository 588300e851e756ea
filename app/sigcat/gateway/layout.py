"""Layout of messages: the bits of signals and their numbers; signals and messages are those of cantools."""

import struct
from collections.abc import Callable
from typing import Any, NamedTuple

_FLOATS = {16: "<e", 32: "<f", 64: "<d"}


class Bits(NamedTuple):
    """The place of a signal in the bytes of a message, taken as one whole number."""

    is_big: bool
    """Whether the first byte of the message is the greatest of the number."""
    shift: int
    mask: int
    size: int
    """Bytes that a frame must have to hold the signal."""


def width(message: Any) -> int:
    """Bytes of a message, with those of signals that end beyond it."""
    return max([int(message.length), *(_size(signal) for signal in message.signals)])


def bits(signal: Any, width: int) -> Bits:
    """The place of a signal in a message of so many bytes."""
    is_big = signal.byte_order == "big_endian"
    shift = width * 8 - _end(signal) if is_big else signal.start
    return Bits(is_big, shift, (1 << signal.length) - 1, _size(signal))


def _size(signal: Any) -> int:
    return -(-_end(signal) // 8)


def _end(signal: Any) -> int:
    """The bit after the last one; of a big-endian signal, bits are counted from the greatest of the first byte."""
    start: int = signal.start
    if signal.byte_order == "big_endian":
        start = start // 8 * 8 + 7 - start % 8
    return start + int(signal.length)


def numbers(signal: Any) -> Callable[[int], float]:
    """The number that bits of a signal are."""
    if signal.conversion.is_float:
        form, size = struct.Struct(_FLOATS[signal.length]), signal.length // 8
        return lambda found: float(form.unpack(found.to_bytes(size, "little"))[0])
    if signal.is_signed:
        sign = 1 << (signal.length - 1)
        return lambda found: found - ((found & sign) << 1)
    return lambda found: found
