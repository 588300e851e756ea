"""Tables of the library: columns of traces, and steps that write the text of a value, packed as C has them."""

import json
import struct
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import NamedTuple

from sigcat.adapter.host.shapes import SECONDS, Array, Number, Shape, packing
from sigcat.runs.recording.csv_file import quoted

SKIPPED, LEFT = 0, 13
NONE = 2**32 - 1
_KINDS = (
    "", "boolean", "uint8", "int8", "uint16", "int16", "uint32", "int32", "uint64", "int64", "float", "double", "seconds",
)  # fmt: skip
_PLAIN, _JSON, _NULLS, _WORD, _NO_STEP = 0, 1, 2, 3, 16
_COLUMN, _SYMBOL, _STEP, _SHAPE = (struct.Struct(form) for form in ("=5I", "=IIq", "=4I", "=5I"))
_NUMBER_ROOM = 40
_MOST_STEPS = 100_000


class Unfit(Exception):
    """A shape that the library does not write."""


class ColumnTables(NamedTuple):
    """Tables for reading."""

    columns: bytes
    targets: bytes
    symbols: bytes
    texts: bytes
    total: int
    row_room: int
    """Bytes that a row may take."""


class Texts:
    """Texts and symbols, by their places."""

    def __init__(self) -> None:
        self._texts = bytearray()
        self._symbols: list[bytes] = []
        self._known: dict[tuple[tuple[str, int], ...], int] = {}

    def place(self, text: str) -> tuple[int, int]:
        """The place and size of a text."""
        data = text.encode()
        self._texts += data
        return len(self._texts) - len(data), len(data)

    def symbols(self, symbols: tuple[tuple[str, int], ...]) -> int:
        """The first of some symbols."""
        if symbols not in self._known:
            self._known[symbols] = len(self._symbols)
            self._symbols += [_SYMBOL.pack(*self.place(text), number) for text, number in symbols]
        return self._known[symbols]

    @property
    def tables(self) -> tuple[bytes, bytes]:
        """Symbols, and texts."""
        return b"".join(self._symbols) or bytes(_SYMBOL.size), bytes(self._texts) or b"\0"


def column_tables(columns: Iterable[tuple[Shape | None, Sequence[int]]]) -> ColumnTables:
    """Tables of columns; each has the targets that get its values. One without a shape is skipped."""
    texts, packed, targets, room = Texts(), [], list[int](), 12
    for shape, listed in columns:
        kind = SKIPPED if shape is None else _kind(shape)
        symbols = shape.symbols if isinstance(shape, Number) else ()
        packed.append(_COLUMN.pack(kind, len(targets), len(listed), texts.symbols(symbols), len(symbols)))
        targets += listed
        room += 12 * max(len(listed), 1) + 12
    return ColumnTables(
        b"".join(packed), struct.pack(f"={len(targets) + 1}I", *targets, 0), *texts.tables, len(packed), room
    )


def _kind(shape: Shape) -> int:
    return _KINDS.index(shape.datatype) if isinstance(shape, Number) else LEFT


# -- writing ------------------------------------------------------------------------------------------------------


class ShapeTables(NamedTuple):
    """Tables for writing."""

    exits: bytes
    entries: bytes
    calls: bytes
    steps: bytes
    symbols: bytes
    texts: bytes
    counts: tuple[int, int, int, int]
    """Numbers of exits, entries, calls and columns."""
    longest: int
    """Bytes of the longest text of a value."""


Placed = tuple[Shape, int | None]
"""A shape, and its column or channel; None: it is not written."""


def csv_tables(
    exits: Sequence[Placed], entries: Sequence[Shape], calls: Sequence[str], columns: int
) -> ShapeTables:  # fmt: skip
    """Tables for CSV. Raises Unfit."""
    named = [(quoted(call), None) for call in calls]
    return _shape_tables(exits, [(shape, None) for shape in entries], named, columns, _csv_parts)


def mcap_tables(
    exits: Sequence[Placed], entries: Sequence[Placed], calls: Sequence[tuple[str, int | None]]
) -> ShapeTables:
    """Tables for MCAP; of each call its name and channel. Raises Unfit."""
    return _shape_tables(exits, entries, calls, 0, _message_parts)


_Part = str | tuple[int, int, tuple[tuple[str, int], ...]]
"""A text, or a number: its kind, style and symbols."""


def _shape_tables(
    exits: Sequence[Placed], entries: Sequence[Placed], calls: Sequence[tuple[str, int | None]], columns: int,
    parts_of: Callable[[Shape], Sequence["_Part"]],
) -> ShapeTables:  # fmt: skip
    texts, steps, longest = Texts(), list[bytes](), 0
    tables = []
    for group in (exits, entries):
        rows = []
        for shape, place in group:
            parts = parts_of(shape) if place is not None else ()
            begin = len(steps)
            steps += [_step(part, texts) for part in parts]
            if len(steps) > _MOST_STEPS:
                raise Unfit
            room = sum(len(part) if isinstance(part, str) else _NUMBER_ROOM + _longest(part[2]) for part in parts) + 1
            longest = max(longest, room)
            size = packing(shape).struct.size
            rows.append(_SHAPE.pack(size, NONE if place is None else place, begin, len(steps) - begin, room))
        tables.append(b"".join(rows) or bytes(_SHAPE.size))
    named = b"".join(struct.pack("=3I", *texts.place(name), NONE if at is None else at) for name, at in calls)
    counts = (len(exits), len(entries), len(calls), columns)
    packed = b"".join(steps) or bytes(_STEP.size)
    return ShapeTables(tables[0], tables[1], named or bytes(12), packed, *texts.tables, counts, longest)


def _longest(symbols: tuple[tuple[str, int], ...]) -> int:
    return max((len(text) for text, _ in symbols), default=0) + 4


def _step(part: _Part, texts: Texts) -> bytes:
    if isinstance(part, str):
        return _STEP.pack(SKIPPED, 0, *texts.place(part))
    kind, style, symbols = part
    return _STEP.pack(kind, style, texts.symbols(symbols), len(symbols))


def _csv_parts(shape: Shape) -> list[_Part]:
    if isinstance(shape, Number):
        return [_number(shape, _PLAIN)]
    parts = _json_parts(shape, _JSON)
    whole = "".join(part if isinstance(part, str) else "0" for part in parts)
    if "," not in whole and '"' not in whole and not any(part[2] for part in parts if not isinstance(part, str)):
        return parts
    return ['"', *(part.replace('"', '""') if isinstance(part, str) else part for part in parts), '"']


def _message_parts(shape: Shape) -> list[_Part]:
    if isinstance(shape, Number) and shape.symbols:
        kind, _, symbols = _number(shape, _NULLS)
        return ['{"value":', (kind, _NULLS | _NO_STEP, ()), ',"symbol":', (kind, _WORD, symbols), "}"]
    return ['{"value":', *_json_parts(shape, _NULLS), "}"]


def _json_parts(shape: Shape, style: int) -> list[_Part]:
    if isinstance(shape, Number):
        return [_number(shape, style)]
    if isinstance(shape, Array):
        if shape.length > _MOST_STEPS:
            raise Unfit
        inner: Mapping[str, Shape] = {str(index): shape.element for index in range(shape.length)}
        return ["[", *_listed(inner, style, is_named=False), "]"]
    return ["{", *_listed(dict(shape.fields), style, is_named=True), "}"]


def _listed(fields: Mapping[str, Shape], style: int, *, is_named: bool) -> list[_Part]:
    parts: list[_Part] = []
    for index, (name, shape) in enumerate(fields.items()):
        parts.append(f"{',' if index else ''}{f'{json.dumps(name)}:' if is_named else ''}")
        parts += _json_parts(shape, style)
    return parts


def _number(shape: Number, style: int) -> tuple[int, int, tuple[tuple[str, int], ...]]:
    """A number; symbols that need quotes or escapes are left to Python."""
    if shape == SECONDS or any(not text.isidentifier() or not text.isascii() for text, _ in shape.symbols):
        raise Unfit
    return _KINDS.index(shape.datatype), style, shape.symbols
