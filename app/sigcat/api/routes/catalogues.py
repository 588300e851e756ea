"""Routes that read catalogues: trees, nodes, search, units."""

from collections.abc import Iterable
from typing import Annotated, Any
from urllib.parse import quote, urlencode

from fastapi import APIRouter, Path, Query, Request
from fastapi.exceptions import RequestValidationError
from fastapi.responses import Response, StreamingResponse
from pydantic import BaseModel, ConfigDict, Field

from sigcat.api.answers import schemas, serializers
from sigcat.api.answers.negotiation import CSV, answer, caching_headers, csv_parts, is_table, rows
from sigcat.api.answers.problems import reads
from sigcat.api.requests.cursors import cursor_of, offset_of
from sigcat.api.requests.dependencies import (
    CatalogueOfNode,
    TheCatalogue,
    TheLibrary,
    TheSettings,
    judge_conditions,
    rules_of,
)
from sigcat.api.requests.long_reading import has_more, in_turn
from sigcat.api.requests.thread_turns import InThread, in_thread, is_for_the_loop, parts_in_turn
from sigcat.api.settings import Settings
from sigcat.catalogue.hosting.library import Hosted
from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.catalogue.model.definition import CORE_ATTRIBUTES
from sigcat.catalogue.model.interfaces import category_of
from sigcat.catalogue.search import FACETS, SearchResult
from sigcat.catalogue.search_filters import checked_filters
from sigcat.digest import digest_of
from sigcat.errors import NotFound, UsageError
from sigcat.limits import ANSWER_DEPTH, NAME_CHARACTERS, PARAMETER_CHARACTERS, PROPOSAL_CHARACTERS, SEARCH_WORDS
from sigcat.names import did_you_mean, nearest

listing = APIRouter(prefix="/api/v1/catalogues", tags=["catalogues"], route_class=InThread)
router = APIRouter(prefix="/api/v1/catalogues/{catalogue}", tags=["catalogues"], route_class=InThread)
_PAGE = 50
_OWN_FIELDS = ("path", "name", "category")
"""Fields of a node that are not attributes."""

NodePath = Annotated[
    str, Path(description="Path of a node.", examples=["Vehicle.Speed"], max_length=PARAMETER_CHARACTERS)
]


Value = Annotated[str, Field(max_length=NAME_CHARACTERS)]
"""A value of a filter."""


_SAID = {True: "yes", False: "no"}
"""Words of a filter for true and false."""


class SearchQuery(BaseModel):
    """Search words, filters, and the requested page of the results."""

    model_config = ConfigDict(extra="forbid")

    q: str = Field(
        "",
        description=f"At most {SEARCH_WORDS} words, in any order, of path, description or unit; a generated name; a static id.",
        max_length=PARAMETER_CHARACTERS,
        examples=["wheel speed"],
    )
    type: Value | None = Field(None, description="branch, sensor, actuator, attribute, struct or property.")
    datatype: Value | None = Field(None, description="Datatype, as trees write it.", examples=["float"])
    unit: Value | None = Field(None, description="Key of a unit.", examples=["km/h"])
    category: Value | None = Field(None, description="data, error, safety_reaction, mode or scheduling.")
    asil: Value | None = Field(None, description="QM, A, B, C or D.")
    overlay: Value | None = Field(None, description="Name of the overlay that added or last changed the node.")
    deprecated: bool | None = Field(None, description="Whether its use is deprecated.")
    instances: bool = Field(
        False, description="Each instance by itself; else those that share a definition are one result."
    )
    limit: int | None = Field(
        None, ge=1, description="Results in one page, at most the setting `results`; without it 50."
    )
    cursor: str | None = Field(None, max_length=NAME_CHARACTERS, description="`next_cursor` of the page before.")

    @property
    def filters(self) -> dict[str, str]:
        """Values by facet, of the filters that were given."""
        given = {facet: getattr(self, facet) for facet in FACETS}
        return {facet: _SAID.get(value, value) for facet, value in given.items() if value is not None}


class RowQuery(SearchQuery):
    """Search words and filters, and the requested fields of the results."""

    instances: bool = Field(
        True, description="Each instance by itself; else those that share a definition are one row."
    )
    limit: int | None = Field(
        None, ge=1, description="Nodes in one page, at most the setting `results`; without it 50, or, as CSV, all."
    )
    fields: str = Field(
        "path,type,datatype,unit",
        description="Fields, separated by commas: `path`, `name`, `category`, or any attribute.",
        max_length=PARAMETER_CHARACTERS,
        examples=["path,unit,min,max,ASILlevel"],
    )

    @property
    def chosen_fields(self) -> tuple[str, ...]:
        """Names of fields, each once."""
        return tuple(dict.fromkeys(name for part in self.fields.split(",") if (name := part.strip())))


@listing.get("", **reads(schemas.CatalogueList, is_table=True))
def list_catalogues(request: Request, library: TheLibrary) -> Response:
    """The hosted catalogues, the default one first."""
    listed = [serializers.catalogue_summary(hosted) for hosted in library]
    return answer(request, schemas.CatalogueList(catalogues=listed), rows(listed))


@router.get("", **reads(schemas.Catalogue, 404, 422))
def get_catalogue(request: Request, hosted: TheCatalogue) -> Response:
    """A catalogue with its layers and its findings."""
    return answer(request, serializers.catalogue_detail(hosted))


@router.get("/nodes/{path}", **reads(schemas.Node, 404, 422))
async def get_node(request: Request, hosted: CatalogueOfNode, path: NodePath) -> Response:
    """A node with its children, and every attribute with its origin and history."""
    node = await node_at(request, hosted.catalogue, path)
    judge_conditions(request)
    if is_for_the_loop(request, node):
        return node_answer(request, hosted, node)
    return await in_turn(request, [node], 1, node_answer, request, hosted, node)


@router.get("/tree", **reads(schemas.TreeNode, 404, 422))
async def get_tree(
    request: Request,
    hosted: CatalogueOfNode,
    settings: TheSettings,
    path: Annotated[
        str | None,
        Query(description="Where the tree begins; without it, at the root.", max_length=PARAMETER_CHARACTERS),
    ] = None,
    depth: Annotated[int, Query(ge=0, le=ANSWER_DEPTH, description="Levels below the first node.")] = 1,
) -> Response:
    """A node and the nodes below it, down to a depth."""
    node = _root(hosted.catalogue) if path is None else await node_at(request, hosted.catalogue, path)
    judge_conditions(request)
    if has_more([node], depth, settings.tree_nodes):
        message = f"The tree has more than {settings.tree_nodes:,} nodes. Ask for a branch, or for less depth."
        raise UsageError(message)
    return await in_turn(request, [node], depth, _tree_answer, request, node, depth)


@router.get("/search", **reads(schemas.SearchPage, 404, 422, is_table=True))
def search_nodes(
    request: Request, hosted: TheCatalogue, settings: TheSettings, query: Annotated[SearchQuery, Query()]
) -> Response:
    """Nodes whose path, description or unit has all the words, best first, with counts for every filter."""
    page = search_page(request, *found(hosted, settings, query))
    return answer(request, page, rows(page.hits))


@router.get("/nodes", **reads(schemas.NodePage, 404, 422, is_table=True))
def list_nodes(
    request: Request, hosted: TheCatalogue, settings: TheSettings, query: Annotated[RowQuery, Query()]
) -> Response:
    """Nodes with the fields that are asked for, and nothing else. CSV without a limit has all of them, as a stream."""
    fields = query.chosen_fields
    _refuse_unknown_fields(request, hosted.catalogue, fields)
    if query.limit is None and query.cursor is None and is_table(request):
        parts = csv_parts(fields, (row_of(node, fields) for node in _all_found(hosted, settings, query)))
        return StreamingResponse(parts_in_turn(request, parts), media_type=CSV, headers=caching_headers(request))
    result, cursor = found(hosted, settings, query)
    mark_next_page(request, cursor)
    listed = [dict(zip(fields, row_of(node, fields), strict=True)) for node in result.nodes]
    return answer(request, schemas.NodePage(total=result.total, rows=listed, next_cursor=cursor), listed)


@router.get("/units", **reads(schemas.UnitList, 404, 422, is_table=True))
def list_units(request: Request, hosted: TheCatalogue) -> Response:
    """The units that the catalogue knows."""
    units = [serializers.unit_schema(unit) for unit in hosted.catalogue.vocabulary.distinct_units]
    return answer(request, schemas.UnitList(units=units), rows(units))


@router.get("/quantities", **reads(schemas.QuantityList, 404, 422, is_table=True))
def list_quantities(request: Request, hosted: TheCatalogue) -> Response:
    """The quantities that the units measure."""
    known = hosted.catalogue.vocabulary.quantities.values()
    quantities = [serializers.quantity_schema(quantity) for quantity in known]
    return answer(request, schemas.QuantityList(quantities=quantities), rows(quantities))


def search_page(request: Request, result: SearchResult, cursor: str | None) -> schemas.SearchPage:
    """One page of results; the header of the answer names the next one."""
    mark_next_page(request, cursor)
    return schemas.SearchPage(
        total=result.total,
        hits=[serializers.search_hit(hit) for hit in result.hits],
        facets={facet: dict(counts) for facet, counts in result.facets.items()},
        suggestions=list(result.did_you_mean),
        next_cursor=cursor,
    )


def found(hosted: Hosted, settings: Settings, query: SearchQuery) -> tuple[SearchResult, str | None]:
    """One page of a query's results, and the cursor of the next one."""
    _check(hosted, settings, query)
    offset = offset_of(query.cursor, searched_state(hosted, query)) if query.cursor else 0
    limit = page_size(query.limit, settings)
    result = hosted.search_index.search(
        query.q, query.filters, limit=limit, offset=offset, each_instance=query.instances
    )
    following = offset + len(result.hits)
    if not result.hits or following >= result.total:
        return result, None
    return result, cursor_of(following, searched_state(hosted, query))


def page_size(limit: int | None, settings: Settings) -> int:
    """Results in one page. Raises RequestValidationError for more than the service gives."""
    if limit is None:
        return min(_PAGE, settings.results)
    if limit > settings.results:
        message = f"Input should be less than or equal to {settings.results}"
        raise RequestValidationError([{"type": "less_than_equal", "loc": ("query", "limit"), "msg": message}])
    return limit


def mark_next_page(request: Request, cursor: str | None) -> None:
    """Keep the header that names the next page (RFC 8288), if there is one."""
    if cursor is not None:
        rest = [pair for pair in request.query_params.multi_items() if pair[0] != "cursor"]
        address = f"{quote(request.scope['path'])}?{urlencode([*rest, ('cursor', cursor)])}"
        request.state.caching = {**request.state.caching, "Link": f'<{address}>; rel="next"'}


def searched_state(hosted: Hosted, query: SearchQuery) -> str:
    """Return the digest that a search's cursor belongs to: of the state of the catalogue, the words and the filters."""
    asked = repr((hosted.catalogue.digest, query.q, query.instances, sorted(query.filters.items())))
    return digest_of(asked.encode("utf-8", "replace"))


def row_of(node: Node, fields: Iterable[str]) -> list[Any]:
    """Values of a node by field: `path`, `name`, `category`, or any attribute."""
    own = {"path": node.path, "name": node.name, "category": category_of(node.path)}
    return [serializers.plain(own[field] if field in own else node.values.get(field)) for field in fields]


def _all_found(hosted: Hosted, settings: Settings, query: SearchQuery) -> Iterable[Node]:
    _check(hosted, settings, query)
    everything = len(hosted.catalogue.nodes)
    index = hosted.search_index
    return index.search(query.q, query.filters, limit=everything, each_instance=query.instances).nodes


def _check(hosted: Hosted, settings: Settings, query: SearchQuery) -> None:
    """Raises UsageError for a text that is too long, and for a filter with a value that no node here can have."""
    if len(query.q) > settings.query_characters:
        raise UsageError(f"The text to search for is longer than {settings.query_characters} characters.")
    checked_filters(query.filters, hosted.catalogue, hosted.search_index)


def _refuse_unknown_fields(request: Request, catalogue: Catalogue, fields: Iterable[str]) -> None:
    """Raises UsageError for a field that neither VSS, nor the rules, nor any node of the catalogue has."""
    known = {*_OWN_FIELDS, *CORE_ATTRIBUTES, *rules_of(request).active.attributes, *catalogue.attributes}
    for field in fields:
        if field not in known:
            hint = did_you_mean(field[:PROPOSAL_CHARACTERS], sorted(known)) or f"Fields are {', '.join(sorted(known))}."
            raise UsageError(f"Unknown field {field[:100]!r}. {hint}".rstrip())


def node_answer(request: Request, hosted: Hosted, node: Node) -> Response:
    """Everything about a node."""
    return answer(request, serializers.node_data(hosted.catalogue, node))


def _tree_answer(request: Request, node: Node, depth: int) -> Response:
    return answer(request, serializers.tree_node(node, depth))


async def node_at(request: Request, catalogue: Catalogue, path: str) -> Node:
    """The node at a path. A thread looks for the nearest paths of one that does not exist."""
    node = catalogue.get(path)
    return await in_thread(request, find_node, catalogue, path) if node is None else node


def find_node(catalogue: Catalogue, path: str) -> Node:
    """The node at a path. Raises NotFound with the nearest paths."""
    node = catalogue.get(path)
    if node is None:
        shown = path if len(path) <= PROPOSAL_CHARACTERS else f"{path[:PROPOSAL_CHARACTERS]}…"
        near = nearest(path[:PROPOSAL_CHARACTERS], catalogue.nodes, limit=5, cutoff=60)
        raise NotFound(f"Catalogue {catalogue.name!r} has no node {shown!r}.", near)
    return node


def _root(catalogue: Catalogue) -> Node:
    if not catalogue.roots:
        raise NotFound(f"Catalogue {catalogue.name!r} has no tree; its findings say why.")
    return catalogue.roots[0]
