"""Files of a bag of ROS 2: its topics with their definitions, and its messages by time.

rosbag2 stores them in MCAP or SQLite, in one file or in several. `ros2 bag record` compresses each file, or each message.
"""

import shutil
import struct
from collections import deque
from collections.abc import Iterator, Sequence
from contextlib import closing, contextmanager
from heapq import heappop, heappush
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import yaml

from sigcat.errors import NoRoom, UsageError
from sigcat.findings import shown
from sigcat.runs.recording.trace_file import refused_trace

if TYPE_CHECKING:
    import sqlite3

    from mcap.records import Schema
    from mcap_ros2.decoder import DecoderFactory

METADATA = "metadata.yaml"
SUFFIX = ".mcap"
_PACKED = ".zstd"
SUFFIXES = (SUFFIX, f"{SUFFIX}{_PACKED}", ".db3", f".db3{_PACKED}")
_MCAP, _SQLITE, _ZSTD = b"\x89MCAP", b"SQLite format 3\0", b"\x28\xb5\x2f\xfd"
"""First bytes of files; a message in CDR begins with 0."""
_STORAGES = ("mcap", "sqlite3")
_DEFINED = "ros2msg"
CDR = "cdr"
_EXTRA = "Bags of ROS 2 need the extra `mcap`: run `pip install 'sigcat[mcap]'`"
_REINDEX = "Run `ros2 bag reindex`."
_AGAIN = "Record the bag again."


class Topic(NamedTuple):
    """A topic with messages in CDR."""

    name: str
    definition: str
    """Text of the definition of its messages; empty if the file has none in the form of .msg files."""


class BagFile(NamedTuple):
    """A file of a bag."""

    path: Path
    first: int
    """Time of the first message; 0 if the file does not say it."""
    topics: tuple[Topic, ...]


class Message(NamedTuple):
    """A message, decoded."""

    path: Path
    topic: str
    time: int
    content: Any


_Head = tuple[int, int, Message, Iterator[Message]]
"""Time of the next message of an open file, the number of the file, the message, and those after it."""


def bag_files(path: Path, folder: Path) -> tuple[BagFile, ...]:
    """The files of a bag, by the time of their first messages. Compressed files are unpacked into a folder.

    Raises InputRefused, UsageError for a bag that is stored in another way, or NoRoom.
    """
    paths, counted = _described(path) if path.is_dir() else ((path,), frozenset())
    found = []
    for index, each in enumerate(paths):
        file = _unpacked(each, folder / f"{index}{SUFFIX}") if _begins(each, _ZSTD) else each
        with _damages(each):
            found.append(_sqlite_file(file) if _begins(file, _SQLITE) else _mcap_file(file))
    absent = sorted(counted - {topic.name for file in found for topic in file.topics})
    if absent:
        message = (
            f"{METADATA} counts messages of {', '.join(map(shown, absent))}, and no file of the bag has this topic."
        )
        raise refused_trace(path / METADATA, message, f"{_AGAIN} If the topic is not needed, run `ros2 bag reindex`.")
    return tuple(sorted(found, key=lambda each: each.first))


def is_cdr(path: Path) -> bool:
    """Whether a file in MCAP has a topic in CDR. Raises InputRefused, or UsageError without the package `mcap`."""
    with _damages(path):
        return bool(_mcap_file(path).topics)


def messages(files: Sequence[BagFile], topics: Sequence[str]) -> Iterator[Message]:
    """Yield the messages of these topics by time. Files of a split bag overlap a little: a file is opened when it is due.

    Raises InputRefused.
    """
    waiting = deque(files)
    heads: list[_Head] = []
    while waiting or heads:
        while waiting and (not heads or waiting[0].first <= heads[0][0]):
            _push(heads, -len(waiting), _messages(waiting.popleft().path, topics))
        if heads:
            _, number, message, rest = heappop(heads)
            yield message
            _push(heads, number, rest)


def _push(heads: list[_Head], number: int, stream: Iterator[Message]) -> None:
    message = next(stream, None)
    if message is not None:
        heappush(heads, (message.time, number, message, stream))


# -- the folder ---------------------------------------------------------------------------------------------------


def _described(path: Path) -> tuple[tuple[Path, ...], frozenset[str]]:
    """Return the files of a bag, and the topics in CDR that have messages by its metadata."""
    if not (path / METADATA).is_file():
        raise UsageError(f"{path}: the bag has no {METADATA}. {_REINDEX}")
    try:
        described = yaml.safe_load((path / METADATA).read_bytes())["rosbag2_bagfile_information"]
        storage, names = str(described["storage_identifier"]), list(map(str, described["relative_file_paths"]))
        compression = str(described.get("compression_format") or "zstd")
        counts = [
            (each["topic_metadata"], each["message_count"]) for each in described.get("topics_with_message_count") or ()
        ]
        counted = frozenset(
            str(topic["name"]) for topic, count in counts if topic["serialization_format"] == CDR and count
        )
    except (yaml.YAMLError, UnicodeDecodeError, KeyError, TypeError, AttributeError, RecursionError):
        raise refused_trace(path / METADATA, f"{METADATA} must be that of a bag of ROS 2.", _REINDEX) from None
    if storage not in _STORAGES:
        raise UsageError(
            f"{path}: the bag must be in MCAP or SQLite, not {shown(storage)}. Convert it with `ros2 bag convert`."
        )
    if compression != "zstd":
        raise UsageError(
            f"{path}: the bag must be compressed by zstd, not {shown(compression)}. Convert it with `ros2 bag convert`."
        )
    for name in names:
        if not (path / Path(name).name).is_file():
            raise UsageError(f"{path / METADATA}: the file {shown(name)} must be in the folder of the bag. {_REINDEX}")
    return tuple(dict.fromkeys(path / Path(name).name for name in names)), counted


def _begins(path: Path, magic: bytes) -> bool:
    with path.open("rb") as file:
        return file.read(len(magic)) == magic


def _unpacked(path: Path, target: Path) -> Path:
    """Decompress a file."""
    with path.open("rb") as file, target.open("wb") as out, _damages(path):
        import zstandard

        reader = zstandard.ZstdDecompressor().stream_reader(file, read_across_frames=True)
        try:
            shutil.copyfileobj(reader, out)
        except OSError as error:
            raise NoRoom(f"{path} cannot be unpacked: {error.strerror}. Let TMPDIR name another folder.") from None
    return target


@contextmanager
def _damages(path: Path) -> Iterator[None]:
    """Report errors of the packages as a damaged bag."""
    import sqlite3

    try:
        import zstandard
        from mcap.exceptions import McapError
    except ImportError:
        raise UsageError(_EXTRA) from None
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
        sqlite3.Error,
        struct.error,
        zstandard.ZstdError,
    ) as error:
        message = f"The bag cannot be read: {str(error) or type(error).__name__}."
        is_mcap = path.name.removesuffix(_PACKED).endswith(SUFFIX)
        raise refused_trace(path, message, "Record it again, or try `mcap recover`." if is_mcap else _AGAIN) from None


# -- MCAP ---------------------------------------------------------------------------------------------------------


def _mcap_file(path: Path) -> BagFile:
    from mcap.reader import make_reader

    with path.open("rb") as file:
        summary = make_reader(file).get_summary()
    if summary is None:
        raise refused_trace(path, "The bag has no summary: its recording was cut off.", "Run `mcap recover`.")
    schemas = {number: schema for number, schema in summary.schemas.items() if schema.encoding == _DEFINED}
    topics = (
        Topic(each.topic, schemas[each.schema_id].data.decode() if each.schema_id in schemas else "")
        for each in summary.channels.values()
        if each.message_encoding == CDR
    )
    return BagFile(path, summary.statistics.message_start_time if summary.statistics else 0, tuple(topics))


def _mcap_messages(path: Path, topics: Sequence[str]) -> Iterator[Message]:
    from mcap.reader import make_reader
    from mcap_ros2.decoder import DecoderFactory

    decoders = DecoderFactory()
    with path.open("rb") as file:
        for schema, channel, message in make_reader(file, validate_crcs=True).iter_messages(topics=topics):
            yield _message(path, channel.topic, message.log_time, decoders, schema, message.data)


# -- SQLite -------------------------------------------------------------------------------------------------------

_TABLES = "SELECT name FROM sqlite_master WHERE type = 'table'"
_TOPICS = "SELECT id, name, type FROM topics WHERE serialization_format = 'cdr' ORDER BY id"
_DEFINITIONS = "SELECT topic_type, encoded_message_definition FROM message_definitions WHERE encoding = ?"
_MESSAGES = "SELECT topic_id, timestamp, data FROM messages WHERE topic_id IN ({}) ORDER BY timestamp, id"


def _sqlite_file(path: Path) -> BagFile:
    with _database(path) as database:
        schemas = _schemas(database)
        (first,) = database.execute("SELECT min(timestamp) FROM messages").fetchone()
    topics = (Topic(name, schema.data.decode()) for name, schema in schemas.values())
    return BagFile(path, int(first or 0), tuple(topics))


def _sqlite_messages(path: Path, topics: Sequence[str]) -> Iterator[Message]:
    from mcap_ros2.decoder import DecoderFactory

    decoders = DecoderFactory()
    with _database(path) as database:
        schemas = {number: each for number, each in _schemas(database).items() if each[0] in topics}
        numbers = ", ".join(map(str, schemas))
        for number, time, data in database.execute(_MESSAGES.format(numbers)):
            name, schema = schemas[number]
            if not isinstance(time, int) or not isinstance(data, bytes):
                raise refused_trace(path, f"A message of {name} must have a time and bytes.", _AGAIN)
            yield _message(path, name, time, decoders, schema, data)


@contextmanager
def _database(path: Path) -> Iterator["sqlite3.Connection"]:
    import sqlite3

    with closing(sqlite3.connect(f"{path.absolute().as_uri()}?mode=ro", uri=True)) as database:
        yield database


def _schemas(database: "sqlite3.Connection") -> dict[int, tuple[str, "Schema"]]:
    """Name and schema of each topic, by its number. Releases before Iron store no definitions."""
    from mcap.records import Schema

    tables = {name for (name,) in database.execute(_TABLES)}
    definitions = dict(database.execute(_DEFINITIONS, (_DEFINED,))) if "message_definitions" in tables else {}
    return {
        int(number): (name, Schema(int(number), definitions.get(kind, "").encode(), _DEFINED, kind))
        for number, name, kind in database.execute(_TOPICS)
    }


# -- messages -----------------------------------------------------------------------------------------------------


def _messages(path: Path, topics: Sequence[str]) -> Iterator[Message]:
    with _damages(path):
        yield from _sqlite_messages(path, topics) if _begins(path, _SQLITE) else _mcap_messages(path, topics)


def _message(
    path: Path, topic: str, time: int, decoders: "DecoderFactory", schema: "Schema | None", data: bytes
) -> Message:
    """Decode a message, which may be compressed. Raises InputRefused."""
    import zstandard

    try:
        decode = decoders.decoder_for(CDR, schema)
    except Exception as error:  # noqa: BLE001 — the parser of definitions has its own
        raise refused_trace(path, f"The definition of {topic} is invalid: {error}.", _AGAIN) from None
    if decode is None:
        raise refused_trace(path, f"The messages of {topic} have no definition.", _AGAIN)
    try:
        return Message(path, topic, time, decode(zstandard.decompress(data) if data.startswith(_ZSTD) else data))
    except Exception:  # noqa: BLE001 — generated decoders raise what the bytes make them raise
        message = f"The message of {topic} at {time / 10**9:.9f} s does not fit its definition, or is damaged."
        raise refused_trace(path, message, _AGAIN) from None
