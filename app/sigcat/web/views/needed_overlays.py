"""Overlays of another catalogue that a function needs to build."""

from collections.abc import Iterable
from functools import lru_cache
from typing import NamedTuple

from sigcat.catalogue.hosting.library import Hosted
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.search import overlay_name
from sigcat.function.hosted_files import HostedFiles
from sigcat.function.hosting import HostedFunction, buildable, functions_over
from sigcat.function.node_uses import uses_of


class Need(NamedTuple):
    """A catalogue over which a function builds, and its overlays that make the difference."""

    hosted: Hosted
    overlays: tuple[str, ...]
    """Empty where the trees differ, and not what is laid over them."""


def need_of(each: HostedFunction, files: HostedFiles, catalogue: Catalogue, library: Iterable[Hosted]) -> Need | None:
    """Return the needs of a function that does not build over a catalogue; None if it builds over none of the library."""
    if each.function is not None:
        return None
    everything = tuple(library)
    known, key = _known_needs(files, everything), (each.id, catalogue.digest)
    if key not in known:
        known[key] = _need_of(each, files, catalogue, everything)
    return known[key]


@lru_cache(maxsize=1)
def _known_needs(_files: HostedFiles, _library: tuple[Hosted, ...]) -> dict[tuple[str, str], Need | None]:
    """Needs by function and digest of the catalogue: to find one, a function is built over many catalogues."""
    return {}


def _need_of(each: HostedFunction, files: HostedFiles, catalogue: Catalogue, library: Iterable[Hosted]) -> Need | None:
    for hosted in library:
        other = hosted.catalogue
        if other is catalogue:
            continue
        there = next((one for one in functions_over(buildable(files, other), other) if one.id == each.id), None)
        if there is not None and there.function is not None:
            paths = (use.path for use in uses_of(there.id, there.function))
            return Need(hosted, _overlays(paths, other, catalogue))
    return None


def _overlays(paths: Iterable[str], there: Catalogue, here: Catalogue) -> tuple[str, ...]:
    """The overlays from which one catalogue has nodes that another one lacks, in their order."""
    nodes = (there.nodes[path] for path in paths if path in there.nodes and path not in here.nodes)
    wanted = {statement.file.overlay for node in nodes for statement in node.definition.statements}
    return tuple(overlay_name(layer.name) for layer in there.overlays if layer.name in wanted)
