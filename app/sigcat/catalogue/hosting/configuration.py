"""`sigcat.toml`: which catalogues and functions a service hosts, declared in one file.

```toml
watch = true                          # read files again when they change
shipped = false                       # leave out what sigcat brings along
functions = ["functions"]             # folders of function.yaml and Function JSON

[[catalogue]]
id = "body"
title = "Body domain"
release = "v5.0"                      # or: spec = "trees/Body.vspec"
overlays = ["overlays/body.vspec"]    # in the order in which they apply
```

Paths are relative to the file. Everything wrong with it is reported at once, with lines.
"""

import re
import sys
import tomllib
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, NamedTuple

from sigcat import codes
from sigcat.catalogue.hosting.source import Source
from sigcat.catalogue.hosting.sources import release_source
from sigcat.catalogue.reading.toml_lines import Lines
from sigcat.errors import InputRefused, NotFound, UsageError
from sigcat.findings import Finding, RuleCode, in_order
from sigcat.limits import CONFIGURATION_BYTES
from sigcat.names import did_you_mean

FILE_NAME = "sigcat.toml"
PATH_LISTS = ("overlays", "units", "quantities", "types", "include_dirs")
CATALOGUE_KEYS: Mapping[str, type] = {
    "id": str, "title": str, "spec": str, "release": str, **dict.fromkeys(PATH_LISTS, list)
}  # fmt: skip
TOP_KEYS: Mapping[str, type] = {"watch": bool, "shipped": bool, "functions": list, "catalogue": list}
_OF_FOLDERS = frozenset(("include_dirs", "functions"))
"""Lists that name folders; all others name files."""

_ID = re.compile(r"[A-Za-z0-9][A-Za-z0-9._-]{0,63}")
_POSITION = re.compile(r"\s*\(at line (\d+), column (\d+)\)|\s*\(at end of document\)")
"""How tomllib ends its messages. Its errors have attributes from Python 3.14 on; before, its words no longer change."""
_KINDS = {str: "text", bool: "true or false", list: "a list"}


class Configuration(NamedTuple):
    """What the file says. Without a file: the shipped catalogues, not watched."""

    file: Path | None = None
    sources: tuple[Source, ...] = ()
    """Declared catalogues, in order."""
    functions: tuple[Path, ...] = ()
    """Folders of functions."""
    is_watching: bool = False
    has_shipped: bool = True
    tables: Mapping[str, Any] = {}
    """What others made of their tables."""


TableReader = Callable[[Mapping[str, Any], Path], Any]
"""Reads a table of others, which is empty where the file does not have it. Raises InputRefused with all findings."""


def read_configuration(file: Path, tables: Mapping[str, TableReader] | None = None) -> Configuration:
    """Read the file. `tables` are further tables, by name. Raises InputRefused with all findings, those of tables too."""
    text = _text(file)
    try:
        data = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise _refused(file, [_syntax_error(error, file, text)]) from None
    reading = _Reading(file, Lines(text))
    others = tables or {}
    reading.check(data, {**TOP_KEYS, **dict.fromkeys(others, dict)}, "")
    read = {name: reading.table(name, data.get(name, {}), reader) for name, reader in others.items()}
    functions = _paths(data, "functions", "", 0, reading)
    sources = tuple(_sources(data.get("catalogue"), reading))
    if reading.findings:
        raise _refused(file, reading.findings)
    return Configuration(
        file,
        sources,
        functions,
        bool(data.get("watch", False)),
        bool(data.get("shipped", True)),
        read,
    )


@dataclass
class _Reading:
    """The file while it is read, with the findings so far."""

    file: Path
    lines: Lines
    findings: list[Finding] = field(default_factory=list)

    def report(self, rule: RuleCode, message: str, table: str, number: int, key: str = "", fix: str = "") -> None:
        line = self.lines.line(table, number, key)
        self.findings.append(rule.finding(message, str(self.file), line, pointer=key, fix=fix))

    def check(self, values: Mapping[str, Any], known: Mapping[str, type], table: str, number: int = 0) -> None:
        """Report unknown keys, and values of the wrong kind."""
        for key, value in values.items():
            kind = known.get(key) or known.get(key.replace("-", "_"))
            if kind is None:
                fix = did_you_mean(key, known) or f"Known are {', '.join(known)}."
                self.report(codes.SETTING_UNKNOWN, f"Unknown setting {key!r}.", table, number, key, fix)
            elif not isinstance(value, kind):
                message = f"`{key}` must be {_KINDS.get(kind, 'a table')}, not {repr(value)[:60]}."
                self.report(codes.SETTING_UNFIT, message, table, number, key)

    def table(self, name: str, values: Any, reader: TableReader) -> Any:
        """What a reader makes of its table; its findings get lines."""
        if not isinstance(values, dict):
            return None  # it has its finding
        try:
            return reader(values, self.file)
        except InputRefused as error:
            self.findings += [self._placed(finding, name) for finding in error.findings]
            return None

    def _placed(self, finding: Finding, table: str) -> Finding:
        if finding.line or finding.file != str(self.file):  # the environment has no lines
            return finding
        return finding._replace(line=self.lines.line_below(table, finding.pointer or finding.path))

    def path(self, text: str) -> Path:
        return self.file.parent / Path(text).expanduser()


def _text(file: Path) -> str:
    try:
        data = file.read_bytes() if file.stat().st_size <= CONFIGURATION_BYTES else None
    except OSError as error:
        raise UsageError(f"{file}: {error.strerror or error}") from None
    if data is None:
        raise UsageError(f"{file}: the file has more than {CONFIGURATION_BYTES:,} bytes")
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        finding = codes.NOT_TOML.finding("The file is not UTF-8.", str(file), line, fix="Save it as UTF-8.")
        raise _refused(file, [finding]) from None


def _refused(file: Path, findings: list[Finding]) -> InputRefused:
    return InputRefused(f"{file} cannot be used", in_order(findings))


def _syntax_error(error: tomllib.TOMLDecodeError, file: Path, text: str) -> Finding:
    message, line, column = _message_and_position(error, text)
    return codes.NOT_TOML.finding(f"Not valid TOML: {message}.", str(file), line, column)


def _message_and_position(error: tomllib.TOMLDecodeError, text: str) -> tuple[str, int, int]:
    if sys.version_info >= (3, 14):
        return error.msg, error.lineno, error.colno
    message = str(error)
    position = _POSITION.search(message)
    line, column = (int(position[1]), int(position[2])) if position and position[1] else (text.count("\n") + 1, 0)
    return _POSITION.sub("", message), line, column


def _sources(listed: Any, reading: _Reading) -> Iterator[Source]:
    known: set[str] = set()
    for number, values in enumerate(listed if isinstance(listed, list) else []):
        if not isinstance(values, dict):
            reading.report(codes.SETTING_UNFIT, "`catalogue` must be tables: [[catalogue]].", "", 0, "catalogue")
            return
        before = len(reading.findings)
        reading.check(values, CATALOGUE_KEYS, "catalogue", number)
        _check_id(values, number, known, reading)
        lists: dict[str, Any] = {name: _paths(values, name, "catalogue", number, reading) for name in PATH_LISTS}
        source = _base(values, number, reading)
        if source is not None and len(reading.findings) == before:
            title = values.get("title") or (source.title if source.release else values["id"])
            yield source._replace(id=values["id"], title=title, **lists)


def _check_id(values: Mapping[str, Any], number: int, known: set[str], reading: _Reading) -> None:
    catalogue_id = values.get("id")
    if catalogue_id is None:
        reading.report(codes.CATALOGUE_INCOMPLETE, "The catalogue has no `id`.", "catalogue", number)
    elif isinstance(catalogue_id, str) and not _ID.fullmatch(catalogue_id):
        message = f"`id` must be letters, digits, '.', '_' and '-', not {catalogue_id[:80]!r}."
        reading.report(codes.SETTING_UNFIT, message, "catalogue", number, "id")
    elif catalogue_id in known:
        reading.report(codes.ID_GIVEN_TWICE, f"Two catalogues have the id {catalogue_id!r}.", "catalogue", number, "id")
    elif isinstance(catalogue_id, str):
        known.add(catalogue_id)


def _base(values: Mapping[str, Any], number: int, reading: _Reading) -> Source | None:
    """The source that `spec` or `release` names, without what is laid over it."""
    spec, release = values.get("spec"), values.get("release")
    if spec is None and release is None and not values.keys() <= CATALOGUE_KEYS.keys():
        return None  # a misspelled key has its finding
    if (spec is None) == (release is None):
        fault = "neither `spec` nor `release`" if spec is None else "both `spec` and `release`"
        reading.report(
            codes.CATALOGUE_INCOMPLETE, f"The catalogue has {fault}; one of them is needed.", "catalogue", number
        )
        return None
    if isinstance(spec, str):
        path = reading.path(spec)
        if path.is_dir():
            fix = "Name the root .vspec file in it."
            reading.report(
                codes.FILE_MISSING,
                f"`spec` must be a file, not the folder {str(path)!r}.",
                "catalogue",
                number,
                "spec",
                fix,
            )
        elif not path.is_file():
            reading.report(codes.FILE_MISSING, f"There is no file {str(path)!r}.", "catalogue", number, "spec")
        return Source("", "", path)
    try:
        return release_source(release) if isinstance(release, str) else None
    except (NotFound, UsageError) as error:
        message = str(error)
        reading.report(codes.FILE_MISSING, message[:1].upper() + message[1:], "catalogue", number, "release")
        return None


def _paths(values: Mapping[str, Any], name: str, table: str, number: int, reading: _Reading) -> tuple[Path, ...]:
    listed = values.get(name.replace("_", "-"), values.get(name, []))
    if not isinstance(listed, list) or not all(isinstance(item, str) for item in listed):
        if isinstance(listed, list):
            reading.report(codes.SETTING_UNFIT, f"`{name}` must be a list of texts.", table, number, name)
        return ()
    paths = tuple(reading.path(item) for item in listed)
    for path in paths:
        if not (path.is_dir() if name in _OF_FOLDERS else path.is_file()):
            kind = "folder" if name in _OF_FOLDERS else "file"
            reading.report(codes.FILE_MISSING, f"There is no {kind} {str(path)!r}.", table, number, name)
    return paths
