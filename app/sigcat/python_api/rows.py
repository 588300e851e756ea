"""Rows of a run, and a table of them in Arrow."""

from collections.abc import Iterable, Iterator, Mapping
from itertools import islice
from types import ModuleType
from typing import TYPE_CHECKING, Any, NamedTuple

from sigcat.adapter.host.shapes import Array, Number, Shape
from sigcat.errors import UsageError

if TYPE_CHECKING:
    import pyarrow as pa

_BATCH = 65_536
"""Rows that are converted at a time."""
_NAMES = {"boolean": "bool_", "float": "float32", "double": "float64"}
"""Arrow's names of datatypes, where VSS has other ones."""


class Row(NamedTuple):
    """Values that were sent at a time."""

    time: int
    """In nanoseconds, on the clock of the trace."""
    call: str
    """The call that ended then; empty if something was sent without one, such as a timeout error."""
    values: Mapping[str, Any]
    """Values that were sent, by path or name of the interface; of arrays lists, of structs mappings."""


def arrow_table(rows: Iterable[Row], columns: Mapping[str, Shape]) -> "pa.Table":
    """Return all rows. Raises UsageError without the package pyarrow."""
    try:
        import pyarrow as pa
    except ImportError:
        raise UsageError("An Arrow table needs the package `pyarrow`: run `pip install pyarrow`") from None
    fields = [("time", pa.duration("ns")), ("call", pa.string())]
    schema = pa.schema([*fields, *((name, _type(shape, pa)) for name, shape in columns.items())])
    return pa.Table.from_batches((_batch(each, schema, pa) for each in _batches(iter(rows))), schema)


def _batches(rows: Iterator[Row]) -> Iterator[list[Row]]:
    while batch := list(islice(rows, _BATCH)):
        yield batch


def _batch(rows: list[Row], schema: "pa.Schema", pa: ModuleType) -> "pa.RecordBatch":
    first = [[row.time for row in rows], [row.call for row in rows]]
    sent = ([row.values.get(field.name) for row in rows] for field in list(schema)[2:])
    arrays = [pa.array(values, field.type) for values, field in zip([*first, *sent], schema, strict=True)]
    return pa.record_batch(arrays, schema=schema)


def _type(shape: Shape, pa: ModuleType) -> "pa.DataType":
    if isinstance(shape, Number):
        return getattr(pa, _NAMES.get(shape.datatype, shape.datatype))()
    if isinstance(shape, Array):
        return pa.list_(_type(shape.element, pa), shape.length)
    return pa.struct([(name, _type(field, pa)) for name, field in shape.fields])
