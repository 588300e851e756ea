"""Columns of a bag of ROS 2 whose messages existed before: the deployment file maps their fields to signals."""

from collections.abc import Iterator

from sigcat import codes
from sigcat.adapter.host.connections import Connections, Entry
from sigcat.errors import InputRefused
from sigcat.function.function_json.conversion import between
from sigcat.integration.deployment import Deployment
from sigcat.integration.ros2.settings import FieldSettings, Ros2Settings
from sigcat.runs.recording.ros2_bag import BagColumns, Column


def bag_columns(deployment: Deployment, connections: Connections) -> BagColumns:
    """Return the fields of `ros2.messages` that the functions receive. Raises InputRefused for a unit that does not fit."""
    settings: Ros2Settings = deployment.ros2  # type: ignore[attr-defined]
    entries = {name: entry for entry in connections.entries for name in entry.names}
    return {topic: tuple(_columns(message.mapped, entries)) for topic, message in settings.messages.items()}


def _columns(fields: dict[str, FieldSettings], entries: dict[str, Entry]) -> Iterator[Column]:
    for path, field in fields.items():
        entry = entries.get(field.signal)
        if entry is None:
            continue
        way = between(field.unit or entry.unit, entry.unit)
        if way is None:
            message = f"{field.signal} cannot be converted from {field.unit} to {entry.unit or 'no unit'}."
            raise InputRefused("The bag cannot be used as a trace.", (codes.TRACE_MALFORMED.finding(message),))
        yield Column(path, field.signal, way, {number: name for name, number in (field.symbols or {}).items()})
