"""Logs of python-can's other forms: its own CSV and SQLite tables, PCAN's TRC, and MDF 4."""

from collections.abc import Iterator
from io import StringIO
from pathlib import Path
from typing import Any

from can import Message
from can.io import CSVReader, SqliteReader, TRCReader
from can.util import dlc2len

from sigcat.errors import UsageError
from sigcat.gateway.frames import Frame, Passed, frame_of
from sigcat.gateway.logs.lines import Lines, TextLines, text_of
from sigcat.gateway.logs.problems import CutLine, DamagedLog, NoLog

_CSV_HEADER = b"timestamp,"
_NEEDS_ASAMMDF = "a log in MDF needs the package asammdf: run `pip install asammdf`"


class CsvLog:
    """The frames of a log in CSV. An exception is about one line; iterate again for those after it."""

    def __init__(self, lines: Lines) -> None:
        self._lines = lines

    def __iter__(self) -> Iterator[Frame | Passed]:
        for line in self._lines:
            if line.strip() and not line.startswith(_CSV_HEADER):
                yield from map(frame_of, CSVReader(StringIO(f"\n{text_of(line)}")))


class _Trc(TRCReader):
    """PCAN's reader, which does not pass over a line that it cannot read, nor take half a byte for one."""

    def _parse_line(self, line: str) -> Message | None:
        cells = tuple(line.split(maxsplit=self._num_columns))
        message = self._parse_cols(cells) if cells else None
        if message is None or message.is_remote_frame or not message.dlc:
            return message
        count = dlc2len(message.dlc)
        if len(message.data) < count:
            raise CutLine(f"it has {len(message.data)} of {count} bytes")
        if any(len(each) != 2 for each in line.split()[-count:]):
            raise CutLine("its data has half a byte")
        return message


class Trc:
    """The frames of a log of PCAN. An exception is about one line; iterate again for those after it."""

    def __init__(self, lines: Lines) -> None:
        self._reader = _Trc(TextLines(lines))  # type: ignore[arg-type]  # it iterates

    def __iter__(self) -> Iterator[Frame | Passed]:
        return map(frame_of, self._reader)


def sqlite_frames(path: Path) -> Iterator[Frame | Passed]:
    """The frames of a table `messages`. Raises NoLog or DamagedLog."""
    import sqlite3

    reader = SqliteReader(path)
    try:
        yield from _until_damaged(iter(reader), sqlite3.Error)
    finally:
        reader.stop()


def mdf_frames(path: Path) -> Iterator[Frame | Passed]:
    """The frames of all buses of CAN in a log in MDF 4. Raises UsageError, NoLog or DamagedLog."""
    from can.io import MF4Reader

    try:
        reader = MF4Reader(path)
    except NotImplementedError:
        raise UsageError(_NEEDS_ASAMMDF) from None
    except Exception as error:  # noqa: BLE001 — asammdf raises what the bytes make it meet
        raise NoLog(_first_line(error)) from None
    try:
        yield from _until_damaged(iter(reader), OSError)
    finally:
        reader.stop()


def _until_damaged(messages: Iterator[Any], of_file: type[Exception]) -> Iterator[Frame | Passed]:
    """Messages of a reader that cannot continue after an error."""
    count = 0
    while True:
        try:
            message = next(messages, None)
            if message is None:
                return
            frame = frame_of(message)
        except Exception as error:  # noqa: BLE001 — readers raise what the bytes make them meet
            if isinstance(error, of_file) and not count:
                raise NoLog(_first_line(error)) from None
            raise DamagedLog(f"frame {count + 1:,} cannot be read ({_first_line(error)})") from None
        count += 1
        yield frame


def _first_line(error: Exception) -> str:
    return str(error).partition("\n")[0][:200].rstrip(".") or type(error).__name__
