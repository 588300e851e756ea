"""The project file of a service that runs: a change of it, or of the files that it finds, takes effect at once.

Some keys need a new start.
"""

import logging
import tomllib
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Any

from sigcat import codes
from sigcat.catalogue.hosting.library import log_findings
from sigcat.catalogue.model.vocabulary import files_beside
from sigcat.errors import InputRefused, UsageError
from sigcat.file_kind import QUANTITY_NAMES, UNIT_NAMES
from sigcat.findings import Finding
from sigcat.project.project_file import PATH_LISTS, files_matching

AT_START = ("watch", "service", "registry")
"""Keys that a service uses when it starts."""
_log = logging.getLogger("sigcat.hosting")


class ProjectFile:
    """A project file that is watched."""

    def __init__(
        self, file: Path | None, take: Callable[[Path], None], refuse: Callable[[tuple[Finding, ...]], None]
    ) -> None:
        """`take` reads the file, and hosts what it names; it raises InputRefused or UsageError before it changes anything.

        `refuse` shows the findings of a file that is not taken; none after one that is.
        """
        self._file, self._take, self._refuse = file, take, refuse
        self._mark = self._seen = _mark_of(file)
        self._started_with = self._taken = _settings_of(file)

    def reload_settled(self) -> None:
        """Take a changed file at the second look, as it may be half written at the first.

        Of an invalid one, log and show the findings: the last good state stays.
        """
        before, self._seen = self._seen, _mark_of(self._file)
        if self._file is None or self._seen == self._mark or self._seen != before:
            return
        self._mark = self._seen
        try:
            _check_content(self._file, self._taken)
            self._take(self._file)
        except (InputRefused, UsageError) as error:
            findings = _findings(self._file, error)
            _log.warning("%s: the file has errors; the last good state stays", self._file)
            log_findings(findings)
            self._refuse(findings)
            return
        self._refuse(())
        _log.info("%s: read again", self._file)
        then, now = self._started_with, _settings_of(self._file)
        self._taken = now
        if keys := [key for key in AT_START if then.get(key) != now.get(key)]:
            _log.warning("%s has changed: start the service again to use %s", self._file, ", ".join(keys))


def _check_content(file: Path, taken: Mapping[str, Any]) -> None:
    """Raise InputRefused for a file that is empty, and was not: an interrupted save leaves one, which is valid TOML."""
    if taken and file.is_file() and not file.stat().st_size:
        fix = "Write it again. To serve without settings, start the service again."
        raise InputRefused("it is empty", (codes.SETTING_UNFIT.finding("The file is empty.", str(file), fix=fix),))


def _findings(file: Path, error: InputRefused | UsageError) -> tuple[Finding, ...]:
    if isinstance(error, InputRefused):
        return error.findings
    rule = codes.SETTING_UNFIT if file.is_file() else codes.FILE_MISSING
    return (rule.finding(str(error), str(file)),)


def _settings_of(file: Path | None) -> Mapping[str, Any]:
    """Values of the file by key; none if it cannot be read."""
    try:
        content = tomllib.loads(file.read_text(encoding="utf-8")) if file is not None else {}
    except (OSError, ValueError, RecursionError):
        return {}
    if file is not None and file.name == "pyproject.toml":
        tools = content.get("tool")
        content = tools.get("sigcat", {}) if isinstance(tools, dict) else {}
    return content if isinstance(content, dict) else {}


def _mark_of(file: Path | None) -> tuple[int, int, tuple[Path, ...]] | None:
    """Size and time of the file, and the files that it finds: those that its wildcards match, and units beside it."""
    try:
        status = file.stat() if file is not None else None
    except OSError:
        return None
    if file is None or status is None:
        return None
    folder, patterns = file.parent, dict.fromkeys(_wildcards(_settings_of(file)))
    matched = (path for text in patterns for path in sorted(files_matching(folder, text)))
    return (status.st_size, status.st_mtime_ns, (*matched, *files_beside([file], (*UNIT_NAMES, *QUANTITY_NAMES))))


def _wildcards(content: Mapping[str, Any]) -> Iterator[str]:
    """The paths of every table that have a wildcard."""
    for key, value in content.items():
        for each in value if isinstance(value, list) else (value,):
            if isinstance(each, dict):
                yield from _wildcards(each)
            elif isinstance(each, str) and "*" in each and key.replace("_", "-") in PATH_LISTS:
                yield each
