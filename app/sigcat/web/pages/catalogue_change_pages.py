"""Two catalogues beside each other: what was added, removed, moved and changed."""

from collections import Counter
from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import Annotated, NamedTuple

from fastapi import APIRouter, Query, Request
from fastapi.responses import Response

from sigcat.api.requests.dependencies import TheWorkQueue
from sigcat.catalogue.comparing.bindings import BINDINGS, EFFECTS, Binding, chosen, classes_of, for_bindings
from sigcat.catalogue.comparing.changes import CLASSES, KINDS, Change
from sigcat.catalogue.comparing.diff import compare
from sigcat.catalogue.hosting.library import Hosted, Library
from sigcat.catalogue.hosting.variants import find_hosted
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.limits import PAGE_CHANGES
from sigcat.web.rendering import page_for
from sigcat.web.views.change_trees import SIGNS, place_of, trees_of, worst_first
from sigcat.web.visits import Visit, visit_of

_REASONS = {effect.rule: effect.why for effect in EFFECTS if effect.what}
"""Sentences of the effects that can decide the class for a binding."""
router = APIRouter()
"""Changes on one page; filters narrow them."""


class Facet(NamedTuple):
    """A filter with the number of changes for each of its values."""

    name: str
    title: str
    counts: tuple[tuple[str, int], ...]
    chosen: str


@router.get("/changes")
async def show_changes(
    request: Request,
    queue: TheWorkQueue,
    old: Annotated[str | None, Query(description="Id of a catalogue.")] = None,
    new: Annotated[str | None, Query(description="Id of a catalogue.")] = None,
    compatibility: Annotated[str, Query(alias="class")] = "",
    kind: str = "",
    binding: Annotated[str, Query(max_length=100)] = "",
    below: Annotated[str, Query(max_length=500)] = "",
) -> Response:
    """The changes from one catalogue to another, as a tree with filters."""
    filters = {"class": compatibility, "kind": kind}
    return await queue.run(_page, visit_of(request), old, new, filters, below, chosen([binding]))


def _page(
    visit: Visit,
    old: str | None,
    new: str | None,
    filters: Mapping[str, str],
    below: str,
    bindings: Sequence[Binding],
) -> Response:
    before, after = sides_of(visit.library, old, new)
    compared = changes_between(before.catalogue, after.catalogue)
    changes = for_bindings(compared, bindings)
    within = [change for change in changes if not below or f"{place_of(change)}.".startswith(f"{below}.")]
    shown = [change for change in within if _fits(change, filters)]
    by_class = Counter(change.compatibility for change in changes)
    return page_for(
        visit,
        "changes.html",
        hosted=after,
        old=before,
        new=after,
        filters={**filters, "below": below, "binding": "".join(bindings)},
        facets=(*_facets(within, filters), _binding_facet(compared, bindings)),
        signs=SIGNS,
        reasons=_REASONS,
        total=len(changes),
        shown=len(shown),
        most=PAGE_CHANGES,
        trees=trees_of(worst_first(shown)[:PAGE_CHANGES]),
        whole=[(name, number) for name in CLASSES if (number := by_class[name])],
    )


def _binding_facet(changes: Sequence[Change], bindings: Sequence[Binding]) -> Facet:
    """Number of changes that break consumers by each binding, whatever the other filters are."""
    classes = (each for change in changes for each in classes_of(change))
    breaking = Counter(each.binding for each in classes if each.compatibility == "breaking")
    return Facet("binding", "Breaks for", tuple((name, breaking[name]) for name in BINDINGS), "".join(bindings))


@lru_cache(maxsize=8)
def changes_between(old: Catalogue, new: Catalogue) -> tuple[Change, ...]:
    """The changes, compared once."""
    return compare(old, new)


def sides_of(library: Library, old: str | None, new: str | None) -> tuple[Hosted, Hosted]:
    """The two catalogues; without names, the default one and the one that it was made from."""
    after = find_hosted(library, new) if new else library.default
    return find_hosted(library, old) if old else _before(after, library), after


def _before(after: Hosted, library: Library) -> Hosted:
    """The catalogue with most of the overlays of another one over the same tree; else the first one beside it, or itself."""
    others = [each for each in library if each.source.id != after.source.id]
    below = [
        each
        for each in others
        if each.source.spec == after.source.spec and {*each.source.overlays} <= {*after.source.overlays}
    ]
    return max(below, key=lambda each: len(each.source.overlays), default=(others or [after])[0])


def _fits(change: Change, filters: Mapping[str, str], but: str = "") -> bool:
    values = {"class": change.compatibility, "kind": change.kind}
    return all(not wanted or name == but or values[name] == wanted for name, wanted in filters.items())


def _facets(changes: Sequence[Change], filters: Mapping[str, str]) -> tuple[Facet, ...]:
    """Each filter counts what the other one leaves."""
    by_class = Counter(change.compatibility for change in changes if _fits(change, filters, "class"))
    by_kind = Counter(change.kind for change in changes if _fits(change, filters, "kind"))
    return (
        Facet("class", "Class", tuple((name, by_class[name]) for name in CLASSES), filters["class"]),
        Facet("kind", "Kind", tuple((name, by_kind[name]) for name in KINDS), filters["kind"]),
    )
