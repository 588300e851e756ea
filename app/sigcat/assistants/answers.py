"""Answers as plain data, bounded: an assistant has little room, and a tree of a company is large."""

import json
from collections.abc import Iterable, Mapping, Sequence
from itertools import islice
from typing import Any

from sigcat.catalogue.comparing.changes import CLASSES, Change
from sigcat.catalogue.comparing.diff_report import diff_data
from sigcat.catalogue.reading.statement import Origin
from sigcat.findings import SEVERITIES, Finding
from sigcat.function.node_uses import NodeUse
from sigcat.limits import ASSISTANT_CHARACTERS, ASSISTANT_ITEMS, ASSISTANT_TEXT
from sigcat.python_api.node import Attribute, Node

Answer = dict[str, Any]


def listed(name: str, entries: Iterable[Answer], total: int) -> Answer:
    """Return the entries that fit into an answer, and how many are omitted."""
    kept: list[Answer] = []
    left = ASSISTANT_CHARACTERS
    for entry in map(_cut, islice(entries, ASSISTANT_ITEMS)):
        left -= len(json.dumps(entry))
        if left < 0:
            break
        kept.append(entry)
    return {name: kept, "omitted": total - len(kept)} if len(kept) < total else {name: kept}


def node_summary(node: Node) -> Answer:
    """Return a node in a list."""
    return _present({
        "path": node.path, "type": node.type, "datatype": node.datatype, "unit": node.unit, "description": node.description
    })  # fmt: skip


def node_detail(node: Node, instances: Sequence[Node]) -> Answer:
    """Return every attribute of a node and its origin, the nodes below it and its instances."""
    attributes = {name: _attribute(each) for name, each in node.attributes.items()}
    paths = [each.path for each in instances] if len(instances) > 1 else []
    return {
        **_present(
            {"path": node.path, "type": node.type, "definition": node.definition_path, "instances": _cut(paths)}
        ),
        "attributes": _cut(attributes),
        **listed("children", map(node_summary, node.children), len(node.children)),
    }


def finding_data(findings: Iterable[Finding], name: str = "findings") -> Answer:
    """Return findings, errors first."""
    ordered = sorted(findings, key=lambda each: SEVERITIES.index(each.severity))
    return listed(name, (_present(each._asdict()) for each in ordered), len(ordered))


def change_data(changes: Sequence[Change]) -> Answer:
    """Return changes, the worst first, and how many there are of each class."""
    ordered = sorted(changes, key=lambda each: CLASSES.index(each.compatibility))
    data = diff_data(ordered)
    return {"summary": data["summary"], **listed("changes", data["changes"], len(changes))}


def use_data(uses: Sequence[NodeUse], unread: Sequence[Finding]) -> Answer:
    """Return the uses of a node by functions; `unread` are findings of function files that cannot be used."""
    found = listed("uses", (_present(use._asdict()) for use in uses), len(uses))
    return {**found, **finding_data(unread, "files_with_errors")} if unread else found


def _attribute(attribute: Attribute) -> Answer:
    before = [value for value, _ in attribute.history[:-1]]
    return {"value": attribute.value, "written_in": _place(attribute.origin), **({"before": before} if before else {})}


def _place(origin: Origin) -> str:
    return f"{origin.file}:{origin.line}"


def _present(fields: Mapping[str, Any]) -> Answer:
    """Return the fields that say something."""
    return {name: value for name, value in fields.items() if value not in ("", 0, [], (), None)}


def _cut(value: Any) -> Any:
    """Return a value with long texts and lists cut, in the types of JSON."""
    if isinstance(value, Mapping):
        return {str(name): _cut(item) for name, item in list(value.items())[:ASSISTANT_ITEMS]}
    if isinstance(value, list | tuple):
        more = len(value) - ASSISTANT_ITEMS
        return [*map(_cut, value[:ASSISTANT_ITEMS]), *([f"… {more:,} more"] if more > 0 else [])]
    if value is None or isinstance(value, bool | int | float):
        return value
    text = str(value).encode("utf-8", "replace").decode()
    return text if len(text) <= ASSISTANT_TEXT else f"{text[:ASSISTANT_TEXT]}…"
