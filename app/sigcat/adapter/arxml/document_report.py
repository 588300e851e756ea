"""For every field of an Integration JSON: its place in the ARXML."""

from collections.abc import Iterator, Mapping

from pydantic import BaseModel

from sigcat.function.document.text_filters import comment
from sigcat.integration.report import Entry, FieldTarget, Targets, entries

Tables = Mapping[type[BaseModel], tuple[str, Targets]]
"""Kind and targets of each part of a document, without the fields that hold other parts."""


def part(kind: str, place: str, *admin: str, **targets: FieldTarget | str) -> tuple[str, Targets]:
    """Kind of a part, and targets of its fields below a place; `admin` are fields in the admin data there."""
    fields = {**dict.fromkeys(admin, "admin data"), **targets}
    return kind, {name: place + target if isinstance(target, str) else target for name, target in fields.items()}


def document_report(document: BaseModel, tables: Tables) -> tuple[Entry, ...]:
    """An entry for each field that has a value, in the order of the document."""
    return tuple(_of_part(document, "", "", tables))


def _of_part(part: BaseModel, function: str, above: str, tables: Tables) -> Iterator[Entry]:
    kind, table = tables[type(part)]
    function = getattr(part, "function", None) or function
    name = comment(getattr(part, "name", None) or getattr(part, "call", None) or "")
    where = "/".join(filter(None, (above, name)))
    inner: list[BaseModel] = []
    targets = dict(table)
    for field, info in type(part).model_fields.items():
        found = _parts(getattr(part, field), tables)
        if found and info.alias not in table:
            inner.extend(found)
            targets[info.alias or field] = FieldTarget("", "")
    yield from (entry for entry in entries(function, where, kind, part, targets) if entry.target)
    for each in inner:
        yield from _of_part(each, function, where, tables)


def _parts(value: object, tables: Tables) -> list[BaseModel]:
    """The parts of a document that a field holds."""
    listed = value if isinstance(value, tuple) else (value,)
    return [each for each in listed if isinstance(each, BaseModel) and type(each) in tables]
