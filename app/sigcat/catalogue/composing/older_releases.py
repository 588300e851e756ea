"""Trees and units of older releases, read as the tools of their time read them, with warnings.

What differs from the present form, by release:

| release | units | spellings in trees |
|---|---|---|
| 3.0 | none: they were in the tools | `enum` for `allowed`, `rbranch`, `type: Actuator` |
| 3.1, 4.0 | one mapping under `units:`, with `label`, `description`, `domain`; no quantities | – |
| 4.1, 4.2 | present form, some entries with old field names; a quantity need not be defined | – |
| 5.0 on | present form | – |

Sources: the changelogs of VSS and of vss-tools. Tools before 5.0 checked neither datatypes of units, nor bounds, nor
duplicate keys; in a tree of that time these are warnings.
"""

import re
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from sigcat import codes
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.model.datatypes import DATATYPES, PRIMITIVES
from sigcat.catalogue.model.definition import TYPES
from sigcat.catalogue.model.vocabulary import (
    STANDARD_QUANTITIES,
    STANDARD_UNITS,
    Quantity,
    Unit,
    Vocabulary,
    files_beside,
    read_vocabulary,
    shared_name,
)
from sigcat.catalogue.reading.layers import Layer
from sigcat.catalogue.reading.statement import Origin, SourceFile, Statement
from sigcat.catalogue.reading.vspec_file import VspecFile, parse_vspec
from sigcat.digest import digest_of
from sigcat.file_kind import QUANTITY_NAMES, ROOT_NAME, UNIT_NAMES
from sigcat.findings import Finding, in_order
from sigcat.limits import DEFAULT_LIMITS, Limits
from sigcat.open_files import read_bytes, size_of
from sigcat.real_path import each_once

_PRESENT_NAMES = {"description": "definition", "label": "unit", "units": "unit", "domain": "quantity"}
"""Fields of a unit by their names before 4.1 (`units` is a slip in 4.1 itself)."""
_OLD_NAME = re.compile(rb"^units:|^[ \t]+(?:description|label|units|domain):", re.MULTILINE)
_ANY_DATATYPE = tuple(sorted(PRIMITIVES))
_UNITS_OF_TOOLS = (
    ("UNIX Timestamp", "Seconds since 1970-01-01 00:00:00 UTC, leap seconds not counted.", "datetime"),
    ("MB", "Amount of data in units of one million bytes.", "data"),
    ("MB/s", "Amount of data in each second, in units of one million bytes.", "data per time"),
)
"""Units that the tools of 3.0 knew and that are no longer in the shipped vocabulary."""
_SPELLINGS_OF_TOOLS = {"Celsius": "celsius"}
"""Keys of shipped units in the spelling of 3.0, which a tree of 3.0 keeps."""
ESSENTIAL = frozenset(
    rule.id
    for rule in (
        codes.NOT_YAML, codes.NOT_UTF_8, codes.NOT_A_MAPPING, codes.NOT_A_VALUE, codes.ALIAS_TO_ITSELF,
        codes.FILE_UNREADABLE, codes.FILE_TOO_LARGE, codes.NESTING_TOO_DEEP,
        codes.INCLUDE_MISSING, codes.INCLUDE_CYCLE, codes.INCLUDE_OUTSIDE, codes.INCLUDES_MULTIPLY,
        codes.SECOND_ROOT, codes.OUTSIDE_ROOT, codes.PATH_MALFORMED, codes.INSTANCES_MULTIPLY,
    )
)  # fmt: skip
"""Rules that every tree has to follow, of any age: without them its files cannot be read, or are not a tree."""


class Units(NamedTuple):
    """A vocabulary, and whether it shows that the tree beside it is of an older release."""

    vocabulary: Vocabulary
    is_older: bool


class _Entry(NamedTuple):
    """A unit of an older file, its fields under their present names."""

    key: str
    values: Mapping[str, Any]
    origin: Origin
    is_older: bool


class _OlderFile(NamedTuple):
    """A units file in an older form."""

    source: SourceFile
    entries: list[_Entry]


# -- units --------------------------------------------------------------------------------------------------------


def read_units(
    spec: Path,
    units: Sequence[Path] = (),
    quantities: Sequence[Path] = (),
    limits: Limits = DEFAULT_LIMITS,
    *,
    overlays: Sequence[Path] = (),
    has_standard: bool = True,
) -> Units:
    """The vocabulary of a tree of any age: the files beside the tree, then those beside its overlays, then those given.

    A tree without units has those of VSS, unless `has_standard` is false. An official one is of 3.0, if none are given:
    its units were in the tools.
    """
    if not units and not files_beside([spec], UNIT_NAMES) and spec.name == ROOT_NAME and spec.is_file():
        more = read_vocabulary(files_beside(overlays, UNIT_NAMES), (), limits)
        return Units(_joined(_units_of_tools(spec, limits), more), is_older=True)
    unit_files = unit_files_of(spec, overlays, units, has_standard=has_standard)
    quantity_files = each_once((*files_beside([spec, *overlays], QUANTITY_NAMES), *quantities))
    older = [file for path in unit_files if (file := _older_file(path, limits)) is not None]
    names = {file.source.name for file in older}
    present = [path for path in unit_files if str(path) not in names]
    vocabulary = read_vocabulary(present, quantity_files, limits, has_standard=has_standard)
    for file in older:
        vocabulary = _with_older(vocabulary, file)
    given = frozenset(map(str, (*units, *quantities)))
    return Units(vocabulary._replace(given=given), bool(older))


def unit_files_of(
    spec: Path, overlays: Sequence[Path], units: Sequence[Path], *, has_standard: bool = True
) -> tuple[Path, ...]:
    """The files of units of a tree: those beside it, or else those of VSS; those beside its overlays; those given."""
    own = files_beside([spec], UNIT_NAMES) or ((STANDARD_UNITS,) if has_standard else ())
    return each_once((*own, *files_beside(overlays, UNIT_NAMES), *units))


def _joined(first: Vocabulary, second: Vocabulary) -> Vocabulary:
    return Vocabulary(
        {**first.units, **second.units},
        {**first.quantities, **second.quantities},
        (*first.files, *second.files),
        (*first.findings, *second.findings),
        unusable=second.unusable,
        is_incomplete=second.is_incomplete,
    )


def _older_file(path: Path, limits: Limits) -> _OlderFile | None:
    """A units file in an older form; None for one in the present form and for one that cannot be read."""
    try:
        data = read_bytes(path) if size_of(path) <= limits.file_bytes else b""
    except OSError:
        return None
    if not _OLD_NAME.search(data):
        return None
    source = SourceFile(str(path), "", digest_of(data))
    entries = list(_entries(parse_vspec(data, source, limits)))
    return _OlderFile(source, entries) if any(entry.is_older for entry in entries) else None


def _entries(file: VspecFile) -> Iterator[_Entry]:
    if [statement.path for statement in file.statements] == ["units"]:
        (statement,) = file.statements
        for key, values in statement.values.items():
            if isinstance(values, dict):
                yield _Entry(key, _with_present_names(values), statement.origin_of_key(key), is_older=True)
        return
    for statement in file.statements:
        values = _with_present_names(statement.values)
        yield _Entry(statement.path, values, statement.origin(), values.keys() != statement.values.keys())


def _with_present_names(values: Mapping[str, Any]) -> dict[str, Any]:
    renamed = {_PRESENT_NAMES[name]: value for name, value in values.items() if name in _PRESENT_NAMES}
    return {**renamed, **{name: value for name, value in values.items() if name not in _PRESENT_NAMES}}


def _with_older(vocabulary: Vocabulary, file: _OlderFile) -> Vocabulary:
    units, quantities = dict(vocabulary.units), dict(vocabulary.quantities)
    findings = [*vocabulary.findings, _older_form(file.entries)]
    names: dict[str, Unit] = {}
    for unit in map(_unit, file.entries):
        if unit.name in names:
            findings.append(shared_name(unit, names[unit.name]))
        names[unit.name] = units[unit.name] = units[unit.key.lower()] = unit
        quantities.setdefault(unit.quantity.lower(), Quantity(unit.quantity, "", "", unit.origin))
    files = (*vocabulary.files, file.source)
    return vocabulary._replace(units=units, quantities=quantities, files=files, findings=tuple(findings))


def _unit(entry: _Entry) -> Unit:
    values = entry.values
    allowed = values.get("allowed-datatypes")
    known = [name for name in allowed if name in DATATYPES] if isinstance(allowed, list) else []
    return Unit(
        entry.key,
        str(values.get("unit") or entry.key),
        str(values.get("definition") or ""),
        str(values.get("quantity") or ""),
        tuple(known) or _ANY_DATATYPE,
        str(values.get("deprecation") or ""),
        entry.origin,
    )


def _older_form(entries: Sequence[_Entry]) -> Finding:
    older = [entry for entry in entries if entry.is_older]
    named = ", ".join(repr(entry.key) for entry in older[:3]) + (", …" if len(older) > 3 else "")
    units = "1 unit is" if len(older) == 1 else f"{len(older)} units are"
    message = f"{units} written as before VSS 4.1: {named}."
    fix = "Write `definition`, `unit`, `quantity` and `allowed-datatypes`, without `units:` above."
    return codes.UNITS_OF_OLDER_RELEASE.finding(message, *older[0].origin.position, fix=fix)


def _units_of_tools(spec: Path, limits: Limits) -> Vocabulary:
    """The shipped units, for any datatype, and those that only the tools of 3.0 knew, with a warning."""
    shipped = read_vocabulary([STANDARD_UNITS], [STANDARD_QUANTITIES], limits)
    units = {name: _unit_of_tools(unit) for name, unit in shipped.units.items()}
    nowhere = Origin(str(spec), 0, 0)
    for key, definition, quantity in _UNITS_OF_TOOLS:
        units[key.lower()] = Unit(key, key, definition, quantity, _ANY_DATATYPE, "", nowhere)
    message = "No units file next to the tree, as in VSS 3.0; the units that sigcat ships are used."
    finding = codes.UNITS_OF_OLDER_RELEASE.finding(message, str(spec), fix="Name a units file to use others.")
    return Vocabulary(units, shipped.quantities, shipped.files, (*shipped.findings, finding))


def _unit_of_tools(shipped: Unit) -> Unit:
    key = _SPELLINGS_OF_TOOLS.get(shipped.key, shipped.key)
    return shipped._replace(key=key, allowed_datatypes=_ANY_DATATYPE)


# -- trees --------------------------------------------------------------------------------------------------------


def with_present_spellings(layer: Layer) -> Layer:
    """An older base tree with its spellings replaced by the present ones, each with a warning."""
    findings: list[Finding] = []
    statements = tuple(_with_present_spellings(statement, findings) for statement in layer.statements)
    if not findings:
        return layer
    once = {(f.file, f.line, f.column): f for f in reversed(findings)}  # a file may be included several times
    return Layer(layer.name, layer.is_overlay, layer.files, statements, (*layer.findings, *once.values()))


def _with_present_spellings(statement: Statement, findings: list[Finding]) -> Statement:
    values: dict[str, Any] = {}
    for name, value in statement.values.items():
        new_name, new_value = _present(name, value, statement.values)
        if new_name in values:
            return statement
        values[new_name] = new_value
        if (new_name, new_value) != (name, value):
            old, new = (name, new_name) if new_name != name else (f"{name}: {value}", f"{name}: {new_value}")
            message = f"`{old}` is an older spelling of `{new}`."
            origin, fix = statement.origin(name), f"Write `{new}`."
            findings.append(codes.SPELLING_OF_OLDER_RELEASE.finding(message, *origin.position, statement.path, fix=fix))
    if values == dict(statement.values):
        return statement
    return statement.with_values(values)


def _present(name: str, value: Any, values: Mapping[str, Any]) -> tuple[str, Any]:
    if name == "enum" and isinstance(value, list) and "allowed" not in values:
        return "allowed", value
    if name == "value" and values.get("type") == "attribute" and "default" not in values:
        return "default", value
    if name == "type" and value == "rbranch":
        return name, "branch"
    if name == "type" and isinstance(value, str) and value.lower() in TYPES:
        return name, value.lower()
    return name, value


def tolerant(catalogue: Catalogue) -> Catalogue:
    """The catalogue with the errors of its base tree as warnings, except those that leave no tree.

    For official releases: the tools of their time accepted them, and readers cannot change them. Overlays are checked
    as today.
    """
    base = {file.name for layer in catalogue.layers[:1] for file in layer.files}
    files = base | {file.name for file in catalogue.vocabulary.files}
    findings = tuple(_tolerated(finding) if finding.file in files else finding for finding in catalogue.findings)
    if findings == catalogue.findings:
        return catalogue
    return catalogue.with_findings(in_order(findings))


def _tolerated(finding: Finding) -> Finding:
    is_tolerable = finding.severity == "error" and finding.rule not in ESSENTIAL
    return finding._replace(severity="warning") if is_tolerable else finding
