"""Check function files for a lint, over the tree that it has chosen."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from pathlib import Path

from sigcat import codes
from sigcat.catalogue.hosting.source import Source
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.findings import Finding
from sigcat.function.code_files import CodeCheck
from sigcat.function.sets.check_set import check_functions
from sigcat.function.sets.others import other_functions, with_others
from sigcat.rules.linting.options import CheckedFunctions

_NOT_READ = frozenset(
    rule.id
    for rule in (
        codes.NOT_YAML, codes.NOT_UTF_8, codes.FILE_TOO_LARGE, codes.NESTING_TOO_DEEP, codes.ALIAS_TO_ITSELF,
        codes.NOT_A_MAPPING, codes.INCLUDE_MISSING, codes.INCLUDE_CYCLE, codes.INCLUDE_OUTSIDE,
        codes.INCLUDE_MALFORMED, codes.FILE_UNREADABLE, codes.NOT_A_VALUE, codes.INCLUDES_MULTIPLY, codes.NODES_NESTED,
    )
)  # fmt: skip
"""Errors that leave out nodes of a file."""
_OF_ABSENT_NODES = frozenset((codes.SIGNAL_UNKNOWN.id, codes.INTERFACE_UNKNOWN.id))
"""Findings that may follow from nodes that a file with errors does not give."""


def checked_functions(
    tree: Source,
    files: Sequence[tuple[bytes, str]],
    is_whole: bool,
    *,
    load_tree: Callable[[Source], Catalogue],
    check_code: CodeCheck | None = None,
    folders: Sequence[Path] = (),
) -> CheckedFunctions:
    """Check function files against a tree. `load_tree` loads it: an editor keeps it loaded; `check_code` checks headers.

    Functions use what others in `folders` define.
    """
    catalogue = load_tree(tree)
    of_units = [f for f in catalogue.findings if f.file in catalogue.vocabulary.faulty_files and f.severity != "info"]
    of_tree = [f for f in catalogue.findings if f.severity == "error" and f not in of_units]
    if of_tree and not catalogue.roots:  # it could not be read: a function has nothing to be checked against
        of_functions: Iterable[Finding] = of_tree
    else:
        if is_whole:
            checked = _checked_set(files, catalogue, folders, check_code)
        else:
            known = with_others(files, catalogue, folders)
            checked = check_functions(files, known, is_whole=False, check_code=check_code)
        of_functions = _causes_first(checked, of_tree)
    findings = tuple(dict.fromkeys((*of_units, *of_functions)))
    return CheckedFunctions(
        findings, tuple(file.name for file in catalogue.files), frozenset(finding.file for finding in of_units)
    )


def _checked_set(
    files: Sequence[tuple[bytes, str]], catalogue: Catalogue, folders: Sequence[Path], check_code: CodeCheck | None
) -> tuple[Finding, ...]:
    """Findings of a set, which may be a folder of the project: others may define or provide what it lacks."""
    findings = check_functions(files, catalogue, check_code=check_code)
    if all(finding.severity == "info" for finding in findings):
        return findings
    others = other_functions(files, folders)
    if not others:
        return findings
    names = {name for _, name in others}
    together = check_functions([*files, *others], catalogue, check_code=check_code)
    return tuple(finding for finding in together if finding.file not in names)


def _causes_first(findings: Sequence[Finding], errors: Sequence[Finding]) -> Iterator[Finding]:
    """The findings, with errors of the tree instead of those that follow from them."""
    for finding in findings:
        causes = [error for error in errors if _explains(error, finding)]
        yield from causes or (finding,)


def _explains(error: Finding, finding: Finding) -> bool:
    """Whether a node is not there, or lacks a value, because of an error of the tree."""
    if error.path and finding.path == error.path:
        return True
    is_left_out = error.rule in _NOT_READ and finding.rule in _OF_ABSENT_NODES
    return is_left_out and (not error.path or finding.path.startswith(f"{error.path}."))
