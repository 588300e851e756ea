"""A bag of ROS 2 (rosbag2 in MCAP) as a trace in CSV. Messages in CDR are decoded by the definitions in the file.

sigcat's own messages have the VSS path of each field in a comment of their definition. An error status has it in the name of its topic.
"""

import csv
import math
import re
import struct
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any, NamedTuple

import yaml

from sigcat import codes
from sigcat.adapter.host.shapes import Array, Record, Shape
from sigcat.errors import InputRefused, UsageError
from sigcat.findings import Finding, shown
from sigcat.function.function_json.conversion import IDENTITY, Linear
from sigcat.names import snake_case
from sigcat.runs.recording.cells import Unfit, cell_of, fitted
from sigcat.runs.recording.times import seconds
from sigcat.runs.recording.trace_file import TIME, Known, refused, refused_trace

METADATA = "metadata.yaml"
_SUFFIX = ".mcap"
_CDR = "cdr"
_EXTRA = "Bags of ROS 2 need the extra `mcap`: run `pip install 'sigcat[mcap]'`"
_PATH = re.compile(r"#\s*([A-Za-z]\w*(?:\.\w+)+)(?:\s+\[[^\]]*\])?")
_FIELD = re.compile(r"[A-Za-z][\w/]*(?:\[[<=\d]*\])?(?:<=\d+)?\s+([a-z]\w*)\s*(?:#.*)?")
_STAMPS = ("stamp", "header")
_STATUS = re.compile(r"_(?:ErrorSts|SftyCondSts)$")


class Column(NamedTuple):
    """A field of the messages of a topic, and the column that it becomes."""

    field: str
    """`twist.linear.x`, `covariance[0]`."""
    name: str
    way: Linear = IDENTITY
    """From the unit of the field to that of the column."""
    symbols: Mapping[int, str] = {}
    """Values of an enumeration by the numbers of the message, where it has others."""


BagColumns = Mapping[str, Sequence[Column]]
"""Columns of existing messages, by topic."""


class _Topic(NamedTuple):
    """The columns of a topic."""

    name: str
    columns: tuple[Column, ...]


def is_bag(path: Path) -> bool:
    """Return whether a path is a folder that `ros2 bag record` wrote, or a file in MCAP with messages in CDR."""
    if path.is_dir():
        return (path / METADATA).is_file()
    return path.suffix.lower() == _SUFFIX and path.is_file() and _has_cdr(path)


def bag_as_csv(path: Path, target: Path, known: Known, mapped: BagColumns) -> tuple[Finding, ...]:
    """Write the values of a bag that are received as CSV, with times from the first message on; return notes.

    `mapped` are the columns of existing messages, such as geometry_msgs/Twist. A row has the time at which the bag received the message. Raises InputRefused, or UsageError for a bag that is not in MCAP.
    """
    files = _files(path)
    topics: dict[str, _Topic] = {}
    unused: dict[str, None] = {}
    for file in files:
        for topic, definition in _definitions(file):
            columns = _mapped(topic, mapped) or _columns(topic, definition, known)
            if columns:
                topics[topic] = _Topic(topic, columns)
            else:
                unused[topic] = None
    names = dict.fromkeys(column.name for topic in topics.values() for column in topic.columns)
    if not names:
        message = f"The bag must have a topic with signals of the functions, and has {', '.join(unused) or 'no topic'}."
        raise refused_trace(
            path, message, "Record topics of generated nodes, whose definitions name the VSS path of each field."
        )
    with target.open("w", newline="", encoding="utf-8") as out:
        writer = csv.writer(out, lineterminator="\n")
        writer.writerow([TIME, *names])
        for time, cells in _rows(files, topics, known):
            writer.writerow([seconds(time), *(cells.get(name, "") for name in names)])
    if not unused:
        return ()
    message = f"Topics without signals of the functions are skipped: {', '.join(unused)}."
    return (codes.TRACE_COLUMN_UNUSED.finding(message, str(path)),)


def _files(path: Path) -> tuple[Path, ...]:
    if not path.is_dir():
        return (path,)
    try:
        described = yaml.safe_load((path / METADATA).read_bytes())["rosbag2_bagfile_information"]
        storage, names = str(described["storage_identifier"]), list(map(str, described["relative_file_paths"]))
    except (yaml.YAMLError, UnicodeDecodeError, KeyError, TypeError, RecursionError):
        raise refused_trace(
            path / METADATA, f"{METADATA} must be that of a bag of ROS 2.", "Run `ros2 bag reindex`."
        ) from None
    if storage != "mcap":
        raise UsageError(f"{path}: the bag must be in MCAP, not {shown(storage)}. Convert it with `ros2 bag convert`.")
    files = tuple(path / Path(name).name for name in names)
    for file in files:
        if not file.is_file():
            raise UsageError(f"{file}: {METADATA} names this file, and it does not exist. Run `ros2 bag reindex`.")
    return files


@contextmanager
def _damages(path: Path) -> Iterator[None]:
    """Report errors of the packages as a damaged bag."""
    import zstandard
    from mcap.exceptions import McapError

    try:
        yield
    except (
        McapError,
        EOFError,
        ValueError,
        LookupError,
        TypeError,
        RuntimeError,
        OSError,
        MemoryError,
        struct.error,
        zstandard.ZstdError,
    ) as error:
        message = f"The bag cannot be read: {str(error) or type(error).__name__}."
        raise refused_trace(path, message, "Record it again, or try `mcap recover`.") from None


def _has_cdr(path: Path) -> bool:
    """Return whether a file has a channel in CDR. A file that cannot be read has none: the reader of traces reports it."""
    try:
        return any(encoding == _CDR for _, encoding, _ in _channels(path))
    except (InputRefused, UsageError):
        return False


def _channels(path: Path) -> Iterator[tuple[str, str, str]]:
    """Topic, encoding of messages and definition of each channel."""
    try:
        from mcap.reader import make_reader
    except ImportError:
        raise UsageError(_EXTRA) from None
    with path.open("rb") as file, _damages(path):
        summary = make_reader(file).get_summary()
        if summary is None:
            raise refused_trace(path, "The bag has no summary: its recording was cut off.", "Run `mcap recover`.")
        for channel in summary.channels.values():
            schema = summary.schemas.get(channel.schema_id)
            yield channel.topic, channel.message_encoding, schema.data.decode() if schema else ""


def _definitions(path: Path) -> Iterator[tuple[str, str]]:
    return ((topic, definition) for topic, encoding, definition in _channels(path) if encoding == _CDR)


# -- columns ------------------------------------------------------------------------------------------------------


def _mapped(topic: str, mapped: BagColumns) -> tuple[Column, ...]:
    """Return the columns of an existing message; a relative topic of the deployment file is in any namespace."""
    for name, columns in mapped.items():
        if topic == name or (not name.startswith("/") and topic.endswith(f"/{name}")):
            return tuple(columns)
    return ()


def _columns(topic: str, definition: str, known: Known) -> tuple[Column, ...]:
    """Return the fields of a topic that are received."""
    fields = tuple(_fields(definition))
    found = tuple(Column(field, path) for field, path in fields if path in known.received)
    data = [field for field, _ in fields if field not in _STAMPS]
    if found or len(data) != 1:
        return found
    name = next((name for name in known.received if _is_topic_of(topic, name)), "")
    return (Column(data[0], name),) if name else ()


def _fields(definition: str) -> Iterator[tuple[str, str]]:
    """Yield each field of a message with the path in the comment above it, or an empty text."""
    path = ""
    for line in definition.splitlines():
        if line.startswith("==="):  # the definition of another message
            return
        text = line.strip()
        comment = _PATH.fullmatch(text)
        field = _FIELD.fullmatch(text)
        if field:
            yield field[1], path
        path = comment[1] if comment else ""


def _is_topic_of(topic: str, name: str) -> bool:
    """Return whether a topic is that of a status: `/core_acc/brake_pressure_timeout` of `CoreAcc_BrakePressureTimeout_ErrorSts`."""
    function, _, rest = _STATUS.sub("", name).partition("_")
    own = f"/{snake_case(function)}/{snake_case(rest)}"
    return _STATUS.search(name) is not None and f"/{topic}".endswith(own)


# -- rows ---------------------------------------------------------------------------------------------------------


def _rows(files: Sequence[Path], topics: Mapping[str, _Topic], known: Known) -> Iterator[tuple[int, dict[str, str]]]:
    """Yield rows by time; values of one topic at one time are in rows one after the other."""
    first = last = -1
    cells: dict[str, str] = {}
    for file in files:
        for topic, time, message in _messages(file, topics):
            if time < last:
                text = f"The message of {topic} at {seconds(time)} s must not be before the end of the file before it."
                raise refused_trace(file, text, "List the files of the bag in order of time.")
            first = time if first < 0 else first
            found = {column.name: _cell(file, topic, column, message, known, time) for column in topics[topic].columns}
            if cells and (time != last or not cells.keys().isdisjoint(found)):
                yield last - first, cells
                cells = {}
            last, cells = time, {**cells, **found}
    if cells:
        yield last - first, cells


def _messages(path: Path, topics: Mapping[str, _Topic]) -> Iterator[tuple[str, int, Any]]:
    try:
        from mcap_ros2.decoder import DecoderFactory
    except ImportError:
        raise UsageError(_EXTRA) from None
    from mcap.reader import make_reader

    with path.open("rb") as file, _damages(path):
        reader = make_reader(file, decoder_factories=[DecoderFactory()])
        for _, channel, message, decoded in reader.iter_decoded_messages(topics=list(topics)):
            yield channel.topic, message.log_time, decoded


def _cell(path: Path, topic: str, column: Column, message: Any, known: Known, time: int) -> str:
    """Return the cell of a field. Raises InputRefused."""
    shape = known.received[column.name]
    try:
        return cell_of(fitted(_value(message, column, shape), shape), shape)
    except AttributeError:
        text = f"The messages of {topic} must have the field {column.field}, as the deployment file says."
        raise refused_trace(path, text, "Correct its path in `ros2.messages`.") from None
    except Unfit as reason:
        text = f"{column.name} {reason}, in {topic} at {seconds(time)} s."
        finding = codes.TRACE_VALUE_UNFIT.finding(text, str(path), path=column.name, fix=reason.fix)
        raise refused(path, (finding,)) from None


def _value(message: Any, column: Column, shape: Shape) -> Any:
    """Return the value of a field, in the unit and with the names of its column. Raises AttributeError without the field."""
    value = message
    for name in re.findall(r"\w+", column.field):
        value = value[int(name)] if name.isdigit() else getattr(value, name)
    value = column.symbols.get(value, value) if column.symbols else _plain(value, shape)
    if column.way == IDENTITY or not isinstance(value, int | float) or not math.isfinite(value):
        return value
    return float(column.way(value))


def _plain(value: Any, shape: Shape) -> Any:
    """Return a value of a message as JSON has it: the members of a message are those of the struct, in their order."""
    if isinstance(shape, Array) and not isinstance(value, str):
        return [_plain(each, shape.element) for each in value]
    members = getattr(value, "__slots__", None)
    if isinstance(shape, Record) and members is not None and len(members) == len(shape.fields):
        pairs = zip(shape.fields, members, strict=True)
        return {name: _plain(getattr(value, member), inner) for (name, inner), member in pairs}
    return value
