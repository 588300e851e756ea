"""The options that an export is asked for, checked before anything runs."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from sigcat.catalogue.exporting.vss_tools.formats import Format, Option, options_of
from sigcat.catalogue.model.definition import CORE_ATTRIBUTES
from sigcat.errors import UsageError
from sigcat.names import did_you_mean


def checked_options(format_: Format, options: Mapping[str, Any]) -> dict[str, Any]:
    """Options by their names with dashes, without those that were not given. Raises UsageError."""
    known = {option.name: option for option in options_of(format_)}
    checked = {}
    for given, value in options.items():
        name = given.replace("_", "-")
        if name not in known:
            hint = did_you_mean(name, known) or f"It takes {', '.join(known)}."
            raise UsageError(f"The export {format_.name} has no option {name!r}. {hint}")
        if value is not None and value not in ((), []):
            checked[name] = _checked_value(known[name], value)
    for name in checked.get("extended-attributes", ()):
        if "," in name or name in CORE_ATTRIBUTES:
            raise UsageError(f"extended-attributes {name!r}: name one attribute that VSS does not define.")
    return checked


def is_file_name(name: str) -> bool:
    """Whether a text names something inside a folder, and not another folder."""
    return name not in (".", "..") and not any(sign in name for sign in ("/", "\\", "\0"))


def _checked_value(option: Option, value: Any) -> Any:
    expected = _EXPECTED[option.kind]
    wrong = ""
    if not isinstance(value, expected[0]) or (option.kind == "number" and isinstance(value, bool)):
        wrong = f"{expected[1]} belongs here"
    elif option.kind == "texts" and not all(isinstance(item, str) for item in value):
        wrong = "a list of texts belongs here"
    elif option.kind in ("name", "output", "folder") and not is_file_name(value):
        wrong = "a plain file name belongs here, without folders"
    elif option.kind == "input" and not value.is_file():
        wrong = "there is no such file"
    elif option.choices and not set([value] if isinstance(value, str) else value) <= set(option.choices):
        wrong = f"one of {', '.join(option.choices)} belongs here"
    if wrong:
        raise UsageError(f"{option.name} {str(value)!r}: {wrong}.")
    return value


_EXPECTED: Mapping[str, tuple[Any, str]] = {
    "flag": (bool, "true or false"), "switch": (bool, "true or false"), "text": (str, "a text"),
    "name": (str, "a text"), "texts": (list | tuple, "a list of texts"), "number": (int, "a whole number"),
    "choice": (str, "a text"), "input": (Path, "a file"), "state": (Path, "a file"), "output": (str, "a file name"),
    "folder": (str, "a folder name"),
}  # fmt: skip
