"""What was received and sent as MCAP, which Foxglove and PlotJuggler open: a topic for each signal, messages in JSON."""

import io
import json
import math
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

from sigcat.errors import UsageError
from sigcat.runs.recording.recorded import Recorded
from sigcat.runs.recording.samples import Sample, samples
from sigcat.runs.recording.shapes import Array, Number, Shape, Value
from sigcat.runs.recording.times import NANOSECONDS
from sigcat.runs.recording.trace_file import Moment

if TYPE_CHECKING:
    from mcap.writer import Writer

_CALL = {
    "type": "object",
    "title": "Call",
    "properties": {"time": {"type": "number", "description": "When it ended, in s."}},
}


def mcap_bytes(
    received: Iterable[Moment], rows: Iterable[Recorded], shapes: Mapping[str, Shape], units: Mapping[str, str]
) -> bytes:
    """The whole file. Raises UsageError if the package `mcap` is missing."""
    try:
        from mcap.writer import Writer
    except ImportError:
        raise UsageError("MCAP needs the package `mcap`: run `pip install mcap`") from None
    output = io.BytesIO()
    writer = Writer(output)
    writer.start(library="sigcat")
    _write(writer, received, tuple(rows), shapes, units)
    writer.finish()  # type: ignore[no-untyped-call]
    return output.getvalue()


def _write(
    writer: "Writer", received: Iterable[Moment], rows: tuple[Recorded, ...], shapes: Mapping[str, Shape],
    units: Mapping[str, str],
) -> None:  # fmt: skip
    channels: dict[str, int] = {}
    for time, name, value in _all(received, rows):
        shape = shapes.get(name)
        if name not in channels:
            channels[name] = _channel(writer, name, _schema(name, shape, units) if shape else _CALL)
        message = _message(value, shape) if shape else {"time": value}
        writer.add_message(channels[name], time, json.dumps(message).encode(), time)


def _all(received: Iterable[Moment], rows: tuple[Recorded, ...]) -> Iterable[Sample]:
    """Values and calls; a call is a sample of its own time."""
    calls = (Recorded(row.time, row.call, (*row.values, (row.call, row.time / NANOSECONDS))) if row.call else row
             for row in rows)  # fmt: skip
    return samples(received, calls)


def _channel(writer: "Writer", name: str, schema: Mapping[str, Any]) -> int:
    """A topic: `Vehicle.Speed` is /Vehicle/Speed."""
    data = json.dumps(schema, ensure_ascii=False).encode()
    schema_id = writer.register_schema(name, "jsonschema", data)
    return writer.register_channel(f"/{name.replace('.', '/')}", "json", schema_id)


# -- messages -----------------------------------------------------------------------------------------------------


def _message(value: Value, shape: Shape) -> dict[str, Any]:
    """`value`, and the symbol of an enumeration beside its number."""
    if isinstance(shape, Number) and shape.symbols:
        symbol = next((symbol for symbol, number in shape.symbols if number == value), None)
        return {"value": value, "symbol": symbol}
    return {"value": _plain(value)}


def _plain(value: Value) -> Any:
    """A value that JSON has: NaN and infinities are null."""
    if isinstance(value, list):
        return [_plain(each) for each in value]
    if isinstance(value, dict):
        return {name: _plain(each) for name, each in value.items()}
    return None if isinstance(value, float) and not math.isfinite(value) else value


def _schema(name: str, shape: Shape, units: Mapping[str, str]) -> dict[str, Any]:
    value = _type(shape)
    if name in units:
        value["description"] = f"In {units[name]}."
    properties = {"value": value}
    if isinstance(shape, Number) and shape.symbols:
        properties["symbol"] = {"type": "string", "enum": [symbol for symbol, _ in shape.symbols]}
    return {"type": "object", "title": name, "properties": properties}


def _type(shape: Shape) -> dict[str, Any]:
    if isinstance(shape, Array):
        return {"type": "array", "items": _type(shape.element)}
    if isinstance(shape, Number):
        kind = "boolean" if shape.datatype == "boolean" else "integer" if shape.is_whole else "number"
        return {"type": kind}
    return {"type": "object", "properties": {name: _type(field) for name, field in shape.fields}}
