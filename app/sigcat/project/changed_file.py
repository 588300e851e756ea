"""The project file of a service that runs: a change of it takes effect at the next start, which the log says."""

import logging
from pathlib import Path

_log = logging.getLogger("sigcat.hosting")


class ProjectFile:
    """A project file that is watched."""

    def __init__(self, file: Path | None) -> None:
        self._file = file
        self._mark = _mark_of(file)

    def reload_changed(self) -> None:
        """Log a change, once."""
        mark = _mark_of(self._file)
        if mark != self._mark:
            self._mark = mark
            _log.warning("%s has changed: start the service again to use it", self._file)


def _mark_of(file: Path | None) -> tuple[int, int] | None:
    """Size and time of the file; None if there is none."""
    try:
        status = file.stat() if file is not None else None
    except OSError:
        return None
    return (status.st_size, status.st_mtime_ns) if status is not None else None
