"""Read a project: `sigcat.toml`, or `[tool.sigcat]` of a pyproject.toml with the same keys.

```toml
functions = ["functions"]             # folders of function.yaml and Function JSON
rules = ["our-rules.yaml"]
units = ["units.yaml"]                # of every catalogue of the project

[[catalogue]]
id = "body"
title = "Body domain"
release = "v5.0"                      # or: spec = "trees/Body.vspec"
overlays = ["overlays/*.vspec"]       # in the order in which they apply
```

Paths are relative to the file. Everything wrong with it is reported at once, with lines.
"""

import os
import re
import sys
import tomllib
from collections.abc import Callable, Container, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from sigcat import codes
from sigcat.catalogue.hosting.source import Source
from sigcat.catalogue.hosting.sources import release_source
from sigcat.catalogue.reading.toml_lines import Lines
from sigcat.errors import InputRefused, NotFound, UsageError
from sigcat.findings import Finding, RuleCode, first_at, in_order
from sigcat.limits import CONFIGURATION_BYTES
from sigcat.names import did_you_mean, nearest
from sigcat.open_files import read_bytes, size_of
from sigcat.path_faults import path_fault
from sigcat.project.chosen_tree import with_additions
from sigcat.project.project import Project
from sigcat.real_path import near_path
from sigcat.rules.linting.configuration import FIELDS as LINT_KEYS
from sigcat.rules.linting.configuration import options_of
from sigcat.rules.linting.options import LintOptions

_OF_CATALOGUES = ("units", "quantities", "types", "include-dirs")
"""Lists that a catalogue may have, and the project for all of its catalogues."""
CATALOGUE_KEYS: Mapping[str, type] = {
    "id": str, "title": str, "spec": str, "release": str, "standard-units": bool,
    **dict.fromkeys(("overlays", *_OF_CATALOGUES), list),
}  # fmt: skip
TOP_KEYS: Mapping[str, type] = {
    "watch": bool, "shipped": bool, "deployment": str, "catalogue": list,
    **dict.fromkeys(("functions", "rules", *_OF_CATALOGUES, "dbc"), list),
    **dict.fromkeys(("lint", "service"), dict),
}  # fmt: skip
_ADVICE = {
    "base": "Write it as `spec` of a [[catalogue]].",
    "overlays": "Write it in a [[catalogue]].",
    **{
        name: f"Write `{name}` before the tables, for every catalogue, or in a [[catalogue]]."
        for name in _OF_CATALOGUES
    },
}
"""Places for the settings of a tree in a project with catalogues."""
_OF_TREES = frozenset(("catalogue", *_OF_CATALOGUES))
"""Keys that a catalogue is made of."""
_OF_SEVERITIES = frozenset(("select", "ignore", "extend-select", "severity", "per-file"))
"""Keys of [lint] that set severities of findings in trees."""
_OF_FOLDERS = frozenset(("include-dirs", "functions"))
"""Lists that name folders; all others name files."""

_ID = r"[A-Za-z0-9][A-Za-z0-9._-]{0,63}"
_POSITION = r"\s*\(at line (\d+), column (\d+)\)|\s*\(at end of document\)"
"""Ends of the messages of tomllib. Its errors have attributes from Python 3.14 on; before, its words no longer change."""
_GIVEN_TWICE = "Cannot overwrite a value"
_KINDS = {str: "text", bool: "true or false", list: "a list"}

TableReader = Callable[[Mapping[str, Any], Path], Any]
"""Reads a table of others, which is empty where the file does not have it. Raises InputRefused with all findings."""


def read_project(file: Path, readers: Mapping[str, TableReader] | None = None) -> Project:
    """Read the file. `readers` check tables that are otherwise kept as they are. Raises InputRefused with all findings."""
    return _read(file, readers or {}, lambda data: data)


def read_catalogues(file: Path) -> Project:
    """Read the catalogues alone, with what is added to them and severities: a revision of git lacks functions and databases.

    Raises InputRefused with all findings.
    """
    return _read(file, {}, _of_trees)


def _of_trees(data: Mapping[str, Any]) -> Mapping[str, Any]:
    lint = data.get("lint")
    severities = _only(lint, _OF_SEVERITIES) if isinstance(lint, dict) else {}
    return {**_only(data, _OF_TREES), "lint": severities}


def _only(values: Mapping[str, Any], names: Container[str]) -> dict[str, Any]:
    return {key: value for key, value in values.items() if key.replace("_", "-") in names}


def _read(
    file: Path, readers: Mapping[str, TableReader], part: Callable[[Mapping[str, Any]], Mapping[str, Any]]
) -> Project:
    text = _text(file)
    try:
        data = tomllib.loads(text)
    except (tomllib.TOMLDecodeError, RecursionError) as error:
        raise _refused(file, [_syntax_error(error, file, text)]) from None
    reading = _Reading(file, Lines(text))
    project = _project(part(reading.own_part(data)), reading, readers)
    if reading.findings:
        raise _refused(file, reading.findings)
    return project


def _project(data: Mapping[str, Any], reading: "_Reading", readers: Mapping[str, TableReader]) -> Project:
    reading.check(data, TOP_KEYS, "")
    read: dict[str, Any] = {name: reading.table(name, data, reader) for name, reader in readers.items()}
    lists: dict[str, Any] = {
        name.replace("-", "_"): _paths(data, name, "", 0, reading)
        for name in ("functions", "rules", *_OF_CATALOGUES, "dbc")
    }
    lint = reading.table("lint", data, options_of) or LintOptions()
    project = Project(
        reading.file,
        deployment=_deployment(data, reading),
        is_watching=bool(data.get("watch", False)),
        shipped=data.get("shipped"),
        lint=lint._replace(rule_files=(*lists["rules"], *lint.rule_files), dbc=(*lists["dbc"], *lint.dbc)),
        tables=read,
        lines=reading.lines,
        **lists,
    )
    _check_one_tree(data, reading)
    catalogues = _catalogues(data.get("catalogue"), reading)
    return project._replace(catalogues=tuple(with_additions(source, project) for source in catalogues))


def _check_one_tree(data: Mapping[str, Any], reading: "_Reading") -> None:
    """Report a tree of the linter, or what is added to it, beside catalogues: all commands check the same."""
    lint = data.get("lint")
    if not data.get("catalogue") or not isinstance(lint, dict):
        return
    for key in lint:
        name = key.replace("_", "-")
        if fix := _ADVICE.get(name):
            message = f"`{key}` in [lint] cannot be used beside [[catalogue]]."
            reading.report(codes.SETTING_UNFIT, message, "lint", 0, key, fix)


class _Reading:
    """The file while it is read, with the findings so far. Not a dataclass: loading that module takes time at each start."""

    def __init__(self, file: Path, lines: Lines) -> None:
        self.file = file
        self.lines = lines
        self.findings: list[Finding] = []
        self._prefix = "" if file.name != "pyproject.toml" else "tool.sigcat"

    def own_part(self, data: Mapping[str, Any]) -> Mapping[str, Any]:
        """The keys of the project: the whole file, or the table of a pyproject.toml."""
        for name in filter(None, self._prefix.split(".")):
            data = data.get(name, {})
            if not isinstance(data, dict):
                self.report(codes.SETTING_UNFIT, f"`{name}` must be a table, not {repr(data)[:60]}.", "", 0)
                return {}
        return data

    def place(self, table: str) -> str:
        """The name of a table in the file."""
        return ".".join(filter(None, (self._prefix, table)))

    def report(
        self, rule: RuleCode, message: str, table: str, number: int, key: str = "", fix: str = "", value: str = ""
    ) -> None:
        """Report a fault of a key, at `value` where that is in its value."""
        line, column = self.lines.position(self.place(table), number, key, value)
        self.findings.append(rule.finding(message, str(self.file), line, column, pointer=key, fix=fix))

    def check(self, values: Mapping[str, Any], known: Mapping[str, type], table: str, number: int = 0) -> None:
        """Report unknown keys, and values of the wrong kind."""
        for key, value in values.items():
            kind = known.get(key.replace("_", "-"))
            if kind is None:
                fix = did_you_mean(key, known) or (not table and _elsewhere(key)) or f"Known are {', '.join(known)}."
                self.report(codes.SETTING_UNKNOWN, f"Unknown setting {key!r}.", table, number, key, fix)
            elif not isinstance(value, kind):
                message = f"`{key}` must be {_KINDS.get(kind, 'a table')}, not {repr(value)[:60]}."
                self.report(codes.SETTING_UNFIT, message, table, number, key)

    def table(self, name: str, data: Mapping[str, Any], reader: TableReader) -> Any:
        """The value that a reader makes of its table; its findings get lines."""
        values = data.get(name, {})
        if not isinstance(values, dict):
            return None  # it has its finding
        try:
            return reader(values, self.file)
        except InputRefused as error:
            self.findings += [self._placed(finding, self.place(name)) for finding in error.findings]
            return None

    def _placed(self, finding: Finding, table: str) -> Finding:
        if finding.line or finding.file != str(self.file):  # the environment has no lines
            return finding
        line, column = self.lines.position_below(table, finding.pointer or finding.path)
        return finding._replace(line=line, column=column)

    def path(self, text: str) -> Path:
        """The path that the file names."""
        return self.near(self.file.parent / Path(text).expanduser())

    def near(self, path: Path) -> Path:
        """A path as the user names it; a link to nothing keeps its name."""
        is_broken = os.path.islink(path) and not os.path.exists(path)  # noqa: PTH110, PTH114 — no OSError
        return near_path(path.parent) / path.name if is_broken else near_path(path)


def _elsewhere(key: str) -> str:
    """The table that a setting before all tables belongs to; empty if it is none of them."""
    tables = {"[[catalogue]]": CATALOGUE_KEYS, "[lint]": LINT_KEYS}
    near = ((name, nearest(key.replace("_", "-"), known, 1)) for name, known in tables.items())
    return next((f"Write `{found[0]}` in {name}." for name, found in near if found), "")


def _text(file: Path) -> str:
    try:
        data = read_bytes(file) if size_of(file) <= CONFIGURATION_BYTES else None
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


def _syntax_error(error: Exception, file: Path, text: str) -> Finding:
    if isinstance(error, RecursionError):
        return codes.NOT_TOML.finding("Values are nested too deeply.", str(file), 1)
    assert isinstance(error, tomllib.TOMLDecodeError)
    message, line, column = _message_and_position(error, text)
    again = _given_before(text.splitlines()[:line])
    if message == _GIVEN_TWICE and again is not None:
        key, first = again
        message = f"`{key}` is given twice, {first_at(str(file), first)}"
        return codes.NOT_TOML.finding(f"Not valid TOML: {message}.", str(file), line, 1, fix="Remove one of the two.")
    return codes.NOT_TOML.finding(f"Not valid TOML: {message}.", str(file), line, column)


def _given_before(lines: Sequence[str]) -> tuple[str, int] | None:
    """The key of the last line, and the line of its table that had it before; None if there is no such line."""
    *before, last = map(_key_of_line, lines)
    for number in range(len(before), 0, -1):
        if last and before[number - 1] == last:
            return last, number
        if lines[number - 1].lstrip().startswith("["):
            break
    return None


def _key_of_line(line: str) -> str:
    match = re.match(r"\s*([\w.\"'-]+)\s*=", line)
    return match[1] if match else ""


def _message_and_position(error: tomllib.TOMLDecodeError, text: str) -> tuple[str, int, int]:
    if sys.version_info >= (3, 14):
        return error.msg, error.lineno, error.colno
    message = str(error)
    position = re.search(_POSITION, message)
    line, column = (int(position[1]), int(position[2])) if position and position[1] else (text.count("\n") + 1, 0)
    return re.sub(_POSITION, "", message), line, column


def _catalogues(listed: Any, reading: _Reading) -> Iterator[Source]:
    known: dict[str, int] = {}
    for number, values in enumerate(listed if isinstance(listed, list) else []):
        if not isinstance(values, dict):
            reading.report(codes.SETTING_UNFIT, "`catalogue` must be tables: [[catalogue]].", "", 0, "catalogue")
            return
        before = len(reading.findings)
        reading.check(values, CATALOGUE_KEYS, "catalogue", number)
        _check_id(values, number, known, reading)
        overlays = _paths(values, "overlays", "catalogue", number, reading)
        lists = {name.replace("-", "_"): _paths(values, name, "catalogue", number, reading) for name in _OF_CATALOGUES}
        source = _base(values, number, reading)
        if source is not None and len(reading.findings) == before:
            title = values.get("title") or (source.title if source.release else values["id"])
            has_standard = bool(values.get(_key(values, "standard-units"), True))
            added: dict[str, Any] = {name: (*getattr(source, name), *paths) for name, paths in lists.items()}
            yield source._replace(
                id=values["id"],
                title=title,
                overlays=(*source.overlays, *overlays),
                has_standard_units=has_standard,
                **added,
            )


def _check_id(values: Mapping[str, Any], number: int, known: dict[str, int], reading: _Reading) -> None:
    catalogue_id = values.get("id")
    if catalogue_id is None:
        reading.report(codes.CATALOGUE_INCOMPLETE, "The catalogue has no `id`.", "catalogue", number)
    elif isinstance(catalogue_id, str) and not re.fullmatch(_ID, catalogue_id):
        message = f"`id` must be letters, digits, '.', '_' and '-', not {catalogue_id[:80]!r}."
        reading.report(codes.SETTING_UNFIT, message, "catalogue", number, "id")
    elif catalogue_id in known:
        reading.report(
            codes.ID_GIVEN_TWICE,
            f"Two catalogues have the id {catalogue_id!r}, {first_at(str(reading.file), known[catalogue_id])}.",
            "catalogue",
            number,
            "id",
        )
    elif isinstance(catalogue_id, str):
        known[catalogue_id] = reading.lines.position(reading.place("catalogue"), number, "id")[0]


def _base(values: Mapping[str, Any], number: int, reading: _Reading) -> Source | None:
    """The source that `spec` or `release` names, without what is laid over it."""
    spec, release = values.get("spec"), values.get("release")
    if spec is None and release is None and not {key.replace("_", "-") for key in values} <= CATALOGUE_KEYS.keys():
        return None  # a misspelled key has its finding
    if (spec is None) == (release is None):
        fault = "neither `spec` nor `release`" if spec is None else "both `spec` and `release`"
        reading.report(
            codes.CATALOGUE_INCOMPLETE, f"The catalogue has {fault}; one of them is needed.", "catalogue", number
        )
        return None
    if isinstance(spec, str):
        path = reading.path(spec)
        if message := path_fault(path):
            fix = "Name the root .vspec file in it." if path.is_dir() else ""
            reading.report(codes.FILE_MISSING, message, "catalogue", number, "spec", fix, spec)
        return Source("", "", path)
    try:
        return release_source(release) if isinstance(release, str) else None
    except (NotFound, UsageError) as error:
        message = str(error)
        text = message[:1].upper() + message[1:]
        reading.report(codes.FILE_MISSING, text, "catalogue", number, "release", value=str(release))
        return None


def _deployment(data: Mapping[str, Any], reading: _Reading) -> Path | None:
    text = data.get("deployment")
    if not isinstance(text, str):
        return None
    path = reading.path(text)
    if message := path_fault(path):
        reading.report(codes.FILE_MISSING, message, "", 0, "deployment", value=text)
    return path


def _paths(values: Mapping[str, Any], name: str, table: str, number: int, reading: _Reading) -> tuple[Path, ...]:
    """The paths of a list; one with a wildcard names every file that matches, in order."""
    key = _key(values, name)
    listed = values.get(key, [])
    if not isinstance(listed, list) or not all(isinstance(item, str) for item in listed):
        if isinstance(listed, list):
            reading.report(codes.SETTING_UNFIT, f"`{name}` must be a list of texts.", table, number, key)
        return ()
    kind = "folder" if name in _OF_FOLDERS else "file"
    found: list[Path] = []
    for item in listed:
        paths, faults = _matches(item, kind, reading) if "*" in item else _named(item, kind, reading)
        found += paths
        for fault in faults:
            reading.report(codes.FILE_MISSING, fault, table, number, key, value=item)
    return tuple(dict.fromkeys(found))


_Matches = tuple[Sequence[Path], Sequence[str]]
"""Paths, and sentences about those that cannot be used."""


def _named(text: str, kind: str, reading: _Reading) -> _Matches:
    path = reading.path(text)
    fault = path_fault(path, kind)
    return ([], [fault]) if fault else ([path], [])


def _matches(text: str, kind: str, reading: _Reading) -> _Matches:
    """The files that match a wildcard. Folders are not meant, unless one is called like a tree."""
    path = reading.file.parent / Path(text).expanduser()
    folder = Path(path.anchor)
    matches = [reading.near(match) for match in sorted(folder.glob(str(path.relative_to(folder))))]
    faults = {match: path_fault(match, kind) for match in matches}
    found = [match for match, fault in faults.items() if not fault]
    told = [fault for match, fault in faults.items() if fault and (match.suffix == ".vspec" or not match.is_dir())]
    return (found, told) if found or told else ([], [_without_matches(text, path, kind)])


def _without_matches(text: str, path: Path, kind: str) -> str:
    """A sentence about a wildcard that nothing matches: its folder cannot be read, or has no such file."""
    folder = next(parent for parent in path.parents if "*" not in str(parent))
    try:
        os.scandir(folder).close()
    except PermissionError as error:
        return f"{str(near_path(folder))!r} cannot be read: {error.strerror}."
    except OSError:
        pass
    return f"There is no {kind} {text!r}."


def _key(values: Mapping[str, Any], name: str) -> str:
    """A key as it is written: with underscores, too."""
    return name if name in values else name.replace("-", "_")
