"""Pages of a catalogue: its tree, a search in it, its units, its layers and findings."""

from collections.abc import Mapping, Sequence
from http import HTTPStatus
from typing import Annotated

from fastapi import APIRouter, Query, Request
from fastapi.responses import JSONResponse, RedirectResponse, Response

from sigcat.api.answers.serializers import catalogue_detail, node_data
from sigcat.api.answers.versions import version_of
from sigcat.api.requests.cursors import cursor_of, offset_of
from sigcat.api.requests.dependencies import (
    AnyCatalogue,
    TheFunctions,
    TheLibrary,
    TheRules,
    TheSettings,
    functions_of,
    library_of,
)
from sigcat.api.requests.long_reading import in_turn
from sigcat.api.requests.thread_turns import InThread
from sigcat.api.routes.catalogues import SearchQuery, find_node, node_at, page_size, searched_state
from sigcat.catalogue.hosting.library import Hosted
from sigcat.catalogue.hosting.variants import (
    folding,
    instance_counts,
    overlay_switches,
    stand_in,
    vehicle_switches,
    without_vehicle,
)
from sigcat.catalogue.model.catalogue import Node
from sigcat.catalogue.search import FACETS, SearchResult
from sigcat.catalogue.search_filters import checked_filters
from sigcat.errors import UsageError
from sigcat.findings import SEVERITIES
from sigcat.function.hosting import FunctionLibrary
from sigcat.function.node_uses import uses_in
from sigcat.integration.grouping import grouped
from sigcat.limits import PAGE_FINDINGS, PICTURED_NODES
from sigcat.web.addresses import Addresses
from sigcat.web.documentation import search as search_documentation
from sigcat.web.pictures.sunburst import sunburst
from sigcat.web.rendering import page
from sigcat.web.views.catalogue_findings import findings_over
from sigcat.web.views.node_view import field_units_of, node_view
from sigcat.web.views.tree_rows import OpenBranches, rows_below, visible_rows
from sigcat.web.views.vehicle_view import base_of, vehicles_of
from sigcat.web.visits import visit_of

router = APIRouter(route_class=InThread)
_ROWS = 400
"""Rows of the tree on a page without JavaScript; more are a link away."""
_LONG_BASKET, _FEWER_ROWS = 20, 100
"""Each link of a row carries the basket: with a long one, a page has fewer rows."""
_DEEPEST = 1_000
_FACET_WORDS = {
    "type": "Type", "datatype": "Datatype", "unit": "Unit", "category": "Interface", "asil": "ASIL",
    "overlay": "Overlay", "deprecated": "Deprecated",
}  # fmt: skip


class PageQuery(SearchQuery):
    """A search of the browser: with `part`, only the changing part of the page is sent; links keep the basket."""

    part: str | None = None
    pick: str | None = None


Opened = Annotated[str, Query(alias="open", description="Open branches, separated by commas; `*` opens all.")]
From = Annotated[int, Query(alias="from", ge=0)]


@router.get("/tree/{catalogue}")
def show_tree(request: Request, hosted: AnyCatalogue, opened: Opened = "", start: From = 0) -> Response:
    """The tree with nothing selected."""
    return _tree(request, hosted, "", opened, start)


@router.get("/tree/{catalogue}/{path}")
def show_node(
    request: Request, library: TheLibrary, hosted: AnyCatalogue, path: str, opened: Opened = "", start: From = 0
) -> Response:
    """The tree with a node selected; with `.json` after the path, the node as the API has it."""
    if path not in hosted.catalogue.nodes and path.endswith(".json"):
        node = find_node(hosted.catalogue, path.removesuffix(".json"))
        return JSONResponse(node_data(hosted.catalogue, node))
    if path not in hosted.catalogue.nodes and (other := stand_in(library, hosted, path)):
        return RedirectResponse(
            Addresses(request.scope.get("root_path", ""), visit_of(request).basket).tree(hosted.source.id, other)
        )
    return _tree(request, hosted, path, opened, start)


@router.get("/rows/{catalogue}")
async def list_rows(
    request: Request,
    hosted: AnyCatalogue,
    functions: TheFunctions,
    path: str = "",
    depth: int = 1,
    version: Annotated[str, Query(alias="v")] = "",
) -> Response:
    """Compact rows below a branch, for the tree in the browser. An address with the right version never changes."""
    nodes = (await node_at(request, hosted.catalogue, path)).children if path else hosted.catalogue.roots
    levels = min(depth, _DEEPEST) - 1
    return await in_turn(request, nodes, levels, _rows_answer, hosted, functions, nodes, levels, version)


def _rows_answer(
    hosted: Hosted, functions: FunctionLibrary, nodes: Sequence[Node], levels: int, version: str
) -> Response:
    is_current = version == _state(hosted, functions)
    caching = "private, max-age=31536000, immutable" if is_current else "no-cache"
    counts = {} if hosted.catalogue.is_expanded else instance_counts(hosted.catalogue)
    users = uses_in(functions.files, hosted.catalogue).functions
    rows = rows_below(nodes, levels, counts, users)
    return JSONResponse(rows, headers={"Cache-Control": caching})


@router.get("/search/{catalogue}")
def show_search(
    request: Request, hosted: AnyCatalogue, settings: TheSettings, query: Annotated[PageQuery, Query()]
) -> Response:
    """Search results with the counts of every filter. A filter that no node can have is refused, as in the API."""
    text = query.q[: settings.query_characters]
    state = searched_state(hosted, query)
    offset = offset_of(query.cursor, state) if query.cursor else 0
    limit = page_size(query.limit, settings)
    refusal, result = _searched(hosted, query, text, limit, offset)
    following = offset + len(result.hits)
    return page(
        request,
        "search.html",
        HTTPStatus.UNPROCESSABLE_ENTITY if refusal else HTTPStatus.OK,
        hosted=hosted,
        refusal=refusal,
        text=text,
        title=", ".join(filter(None, (text, *query.filters.values()))) or "Search",
        sought=result.words,
        filters=query.filters,
        facets=_facets(result.facets, query.filters, result.total),
        result=result,
        chapters=search_documentation(text),
        uses=uses_in(functions_of(request).files, hosted.catalogue),
        offset=offset,
        cursor=cursor_of(following, state) if result.hits and following < result.total else None,
    )


@router.get("/units/{catalogue}")
def show_units(request: Request, hosted: AnyCatalogue) -> Response:
    """Units by quantity."""
    units = sorted(hosted.catalogue.vocabulary.distinct_units, key=lambda unit: unit.quantity)
    by_quantity = grouped(units, lambda unit: unit.quantity)
    return page(request, "units.html", hosted=hosted, by_quantity=by_quantity)


@router.get("/catalogues/{catalogue}")
def show_catalogue(
    request: Request, hosted: AnyCatalogue, rules: TheRules, functions: TheFunctions, library: TheLibrary
) -> Response:
    """A catalogue's layers, and what its files and the rules say of it, and of the functions over it."""
    found = findings_over(hosted, rules, functions.files, library)
    findings = sorted(found, key=lambda finding: SEVERITIES.index(finding.severity))
    return page(
        request,
        "catalogue.html",
        hosted=hosted,
        detail=catalogue_detail(hosted),
        sunburst=sunburst(hosted.catalogue) if len(hosted.catalogue.nodes) <= PICTURED_NODES else None,
        findings=findings[:PAGE_FINDINGS],
        total=len(findings),
    )


@router.get("/{page_name}.ico", include_in_schema=False)
def no_icon(page_name: str) -> Response:  # noqa: ARG001 - browsers ask for it even where a page names its icon
    """No content, rather than a missing page in every log."""
    return Response(status_code=204)


def _searched(hosted: Hosted, query: SearchQuery, text: str, limit: int, offset: int) -> tuple[str, SearchResult]:
    """Why a search is refused, empty where it is not, and what it finds: with a filter that is refused, the counts of others."""
    refusal, index = "", hosted.search_index
    try:
        checked_filters(query.filters, hosted.catalogue, index)
    except UsageError as error:
        refusal = str(error)
    try:
        result = index.search(text, query.filters, limit=limit, offset=offset, each_instance=query.instances)
    except UsageError as error:
        return str(error), SearchResult((), 0, {})
    return refusal, result


def _tree(request: Request, hosted: Hosted, path: str, opened: str, start: int) -> Response:
    catalogue = hosted.catalogue
    selected = find_node(catalogue, path) if path else None
    first = selected or (catalogue.roots[0] if catalogue.roots else None)
    named = opened.split(",") if opened else [root.path for root in catalogue.roots if path in ("", root.path)]
    branches = OpenBranches(named, path)
    most_rows = _ROWS if len(visit_of(request).basket.paths) < _LONG_BASKET else _FEWER_ROWS
    rows, total = visible_rows(catalogue, branches, start, most_rows)
    uses = uses_in(functions_of(request).files, catalogue)
    return page(
        request,
        "tree.html",
        hosted=hosted,
        selected=path,
        view=node_view(catalogue, first, field_units_of(request.app.state.rules.rules), uses) if first else None,
        switches=overlay_switches(library_of(request), hosted),
        vehicles=vehicle_switches(hosted),
        without_vehicle=without_vehicle(hosted),
        in_vehicles=vehicles_of(base_of(library_of(request), hosted), first.path) if first else (),
        folding=folding(hosted),
        instances={} if catalogue.is_expanded else instance_counts(catalogue),
        rows=rows,
        total=total,
        start=start,
        most_rows=most_rows,
        branches=branches,
        opened=opened,
        state=_state(hosted, functions_of(request)),
        users=uses.functions,
        detail=catalogue_detail(hosted) if first is None else None,
    )


def _state(hosted: Hosted, functions: FunctionLibrary) -> str:
    """Owner of the rows of a tree: the catalogue, and the functions that use it."""
    return f"{version_of(hosted)}-{functions.digest[:8]}"


def _facets(
    counted: Mapping[str, Mapping[str, int]], filters: Mapping[str, str], total: int
) -> list[tuple[str, str, list[tuple[str, int]], str]]:
    """Filters that would narrow the results: (facet, title, values with counts, chosen value)."""
    facets = []
    for facet in FACETS:
        values = sorted(counted.get(facet, {}).items(), key=lambda item: (-item[1], item[0]))
        chosen = filters.get(facet, "")
        if chosen or any(number < total for _, number in values):
            facets.append((facet, _FACET_WORDS[facet], values, chosen))
    return facets
