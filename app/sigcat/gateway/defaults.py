"""A file of default values for sending, as the KUKSA CAN provider has it: signals of CAN with numbers in their unit, or names."""

import json
import re
from collections.abc import Iterator, Mapping
from pathlib import Path

from sigcat import codes
from sigcat.catalogue.network.can_database import CanDatabase
from sigcat.catalogue.network.network_values import Unfit
from sigcat.catalogue.network.sent_numbers import raw_of
from sigcat.errors import InputRefused
from sigcat.findings import Finding, has_errors, shown
from sigcat.limits import DEFAULT_LIMITS
from sigcat.names import did_you_mean

_LIKE = 'Write {"MirrorState": 2, "Gear": "PARK"}.'


def read_defaults(path: Path, database: CanDatabase) -> tuple[Mapping[str, float | str], tuple[Finding, ...]]:
    """Values by signal, and warnings of signals that the database does not have. Raises InputRefused."""
    text = path.read_bytes()[: DEFAULT_LIMITS.file_bytes + 1].decode("utf-8", "replace")
    try:
        given = json.loads(text)
    except (ValueError, RecursionError) as error:
        line, column = getattr(error, "lineno", 1), getattr(error, "colno", 1)
        raise _refused(
            codes.DEFAULTS_INVALID.finding("The file must be JSON.", str(path), line, column, fix=_LIKE)
        ) from None
    if not isinstance(given, dict):
        raise _refused(codes.DEFAULTS_INVALID.finding("The file must be a JSON object.", str(path), 1, 1, fix=_LIKE))
    found = tuple(finding for name, value in given.items() for finding in _findings(name, value, database, path, text))
    if has_errors(found):
        raise _refused(*found)
    return {name: value for name, value in given.items() if name in database.signals}, found


def _refused(*findings: Finding) -> InputRefused:
    return InputRefused("The default values cannot be used.", findings)


def _findings(name: str, value: object, database: CanDatabase, path: Path, text: str) -> Iterator[Finding]:
    """Return the finding for a value, at its line."""
    place = re.search(rf"{re.escape(json.dumps(name))}\s*:", text)
    line = text.count("\n", 0, place.start()) + 1 if place else 1
    if name not in database.signals:
        message = f"The CAN database has no signal {shown(name)}."
        rule = codes.DEFAULTS_INVALID.graded("warning")  # a file may be for more than one database
        yield rule.finding(message, str(path), line, 1, fix=did_you_mean(name, database.signals))
        return
    if isinstance(value, bool) or not isinstance(value, int | float | str):
        message = f"{name} must have a number or a name, not {shown(value)}."
        yield codes.DEFAULTS_INVALID.finding(message, str(path), line, 1, fix=_LIKE)
        return
    for signal in (each for message in database.messages for each in message.signals if each.name == name):
        try:
            raw_of(signal, value)
        except Unfit as why:
            text_of_value = f"The default {shown(value)} of {name} is {why}."
            yield codes.DEFAULTS_INVALID.finding(text_of_value, str(path), line, 1)
            return
