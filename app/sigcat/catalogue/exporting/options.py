"""The options that an export is asked for, checked before anything runs."""

import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from sigcat.catalogue.exporting.exporter import Exporter, Option
from sigcat.catalogue.model.definition import CORE_ATTRIBUTES
from sigcat.errors import UsageError
from sigcat.names import did_you_mean


def checked_options(exporter: Exporter, options: Mapping[str, Any]) -> dict[str, Any]:
    """Options by their names with dashes, without those that were not given. Raises UsageError."""
    known = {option.name: option for option in exporter.options}
    checked = {}
    for given, value in options.items():
        name = given.replace("_", "-")
        option = option_named(name, known, exporter)
        if value is not None and value not in ((), []):
            checked[name] = _checked_value(option, value)
    for name in checked.get("extended-attributes", ()):
        if "," in name or name in CORE_ATTRIBUTES:
            raise UsageError(f"extended-attributes must name one attribute that VSS does not define, not {name!r}.")
    return checked


def option_named(name: str, known: Mapping[str, Option], exporter: Exporter) -> Option:
    """One of the options that an exporter is known by. Raises UsageError with the nearest names."""
    if name not in known:
        hint = did_you_mean(name, known) or f"It takes {', '.join(known)}."
        raise UsageError(f"The export {exporter.name} has no option {name[:80]!r}. {hint}")
    return known[name]


def is_file_name(name: str) -> bool:
    """Whether a text names something inside a folder, and not another folder."""
    return name not in (".", "..") and not any(sign in name for sign in ("/", "\\", "\0"))


def _checked_value(option: Option, value: Any) -> Any:
    expected = _EXPECTED[option.kind]
    wrong = ""
    if not isinstance(value, expected[0]) or (option.kind == "number" and isinstance(value, bool)):
        wrong = f"must be {expected[1]}"
    elif option.kind == "texts" and not all(isinstance(item, str) for item in value):
        wrong = "must be a list of texts"
    elif option.kind in ("name", "output", "folder") and not is_file_name(value):
        wrong = "must be a plain file name, without folders"
    elif option.kind == "identifier" and not re.fullmatch(r"[A-Za-z_][A-Za-z0-9_]*", value):
        wrong = "must be letters, digits and underscores, no digit first"
    elif option.kind == "input" and not value.is_file():
        wrong = "must be a file"
    elif option.choices and not set([value] if isinstance(value, str) else value) <= set(option.choices):
        wrong = f"must be one of {', '.join(option.choices)}"
    if wrong:
        raise UsageError(f"{option.name} {wrong}, not {str(value)!r}.")
    return value


_EXPECTED: Mapping[str, tuple[Any, str]] = {
    "flag": (bool, "true or false"), "switch": (bool, "true or false"), "text": (str, "text"),
    "name": (str, "text"), "identifier": (str, "text"), "texts": (list | tuple, "a list of texts"), "number": (int, "a whole number"),
    "choice": (str, "text"), "input": (Path, "a file"), "state": (Path, "a file"), "output": (str, "a file name"),
    "folder": (str, "a folder name"),
}  # fmt: skip
