"""A trace in MCAP, as `mcap_file` and other tools write it: its messages in JSON, row by row as the CSV that everything else reads."""

import csv
import json
import struct
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

from sigcat import codes
from sigcat.errors import InputRefused, UsageError
from sigcat.findings import shown
from sigcat.runs.recording.times import seconds
from sigcat.runs.recording.trace_file import TIME

SUFFIX = ".mcap"
_MAGIC = b"\x89MCAP0\r\n"
_FIX = "Record topics as `sigcat simulate -o FILE.mcap` writes them: a message in JSON, with `value`."


class _Value(NamedTuple):
    time: int
    name: str
    cell: str


def as_csv(path: Path, folder: Path) -> Path:
    """A trace as it is, or, of one in MCAP, the same as CSV in a folder. Raises InputRefused, or UsageError without the package."""
    if path.suffix.lower() != SUFFIX:
        return path
    names = dict.fromkeys(each.name for each in _values(path))
    if not names:
        raise _refused(path, "The file must have messages in JSON with `value`, and has none.", _FIX)
    target = folder / f"{path.name}.csv"
    with target.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow([TIME, *names])
        for time, cells in _rows(path):
            writer.writerow([seconds(time), *(cells.get(name, "") for name in names)])
    return target


def _rows(path: Path) -> Iterator[tuple[int, dict[str, str]]]:
    """What came at one time is a row; what came twice at that time is in a row after it."""
    last, cells = -1, dict[str, str]()
    for time, name, cell in _values(path):
        if cells and (time != last or name in cells):
            yield last, cells
            cells = {}
        last, cells[name] = time, cell
    if cells:
        yield last, cells


def _values(path: Path) -> Iterator[_Value]:
    """In order of time. What has no `value`, as the calls of a run, is no signal."""
    try:
        from mcap.exceptions import McapError
        from mcap.reader import make_reader
    except ImportError:
        raise UsageError("MCAP needs the package `mcap`: run `pip install mcap`") from None
    try:
        with path.open("rb") as file:
            for _, channel, message in make_reader(file).iter_messages():
                if channel.message_encoding == "json":
                    yield from _value(path, channel.topic, message.log_time, message.data)
    except (McapError, EOFError, struct.error):
        raise _refused(
            path, f"The file must be in MCAP: {_why(path)}.", "Record it anew, or try `mcap recover`."
        ) from None


def _why(path: Path) -> str:
    with path.open("rb") as file:
        begins = file.read(len(_MAGIC)) == _MAGIC
    return "it ends in the middle, or is damaged" if begins else "it does not begin as such a file"


def _value(path: Path, topic: str, time: int, data: bytes) -> Iterator[_Value]:
    try:
        message = json.loads(data)
    except ValueError:
        raise _refused(path, f"A message of {shown(topic)} must be JSON, at {seconds(time)} s.", _FIX) from None
    if isinstance(message, dict) and "value" in message:
        yield _Value(time, topic.removeprefix("/").replace("/", "."), _cell(message))


def _cell(message: dict[str, Any]) -> str:
    """Where there is a symbol, it says what the number means. A number that JSON does not have is null."""
    value, symbol = message["value"], message.get("symbol")
    if isinstance(symbol, str):
        return symbol
    if value is None:
        return "nan"
    return value if isinstance(value, str) else json.dumps(value)


def _refused(path: Path, message: str, fix: str) -> InputRefused:
    return InputRefused(
        f"{path} cannot be used as a trace.", (codes.TRACE_MALFORMED.finding(message, str(path), fix=fix),)
    )
