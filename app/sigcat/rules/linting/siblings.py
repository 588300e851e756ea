"""Other meanings of overlays: they stack, and one has what another lacks; or they have a separate tree."""

import re
from collections.abc import Callable, Collection, Iterable, Iterator
from pathlib import Path

from sigcat import codes
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.model.interfaces import category_of, interface_name
from sigcat.catalogue.reading.layers import Layer
from sigcat.findings import Finding
from sigcat.names import parent_path
from sigcat.rules.checks.references import names_in
from sigcat.rules.checks.signals import moved_to
from sigcat.rules.engine import Found
from sigcat.rules.linting.includes import first_bytes
from sigcat.rules.record import Rule

_KEY = re.compile(rb"^[\"']?([A-Za-z_][\w.]*)[\"']?[ \t]*:", re.MULTILINE)
_OF_A_PATH = frozenset(("overlay-unknown-node", "overlay-deletes-nothing"))
"""Checks that find a node which is missing."""


def with_siblings(
    found: Iterable[Found], overlay: Path, catalogue: Catalogue, rules: Iterable[Rule]
) -> Iterator[Found]:
    """Findings; those of something that is missing say which overlay beside this one has it."""
    by_id = {rule.id: rule for rule in rules}
    for finding, repair in found:
        is_missing = _is_missing(finding, by_id.get(finding.rule), catalogue)
        other = _file_with(is_missing, overlay) if is_missing is not None else None
        if other is not None:
            advice = f"{other.name!r} has it: if they apply together, list both as `overlays` in the configuration."
            yield finding._replace(fix=advice), None
        else:
            yield finding, repair


def with_own_tree(found: Iterable[Found], layer: Layer, rules: Iterable[Rule]) -> Iterator[Found]:
    """Findings of an overlay over the shipped tree, which the user did not name: it may be meant as a whole tree."""
    about_overlays = {rule.id for rule in rules if rule.check.startswith("overlay-")}
    is_whole = _is_whole(layer)
    for finding, repair in found:
        if is_whole and finding.rule in about_overlays:
            fix = f"{finding.fix} If the file is a separate tree and not an overlay of the shipped one, add `-s {layer.name}`."
            yield finding._replace(fix=fix.lstrip()), repair
        else:
            yield finding, repair


def _is_whole(layer: Layer) -> bool:
    """Whether a layer has a root with a description, all branches that it needs, and a type of every node."""
    written = {statement.path: statement.values for statement in layer.statements}
    roots = [path for path in written if "." not in path]
    return (
        len(roots) == 1
        and "description" in written[roots[0]]
        and all(
            "type" in values and (path in roots or parent_path(path) in written) for path, values in written.items()
        )
    )


def _is_missing(finding: Finding, rule: Rule | None, catalogue: Catalogue) -> Callable[[str], bool] | None:
    """Whether a path is what a finding misses; None for a finding that misses nothing."""
    if finding.rule == codes.BRANCH_UNDEFINED.id or (rule is not None and rule.check in _OF_A_PATH):
        return finding.path.__eq__
    definition = catalogue.definitions.get(finding.path)
    if rule is None or definition is None:
        return None
    if rule.check == "deprecation-target":
        target = moved_to(definition)
        return lambda path: path == target or path.endswith(f".{target}")
    if rule.check == "reference":
        names = frozenset(names_in(definition, rule.options["attribute"])).difference(catalogue.interfaces)
        return lambda path: _is_interface_among(names, path)
    return None


def _is_interface_among(names: Collection[str], path: str) -> bool:
    return category_of(path) not in (None, "data") and interface_name(path) in names


def _file_with(is_missing: Callable[[str], bool], overlay: Path) -> Path | None:
    """A file in the folder of an overlay that writes such a node."""
    for other in sorted(overlay.parent.glob("*.vspec")):
        if other.name != overlay.name and any(is_missing(key.decode()) for key in _KEY.findall(first_bytes(other))):
            return other
    return None
