"""Export and import a registry: its log and all content, byte for byte, as lines of JSON."""

import base64
import binascii
import json
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

from sqlalchemy import Connection, insert, select
from sqlalchemy.exc import SQLAlchemyError

from sigcat import codes
from sigcat.errors import InputRefused
from sigcat.registry.reference import refused
from sigcat.registry.storing.content import all_content
from sigcat.registry.storing.database import Place, writing
from sigcat.registry.storing.entry import Link
from sigcat.registry.storing.replay import apply
from sigcat.registry.storing.sqlite import new_file
from sigcat.registry.storing.tables import CONTENTS, LOG
from sigcat.registry.storing.verify import read_log, verify

_HEADER = {"format": "sigcat registry", "schema": 1}
"""The first line. The tables that follow from the log are not exported, so that it has another number than their schema."""


def exported(connection: Connection) -> Iterator[str]:
    """Yield the lines of an export: its format, content by digest, the log in order, and the hash of its last entry."""
    yield _line(_HEADER)
    for digest, data in all_content(connection):
        yield _line({"content": digest, "data": base64.b64encode(data).decode("ascii")})
    last = ""
    for link in read_log(connection):
        yield _line(link._asdict())
        last = link.hash
    yield _line({"end": last})


def import_lines(database: Place, lines: Iterable[bytes], name: str) -> str:
    """Write an export into an empty registry, and return the head of its log. Raises InputRefused; then nothing is kept."""
    if isinstance(database, Path) and database.parent.is_dir() and not database.exists():
        with new_file(database) as file:
            return _import(file, lines, name)
    return _import(database, lines, name)


def _import(database: Place, lines: Iterable[bytes], name: str) -> str:
    with writing(database) as connection:
        if connection.execute(select(LOG.c.number).limit(1)).first() is not None:
            raise _unfit("The registry must be empty to import another one.", name, fix="Name a new `database`.")
        end = _read(connection, lines, name)
        checked = verify(connection)
        if checked.findings:
            raise InputRefused("nothing was imported", checked.findings)
        if end != checked.head:
            raise _unfit(
                "The file is cut, or lines of it are missing: its log does not end with the entry of its last line.",
                name,
            )
        return checked.head


def _read(connection: Connection, lines: Iterable[bytes], name: str) -> str | None:
    """Write the lines, and return the hash of the last entry as the last line has it; None if that line is missing."""
    number, end = 0, None
    for number, line in enumerate(lines, 1):
        try:
            data = json.loads(line)
            if end is not None:
                raise ValueError(line)
            if isinstance(data, dict) and data.keys() == {"end"}:
                end = str(data["end"])
            else:
                _read_line(connection, data, is_first=number == 1)
        except _UNREADABLE:
            message = f"Line {number} is not a line of an export of schema 1."
            raise _unfit(message, name, number) from None
    if not number:
        raise _unfit("The file is empty.", name)
    return end


_UNREADABLE = (ValueError, TypeError, KeyError, AttributeError, binascii.Error, RecursionError, SQLAlchemyError)
"""Errors of a line of any content."""


def _read_line(connection: Connection, line: Any, *, is_first: bool) -> None:
    if is_first:
        if line != _HEADER:
            raise ValueError(line)
    elif "content" in line:
        data = base64.b64decode(line["data"], validate=True)
        connection.execute(insert(CONTENTS).values(digest=line["content"], data=data))
    else:
        link = Link(**line)
        connection.execute(insert(LOG).values(**link._asdict()))
        apply(connection, link.entry)


def _unfit(message: str, name: str, line: int = 0, fix: str = "") -> InputRefused:
    return refused(codes.IMPORT_UNFIT.finding(message, name, line, fix=fix or "Export the registry again."))


def _line(values: Any) -> str:
    return json.dumps(values, sort_keys=True, ensure_ascii=False) + "\n"
