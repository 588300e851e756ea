"""The project file that fits a folder: the trees, overlays, units, functions and rules that are in it."""

import json
import os
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

from sigcat.catalogue.model.definition import CORE_ATTRIBUTES
from sigcat.catalogue.model.vocabulary import files_beside
from sigcat.catalogue.reading.layers import Layer, read_layer
from sigcat.errors import UsageError
from sigcat.file_kind import QUANTITY_NAMES, UNIT_NAMES, file_kind
from sigcat.names import parent_path
from sigcat.project.starting.start import catalogue_id
from sigcat.rules.checks.attributes import extended_attributes
from sigcat.rules.linting.discovery import Kind, Source, discover
from sigcat.rules.linting.options import LintOptions
from sigcat.rules.linting.selection import rules_for


class Found(NamedTuple):
    """The files of a folder that a project uses."""

    trees: tuple[Path, ...]
    overlays: tuple[Path, ...]
    """In an order in which each finds the branches that others define."""
    types: tuple[Path, ...]
    units: tuple[Path, ...]
    """Without those that are beside a tree or an overlay, which are found."""
    quantities: tuple[Path, ...]
    functions: tuple[Path, ...]
    """Folders."""
    rules: tuple[Path, ...]
    dbc: tuple[Path, ...]
    attributes: tuple[str, ...]
    """Attributes of overlays that neither VSS nor sigcat defines."""


def found_in(folder: Path) -> Found:
    """Look at the files of a folder. Raises UsageError for a folder without a tree, an overlay and a function."""
    sources = discover([folder])
    trees, overlays = _of(sources, "tree"), tuple(read_layer(path, is_overlay=True) for path in _of(sources, "overlay"))
    functions = _of(sources, "function")
    if not (trees or overlays or functions):
        raise UsageError(
            f"{folder}: no tree, overlay or function found. `sigcat init` without --from starts a project."
        )
    beside = {*files_beside([*trees, *_of(sources, "overlay")], (*UNIT_NAMES, *QUANTITY_NAMES))}
    vocabulary = {
        path: file_kind(path.read_bytes(), path.name) for path in _of(sources, "vocabulary") if path not in beside
    }
    return Found(
        trees,
        tuple(Path(layer.name) for layer in _in_order(overlays)),
        _of(sources, "types"),
        tuple(path for path, kind in vocabulary.items() if kind == "units"),
        tuple(path for path, kind in vocabulary.items() if kind == "quantities"),
        _folders(functions, folder),
        _of(sources, "rules"),
        tuple(sorted(path for path in folder.rglob("*.dbc") if path.is_file())),
        tuple(sorted(_attributes(overlays))),
    )


def configuration_of(found: Found, place: Path) -> str:
    """Return the text of the project file. `place` is the folder that it will be in."""
    lists = ("functions", "rules", "units", "quantities", "dbc")
    lines = [f"{name} = {_listed(getattr(found, name), place)}" for name in lists if getattr(found, name)]
    if found.attributes:
        lines += ["", "[lint]", f"extended-attributes = {json.dumps(list(found.attributes), ensure_ascii=False)}"]
    for number, tree in enumerate(found.trees or (None,)):
        name = place.resolve().name if number == 0 else f"{place.resolve().name}-{tree.stem if tree else ''}"
        lines += [
            "",
            "[[catalogue]]",
            f'id = "{catalogue_id(name)}"',
            f"title = {json.dumps(name, ensure_ascii=False)}",
        ]
        lines += [f"spec = {_quoted(tree, place)}" if tree else 'release = "shipped"']
        lines += [f"types = {_listed(found.types, place)}"] if found.types else []
        lines += [f"overlays = {_overlays(found.overlays, place)}"] if found.overlays and number == 0 else []
    return "\n".join(lines).lstrip("\n") + "\n"


def _of(sources: Sequence[Source], kind: Kind) -> tuple[Path, ...]:
    return tuple(source.path for source in sources if source.kind == kind)


def _in_order(overlays: Sequence[Layer]) -> Iterator[Layer]:
    """Yield overlays after those that define the branches above their nodes; otherwise as they are."""
    waiting = list(overlays)
    paths = {layer.name: {statement.path for statement in layer.statements} for layer in overlays}
    while waiting:
        free = (layer for layer in waiting if not any(_needs(layer, other, paths) for other in waiting))
        following = next(free, waiting[0])
        waiting.remove(following)
        yield following


def _needs(layer: Layer, other: Layer, paths: "dict[str, set[str]]") -> bool:
    own, others = paths[layer.name], paths[other.name]
    return layer is not other and any(parent_path(path) in others - own for path in own)


def _attributes(overlays: Iterable[Layer]) -> set[str]:
    known = extended_attributes(tuple(rules_for(LintOptions()))) | CORE_ATTRIBUTES
    return {
        name for layer in overlays for statement in layer.statements for name in statement.values if name not in known
    }


def _folders(functions: Iterable[Path], folder: Path) -> tuple[Path, ...]:
    """The folders that hold the folders of functions, without those inside another one."""
    above = {file.parent.parent if file.parent != folder else folder for file in functions}
    return tuple(sorted(path for path in above if not any(other in path.parents for other in above)))


def _overlays(overlays: Sequence[Path], place: Path) -> str:
    """The overlays as a pattern where it names them in this order, else one by one."""
    folder = overlays[0].parent
    if list(overlays) == sorted(path for path in folder.glob("*.vspec") if path.is_file()):
        return f"[{_quoted(folder / '*.vspec', place)}]"
    return _listed(overlays, place)


def _listed(paths: Iterable[Path], place: Path) -> str:
    return f"[{', '.join(_quoted(path, place) for path in paths)}]"


def _quoted(path: Path, place: Path) -> str:
    return json.dumps(Path(os.path.relpath(path, place)).as_posix(), ensure_ascii=False)
