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

import re
import sys
import tomllib
from collections.abc import Callable, Container, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from sigcat import codes
from sigcat.catalogue.hosting.source import Source
from sigcat.catalogue.hosting.sources import release_source, shipped_sources
from sigcat.catalogue.model.vocabulary import files_beside
from sigcat.catalogue.reading.toml_lines import Lines
from sigcat.errors import InputRefused, NotFound, UsageError
from sigcat.file_kind import QUANTITY_NAMES, UNIT_NAMES
from sigcat.findings import Finding, first_at, in_order, shown
from sigcat.limits import CONFIGURATION_BYTES
from sigcat.names import nearest
from sigcat.open_files import read_bytes, size_of
from sigcat.path_faults import path_fault
from sigcat.project.chosen_tree import with_additions
from sigcat.project.project import POSTGRESQL, Project, RegistrySettings, ServerUrl
from sigcat.project.project_file import Reading, TableReader, paths_of, written_key
from sigcat.project.read_vehicles import VEHICLE_KEYS, read_vehicles
from sigcat.rules.linting.configuration import FIELDS as LINT_KEYS
from sigcat.rules.linting.configuration import options_of
from sigcat.rules.linting.options import LintOptions
from sigcat.text_lines import CONFLICT, line_of_conflict, lines_of

_OF_CATALOGUES = ("units", "quantities", "types", "include-dirs")
"""Lists that a catalogue may have, and the project for all of its catalogues."""
_FOUND = {"units": UNIT_NAMES, "quantities": QUANTITY_NAMES}
"""Names of files beside the project file, which it need not list."""
CATALOGUE_KEYS: Mapping[str, type] = {
    "id": str, "title": str, "spec": str, "release": str, "standard-units": bool,
    **dict.fromkeys(("overlays", *_OF_CATALOGUES), list),
}  # fmt: skip
SERVER = r"https?://[^\s/?#@]+(/[^\s?#]*)?"
"""Address of a service: user names and passwords in it would be shown in messages."""
REGISTRY_KEYS: Mapping[str, type] = {
    "database": str, "key": str, "server": str, "webhook-hosts": list, "webhook-networks": list,
}  # fmt: skip
TOP_KEYS: Mapping[str, type] = {
    "watch": bool, "shipped": bool, "deployment": str, "catalogue": list, "vehicle": list,
    **dict.fromkeys(("functions", "rules", *_OF_CATALOGUES, "dbc"), list),
    **dict.fromkeys(("lint", "service", "registry"), dict),
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
_OF_TREES = frozenset(("catalogue", "vehicle", *_OF_CATALOGUES))
"""Keys that a catalogue is made of."""
_OF_SEVERITIES = frozenset(("select", "ignore", "extend-select", "severity", "per-file"))
"""Keys of [lint] that set severities of findings in trees."""

_ID = r"[A-Za-z0-9][A-Za-z0-9._-]{0,63}"
_POSITION = r"\s*\(at line (\d+), column (\d+)\)|\s*\(at end of document\)"
"""Ends of the messages of tomllib. Its errors have attributes from Python 3.14 on; before, its words no longer change."""
_GIVEN_TWICE = "Cannot overwrite a value"


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
    reading = Reading(file, Lines(text))
    project = _project(part(reading.own_part(data)), reading, readers)
    if reading.findings:
        raise _refused(file, reading.findings)
    return project


def _project(data: Mapping[str, Any], reading: "Reading", readers: Mapping[str, TableReader]) -> Project:
    reading.check(data, TOP_KEYS, "", elsewhere=_elsewhere)
    read: dict[str, Any] = {name: reading.table(name, data, reader) for name, reader in readers.items()}
    lists: dict[str, Any] = {
        name.replace("-", "_"): paths_of(data, name, "", 0, reading)
        for name in ("functions", "rules", *_OF_CATALOGUES, "dbc")
    }
    lists |= _vocabulary_beside(data, reading)
    lint = reading.table("lint", data, options_of) or LintOptions()
    project = Project(
        reading.file,
        deployment=_deployment(data, reading),
        is_watching=bool(data.get("watch", False)),
        shipped=data.get("shipped"),
        registry=_registry(data, reading),
        registry_server=_server(data),
        lint=lint._replace(rule_files=(*lists["rules"], *lint.rule_files), dbc=(*lists["dbc"], *lint.dbc)),
        tables=read,
        lines=reading.lines,
        **lists,
    )
    _check_one_tree(data, reading)
    catalogues = tuple(_catalogues(data.get("catalogue"), reading))
    project = project._replace(vehicles=read_vehicles(data.get("vehicle"), _ids(data.get("catalogue")), reading))
    return project._replace(catalogues=tuple(with_additions(source, project) for source in catalogues))


def _ids(listed: Any) -> Sequence[str]:
    """Return the ids that vehicles may name: those of the project, or of the catalogues that sigcat ships."""
    ids = [values["id"] for values in listed if isinstance(values.get("id"), str)] if _is_tables(listed) else []
    return ids or [source.id for source in shipped_sources()]


def _is_tables(listed: Any) -> bool:
    return isinstance(listed, list) and all(isinstance(values, dict) for values in listed)


def _vocabulary_beside(data: Mapping[str, Any], reading: "Reading") -> Mapping[str, tuple[Path, ...]]:
    """The files of units and quantities beside the project file that it does not list. Beside a tree, they are of the tree."""
    catalogues = data.get("catalogue")
    if not isinstance(catalogues, list):
        return {}
    specs = [each.get("spec") for each in catalogues if isinstance(each, dict)]
    if any(reading.path(spec).parent == reading.file.parent for spec in specs if isinstance(spec, str)):
        return {}
    return {name: files_beside([reading.file], names) for name, names in _FOUND.items() if name not in data}


def _check_one_tree(data: Mapping[str, Any], reading: "Reading") -> None:
    """Report a tree of the linter, or what is added to it, beside catalogues: all commands check the same."""
    lint = data.get("lint")
    if not data.get("catalogue") or not isinstance(lint, dict):
        return
    for key in lint:
        name = key.replace("_", "-")
        if fix := _ADVICE.get(name):
            message = f"`{key}` in [lint] cannot be used beside [[catalogue]]."
            reading.report(codes.SETTING_UNFIT, message, "lint", 0, key, fix)


def _before_tables(key: str) -> str:
    """The place of a setting that belongs before all tables; empty if it does not."""
    near = nearest(key.replace("_", "-"), TOP_KEYS, 1)
    of_lint = nearest(key.replace("_", "-"), LINT_KEYS, 1)
    if of_lint and not near:
        return f"Write `{of_lint[0]}` in [lint]."
    return f"Write `{near[0]}` before the first table." if near else ""


def _elsewhere(key: str) -> str:
    """The table that a setting before all tables belongs to; empty if it is none of them."""
    tables = {"[[catalogue]]": CATALOGUE_KEYS, "[[vehicle]]": VEHICLE_KEYS, "[lint]": LINT_KEYS}
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
    again = _given_before(lines_of(text)[:line])
    if message == _GIVEN_TWICE and again is not None:
        key, first = again
        message = f"`{key}` is given twice, {first_at(str(file), first)}"
        return codes.NOT_TOML.finding(f"Not valid TOML: {message}.", str(file), line, 1, fix="Remove one of the two.")
    from sigcat.project.toml_syntax import open_bracket, toml_advice  # seldom needed

    if conflict := line_of_conflict(text):
        return codes.NOT_TOML.finding(CONFLICT[0], str(file), conflict, 1, fix=CONFLICT[1])
    lines = lines_of(text)
    fix = toml_advice(lines, line, column)
    if not fix and (opened := open_bracket(lines[: line - 1])):
        return codes.NOT_TOML.finding(f"Not valid TOML: {message}.", str(file), *opened, fix="Close the bracket.")
    return codes.NOT_TOML.finding(f"Not valid TOML: {message}.", str(file), line, column, fix=fix)


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


def _catalogues(listed: Any, reading: Reading) -> Iterator[Source]:
    known: dict[str, int] = {}
    for number, values in enumerate(listed if isinstance(listed, list) else []):
        if not isinstance(values, dict):
            reading.report(codes.SETTING_UNFIT, "`catalogue` must be tables: [[catalogue]].", "", 0, "catalogue")
            return
        before = len(reading.findings)
        reading.check(values, CATALOGUE_KEYS, "catalogue", number, _before_tables)
        _check_id(values, number, known, reading)
        overlays = paths_of(values, "overlays", "catalogue", number, reading)
        lists = {
            name.replace("-", "_"): paths_of(values, name, "catalogue", number, reading) for name in _OF_CATALOGUES
        }
        source = _base(values, number, reading)
        if source is not None and len(reading.findings) == before:
            title = values.get("title") or (source.title if source.release else values["id"])
            has_standard = bool(values.get(written_key(values, "standard-units"), True))
            added: dict[str, Any] = {name: (*getattr(source, name), *paths) for name, paths in lists.items()}
            yield source._replace(
                id=values["id"],
                title=title,
                overlays=(*source.overlays, *overlays),
                has_standard_units=has_standard,
                **added,
            )


def _check_id(values: Mapping[str, Any], number: int, known: dict[str, int], reading: Reading) -> None:
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


def _base(values: Mapping[str, Any], number: int, reading: Reading) -> Source | None:
    """The source that `spec` or `release` names, without what is laid over it."""
    spec, release = values.get("spec"), values.get("release")
    if spec is None and release is None and not {key.replace("_", "-") for key in values} <= CATALOGUE_KEYS.keys():
        return None  # a misspelled key has its finding
    if (spec is None) == (release is None):
        fault = "neither `spec` nor `release`" if spec is None else "both `spec` and `release`"
        fix = 'Write `release = "shipped"`, or name a root .vspec file as `spec`.' if spec is None else "Remove one."
        message = f"The catalogue has {fault}; one of them is needed."
        reading.report(codes.CATALOGUE_INCOMPLETE, message, "catalogue", number, fix=fix)
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


def _deployment(data: Mapping[str, Any], reading: Reading) -> Path | None:
    text = data.get("deployment")
    if not isinstance(text, str):
        return None
    path = reading.path(text)
    if message := path_fault(path):
        reading.report(codes.FILE_MISSING, message, "", 0, "deployment", value=text)
    return path


def _check_server(values: Mapping[str, Any], reading: Reading) -> None:
    """Report an address that is not one, and a database beside it: one of both would be ignored."""
    server = values["server"]
    if isinstance(server, str) and not re.fullmatch(SERVER, server):
        message = "[registry] `server` must be an address of HTTP or HTTPS."
        reading.report(
            codes.SETTING_UNFIT, message, "registry", 0, "server", 'Write `server = "https://signals.example"`.'
        )
    for other in ("database", "key"):
        if other in values:
            message = f"[registry] must have `server` or `{other}`, not both."
            reading.report(codes.SETTING_UNFIT, message, "registry", 0, other, "Remove one of them.")


def _server(data: Mapping[str, Any]) -> str:
    values = data.get("registry")
    server = values.get("server", "") if isinstance(values, dict) else ""
    return server if isinstance(server, str) else ""


def _registry(data: Mapping[str, Any], reading: Reading) -> RegistrySettings | None:
    """Return the place of the registry, whose files may not exist yet; None if the project has none."""
    values = data.get("registry")
    if not isinstance(values, dict):
        return None
    reading.check(values, REGISTRY_KEYS, "registry", elsewhere=_before_tables)
    database, key = values.get("database"), values.get("key")
    if "server" in values:
        _check_server(values, reading)
        return None
    if database is None or database == "":
        message = "[registry] must have `database`, the path of a file or a URL of PostgreSQL."
        reading.report(codes.SETTING_UNFIT, message, "registry", 0, "database", 'Write `database = "registry.db"`.')
    if not isinstance(database, str):
        return None
    if "://" in database and not database.startswith(POSTGRESQL):
        message = f"`database` of [registry] must be the path of a file, or a URL of PostgreSQL, not {shown(database)}."
        reading.report(codes.SETTING_UNFIT, message, "registry", 0, "database", f"Write {POSTGRESQL}USER@HOST/NAME.")
    place = ServerUrl(database) if database.startswith(POSTGRESQL) else reading.path(database)
    key_file = reading.path(key) if isinstance(key, str) else None
    hosts, networks = (_texts(values, name, reading) for name in ("webhook-hosts", "webhook-networks"))
    for network in networks:
        if not _is_network(network):
            message = f"`webhook-networks` must have networks such as 10.20.0.0/16, not {network!r}."
            reading.report(codes.SETTING_UNFIT, message, "registry", 0, written_key(values, "webhook-networks"))
    return RegistrySettings(place, key_file, hosts, networks)


def _texts(values: Mapping[str, Any], name: str, reading: Reading) -> tuple[str, ...]:
    key = written_key(values, name)
    listed = values.get(key, [])
    if not isinstance(listed, list) or not all(isinstance(item, str) for item in listed):
        if isinstance(listed, list):
            reading.report(codes.SETTING_UNFIT, f"`{name}` must be a list of texts.", "registry", 0, key)
        return ()
    return tuple(listed)


def _is_network(text: str) -> bool:
    import ipaddress

    try:
        ipaddress.ip_network(text)
    except ValueError:
        return False
    return True
