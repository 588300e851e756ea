"""Allowed values whose names meet in an exported .proto file, so that protoc refuses it."""

import re
from collections.abc import Iterator

from sigcat import codes
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.model.datatypes import element_of
from sigcat.catalogue.model.definition import Definition
from sigcat.findings import Finding
from sigcat.names import parent_path

_NAME = re.compile(r"[A-Za-z_]\w*", re.ASCII)


def value_name_findings(catalogue: Catalogue) -> Iterator[Finding]:
    """Yield one finding, at the first of the signals with such a value."""
    found = list(_problems(catalogue))
    if found:
        definition, message = found[0]
        more = f" The same is true of {len(found) - 1:,} more." if len(found) > 1 else ""
        fix = "Rename the value in an overlay, or use another export."
        origin = definition.origin("allowed").position
        yield codes.VALUE_NAME_TAKEN.finding(message + more, *origin, definition.path, fix=fix)


def _problems(catalogue: Catalogue) -> Iterator[tuple[Definition, str]]:
    """Yield each signal with such a value, and the message about it."""
    taken: dict[tuple[str, str], str] = {}
    for path, definition in catalogue.definitions.items():
        is_text = element_of(str(definition.values.get("datatype"))) == "string"
        names = [str(value) for value in definition.values.get("allowed") or ()] if is_text else []
        wrong = next((name for name in names if not _NAME.fullmatch(name)), None)
        other = next((name for name in names if (parent_path(path), name) in taken), None)
        if wrong is not None:
            yield definition, f"protoc refuses the value {wrong!r}, which is not a name."
        elif other is not None:
            yield (
                definition,
                f"protoc refuses the value {other!r}, which is also one of {taken[parent_path(path), other]}.",
            )
        taken |= {(parent_path(path), name): path for name in names if (parent_path(path), name) not in taken}
