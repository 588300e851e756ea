"""SAE J1939: messages are found by their parameter group number (PGN), whatever source and priority frames have, and messages that
are longer than a frame are put together from the frames of the transport protocol."""

from collections.abc import Iterable, Iterator, Mapping
from typing import Any, NamedTuple

from sigcat.gateway.frames import Frame, Passed

_DESTINATION_SPECIFIC = 240
"""PDU formats below it have a destination in the identifier, which is not part of the PGN."""
_CONNECTION, _DATA = 0xEC00, 0xEB00
"""PGNs of the transport protocol."""
_REQUEST_TO_SEND, _BROADCAST, _ABORT = 16, 32, 255
_BYTES = 7
"""Bytes of a message in each frame of data, behind its number."""
_MOST_OPEN = 1000
"""Messages that are put together at a time."""


def pgn(identifier: int) -> int:
    """The PGN of an identifier."""
    group = identifier >> 8 & 0x3FFFF
    return group if group >> 8 & 0xFF >= _DESTINATION_SPECIFIC else group & 0x3FF00


def by_pgn(messages: Iterable[tuple[int, Any]]) -> Mapping[int, Any]:
    """Meanings by PGN, of pairs of an identifier and what it means; a PGN of several identifiers is left out."""
    found: dict[int, list[Any]] = {}
    for identifier, meaning in messages:
        found.setdefault(pgn(identifier), []).append(meaning)
    return {group: meanings[0] for group, meanings in found.items() if len(meanings) == 1}


class _Open(NamedTuple):
    """A message that is put together."""

    group: int
    size: int
    data: bytearray


def assembled(frames: Iterable[Frame | Passed]) -> Iterator[Frame | Passed]:
    """Frames, with each message of the transport protocol as one frame behind its last part; its parts are `transport`."""
    waiting: dict[tuple[str, int], _Open] = {}
    for frame in frames:
        if isinstance(frame, Passed) or not frame.is_extended or pgn(frame.identifier) not in (_CONNECTION, _DATA):
            yield frame
            continue
        yield Passed("transport")
        key = frame.channel, frame.identifier & 0xFFFF  # its destination and its source
        if pgn(frame.identifier) == _CONNECTION:
            _connect(waiting, key, frame.data)
        elif (part := waiting.get(key)) is not None:
            whole = _add(part, frame.data)
            if whole is None or len(whole) == part.size:
                del waiting[key]
            if whole is not None and len(whole) == part.size:
                yield _message(frame, part.group, bytes(whole))


def _connect(waiting: dict[tuple[str, int], _Open], key: tuple[str, int], data: bytes) -> None:
    """Begin a message, or give it up."""
    if len(data) < 8:
        return
    if data[0] in (_REQUEST_TO_SEND, _BROADCAST):
        if len(waiting) >= _MOST_OPEN:
            waiting.pop(next(iter(waiting)))
        waiting[key] = _Open(int.from_bytes(data[5:8], "little"), int.from_bytes(data[1:3], "little"), bytearray())
    elif data[0] == _ABORT:
        waiting.pop(key, None)


def _add(part: _Open, data: bytes) -> bytearray | None:
    """The data of a message with its next bytes; None if a part is missing."""
    if not data or data[0] != len(part.data) // _BYTES + 1:
        return None
    part.data.extend(data[1 : 1 + min(_BYTES, part.size - len(part.data))])
    return part.data


def _message(last: Frame, group: int, data: bytes) -> Frame:
    """A message as one frame, with the priority, destination and source of its parts."""
    destination = 0 if group >> 8 & 0xFF >= _DESTINATION_SPECIFIC else last.identifier & 0xFF00
    identifier = last.identifier & 0x1C0000FF | group << 8 | destination
    return Frame(last.time, identifier, True, data, last.channel)
