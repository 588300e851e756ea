"""Migrate the files of a project: paths of files and a migration in, changed texts and findings out. Nothing is written."""

import os
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import chain
from pathlib import Path
from typing import NamedTuple

from yaml.nodes import MappingNode

from sigcat import codes
from sigcat.catalogue.comparing.sides import Side
from sigcat.catalogue.reading.yaml_document import read_document
from sigcat.errors import NotFound
from sigcat.file_kind import ROOT_NAME, ending_of, file_kind
from sigcat.findings import Finding, RuleCode, in_order
from sigcat.limits import DEFAULT_LIMITS
from sigcat.migration.changed_text import Migrated, Outcome, Replacement, migrated
from sigcat.migration.function_changes import FunctionFile, function_changes
from sigcat.migration.include_changes import Included, include_changes, included_below
from sigcat.migration.migration import Migration
from sigcat.migration.overlay_changes import OverlayFile, overlay_changes
from sigcat.migration.record import RECORD, Record, folder_of_record, read_record, record_bytes, releases_of
from sigcat.migration.release_changes import pipeline_changes, project_changes, vehicle_changes
from sigcat.migration.table import is_table, read_table, release_of, tables_between
from sigcat.migration.trace_changes import migrated_trace
from sigcat.migration.yaml_changes import yaml_changes
from sigcat.open_files import read_bytes
from sigcat.real_path import real_path

_SKIPPED = frozenset(("node_modules", "__pycache__", "build", "dist", "site-packages"))
_PROJECTS = ("sigcat.toml", "pyproject.toml")
_PIPELINES = ("makefile", "jenkinsfile", "azure-pipelines.yml", ".pre-commit-config.yaml", "bitbucket-pipelines.yml")
_PIPELINE_FOLDERS = frozenset((".github", ".circleci", ".gitlab"))
_NAME_OF_PIPELINE = re.compile(r"\.gitlab-ci.*\.ya?ml")
_YAML = (".yaml", ".yml")
_PATH_IN_JSON = re.compile(r'"([A-Za-z]\w*(?:\.\w+)+)"')


class Options(NamedTuple):
    """Options of a migration."""

    tables: tuple[Path, ...] = ()
    """Tables of moves; without any, the shipped ones."""
    choices: Mapping[str, str] = {}
    """New paths that a person chose."""
    accepts_guesses: bool = False


class Releases(NamedTuple):
    """Names of both sides: as the user wrote them, and as `.sigcat-migrated` has them."""

    old: str
    new: str
    new_id: str


class Project(NamedTuple):
    """The files to migrate, and what is known about them."""

    files: tuple[Path, ...]
    releases: Releases
    folder: Path
    """Folder of the record of files that are below no project."""
    records: Mapping[Path, Record]
    """By their folders."""
    layers: frozenset[Path] = frozenset()
    """Files of the two catalogues themselves, which are not changed."""


def migrated_files(
    paths: Sequence[Path], folder: Path, sides: tuple[Side, Side], options: Options
) -> tuple[tuple[Migrated, ...], Mapping[Path, bytes]]:
    """Migrate the files below paths between two sides. Returns them, and the changed records by their paths.

    Raises NotFound, UsageError for a damaged record, and InputRefused for a table that cannot be used.
    """
    old, new = (side.catalogue for side in sides)
    tables = tuple(map(read_table, options.tables)) or tables_between(release_of(old), release_of(new))
    migration = Migration(old, new, tables, options.choices, accepts_guesses=options.accepts_guesses)
    new_id = release_of(new) or new.digest
    layers = frozenset(real_path(Path(file.name)) for each in (old, new) for file in each.files)
    named = files_in(paths)
    records = {each: read_record(each) for each in {folder_of_record(path, folder) for path in named}}
    project = Project(named, Releases(sides[0].title, sides[1].title, new_id), folder, records, layers)
    files = tuple(migrate(project, migration))
    return files, dict(_changed_records(project, files))


def _changed_records(project: Project, files: Sequence[Migrated]) -> Iterator[tuple[Path, bytes]]:
    for folder, record in project.records.items():
        own = [file for file in files if folder_of_record(Path(file.file), project.folder) == folder]
        after = record_bytes(folder, record, own, project.releases.new_id)
        if after != record_bytes(folder, record, (), ""):
            yield folder / RECORD, after


def files_in(paths: Sequence[Path]) -> tuple[Path, ...]:
    """Return the files below paths, hidden files of pipelines included. Raises NotFound."""
    found: dict[Path, None] = {}
    for path in paths:
        if not path.exists():
            raise NotFound(f"{path}: there is no such file or folder")
        found.update(dict.fromkeys(_walk(path) if path.is_dir() else (path,)))
    return tuple(found)


def migratable(paths: Sequence[Path]) -> Iterator[Path]:
    """Yield the files below paths that a migration may rewrite. Tables of moves are none. Raises NotFound."""
    for path in files_in(paths):
        if path.name == RECORD or (_may_change(path) and not is_table(path)):
            yield path


def _walk(folder: Path) -> Iterator[Path]:
    for here, folders, files in os.walk(folder):
        folders[:] = sorted(f for f in folders if f in _PIPELINE_FOLDERS or not (f.startswith(".") or f in _SKIPPED))
        yield from (Path(here, name) for name in sorted(files))


def migrate(project: Project, migration: Migration) -> Iterator[Migrated]:
    """Yield the files that change, or about which there is something to say."""
    included = included_below(project.files)
    for path in project.files:
        if real_path(path) not in project.layers:
            found = _migrated(path, project, migration, included.get(real_path(path), Included()))
            if found is not None and (found.is_changed or found.findings):
                yield found._replace(findings=in_order(found.findings))


def _migrated(path: Path, project: Project, migration: Migration, included: Included) -> Migrated | None:
    if not _may_change(path):
        return None
    if path.stat().st_size > DEFAULT_LIMITS.file_bytes:
        return _skipped(
            path,
            codes.FILE_TOO_LARGE,
            f"The file has more than {DEFAULT_LIMITS.file_bytes:,} bytes. It is not migrated.",
        )
    data, name, releases = read_bytes(path), str(path), project.releases
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError:
        message = "The file must be in UTF-8. It is not migrated."
        return _skipped(path, codes.NOT_UTF_8, message) if ending_of(path.name) == ".vspec" else None
    record = project.records[folder_of_record(path, project.folder)]
    current = [signal for signal, release in releases_of(record, path, data).items() if release == releases.new_id]
    if path.name in _PROJECTS:
        values: list[str] = []
        of_vehicles = vehicle_changes(name, text, migration, current, values)
        found = migrated(name, data, chain(project_changes(text, releases.old, releases.new), of_vehicles))
        found = found._replace(values=tuple(values))
    elif _is_pipeline(path):
        accepts = migration.accepts_guesses
        outcomes = pipeline_changes(name, text, releases.old, releases.new, accepts_guesses=accepts)
        found = migrated(name, data, outcomes)
    elif ending_of(path.name) == ".csv":
        found = migrated_trace(name, data, migration, current)
    elif ending_of(path.name) == ".json":
        found = migrated(name, data, _of_json(name, text, migration))
    else:
        found = _of_yaml(path, data, migration, included, current)
    return found


def _skipped(path: Path, rule: RuleCode, message: str) -> Migrated | None:
    """Return a finding instead of changes; none about JSON, which is of any program."""
    if ending_of(path.name) == ".json":
        return None
    return Migrated(str(path), b"", b"", findings=(rule.finding(message, str(path), 1, 1),))


def _may_change(path: Path) -> bool:
    return path.is_file() and (
        ending_of(path.name) in (".vspec", ".csv", ".json", *_YAML) or path.name in _PROJECTS or _is_pipeline(path)
    )


def _is_pipeline(path: Path) -> bool:
    name = path.name.lower()
    is_named = name in _PIPELINES or _NAME_OF_PIPELINE.fullmatch(name) is not None or ending_of(name) == ".sh"
    return is_named or (ending_of(name) in _YAML and not _PIPELINE_FOLDERS.isdisjoint(path.parts))


def _of_json(file: str, text: str, migration: Migration) -> Iterator[Finding]:
    """Yield the finding about a generated document that names nodes which moved."""
    if file_kind(text.encode(), file) not in ("function json", "integration json"):
        return
    paths = dict.fromkeys(match[1] for match in _PATH_IN_JSON.finditer(text) if migration.knows(match[1]))
    moved = [path for path in paths if migration.fate(path, is_signal=True).status != "same"]
    if moved:
        message = f"The document names {moved[0]}, which changed."
        yield codes.GENERATED_FILE_OUTDATED.finding(message, file, 1, 1, fix="Generate it again.")


def _of_yaml(path: Path, data: bytes, migration: Migration, included: Included, current: Sequence[str]) -> Migrated:
    document = read_document(data, str(path))
    kind = file_kind(data, path.name)
    if document.root is None and document.findings:  # other files are for other programs
        return Migrated(str(path), data, data, findings=document.findings if kind in ("vspec", "function") else ())
    root = document.root or MappingNode("", [])
    values: list[str] = []
    if kind == "function":
        outcomes: Iterable[Outcome] = function_changes(FunctionFile(str(path), document.text, root, migration))
    elif kind == "vspec":
        outcomes = (
            ()
            if included.is_of_tree or path.name == ROOT_NAME
            else _of_overlay(OverlayFile(str(path), document.text, root, "", migration), included)
        )
    elif kind == "unknown":
        outcomes = yaml_changes(str(path), document.text, root, migration, current, values)
    else:
        outcomes = ()
    found = migrated(str(path), data, outcomes)
    return found._replace(values=tuple(dict.fromkeys(values)))


def _of_overlay(overlay: OverlayFile, included: Included) -> Iterator[Outcome]:
    """Yield the changes of an overlay, which must be the same below each branch that it is included in."""
    prefixes = included.prefixes or ("",)
    results = [list(overlay_changes(overlay._replace(prefix=prefix))) for prefix in prefixes]
    edits = [[each.edit for each in result if isinstance(each, Replacement)] for result in results]
    if any(each != edits[0] for each in edits):
        message = f"The file is included below {' and '.join(prefixes)}, where it changes differently."
        yield codes.MOVE_UNDECIDED.finding(message, overlay.file, 1, 1, fix="Split the file.")
        return
    yield from results[0]
    yield from include_changes(overlay.file, overlay.text, prefixes[0], overlay.migration)
