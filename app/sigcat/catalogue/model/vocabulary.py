"""Units and quantities: what the `unit` attribute of a tree may say.

A vocabulary is a value: two catalogues with different units live in one process.
"""

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from functools import lru_cache
from pathlib import Path
from typing import Any, NamedTuple

from sigcat import codes
from sigcat.catalogue.model.datatypes import DATATYPES
from sigcat.catalogue.reading.compiled_tree import compiled_file, compiled_files, keep
from sigcat.catalogue.reading.statement import Origin, SourceFile, Statement
from sigcat.catalogue.reading.vspec_file import QUANTITIES, UNITS, EntryWords, VspecFile, parse_vspec
from sigcat.data import VSPEC
from sigcat.digest import digest_of
from sigcat.file_kind import QUANTITY_NAMES, UNIT_NAMES
from sigcat.findings import Finding, RuleCode, shown
from sigcat.limits import DEFAULT_LIMITS, Limits
from sigcat.names import did_you_mean
from sigcat.open_files import read_bytes


class Quantity(NamedTuple):
    """A kind of property that units measure, such as `velocity`."""

    key: str
    definition: str
    remark: str
    origin: Origin


class Unit(NamedTuple):
    """A unit of measurement. `key` is what trees write, `name` is the unit as text."""

    key: str
    name: str
    definition: str
    quantity: str
    allowed_datatypes: tuple[str, ...]
    deprecation: str
    origin: Origin

    @property
    def meaning(self) -> tuple[str | tuple[str, ...], ...]:
        """Everything but where the unit was written."""
        return self.key, self.name, self.definition, self.quantity, self.allowed_datatypes, self.deprecation


class Vocabulary(NamedTuple):
    """Units by lower-case key and by name, quantities by key, and what was wrong with their files."""

    units: Mapping[str, Unit]
    quantities: Mapping[str, Quantity]
    files: tuple[SourceFile, ...]
    findings: tuple[Finding, ...]
    given: frozenset[str] = frozenset()
    """Names of the files that were given, and not found beside the tree: vss-tools would read these alone."""
    unusable: frozenset[str] = frozenset()
    """Units in lower case, by key and by name, that a file defines with an error."""
    is_incomplete: bool = False
    """Whether a file of units could not be read as a whole."""

    def unit(self, name: str) -> Unit | None:
        """The unit with this key or name, in any case."""
        return self.units.get(name.lower())

    def is_unknown(self, name: str) -> bool:
        """Whether no file has a unit with this key or name."""
        return self.unit(name) is None and not self.may_define(name)

    def may_define(self, name: str) -> bool:
        """Whether a file of units has an error because of which the unit may be unknown."""
        return self.is_incomplete or name.lower() in self.unusable

    @property
    def faulty_files(self) -> frozenset[str]:
        """Files with an error or without entries: findings in other files may follow from them."""
        return frozenset(
            finding.file
            for finding in self.findings
            if finding.severity == "error" or finding.rule == codes.VOCABULARY_EMPTY.id
        )

    @property
    def distinct_units(self) -> tuple[Unit, ...]:
        """Every unit once, in the order of its file."""
        return tuple(dict.fromkeys(self.units.values()))


_UNIT_FIELDS = frozenset(
    ("definition", "unit", "label", "quantity", "domain", "qudt", "allowed-datatypes", "deprecation", "comment")
)
"""The fields of a unit, those of older releases included."""
_QUANTITY_FIELDS = frozenset(("definition", "comment", "remark"))
EMPTY = Vocabulary({}, {}, (), ())
STANDARD_UNITS, STANDARD_QUANTITIES = VSPEC / UNIT_NAMES[0], VSPEC / QUANTITY_NAMES[0]
"""The files of VSS, in the words of this project."""


def read_vocabulary(
    unit_files: Sequence[Path],
    quantity_files: Sequence[Path],
    limits: Limits = DEFAULT_LIMITS,
    *,
    has_standard: bool = True,
) -> Vocabulary:
    """Read units and quantities. An entry with an error is a finding, and is skipped.

    `has_standard`: units may measure the quantities of VSS, whether the files define these or not.
    """
    findings: list[Finding] = []
    sources: list[SourceFile] = []
    quantities = {
        key: _quantity(entry, findings)
        for key, entry in _entries(quantity_files, QUANTITIES, limits, sources, findings)
    }
    known = _Quantities(quantities, has_standard=has_standard)
    before = len(findings)
    entries = _entries(unit_files, UNITS, limits, sources, findings)
    wrong = {finding.path.lower() for finding in findings[before:] if finding.severity == "error"}
    units, skipped = _units(entries, known, findings)
    if units and not (quantities or has_standard):
        findings.append(_quantities_missing(unit_files[0]))
    return Vocabulary(
        units,
        {**known.measured, **quantities},
        tuple(sources),
        tuple(findings),
        unusable=frozenset({*wrong, *skipped}.difference(units)),
        is_incomplete="" in wrong,  # an error that is not about one unit
    )


def _units(
    entries: Iterable[tuple[str, Statement]], quantities: "_Quantities", findings: list[Finding]
) -> tuple[dict[str, Unit], set[str]]:
    """The units by key and name, and the keys and names of those that are skipped."""
    units: dict[str, Unit] = {}
    names: dict[str, Unit] = {}
    skipped: set[str] = set()
    for key, entry in entries:
        unit = _unit(entry, quantities, findings)
        if unit is None:
            skipped |= {key, _name_of(entry.values).lower()}
            continue
        if unit.name in names and names[unit.name].key.lower() != key:
            findings.append(shared_name(unit, names[unit.name]))
        if unit.name:
            names[unit.name] = unit
            units[unit.name] = unit
        units[key] = unit
    return units, skipped


class _Quantities:
    """The quantities that units may measure: those that were read, and those of VSS, which are read when one is needed."""

    def __init__(self, read: Mapping[str, Quantity], *, has_standard: bool) -> None:
        self.read = read
        self._has_standard = has_standard
        self.measured: dict[str, Quantity] = {}
        """Quantities of VSS that a unit measures, and no file defines."""

    @property
    def all(self) -> Mapping[str, Quantity]:
        return {**(standard_quantities() if self._has_standard else {}), **self.read}

    def is_known(self, key: str) -> bool:
        """Whether a unit may measure it; anything where none are defined, which is one finding."""
        if key in self.read or not self.all:
            return True
        if key in self.all:
            self.measured[key] = self.all[key]
        return key in self.measured


@lru_cache(maxsize=1)
def standard_quantities() -> Mapping[str, Quantity]:
    """The quantities of VSS by key."""
    return {
        key: _quantity(entry, []) for key, entry in _entries([STANDARD_QUANTITIES], QUANTITIES, DEFAULT_LIMITS, [], [])
    }


def _quantities_missing(units: Path) -> Finding:
    """One finding, not one for every unit."""
    message = f"{str(units)!r} uses quantities that are not defined."
    fix = "Add a quantities.yaml, or pass one with -q."
    return codes.QUANTITIES_MISSING.finding(message, str(units), fix=fix)


def _nothing_defined(path: Path, words: EntryWords) -> Finding:
    message = f"The file does not define a {words.entry}."
    return codes.VOCABULARY_EMPTY.finding(message, str(path), fix="Define one, or remove the file.")


def files_beside(paths: Iterable[Path], names: Sequence[str]) -> tuple[Path, ...]:
    """The files with one of these names in the folders of `paths`."""
    folders = dict.fromkeys(path.parent for path in paths)
    return tuple(folder / name for folder in folders for name in names if (folder / name).is_file())


def _entries(
    paths: Sequence[Path], words: EntryWords, limits: Limits, sources: list[SourceFile], findings: list[Finding]
) -> list[tuple[str, Statement]]:
    entries: dict[str, Statement] = {}
    for path in paths:
        try:
            data = read_bytes(path)
        except OSError as error:
            reason = error.strerror or str(error)
            findings.append(codes.FILE_UNREADABLE.finding(f"{str(path)!r} cannot be read: {reason}.", str(path)))
            continue
        source = SourceFile(str(path), "", digest_of(data))
        file = _parsed(path, data, source, limits, words)
        sources.append(source)
        findings.extend(file.findings)
        if not (file.statements or file.findings):
            findings.append(_nothing_defined(path, words))
        for statement in file.statements:
            key = statement.path.lower()
            if key in entries and not _means_the_same(statement, entries[key]):
                findings.append(_replaced(statement, entries[key], words.entry.capitalize()))
            entries[key] = statement
    return list(entries.items())


def _parsed(path: Path, data: bytes, source: SourceFile, limits: Limits, words: EntryWords) -> VspecFile:
    """Parse a file; those of VSS are kept parsed."""
    if path not in (STANDARD_UNITS, STANDARD_QUANTITIES) or limits != DEFAULT_LIMITS:
        return parse_vspec(data, source, limits, words)
    kept = compiled_files(path.stem)
    file = compiled_file(source, kept) or parse_vspec(data, source, limits, words)
    keep([file], kept, path.stem)
    return file


def _means_the_same(entry: Statement, earlier: Statement) -> bool:
    """Whether an entry of another file says what the earlier one says. Texts of the shipped files are this project's own words."""
    places = {entry.origin().file, earlier.origin().file}
    if entry.path != earlier.path or len(places) == 1:
        return False
    has_own_words = not places.isdisjoint((str(STANDARD_UNITS), str(STANDARD_QUANTITIES)))
    return _meaning(entry.values, has_own_words=has_own_words) == _meaning(earlier.values, has_own_words=has_own_words)


def _meaning(values: Mapping[str, Any], *, has_own_words: bool) -> tuple[Any, ...]:
    allowed = values.get("allowed-datatypes")
    datatypes = frozenset(map(str, allowed)) if isinstance(allowed, list) else allowed
    definition = "" if has_own_words else values.get("definition")
    return _name_of(values), _quantity_of(values), datatypes, definition


def _name_of(values: Mapping[str, Any]) -> str:
    return str(values.get("unit") or values.get("label") or "")


def _replaced(entry: Statement, earlier: Statement, what: str) -> Finding:
    if entry.path == earlier.path:
        message = f"{what} {entry.path!r} replaces the one at {earlier.origin().file}:{earlier.origin().line}."
        return _about(entry, codes.UNIT_REPLACED, message, fix="Give it another key, or remove one of the two.")
    message = f"{what} {entry.path!r} replaces {earlier.path!r}: case does not count in keys, for vss-tools either."
    fix = f"Give one of them another key; until then, {earlier.path!r} means {entry.path!r}."
    return _about(entry, codes.UNIT_REPLACED, message, fix=fix)


def _quantity(entry: Statement, findings: list[Finding]) -> Quantity:
    findings.extend(_unknown_fields(entry, "Quantity", _QUANTITY_FIELDS))
    values = entry.values
    if not values.get("definition"):
        findings.append(_about(entry, codes.UNIT_INCOMPLETE, f"Quantity {entry.path!r} must have a `definition`."))
    return Quantity(entry.path, str(values.get("definition") or ""), str(values.get("remark") or ""), entry.origin())


def _unit(entry: Statement, quantities: _Quantities, findings: list[Finding]) -> Unit | None:
    values = entry.values
    findings.extend(_unknown_fields(entry, "Unit", _UNIT_FIELDS))
    has = {"definition": isinstance(values.get("definition"), str), "unit": "unit" in values or "label" in values}
    if missing := [f"a `{name}`" for name, is_there in has.items() if not is_there]:
        message = f"Unit {entry.path!r} must have {' and '.join(missing)}."
        fix = "" if "quantity" in values or has["unit"] else "A quantity belongs in a file of `quantities`."
        findings.append(_about(entry, codes.UNIT_INCOMPLETE, message, fix=fix))
        return None
    quantity = _quantity_of(values)
    if not quantity:
        message, fix = f"Unit {entry.path!r} must have a `quantity`.", "`sigcat units` lists quantities."
        findings.append(_about(entry, codes.UNIT_INCOMPLETE, message, fix=fix))
        return None
    if not quantities.is_known(quantity.lower()):
        from sigcat.catalogue.model.common_units import quantity_advice  # its tables take time at start-up

        hint = quantity_advice(quantity, entry.path, _name_of(values), quantities.all)
        message = f"Unit {entry.path!r} has the unknown quantity {shown(quantity)}."
        findings.append(_about(entry, codes.QUANTITY_UNKNOWN, message, "quantity", hint))
        return None
    if quantity != quantity.lower() and quantities.all:
        message = (
            f"The quantity of unit {entry.path!r} must be in lower case, not {shown(quantity)}: vss-tools refuses it."
        )
        findings.append(_about(entry, codes.QUANTITY_UNKNOWN, message, "quantity", f"Write {quantity.lower()!r}."))
    allowed = values.get("allowed-datatypes") or []
    if not isinstance(allowed, list):
        message = f"`allowed-datatypes` of unit {entry.path!r} must be a list, not {shown(allowed)}."
        hint = f"Write [{allowed}]." if allowed in DATATYPES else "Write [numeric], for example."
        findings.append(_about(entry, codes.UNIT_INCOMPLETE, message, "allowed-datatypes", hint))
        return None
    unknown = [name for name in allowed if name not in DATATYPES]
    if unknown:
        message = f"Unit {entry.path!r} allows {', '.join(map(shown, unknown))}, which is not a datatype."
        hint = did_you_mean(str(unknown[0]), DATATYPES) or "Use numeric, or datatypes of VSS such as float."
        findings.append(_about(entry, codes.UNIT_INCOMPLETE, message, "allowed-datatypes", hint))
        return None
    return Unit(
        entry.path,
        _name_of(values),
        values["definition"],
        quantity,
        tuple(allowed),
        str(values.get("deprecation") or ""),
        entry.origin(),
    )


def _unknown_fields(entry: Statement, what: str, known: Collection[str]) -> Iterator[Finding]:
    """Fields that other tools ignore silently."""
    for name in entry.values:
        if name not in known:
            message = f"{what} {entry.path!r} has the unknown field {shown(name)}, which is ignored."
            fix = did_you_mean(name.replace("_", "-"), sorted(known, key=lambda field: field in entry.values))
            origin = entry.origin_of_key(name)
            yield codes.UNIT_FIELD_UNKNOWN.finding(message, *origin.position, entry.path, fix=fix or "Remove it.")


def _quantity_of(values: Mapping[str, Any]) -> str:
    qudt = values.get("qudt")
    nested = qudt.get("quantity-kind") if isinstance(qudt, dict) else None
    return str(values.get("quantity") or nested or values.get("domain") or "")


def shared_name(unit: Unit, other: Unit) -> Finding:
    """The finding that two units have one name."""
    message = f"Units {other.key!r} and {unit.key!r} share the name {unit.name!r}."
    fix = "Give each unit a unique name; other tools refuse the file."
    if unit.quantity == other.quantity:
        fix = f"Remove {unit.key!r} and use {other.key!r}. If they differ, give each a unique name."
    return codes.UNIT_NAME_SHARED.finding(message, *unit.origin.position, unit.key, fix=fix)


def _about(entry: Statement, rule: RuleCode, message: str, attribute: str = "", fix: str = "") -> Finding:
    return rule.finding(message, *entry.origin(attribute).position, entry.path, fix=fix)
