"""Files to publish: read, resolved and checked against the catalogue of the project."""

import json
from collections.abc import Iterable, Mapping, Sequence
from pathlib import PurePath
from typing import Any, NamedTuple

from sigcat import codes
from sigcat.catalogue.comparing.diff_report import plain
from sigcat.catalogue.comparing.trial import OverlayPlace, Trial, try_layer
from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.catalogue.reading.layers import Layer
from sigcat.errors import InputRefused
from sigcat.findings import has_errors
from sigcat.function.function_file import CheckedFunction
from sigcat.function.function_json.model import FunctionJson, to_json
from sigcat.function.sets.check_set import read_set
from sigcat.limits import DEFAULT_LIMITS, Limits
from sigcat.registry.candidates.candidate import Candidate
from sigcat.registry.reference import refused
from sigcat.registry.use import Use, uses_of
from sigcat.registry.use import to_json as uses_json


class ReadFunction(NamedTuple):
    """A function of a file that has no errors."""

    file: str
    content: bytes
    checked: CheckedFunction
    uses: tuple[Use, ...]

    @property
    def function(self) -> FunctionJson:
        """The function."""
        assert self.checked.function is not None
        return self.checked.function


def read_functions(
    files: Sequence[tuple[bytes, str]], catalogue: Catalogue, limits: Limits = DEFAULT_LIMITS
) -> tuple[ReadFunction, ...]:
    """Read functions of named texts as one set, so that one may use definitions of another. Raises InputRefused."""
    members, over = read_set(files, catalogue, limits)
    findings = tuple(finding for member in members for finding in member.findings)
    if has_errors(findings):
        raise InputRefused("the functions have errors", findings)
    return tuple(
        ReadFunction(file, data, member, uses_of(member.function, catalogue, over))
        for (data, file), member in zip(files, members, strict=True)
        if member.function is not None
    )


def function_candidates(functions: Iterable[ReadFunction], version: str = "") -> tuple[Candidate, ...]:
    """Candidates of functions, under their own versions. Raises InputRefused if `version` contradicts one."""
    return tuple(_function_candidate(each, version) for each in functions)


def _function_candidate(read: ReadFunction, version: str) -> Candidate:
    info = read.function.info
    if version and info.version and info.version != version:
        message = f"The version must be {info.version}, as the file says, not {version}."
        finding = codes.VERSION_TAKEN.finding(
            message, read.file, fix="Remove `--version`, or change the version in the file."
        )
        raise refused(finding)
    chosen = version or info.version or ""
    if not chosen:
        message = f"{info.function_name} has no version."
        fix = "Write `version: 1.0.0` in the file, or pass `--version 1.0.0`."
        raise refused(codes.VERSION_NOT_SEMANTIC.finding(message, read.file, fix=fix))
    owner = info.function_responsible.raw
    resolved, uses = to_json(read.function), uses_json(read.uses)
    return Candidate("function", info.function_name, chosen, owner, read.content, resolved, uses, read.file)


def overlay_candidate(
    layer: Layer, content: bytes, place: OverlayPlace, version: str, owner: str = "", limits: Limits = DEFAULT_LIMITS
) -> Candidate:
    """The candidate of an overlay at its place in a catalogue. Raises InputRefused."""
    trial = overlay_trial(layer, place, limits)
    resolved = _nodes_json({node.path: _values(node) for node in trial.nodes})
    name, after = PurePath(layer.name).stem, trial.catalogue
    return Candidate("overlay", name, version, owner, content, resolved, b"", layer.name, all_nodes(after), after)


def overlay_trial(layer: Layer, place: OverlayPlace, limits: Limits = DEFAULT_LIMITS) -> Trial:
    """Apply an overlay at its place in a catalogue. Raises InputRefused if it brings errors."""
    trial = try_layer(place, layer, limits)
    if has_errors(trial.findings):
        raise InputRefused("the overlay has errors", trial.findings)
    return trial


def catalogue_candidate(catalogue: Catalogue, content: bytes, version: str, owner: str = "") -> Candidate:
    """The candidate of a tree with its overlays: its content is every file that it was read from."""
    nodes = all_nodes(catalogue)
    resolved = _nodes_json(nodes)
    return Candidate("catalogue", catalogue.name, version, owner, content, resolved, b"", "", nodes, catalogue)


def all_nodes(catalogue: Catalogue) -> Mapping[str, Mapping[str, Any]]:
    """Attributes of all nodes by path."""
    return {path: _values(node) for path, node in catalogue.nodes.items()}


def _values(node: Node) -> Mapping[str, Any]:
    values: Mapping[str, Any] = plain(dict(node.values))
    return values


def _nodes_json(nodes: Mapping[str, Mapping[str, Any]]) -> bytes:
    return json.dumps(nodes, sort_keys=True, ensure_ascii=False).encode()
