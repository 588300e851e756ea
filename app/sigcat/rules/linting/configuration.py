"""The settings of the linter: the table `[lint]` of a project file. Paths in it are relative to the folder of the file."""

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, NamedTuple

from sigcat import codes
from sigcat.errors import InputRefused
from sigcat.findings import SEVERITIES, Finding, shown
from sigcat.names import did_you_mean
from sigcat.real_path import near_path
from sigcat.rules.linting.options import LintOptions, PerFile
from sigcat.rules.linting.severity import OFF


class _Faults(NamedTuple):
    """Faults of a table, each with its key."""

    findings: list[Finding]
    file: Path

    def add(self, key: str, message: str) -> None:
        self.findings.append(codes.CONFIGURATION_UNUSABLE.finding(message.rstrip(), str(self.file), path=key))


def options_of(table: Mapping[str, Any], path: Path) -> LintOptions:
    """The options that a table of the configuration `path` says. Raises InputRefused, with everything that is wrong."""
    read: dict[str, Any] = {}
    faults = _Faults([], path)
    for key, value in table.items():
        known = FIELDS.get(key.replace("_", "-"))
        if known is None:
            hint = did_you_mean(key, FIELDS) or f"Known are {', '.join(FIELDS)}."
            faults.add(key, f"Unknown setting `{key}`. {hint}")
        else:
            field, convert = known
            read[field] = convert(key, value, faults)
    if faults.findings:
        raise InputRefused(f"The configuration {str(path)!r} cannot be used.", tuple(faults.findings))
    return LintOptions(file=path, root=path.parent, **read)


def _texts(key: str, value: Any, faults: _Faults) -> tuple[str, ...]:
    if not isinstance(value, list) or not all(isinstance(item, str) for item in value):
        faults.add(key, f"`{key}` must be a list of texts, not {shown(value)}.")
        return ()
    return tuple(value)


def _path(key: str, value: Any, faults: _Faults) -> Path | None:
    folder = faults.file.parent
    if not isinstance(value, str):
        faults.add(key, f"`{key}` must be the name of a file, not {value!r}.")
        return None
    try:
        (folder / value).stat()
    except PermissionError as error:
        faults.add(key, f"`{key}` names {value!r}, which cannot be read: {error.strerror}.")
    except (OSError, ValueError):
        faults.add(key, f"`{key}` names {value!r}, which does not exist in {str(folder)!r}.")
    else:
        return near_path(folder / value)
    return None


def _paths(key: str, value: Any, faults: _Faults) -> tuple[Path, ...]:
    found: list[Path | None] = []
    for text in _texts(key, value, faults):
        if "*" in text:
            found.extend(near_path(match) for match in sorted(faults.file.parent.glob(text)))
        else:
            found.append(_path(key, text, faults))
    return tuple(dict.fromkeys(path for path in found if path is not None))


def _severities(key: str, value: Any, faults: _Faults) -> dict[str, str]:
    if not isinstance(value, dict):
        faults.add(key, f"`{key}` must be a table of codes with severities.")
        return {}
    words = (*SEVERITIES, OFF)
    for code, severity in value.items():
        if severity not in words:
            meant = did_you_mean(str(severity), words)
            message = f"`{key}.{code}` must be {', '.join(SEVERITIES)} or {OFF}, not {shown(severity)}. {meant}"
            faults.add(f"{key}.{code}", message)
    return {str(code): str(severity) for code, severity in value.items()}


def _per_file(key: str, value: Any, faults: _Faults) -> tuple[PerFile, ...]:
    if not isinstance(value, dict):
        faults.add(key, f"`{key}` must have a table for each pattern of files.")
        return ()
    return tuple(PerFile(glob, _severities(f"{key}.{glob}", inner, faults)) for glob, inner in value.items())


def _rule_options(key: str, value: Any, faults: _Faults) -> dict[str, dict[str, Any]]:
    if not isinstance(value, dict):
        faults.add(key, f"`{key}` must have a table of options for each code.")
        return {}
    for code, inner in value.items():
        if not isinstance(inner, dict):
            faults.add(f"{key}.{code}", f"`{key}.{code}` must be a table of options, not {shown(inner)}.")
    return value


FIELDS: Mapping[str, tuple[str, Callable[[str, Any, _Faults], Any]]] = {
    "select": ("select", _texts),
    "ignore": ("ignore", _texts),
    "extend-select": ("extend_select", _texts),
    "severity": ("severities", _severities),
    "per-file": ("per_file", _per_file),
    "exclude": ("exclude", _texts),
    "base": ("base", _path),
    "overlays": ("overlays", _paths),
    "include-dirs": ("include_dirs", _paths),
    "units": ("units", _paths),
    "quantities": ("quantities", _paths),
    "types": ("types", _paths),
    "dbc": ("dbc", _paths),
    "extended-attributes": ("attributes", _texts),
    "rules": ("rule_files", _paths),
    "options": ("rule_options", _rule_options),
    "baseline": ("baseline", _path),
}
"""Keys of the table, each with the field of LintOptions that it sets."""
