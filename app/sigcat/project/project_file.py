"""A project file while it is read: its places, its paths, and the findings so far."""

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from sigcat import codes
from sigcat.catalogue.reading.toml_lines import Lines
from sigcat.errors import InputRefused
from sigcat.findings import Finding, RuleCode
from sigcat.names import did_you_mean
from sigcat.path_faults import path_fault
from sigcat.real_path import near_path

TableReader = Callable[[Mapping[str, Any], Path], Any]
"""Reads a table of others, which is empty where the file does not have it. Raises InputRefused with all findings."""
_KINDS = {str: "text", bool: "true or false", list: "a list"}
FOLDERS = frozenset(("include-dirs", "functions"))
"""Lists that name folders; all others name files."""
PATH_LISTS = FOLDERS | {"overlays", "with", "units", "quantities", "types", "rules", "dbc"}
"""Keys of lists of paths, in any table. A path of them may have a wildcard."""


class Reading:
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

    def check(
        self,
        values: Mapping[str, Any],
        known: Mapping[str, type],
        table: str,
        number: int = 0,
        elsewhere: Callable[[str], str] = lambda _key: "",
    ) -> None:
        """Report unknown keys, and values of the wrong kind. `elsewhere` knows the place of a key that belongs to another table."""
        for key, value in values.items():
            kind = known.get(key.replace("_", "-"))
            if kind is None:
                fix = did_you_mean(key, known) or elsewhere(key) or f"Known are {', '.join(known)}."
                self.report(codes.SETTING_UNKNOWN, f"Unknown setting {key!r}.", table, number, key, fix)
            elif not isinstance(value, kind):
                message = f"`{key}` must be {_KINDS.get(kind, 'a table')}, not {repr(value)[:60]}."
                fix = f"Write `[[{key}]]`." if kind is list and isinstance(value, dict) else ""
                self.report(codes.SETTING_UNFIT, message, table, number, key, fix)

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


def paths_of(values: Mapping[str, Any], name: str, table: str, number: int, reading: Reading) -> tuple[Path, ...]:
    """The paths of a list; one with a wildcard names every file that matches, in order."""
    key = written_key(values, name)
    listed = values.get(key, [])
    if not isinstance(listed, list) or not all(isinstance(item, str) for item in listed):
        if isinstance(listed, list):
            reading.report(codes.SETTING_UNFIT, f"`{name}` must be a list of texts.", table, number, key)
        return ()
    kind = "folder" if name in FOLDERS else "file"
    found: list[Path] = []
    for item in listed:
        paths, faults = _matches(item, kind, reading) if "*" in item else _one_path(item, kind, reading)
        found += paths
        for fault in faults:
            reading.report(codes.FILE_MISSING, fault, table, number, key, value=item)
    return tuple(dict.fromkeys(found))


_Matches = tuple[Sequence[Path], Sequence[str]]
"""Paths, and sentences about those that cannot be used."""


def _one_path(text: str, kind: str, reading: Reading) -> _Matches:
    path = reading.path(text)
    fault = path_fault(path, kind)
    return ([], [fault]) if fault else ([path], [])


def _matches(text: str, kind: str, reading: Reading) -> _Matches:
    """The files that match a wildcard. Folders are not meant, unless one is called like a tree."""
    path = reading.file.parent / Path(text).expanduser()
    matches = [reading.near(match) for match in sorted(files_matching(reading.file.parent, text))]
    faults = {match: path_fault(match, kind) for match in matches}
    found = [match for match, fault in faults.items() if not fault]
    told = [fault for match, fault in faults.items() if fault and (match.suffix == ".vspec" or not match.is_dir())]
    return (found, told) if found or told else ([], [_without_matches(text, path, kind)])


def files_matching(folder: Path, text: str) -> Iterator[Path]:
    """The paths that a wildcard of a file in a folder matches; none if `**` is a part of a name."""
    path = folder / Path(text).expanduser()
    root = Path(path.anchor)
    return root.glob(str(path.relative_to(root))) if _is_pattern(path) else iter(())


def _is_pattern(path: Path) -> bool:
    return all(name == "**" or "**" not in name for name in path.parts)


def _without_matches(text: str, path: Path, kind: str) -> str:
    """A sentence about a wildcard that nothing matches: its folder cannot be read, or has no such file."""
    if not _is_pattern(path):
        return f"`**` in {text!r} must be the whole name of a folder, as in '**/*.vspec'."
    folder = next(parent for parent in path.parents if "*" not in str(parent))
    return path_fault(near_path(folder), "folder") or f"There is no {kind} {text!r}."


def written_key(values: Mapping[str, Any], name: str) -> str:
    """A key as it is written: with underscores, too."""
    return name if name in values else name.replace("-", "_")
