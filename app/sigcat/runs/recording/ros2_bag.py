"""A bag of ROS 2 (rosbag2) as a trace in CSV. Messages in CDR are decoded by the definitions in the file.

sigcat's own messages have the VSS path of each field in a comment of their definition. An error status has it in the name of its topic.
"""

import csv
import math
import re
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from sigcat import codes
from sigcat.adapter.host.shapes import Array, Record, Shape
from sigcat.errors import InputRefused, UsageError
from sigcat.findings import Finding
from sigcat.function.function_json.conversion import IDENTITY, Linear, between
from sigcat.names import snake_case
from sigcat.runs.recording.bag_files import METADATA, SUFFIX, SUFFIXES, BagFile, Message, bag_files, is_cdr, messages
from sigcat.runs.recording.cells import Unfit, cell_of, fitted
from sigcat.runs.recording.times import seconds
from sigcat.runs.recording.trace_file import TIME, Known, refused, refused_trace
from sigcat.temporary_files import temporary_folder

_PATH = re.compile(r"#\s*(?P<path>[A-Za-z]\w*(?:\.\w+)+)(?:\s+\[(?P<unit>[^\]]*)\])?")
_FIELD = re.compile(r"[A-Za-z][\w/]*(?:\[[<=\d]*\])?(?:<=\d+)?\s+([a-z]\w*)\s*(?:#.*)?")
_STAMPS = ("stamp", "header")
_STATUS = re.compile(r"_(?:ErrorSts|SftyCondSts)$")
_UNDEFINED = (
    "Convert the bag to MCAP with `ros2 bag convert`, where the packages of its messages are installed: "
    "ROS 2 before Iron stores no definitions in SQLite."
)


class Column(NamedTuple):
    """A field of the messages of a topic, and the column that it becomes."""

    field: str
    """`twist.linear.x`, `covariance[0]`."""
    name: str
    way: Linear = IDENTITY
    """From the unit of the field to that of the column."""
    symbols: Mapping[int, str] = {}
    """Values of an enumeration by the numbers of the message, where it has others."""


class _Field(NamedTuple):
    """A field of a message, with the signal that its definition names."""

    name: str
    path: str
    unit: str


BagColumns = Mapping[str, Sequence[Column]]
"""Columns of existing messages, by topic."""


def is_bag(path: Path) -> bool:
    """Return whether a path is a folder that `ros2 bag record` wrote, or a file of one.

    A file in MCAP has messages in CDR. One that cannot be read has none: the reader of traces reports it.
    """
    if path.is_dir():
        return any(each.name == METADATA or each.name.endswith(SUFFIXES) for each in path.iterdir())
    if path.suffix.lower() != SUFFIX or not path.is_file():
        return path.name.endswith(SUFFIXES) and path.is_file()
    try:
        return is_cdr(path)
    except (InputRefused, UsageError):
        return False


def bag_as_csv(path: Path, target: Path, known: Known, mapped: BagColumns) -> tuple[Finding, ...]:
    """Write the values of a bag that are received as CSV, with times from the first message on; return notes.

    `mapped` are the columns of existing messages, such as geometry_msgs/Twist. A row has the time at which the bag received the message.
    Raises InputRefused, UsageError for a bag that is stored in another way, or NoRoom.
    """
    with temporary_folder("sigcat-bag-files-") as folder:
        files = bag_files(path, Path(folder))
        return _as_csv(path, files, target, known, mapped)


def _as_csv(
    path: Path, files: Sequence[BagFile], target: Path, known: Known, mapped: BagColumns
) -> tuple[Finding, ...]:
    definitions = _definitions(files)
    found = {name: _mapped(name, mapped) or _columns(path, name, text, known) for name, text in definitions.items()}
    topics = {name: columns for name, columns in found.items() if columns}
    unused = [name for name in definitions if name not in topics]
    undefined = [name for name in topics or definitions if not definitions[name]]
    if undefined:
        message = f"The bag has no definition of the messages of {', '.join(undefined)}."
        raise refused_trace(path, message, _UNDEFINED)
    _refuse_ambiguous(path, topics)
    names = dict.fromkeys(column.name for columns in topics.values() for column in columns)
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


def _refuse_ambiguous(path: Path, topics: BagColumns) -> None:
    """Raise InputRefused if two topics have the same signal."""
    first: dict[str, str] = {}
    for topic, columns in topics.items():
        for column in columns:
            other = first.setdefault(column.name, topic)
            if other != topic:
                message = f"The bag must have one topic with {column.name}, and has {other} and {topic}."
                raise refused_trace(path, message, "Record one of them, or filter the bag with `ros2 bag convert`.")


def _definitions(files: Sequence[BagFile]) -> Mapping[str, str]:
    """The definition of each topic, from the first file that has one."""
    found: dict[str, str] = {}
    for topic in (topic for file in files for topic in file.topics):
        found[topic.name] = found.get(topic.name) or topic.definition
    return found


# -- columns ------------------------------------------------------------------------------------------------------


def _mapped(topic: str, mapped: BagColumns) -> tuple[Column, ...]:
    """Return the columns of an existing message; a relative topic of the deployment file is in any namespace."""
    for name, columns in mapped.items():
        if topic == name or (not name.startswith("/") and topic.endswith(f"/{name}")):
            return tuple(columns)
    return ()


def _columns(bag: Path, topic: str, definition: str, known: Known) -> tuple[Column, ...]:
    """Return the fields of a topic that are received. Raises InputRefused for a unit that does not fit."""
    fields = tuple(_fields(definition))
    found = tuple(
        Column(field.name, field.path, _way(bag, field, known)) for field in fields if field.path in known.received
    )
    data = [field.name for field in fields if field.name not in _STAMPS]
    if found or len(data) != 1:
        return found
    name = next((name for name in known.received if _is_topic_of(topic, name)), "")
    return (Column(data[0], name),) if name else ()


def _way(bag: Path, field: _Field, known: Known) -> Linear:
    """Return the way from the unit that the definition names to that of the signal."""
    unit = known.units.get(field.path, "")
    way = between(field.unit or unit, unit)
    if way is None:
        message = f"{field.path} cannot be converted from {field.unit}, as the bag has it, to {unit or 'no unit'}."
        raise refused_trace(bag, message, "Record the bag with the unit of the catalogue.")
    return way


def _fields(definition: str) -> Iterator[_Field]:
    """Yield each field of a message, with the path and the unit in the comment above it."""
    path = unit = ""
    for line in definition.splitlines():
        if line.startswith("==="):  # the definition of another message
            return
        text = line.strip()
        comment = _PATH.fullmatch(text)
        field = _FIELD.fullmatch(text)
        if field:
            yield _Field(field[1], path, unit)
        path, unit = (comment["path"], comment["unit"] or "") if comment else ("", "")


def _is_topic_of(topic: str, name: str) -> bool:
    """Return whether a topic is that of a status: `/core_acc/brake_pressure_timeout` of `CoreAcc_BrakePressureTimeout_ErrorSts`."""
    function, _, rest = _STATUS.sub("", name).partition("_")
    own = f"/{snake_case(function)}/{snake_case(rest)}"
    return _STATUS.search(name) is not None and f"/{topic}".endswith(own)


# -- rows ---------------------------------------------------------------------------------------------------------


def _rows(files: Sequence[BagFile], topics: BagColumns, known: Known) -> Iterator[tuple[int, dict[str, str]]]:
    """Yield rows by time; values of one topic at one time are in rows one after the other."""
    first = last = -1
    cells: dict[str, str] = {}
    for message in messages(files, list(topics)):
        time = message.time
        first = time if first < 0 else first
        found = {column.name: _cell(message, column, known) for column in topics[message.topic]}
        if cells and (time != last or not cells.keys().isdisjoint(found)):
            yield last - first, cells
            cells = {}
        last, cells = time, {**cells, **found}
    if cells:
        yield last - first, cells


def _cell(message: Message, column: Column, known: Known) -> str:
    """Return the cell of a field. Raises InputRefused."""
    shape, path = known.received[column.name], message.path
    try:
        return cell_of(fitted(_value(message.content, column, shape), shape), shape)
    except AttributeError:
        text = f"The messages of {message.topic} must have the field {column.field}, as the deployment file says."
        raise refused_trace(path, text, "Correct its path in `ros2.messages`.") from None
    except Unfit as reason:
        text = f"{column.name} {reason}, in {message.topic} at {seconds(message.time)} s."
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
