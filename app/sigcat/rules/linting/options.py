"""The options of a lint, and its result."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from types import MappingProxyType
from typing import Any, NamedTuple

from sigcat.catalogue.hosting.source import Source
from sigcat.data import INTERFACE_RULES
from sigcat.findings import Finding
from sigcat.rules.problem import Repair

_NONE: Mapping[str, Any] = MappingProxyType({})


class CheckedFunctions(NamedTuple):
    """Findings in function files, and the files of the catalogue that they were checked against."""

    findings: Sequence[Finding]
    beside: tuple[str, ...]
    causes: frozenset[str] = frozenset()
    """Faulty files of units: findings in functions may follow from them."""


FunctionCheck = Callable[[Sequence[tuple[bytes, str]], bool], CheckedFunctions]
"""Checks function files, bytes with names, alone and as one set; the flag says whether the set is complete.

Passed in by the command line: this room does not import functions.
"""


class PerFile(NamedTuple):
    """Severities that hold for files that match a glob, relative to the folder of the configuration."""

    glob: str
    severities: Mapping[str, str]


class LintOptions(NamedTuple):
    """Options of a lint. Codes may be cut short: `V1` selects all that start with it."""

    select: tuple[str, ...] = ()
    """Only these rules, in place of the default set."""
    ignore: tuple[str, ...] = ()
    extend_select: tuple[str, ...] = ()
    """These rules beside the default set: those that are off by default."""
    severities: Mapping[str, str] = _NONE
    """error, warning, info or off, by code."""
    per_file: tuple[PerFile, ...] = ()
    file: Path | None = None
    """The configuration."""
    root: Path = Path()
    """Folder to which the globs of `per_file` and `exclude` are relative."""
    exclude: tuple[str, ...] = ()
    base: Path | None = None
    """The tree that overlays are checked against. Without it: one of the paths, or found near the overlay, or shipped."""
    overlays: tuple[Path, ...] = ()
    """Overlays that stack, in the order in which they apply; any other is linted on top of them, alone."""
    catalogues: tuple[Source, ...] = ()
    """The catalogues of the project. Their trees and overlays are linted with what belongs to them."""
    of_vehicles: tuple[Path, ...] = ()
    """Overlays that vehicles of the project add to a catalogue."""
    include_dirs: tuple[Path, ...] = ()
    units: tuple[Path, ...] = ()
    quantities: tuple[Path, ...] = ()
    types: tuple[Path, ...] = ()
    has_standard_units: bool = True
    """Whether a tree without a file of units has those of VSS."""
    dbc: tuple[Path, ...] = ()
    """The CAN database that mappings are checked against."""
    attributes: tuple[str, ...] = ()
    """Extended attributes that count as known."""
    rule_folder: Path = INTERFACE_RULES
    rule_files: tuple[Path, ...] = ()
    """Files with rules of a company."""
    rule_options: Mapping[str, Mapping[str, Any]] = _NONE
    """Options of checks by the code of the rule, over those of the rule's record."""
    baseline: Path | None = None
    check_functions: FunctionCheck | None = None
    check_project: Callable[[], Iterable[Finding]] | None = None
    """Returns the findings in the project file, which is checked with the folder that it is in."""

    def over(self, source: Source) -> "LintOptions":
        """The options with the tree, the overlays and the vocabulary of a catalogue."""
        return self._replace(
            base=source.spec,
            overlays=source.overlays,
            include_dirs=source.include_dirs,
            units=source.units,
            quantities=source.quantities,
            types=source.types,
            has_standard_units=source.has_standard_units,
        )


NO_OPTIONS = LintOptions()


Identity = tuple[str, str, int, int, str]
"""Identity of a finding, whatever its severity and instance: rule, file, line, column, message."""


def identity_of(finding: Finding) -> Identity:
    """The key of a finding's repair."""
    return (finding.rule, finding.file, finding.line, finding.column, finding.message)


class LintResult(NamedTuple):
    """Findings in order, the files that were looked at, and the repairs of those findings that have one."""

    findings: tuple[Finding, ...]
    files: tuple[str, ...]
    beside: tuple[str, ...] = ()
    """Files that were read too, such as those of the tree that an overlay is made for."""
    repairs: Mapping[Identity, Repair] = MappingProxyType({})
    suppressed: int = 0
    counted: frozenset[str] = frozenset()
    """Rules whose findings a report counts where they say the same of one file."""

    @property
    def fails(self) -> bool:
        """Whether a finding is more than a note."""
        return any(finding.severity != "info" for finding in self.findings)
