"""The start page: catalogues and functions that the service hosts, their findings, and what changed last."""

from collections import Counter
from typing import NamedTuple

from fastapi import APIRouter, Request
from fastapi.responses import Response

from sigcat.api.answers.serializers import finding_counts
from sigcat.api.requests.dependencies import TheFunctions, TheLibrary
from sigcat.api.requests.thread_turns import InThread
from sigcat.catalogue.comparing.changes import CLASSES
from sigcat.catalogue.hosting.library import Hosted, Library
from sigcat.web.pages.catalogue_change_pages import changes_between, sides_of
from sigcat.web.rendering import page
from sigcat.web.views.function_states import function_states

router = APIRouter(route_class=InThread)


class LastChanges(NamedTuple):
    """Changes from one hosted catalogue to another one, counted by class."""

    old: Hosted
    new: Hosted
    total: int
    classes: tuple[tuple[str, int], ...]


@router.get("/")
def show_start(request: Request, library: TheLibrary, functions: TheFunctions) -> Response:
    """Catalogues with the findings of reading them, functions with their errors, and the changes of the default catalogue."""
    return page(
        request,
        "start.html",
        catalogues=[(each, finding_counts(each.rejected or each.catalogue.findings)) for each in library],
        functions=function_states(functions.files, library),
        changed=_last_changes(library),
    )


def _last_changes(library: Library) -> LastChanges | None:
    """Return the changes of the default catalogue over the one that it was made from; None for one catalogue alone."""
    old, new = sides_of(library, None, None)
    if old is new:
        return None
    changes = changes_between(old.catalogue, new.catalogue)
    by_class = Counter(change.compatibility for change in changes)
    return LastChanges(old, new, len(changes), tuple((name, by_class[name]) for name in CLASSES if by_class[name]))
