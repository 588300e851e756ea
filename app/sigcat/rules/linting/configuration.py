"""Configuration: `[tool.sigcat.lint]` of a pyproject.toml, or `[lint]` of a sigcat.toml, found upwards.

Paths in it are relative to its folder. The command line lays its options over it.
"""

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from sigcat import codes
from sigcat.errors import InputRefused, UsageError
from sigcat.findings import SEVERITIES
from sigcat.names import did_you_mean
from sigcat.rules.linting.options import LintOptions, PerFile
from sigcat.rules.linting.severity import OFF

FILES = ("sigcat.toml", "pyproject.toml")


def find_configuration(start: Path) -> Path | None:
    """The nearest configuration in `start` or above it; a pyproject.toml counts only with a table for sigcat."""
    for folder in (start.resolve(), *start.resolve().parents):
        for name in FILES:
            path = folder / name
            if path.is_file() and (name == FILES[0] or b"tool.sigcat" in path.read_bytes()):
                return path
    return None


def read_configuration(path: Path) -> LintOptions:
    """The options of a configuration file. Raises InputRefused, with every field that is wrong."""
    import tomllib  # only where there is a configuration: it takes time at start-up

    try:
        data = tomllib.loads(path.read_bytes().decode("utf-8-sig"))
    except OSError as error:
        raise InputRefused(f"The configuration {str(path)!r} cannot be read: {error.strerror}.") from None
    except (ValueError, RecursionError) as error:
        raise InputRefused(f"The configuration {str(path)!r} is not valid TOML: {error}") from None
    table = _table_in(data) if path.name == FILES[1] else data.get("lint", {})
    if not isinstance(table, dict):
        raise InputRefused(f"`lint` in {str(path)!r} must be a table.")
    return options_of(table, path)


def _table_in(data: Mapping[str, Any]) -> Any:
    found: Any = data
    for name in ("tool", "sigcat", "lint"):
        found = found.get(name, {}) if isinstance(found, dict) else {}
    return found


def options_of(table: Mapping[str, Any], path: Path) -> LintOptions:
    """The options that a table of the configuration `path` says. Raises InputRefused, with every field that is wrong."""
    read: dict[str, Any] = {}
    findings = []
    for key, value in table.items():
        try:
            known = _FIELDS.get(key.replace("_", "-"))
            if known is None:
                raise UsageError(f"Unknown setting `{key}`. {did_you_mean(key, _FIELDS)}".strip())
            field, convert = known
            read[field] = convert(key, value, path.parent)
        except UsageError as error:
            findings.append(codes.CONFIGURATION_UNUSABLE.finding(str(error), str(path), path=key))
    if findings:
        raise InputRefused(f"The configuration {str(path)!r} cannot be used.", tuple(findings))
    return LintOptions(file=path, root=path.parent, **read)


def _texts(key: str, value: Any, _folder: Path) -> tuple[str, ...]:
    if not isinstance(value, list) or not all(isinstance(item, str) for item in value):
        raise UsageError(f"`{key}` must be a list of texts.")
    return tuple(value)


def _path(key: str, value: Any, folder: Path) -> Path:
    if not isinstance(value, str):
        raise UsageError(f"`{key}` must be the name of a file, not {value!r}.")
    if not (folder / value).exists():
        raise UsageError(f"`{key}` names {value!r}, which does not exist in {str(folder)!r}.")
    return _near(folder / value)


def _paths(key: str, value: Any, folder: Path) -> tuple[Path, ...]:
    found: list[Path] = []
    for text in _texts(key, value, folder):
        matches = sorted(folder.glob(text)) if "*" in text else [_path(key, text, folder)]
        found.extend(_near(match) for match in matches)
    return tuple(dict.fromkeys(found))


def _near(path: Path) -> Path:
    """The path as a user names it: relative to the working folder, where it lies below it."""
    try:
        return path.resolve().relative_to(Path.cwd())
    except ValueError:
        return path


def _severities(key: str, value: Any, _folder: Path) -> dict[str, str]:
    if not isinstance(value, dict):
        raise UsageError(f"`{key}` must be a table of codes with severities.")
    words = (*SEVERITIES, OFF)
    if wrong := [f"{severity!r} of {code}" for code, severity in value.items() if severity not in words]:
        meant = did_you_mean(str(next(s for s in value.values() if s not in words)), words)
        raise UsageError(f"`{key}` must be {', '.join(SEVERITIES)} or {OFF}, not {', '.join(wrong)}. {meant}".rstrip())
    return {str(code): str(severity) for code, severity in value.items()}


def _per_file(key: str, value: Any, folder: Path) -> tuple[PerFile, ...]:
    if not isinstance(value, dict):
        raise UsageError(f"`{key}` must have a table for each pattern of files.")
    entries, wrong = [], []
    for glob, inner in value.items():
        try:
            entries.append(PerFile(glob, _severities(f"{key}.{glob}", inner, folder)))
        except UsageError as error:
            wrong.append(str(error))
    if wrong:
        raise UsageError(" ".join(wrong))
    return tuple(entries)


def _rule_options(key: str, value: Any, _folder: Path) -> dict[str, dict[str, Any]]:
    if not isinstance(value, dict) or not all(isinstance(inner, dict) for inner in value.values()):
        raise UsageError(f"`{key}` must have a table of options for each code.")
    return value


_FIELDS: Mapping[str, tuple[str, Callable[[str, Any, Path], Any]]] = {
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
    "extended-attributes": ("attributes", _texts),
    "rules": ("rule_files", _paths),
    "options": ("rule_options", _rule_options),
    "baseline": ("baseline", _path),
}
"""Keys of the table, each with the field of LintOptions that it sets."""
