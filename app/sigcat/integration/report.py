"""Place of each field of each interface in the result: nothing that a function declares is dropped in silence."""

import json
from collections.abc import Iterable, Mapping
from types import MappingProxyType
from typing import Any, NamedTuple

from pydantic import BaseModel

from sigcat.function.document.text_filters import markdown
from sigcat.integration.source_functions import SOURCE_FUNCTIONS

NOT_CARRIED = "not carried"
_NOWHERE_BELOW = (NOT_CARRIED, "none", SOURCE_FUNCTIONS)


class Entry(NamedTuple):
    """One field of one interface of a function."""

    function: str
    interface: str
    kind: str
    """signal, queue, method, parameter, error, safety reaction, mode, call, …"""
    field: str
    """Name in Function JSON."""
    target: str
    """Place of its value in the result, or `not carried`."""
    note: str = ""
    """Why it went there, or why it is not carried; empty if that is plain."""


class FieldTarget(NamedTuple):
    """Target of a field, whatever the interface."""

    target: str
    note: str = ""


Targets = Mapping[str, FieldTarget | str]
"""By field. A place may have words such as `{port}`."""
OF_ABSENT: Targets = dict.fromkeys(
    ("AbsentSignalList", "AbsentDataQList"),
    FieldTarget(SOURCE_FUNCTIONS, "the vehicle lacks the signals: the core has their start values"),
)
"""Targets of optional signals that are absent, on every platform."""


def same_names(place: str, fields: Iterable[str]) -> dict[str, FieldTarget | str]:
    """Targets of fields that have the same names at a place, which the names follow at once."""
    return {field: f"{place}{field}" for field in fields}


def fields_of(*models: type[BaseModel]) -> tuple[str, ...]:
    """Names of all fields on the wire."""
    return tuple(str(field.alias) for model in models for field in model.model_fields.values())


def entries(
    function: str,
    interface: str,
    kind: str,
    model: BaseModel,
    targets: Targets,
    names: Mapping[str, str] = MappingProxyType({}),
    below: str = "",
) -> list[Entry]:
    """An entry for each field that has a value. A field that no target is known for is listed as not carried.

    `names` replace the words of targets, which are `below` a place unless the functions as a whole have them.
    """
    made = []
    named = [(str(field.alias or name), getattr(model, name)) for name, field in type(model).model_fields.items()]
    for field, value in (*named, *(model.model_extra or {}).items()):
        if value is None or value in ((), [], {}):
            continue
        known = targets.get(field, FieldTarget(NOT_CARRIED, "no field of Function JSON that sigcat knows"))
        place, note = (known, "") if isinstance(known, str) else known
        for word, name in names.items():
            place = place.replace(f"{{{word}}}", name)
        if below and place not in _NOWHERE_BELOW:
            place = f"{below}/{place}"
        made.append(Entry(function, interface, kind, field, place, note))
    return made


def to_json(report: Iterable[Entry]) -> bytes:
    """The report as JSON: a list of objects."""
    rows: list[dict[str, Any]] = [
        {key: value for key, value in entry._asdict().items() if value or key != "note"} for entry in report
    ]
    return (json.dumps(rows, indent=2, ensure_ascii=False) + "\n").encode()


def to_markdown(report: Iterable[Entry]) -> str:
    """The report as a Markdown table. What documents contain is escaped."""
    lines = ["| function | interface | kind | field | goes to | note |", "|---|---|---|---|---|---|"]
    lines.extend("| " + " | ".join(map(markdown, entry)) + " |" for entry in report)
    return "\n".join(lines) + "\n"


def written_as(report: Iterable[Entry], ending: str) -> bytes:
    """The report as JSON for `.json`, or else as a Markdown table."""
    return to_json(report) if ending.lower() == ".json" else to_markdown(report).encode()
