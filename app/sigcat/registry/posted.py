"""Files that are posted to the service: functions and overlays over a hosted catalogue, and whole catalogues."""

from collections.abc import Iterator, Sequence
from pathlib import PurePath
from typing import NamedTuple

from sigcat.catalogue.comparing.trial import OverlayPlace
from sigcat.catalogue.hosting.variants import Choice, overlays_of, variant_of
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.reading.layers import Layer, layer_from_text
from sigcat.errors import UsageError
from sigcat.file_kind import file_kind, root_branch
from sigcat.findings import Finding, in_order
from sigcat.limits import Limits
from sigcat.registry.candidates.candidate import Candidate
from sigcat.registry.candidates.candidates import (
    catalogue_candidate,
    function_candidates,
    overlay_candidate,
    overlay_trial,
    read_functions,
)
from sigcat.registry.candidates.catalogue_files import ENDING, sent_catalogue
from sigcat.registry.compatibility.breaking import broken_by_catalogue, broken_by_functions
from sigcat.registry.compatibility.member import file_member
from sigcat.registry.storing.database import Snapshot

File = tuple[bytes, str]
"""Content and name."""


class Posted(NamedTuple):
    """Files by their kind."""

    functions: tuple[File, ...]
    overlays: tuple[File, ...]
    catalogues: tuple[File, ...]


def posted_files(files: Sequence[File]) -> Posted:
    """The files by their kind. Raises UsageError for others."""
    functions, overlays, catalogues = list[File](), list[File](), list[File]()
    for data, name in files:
        if not data.strip():
            raise UsageError(f"{name} is empty. Choose a function or an overlay.")
        kind = file_kind(data, name)
        if name.endswith(ENDING):
            catalogues.append((data, name))
        elif kind in ("function", "function json"):
            functions.append((data, name))
        elif kind == "vspec" and not root_branch(data):
            overlays.append((data, name))
        else:
            raise UsageError(f"{name} must be a function or an overlay. `sigcat publish` sends a tree with its files.")
    return Posted(tuple(functions), tuple(overlays), tuple(catalogues))


def posted_candidates(
    files: Sequence[File], catalogue: Catalogue, version: str, owner: str, limits: Limits
) -> tuple[Candidate, ...]:
    """Candidates of posted files. Raises InputRefused, and UsageError for an overlay or a catalogue without a version."""
    posted = posted_files(files)
    if (posted.overlays or posted.catalogues) and not version:
        raise UsageError("The file of an overlay or a catalogue has no version. Add the parameter `version`.")
    overlays: list[Candidate] = []
    for data, name, layer in _layers(posted.overlays, limits):
        overlays.append(overlay_candidate(layer, data, _place(catalogue, name), version, owner, limits))
        catalogue = overlays[-1].catalogue or catalogue  # files of one request may need each other
    functions = read_functions(posted.functions, catalogue, limits) if posted.functions else ()
    sent = (sent_catalogue(data, name, limits) for data, name in posted.catalogues)
    catalogues = (catalogue_candidate(each.catalogue, each.content, version, owner) for each in sent)
    return (*function_candidates(functions, version), *overlays, *catalogues)


def posted_findings(
    connection: Snapshot, files: Sequence[File], catalogue: Catalogue, limits: Limits
) -> tuple[Finding, ...]:
    """Findings about published functions that the files break. Raises InputRefused for files with errors."""
    return tuple(in_order(_broken(connection, posted_files(files), catalogue, limits)))


def _broken(connection: Snapshot, posted: Posted, catalogue: Catalogue, limits: Limits) -> Iterator[Finding]:
    for _, name, layer in _layers(posted.overlays, limits):
        catalogue = overlay_trial(layer, _place(catalogue, name), limits).catalogue
        yield from broken_by_catalogue(connection, catalogue, name)
    if posted.functions:
        members = [file_member(each) for each in read_functions(posted.functions, catalogue, limits)]
        yield from (conflict.finding for conflict in broken_by_functions(connection, members))
    for data, name in posted.catalogues:
        yield from broken_by_catalogue(
            connection, sent_catalogue(data, name, limits).catalogue, name.removesuffix(ENDING)
        )


def _layers(overlays: Sequence[File], limits: Limits) -> Iterator[tuple[bytes, str, Layer]]:
    for data, name in overlays:
        yield data, name, layer_from_text(data, name, limits=limits)


def _place(catalogue: Catalogue, overlay: str) -> OverlayPlace:
    """The place of an overlay that the catalogue has, which is known by its name; else on top."""
    name, names = PurePath(overlay).stem, overlays_of(catalogue)
    if name not in names:
        return OverlayPlace(catalogue)
    number = names.index(name)
    return OverlayPlace(variant_of(catalogue, Choice("", frozenset(names[number:]))), catalogue.overlays[number + 1 :])
