"""Compose a catalogue for a vehicle: its settings are statements of two layers, with their places in the project file.

`instances` and values of attributes come first; `without` names nodes of the result.
"""

import re
from collections.abc import Iterable, Iterator, Mapping
from fnmatch import translate
from typing import Any, NamedTuple

from sigcat import codes
from sigcat.catalogue.composing.compose import expanded_paths
from sigcat.catalogue.composing.compose_over import Known, compose_over
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.model.definition import BRANCH, Definition, instances_of
from sigcat.catalogue.model.vehicle import Setting, Vehicle
from sigcat.catalogue.reading.layers import Layer
from sigcat.catalogue.reading.statement import SourceFile, Statement, mark_of
from sigcat.digest import digest_of
from sigcat.findings import Finding, RuleCode, shown
from sigcat.limits import DEFAULT_LIMITS, Limits
from sigcat.names import did_you_mean, parent_path

_LAST_RANGE = re.compile(r"\[ *(\d+) *, *\d+ *\](?!.*\[)")
_STATED = ("type", "datatype", "description")
"""Attributes that vss-tools needs of each node that a file names."""

Said = Statement | Finding
"""Results of a setting: a statement, or its fault."""


class _Place(NamedTuple):
    """A position as YAML counts it, from 0."""

    line: int
    column: int


def configured(
    base: Catalogue, vehicle: Vehicle, limits: Limits = DEFAULT_LIMITS, known: Known | None = None
) -> Catalogue:
    """Return the catalogue of a vehicle. Settings that do not fit are findings in the project file.

    `known` are nodes that vehicles over the same base share.
    """
    if not base.roots:
        return base  # its findings say why
    content = repr(vehicle._replace(file="", overlays=())).encode("utf-8", "surrogatepass")
    file = SourceFile(vehicle.file, vehicle.label, digest_of(content))
    changed = _with(base, [*_instances(base, vehicle, file), *_defaults(base, vehicle, file)], file, limits, known)
    return _with(changed, list(_deleted(changed, vehicle, file)), file, limits, known)


def _with(base: Catalogue, said: Iterable[Said], file: SourceFile, limits: Limits, known: Known | None) -> Catalogue:
    statements = tuple(each for each in said if isinstance(each, Statement))
    findings = tuple(each for each in said if isinstance(each, Finding))
    if not statements and not findings:
        return base
    return compose_over(base, Layer(file.overlay, True, (file,), statements, findings), limits, known)


# -- instances --------------------------------------------------------------------------------------------------------


def _instances(base: Catalogue, vehicle: Vehicle, file: SourceFile) -> Iterator[Said]:
    for setting in vehicle.instances:
        definition = base.definitions.get(setting.path)
        if definition is None:
            yield _unknown(setting, base, vehicle)
        elif definition.type != BRANCH:
            yield _unfit(setting, vehicle, f"{setting.path!r} must be a branch to have instances.")
        elif not isinstance(setting.value, int):
            yield _statement(setting, setting.path, file, {"instances": _listed(setting.value)})
        elif (instances := _with_rows(instances_of(definition.values), setting.value)) is None:
            message = f"{setting.path!r} has no range of instances such as `Row[1,2]`."
            yield _unfit(setting, vehicle, message, "Write the instances as a list.")
        else:
            yield _statement(setting, setting.path, file, {"instances": instances})


def _listed(value: Any) -> Any:
    return [_listed(item) for item in value] if isinstance(value, tuple) else value


def _with_rows(instances: list[Any], rows: int) -> list[Any] | None:
    """Return the instances with a number of rows: of the first range. None if there is no range.

    A single row is a list of one name: vss-tools puts nothing below a single name outside a list.
    """
    for position, entry in enumerate(instances):
        if isinstance(entry, str) and (found := _LAST_RANGE.search(entry)):
            first = int(found[1])
            row = f"[{first},{first + rows - 1}]" if rows > 1 else str(first)
            named = f"{entry[: found.start()]}{row}{entry[found.end() :]}"
            return [*instances[:position], named if rows > 1 else [named], *instances[position + 1 :]]
    return None


# -- values of attributes ---------------------------------------------------------------------------------------------


def _defaults(base: Catalogue, vehicle: Vehicle, file: SourceFile) -> Iterator[Said]:
    paths = _paths_of(base) if any(each.path not in base.definitions for each in vehicle.defaults) else {}
    for setting in vehicle.defaults:
        definition = base.definitions.get(paths.get(setting.path, setting.path))
        if definition is None:
            yield _unknown(setting, base, vehicle)
        elif definition.type != "attribute":
            message = f"{setting.path!r} must be an attribute, whose value a vehicle has from the start."
            yield _unfit(setting, vehicle, message, "Write a name without dots for a fact that no node has.")
        else:
            stated = {} if setting.path in base.definitions else _stated(definition)
            yield _statement(setting, setting.path, file, {**stated, "default": _listed(setting.value)})


def _stated(definition: Definition) -> Mapping[str, Any]:
    return {name: definition.values[name] for name in _STATED if name in definition.values}


# -- nodes that a vehicle does not have -------------------------------------------------------------------------------


def _deleted(catalogue: Catalogue, vehicle: Vehicle, file: SourceFile) -> Iterator[Said]:
    if not vehicle.without:
        return
    paths = _paths_of(catalogue)
    chosen: dict[str, Setting] = {}
    for setting in vehicle.without:
        matching = _matching(setting.path, catalogue, paths)
        if not matching:
            yield _unknown(setting, catalogue, vehicle)
        elif matching == [catalogue.roots[0].path]:
            yield _unfit(setting, vehicle, "The root of the tree cannot be removed.")
        chosen |= {path: setting for path in matching if "." in path}
    for path, setting in chosen.items():
        definition = catalogue.definitions.get(paths.get(path, path))
        if definition is not None and not _is_below(path, chosen):  # a branch without a definition is an error already
            values = {} if path in catalogue.definitions else _stated(definition)
            yield _statement(setting, path, file, {**values, "delete": True})


def _paths_of(catalogue: Catalogue) -> Mapping[str, str]:
    """Every path of the signal tree with that of its definition."""
    if catalogue.is_expanded:
        return {node.path: node.template for root in catalogue.roots[:1] for node in root.walk()}
    return dict(expanded_paths(catalogue))


def _matching(pattern: str, catalogue: Catalogue, paths: Mapping[str, str]) -> list[str]:
    """Return the definitions that a path or pattern names, and instances where it does not name their definition."""
    if "*" not in pattern:
        return [pattern] if pattern in catalogue.definitions or pattern in paths else []
    matches = re.compile(translate(pattern)).match
    defined = {path: None for path in catalogue.definitions if matches(path)}
    instances = (path for path, template in paths.items() if template not in defined and matches(path))
    return [*defined, *(path for path in instances if path not in defined)]


def _is_below(path: str, chosen: Mapping[str, Setting]) -> bool:
    above = parent_path(path)
    while above:
        if above in chosen:
            return True
        above = parent_path(above)
    return False


# -- statements and findings ------------------------------------------------------------------------------------------


def _statement(setting: Setting, path: str, file: SourceFile, values: Mapping[str, Any]) -> Statement:
    place = _Place(max(setting.line - 1, 0), max(setting.column - 1, 0))
    mark = mark_of(place, place)
    return Statement(path, file, values, mark, [mark] * len(values))


def _unknown(setting: Setting, catalogue: Catalogue, vehicle: Vehicle) -> Finding:
    if "*" in setting.path:
        message = f"Pattern {setting.path!r} matches no node of catalogue {vehicle.catalogue!r}."
        return _finding(codes.VEHICLE_NODE_UNKNOWN, setting, vehicle, message, "Correct the pattern, or remove it.")
    message = f"Catalogue {vehicle.catalogue!r} has no node {shown(setting.path)}."
    near = did_you_mean(setting.path, (*catalogue.definitions, *_paths_of(catalogue)))
    return _finding(codes.VEHICLE_NODE_UNKNOWN, setting, vehicle, message, near or "Correct the path, or remove it.")


def _unfit(setting: Setting, vehicle: Vehicle, message: str, fix: str = "") -> Finding:
    return _finding(codes.SETTING_UNFIT, setting, vehicle, message, fix)


def _finding(rule: RuleCode, setting: Setting, vehicle: Vehicle, message: str, fix: str) -> Finding:
    return rule.finding(message, vehicle.file, setting.line, setting.column, setting.path, fix=fix)
