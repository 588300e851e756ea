"""Tabs of pages with generated documents: the files of a platform as folders, one of them open, and all as an archive."""

from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from io import BytesIO
from typing import NamedTuple
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

from starlette.responses import Response

from sigcat.errors import InputRefused, NotFound
from sigcat.names import nearest
from sigcat.platforms.table import PLATFORMS
from sigcat.web.views.generated_documents import (
    CORE,
    FUNCTION_JSON,
    SET_VIEWS,
    VIEWS,
    GeneratedDocument,
    attached,
    attachment,
    document_named,
    views_of,
)


class Tab(NamedTuple):
    """Views of documents that a page shows together: the files of a platform."""

    title: str
    views: Mapping[str, str]


SET_TABS = {
    CORE: Tab("Code", {CORE: SET_VIEWS[CORE]}),
    **{name: Tab(platform.title, views_of(platform)) for name, platform in PLATFORMS.items()},
}
"""The tabs of a set of functions, by their ids."""
TABS = {**SET_TABS, FUNCTION_JSON: Tab(VIEWS[FUNCTION_JSON], {FUNCTION_JSON: VIEWS[FUNCTION_JSON]})}
"""Those of one function."""
Make = Callable[[Collection[str]], Iterable[GeneratedDocument]]
"""Documents of some views, in the order of the views of a tab."""
_OLDEST = (1980, 1, 1, 0, 0, 0)
"""Date of each file in an archive: the earliest that it can have."""


class Folder(NamedTuple):
    """Documents in one folder of a view."""

    view: str
    """Title of the view, of its first folder; empty for the folders after it."""
    path: str
    documents: Sequence[GeneratedDocument]


class OpenTab(NamedTuple):
    """A tab with its documents, and the one that is open."""

    folders: Sequence[Folder]
    document: GeneratedDocument


def chosen_tab(given: str, titles: Iterable[str], tabs: Mapping[str, Tab]) -> str:
    """Return the id of the tab with a view or a document. `titles` has the tabs of the page, also those without documents.

    Raises NotFound with the nearest ids.
    """
    view = given.partition(".")[0]
    found = next((name for name, tab in tabs.items() if view in tab.views), view)
    if found not in titles:
        raise NotFound(f"Unknown view {given[:100]!r}.", nearest(given[:100], [*titles, *VIEWS]))
    return found


def open_tab(given: str, tab: Tab, make: Make) -> OpenTab:
    """The documents of a tab, and the one with an id, or the first one of a view. Raises NotFound with the nearest ids."""
    made = [(tab.views[document.view], document) for document in make(tab.views)]
    known = {document.id: document for _, document in made}
    of_view = {document.view: document for _, document in reversed(made)}
    if given not in (*known, *of_view):
        raise NotFound(f"Unknown document {given[:100]!r}.", nearest(given[:100], known))
    return OpenTab(_folders(made), known.get(given) or of_view[given])


def download(given: str, name: str, make: Make, tabs: Mapping[str, Tab]) -> Response:
    """A document, or all of a tab as an archive (`ros2.zip`).

    Raises NotFound with the nearest ids, and InputRefused if nothing of the tab can be made.
    """
    tab = given.removesuffix(".zip")
    if tab != given and tab in tabs:
        documents = list(make(tabs[tab].views))
        if not any(document.is_made for document in documents):
            findings = dict.fromkeys(finding for document in documents for finding in document.findings)
            raise InputRefused(f"{tabs[tab].title} cannot be made.", tuple(findings))
        return attachment(_archive(documents), f"{name}.{given}", "application/zip")
    return attached(document_named(given, make))


def _folders(made: Iterable[tuple[str, GeneratedDocument]]) -> list[Folder]:
    """Folders in the order of the views, those of a view by their paths."""
    by_folder: dict[str, dict[str, list[GeneratedDocument]]] = {}
    for title, document in made:
        by_folder.setdefault(title, {}).setdefault(document.folder, []).append(document)
    return [
        Folder(title if index == 0 else "", path, documents)
        for title, folders in by_folder.items()
        for index, (path, documents) in enumerate(sorted(folders.items()))
    ]


def _archive(documents: Iterable[GeneratedDocument]) -> bytes:
    """The documents in folders that are called as their views."""
    data = BytesIO()
    with ZipFile(data, "w") as archive:
        for each in documents:
            if each.is_made:
                entry = ZipInfo(f"{each.view}/{each.file}", _OLDEST)
                archive.writestr(entry, each.text.encode("utf-8", "replace"), ZIP_DEFLATED)
    return data.getvalue()
