"""An id catalogue as CSV: a company's list of the SOME/IP ids that are given away, by the keys of a deployment."""

import csv
import io
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence

from sigcat import codes
from sigcat.errors import InputRefused
from sigcat.findings import Finding
from sigcat.integration.autosar_adaptive.deployment.identifiers import largest_id
from sigcat.limits import Limits

_NUMBER = re.compile(r"0[xX][0-9a-fA-F]{1,8}|[0-9]{1,10}")
_COLUMNS = "Write a first line `name,id`; other columns may follow."
_NAMES = "Write a name such as Service, Service:instance or Service.Event, and a number such as 4660 or 0x1234."

Entry = tuple[int, str, str]
"""Line, name and id as they are written."""


def read_csv(data: bytes, name: str, limits: Limits) -> dict[str, int]:
    """The ids of a file by name. Raises InputRefused with everything that is wrong."""
    if len(data) > limits.file_bytes:
        raise InputRefused(f"{name} must have at most {limits.file_bytes:,} bytes.")
    try:
        return collected(_entries(data, name), name)
    except (UnicodeDecodeError, csv.Error) as error:
        raise _refused(name, [_wrong(f"The file must be CSV in UTF-8: {error}.", name, 1, _COLUMNS)]) from error


def collected(entries: Iterable[Entry], name: str) -> dict[str, int]:
    """Ids by name. Raises InputRefused for an invalid id, or two ids of one name."""
    ids: dict[str, int] = {}
    findings = []
    for line, key, text in entries:
        number = int(text, 16 if text[:2].lower() == "0x" else 10) if _NUMBER.fullmatch(text) else 0
        if not key or not 1 <= number <= largest_id(key):
            message = f"An id must have a name and be from 1 to {largest_id(key)}, not {text[:40]!r} of {key[:100]!r}."
            findings.append(_wrong(message, name, line, _NAMES))
        elif ids.setdefault(key, number) != number:
            message = f"{key[:100]} must have one id, not {ids[key]} and {number}."
            findings.append(_wrong(message, name, line, "Remove one of them."))
    if findings:
        raise _refused(name, findings)
    return ids


def merged(catalogues: Sequence[Mapping[str, int]], names: Sequence[str]) -> dict[str, int]:
    """The ids of several catalogues. Raises InputRefused where they give a name two ids."""
    ids: dict[str, int] = {}
    findings = []
    fix = "State the right one under `identifiers` of the deployment file, and remove the other."
    for catalogue, name in zip(catalogues, names, strict=True):
        for key, number in catalogue.items():
            if ids.setdefault(key, number) != number:
                message = f"{key[:100]} must have one id in all id catalogues, not {ids[key]} and {number}."
                findings.append(_wrong(message, name, 0, fix))
    if findings:
        raise _refused(names[-1], findings)
    return ids


def _entries(data: bytes, name: str) -> Iterator[Entry]:
    text = data.decode("utf-8-sig")
    first = text.partition("\n")[0]
    rows = csv.reader(io.StringIO(text), delimiter=";" if ";" in first and "," not in first else ",")
    columns = [column.strip().lower() for column in next(rows, [])]
    if not {"name", "id"} <= set(columns):
        raise _refused(name, [_wrong("The first line must have the columns `name` and `id`.", name, 1, _COLUMNS)])
    at_name, at_id = columns.index("name"), columns.index("id")
    for row in rows:
        if any(cell.strip() for cell in row):
            cells = [*(cell.strip() for cell in row), *[""] * len(columns)]
            yield rows.line_num, cells[at_name], cells[at_id]


def _wrong(message: str, name: str, line: int, fix: str) -> Finding:
    return codes.ID_REFUSED.finding(message, name, line, 1 if line else 0, fix=fix)


def _refused(name: str, findings: list[Finding]) -> InputRefused:
    return InputRefused(f"{name} cannot be used as an id catalogue.", tuple(findings))
