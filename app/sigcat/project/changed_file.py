"""The project file of a service that runs: a change of it takes effect at the next start, which the log says."""

import logging
import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

_log = logging.getLogger("sigcat.hosting")


class ProjectFile:
    """A project file that is watched."""

    def __init__(self, file: Path | None) -> None:
        self._file = file
        self._mark = _mark_of(file)
        self._settings = _settings_of(file)

    def reload_changed(self) -> None:
        """Log a change with its keys, once."""
        mark = _mark_of(self._file)
        if mark != self._mark:
            self._mark = mark
            before, now = self._settings, _settings_of(self._file)
            if before is None or now is None:
                _log.warning("%s has changed: start the service again to use it", self._file)
            elif keys := [key for key in sorted({*before, *now}) if before.get(key) != now.get(key)]:
                _log.warning("%s has changed: start the service again to use %s", self._file, ", ".join(keys))
            self._settings = now


def _settings_of(file: Path | None) -> Mapping[str, Any] | None:
    """Values of the file by key; None if it cannot be read."""
    try:
        content = tomllib.loads(file.read_text(encoding="utf-8")) if file is not None else {}
    except (OSError, ValueError):
        return None
    if file is not None and file.name == "pyproject.toml":
        tools = content.get("tool")
        content = tools.get("sigcat", {}) if isinstance(tools, dict) else {}
    return content if isinstance(content, dict) else None


def _mark_of(file: Path | None) -> tuple[int, int] | None:
    """Size and time of the file; None if there is none."""
    try:
        status = file.stat() if file is not None else None
    except OSError:
        return None
    return (status.st_size, status.st_mtime_ns) if status is not None else None
