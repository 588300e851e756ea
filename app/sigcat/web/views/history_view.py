"""The history of a node, ready to be shown: a row for each release that has it."""

from collections.abc import Iterator, Mapping
from typing import NamedTuple

from sigcat.catalogue.hosting.library import Hosted, Library
from sigcat.migration.node_history import (
    Event,
    NodeHistory,
    event_text,
    history_summary,
    official_releases,
    release_text,
)

SIGNS = {"oldest": "·", "added": "+", "removed": "−", "changed": "~", "moved": "→", "": "="}
_OLDEST = {"oldest": ", the oldest release here"}


class HistoryRow(NamedTuple):
    """A release, and what happened in it."""

    release: str
    """Number of the release; empty: the catalogue itself."""
    hosted: Hosted | None
    """The hosted release."""
    path: str
    """Path of the node in it; empty if it was removed."""
    event: Event | None
    """None if nothing happened."""
    where: str
    """The release, with those before it that are not here."""
    text: str
    sign: str


class HistoryView(NamedTuple):
    """The history of a node."""

    history: NodeHistory
    rows: tuple[HistoryRow, ...]
    summary: str


def history_view(history: NodeHistory, library: Library) -> HistoryView:
    """The history with a row for each release from the first that has the node."""
    catalogues = {id(each.catalogue): each for each in library}
    releases = official_releases((each.source, each.catalogue) for each in library)
    hosted = {each.number: catalogues[id(each.catalogue)] for each in releases}
    return HistoryView(history, tuple(_rows(history, hosted)), history_summary(history))


def _rows(history: NodeHistory, hosted: Mapping[str, Hosted]) -> Iterator[HistoryRow]:
    """Yield the releases in their order. The events of the catalogue itself follow its release."""
    by_release = {event.release: event for event in history.events}
    path = ""
    for release in _places(history):
        event = by_release.get(release)
        path = event.path if event else path
        if event:
            text = event_text(event, history)
            text = text[:1].upper() + text[1:] + _OLDEST.get(event.kind, "")
            yield HistoryRow(release, hosted.get(release), path, event, release_text(event), text, SIGNS[event.kind])
        elif path:
            yield HistoryRow(release, hosted.get(release), path, None, release, "Unchanged", SIGNS[""])


def _places(history: NodeHistory) -> Iterator[str]:
    """Yield the releases, and the catalogue itself where it has an event."""
    events = [event.release for event in history.events]
    for release in dict.fromkeys((*history.releases, *events)):
        if release:
            yield release
        if "" in events and release == history.release:
            yield ""
    if "" in events and history.release not in history.releases:
        yield ""
