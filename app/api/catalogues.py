"""Routes that read catalogues: trees, nodes, search, units."""

from typing import Annotated

from fastapi import APIRouter, Path, Query
from pydantic import BaseModel, ConfigDict, Field

from app.api import presenting, schemas
from app.api.cursors import cursor_of, offset_of
from app.api.problems import problem_documentation
from app.api.requests import TheCatalogue, TheLibrary, TheSettings
from app.catalogue.model import Catalogue, Node
from app.catalogue.search import FACETS
from app.errors import NotFound, UsageError
from app.names import nearest

listing = APIRouter(prefix="/api/v1/catalogues", tags=["catalogues"])
router = APIRouter(prefix="/api/v1/catalogues/{catalogue}", tags=["catalogues"])
_LONGEST_NAME = 500
_DEEPEST = 64

NodePath = Annotated[str, Path(description="Path of a node.", examples=["Vehicle.Speed"])]


class SearchQuery(BaseModel):
    """What is searched for, the filters, and which page of the results is wanted."""

    model_config = ConfigDict(extra="forbid")

    q: str = Field("", description="Words, in any order, of path, description or unit.", examples=["wheel speed"])
    type: str | None = Field(None, description="branch, sensor, actuator, attribute, struct or property.")
    datatype: str | None = Field(None, examples=["float"])
    unit: str | None = Field(None, description="Key of a unit.", examples=["km/h"])
    category: str | None = Field(None, description="data, error, safety_reaction, mode or scheduling.")
    asil: str | None = Field(None, description="QM, A, B, C or D.")
    overlay: str | None = Field(None, description="Name of the overlay that added or last changed the node.")
    deprecated: str | None = Field(None, description="`yes` or `no`.", pattern="^(yes|no)$")
    limit: int = Field(50, ge=1, description="Results in one page.")
    cursor: str | None = Field(None, max_length=200, description="`next_cursor` of the page before.")

    @property
    def filters(self) -> dict[str, str]:
        """Values by facet, of the filters that were given."""
        given = {facet: getattr(self, facet) for facet in FACETS}
        return {facet: value for facet, value in given.items() if value is not None}


@listing.get("")
def list_catalogues(library: TheLibrary) -> schemas.Catalogues:
    """The hosted catalogues, the default one first."""
    return schemas.Catalogues(catalogues=[presenting.catalogue_summary(hosted) for hosted in library])


@router.get("", responses=problem_documentation(404, 422))
def get_catalogue(hosted: TheCatalogue) -> schemas.Catalogue:
    """A catalogue with its layers and its findings."""
    return presenting.catalogue_detail(hosted)


@router.get("/nodes/{path}", responses=problem_documentation(404, 422))
def get_node(hosted: TheCatalogue, path: NodePath) -> schemas.Node:
    """A node with its children, and every attribute with its origin and history."""
    return presenting.node_detail(hosted.catalogue, find_node(hosted.catalogue, path))


@router.get("/tree", responses=problem_documentation(400, 404, 422))
def get_tree(
    hosted: TheCatalogue,
    settings: TheSettings,
    path: Annotated[str | None, Query(description="Where the tree begins; without it, at the root.")] = None,
    depth: Annotated[int, Query(ge=0, le=_DEEPEST, description="Levels below the first node.")] = 1,
) -> schemas.TreeNode:
    """A node and what stands below it, down to a depth."""
    node = _root(hosted.catalogue) if path is None else find_node(hosted.catalogue, path)
    if _is_larger(node, depth, settings.tree_nodes):
        message = f"The tree has more than {settings.tree_nodes:,} nodes. Ask for a branch, or for less depth."
        raise UsageError(message)
    return presenting.tree_node(node, depth)


@router.get("/search", responses=problem_documentation(400, 404, 422))
def search_nodes(
    hosted: TheCatalogue, settings: TheSettings, query: Annotated[SearchQuery, Query()]
) -> schemas.SearchPage:
    """Nodes whose path, description or unit has all the words, best first, with counts for every filter."""
    if len(query.q) > settings.query_characters:
        raise UsageError(f"The text to search for is longer than {settings.query_characters} characters.")
    digest = hosted.catalogue.digest
    offset = offset_of(query.cursor, digest) if query.cursor else 0
    limit = min(query.limit, settings.results)
    result = hosted.search_index.search(query.q, query.filters, limit=limit, offset=offset)
    following = offset + len(result.nodes)
    return schemas.SearchPage(
        total=result.total,
        nodes=[presenting.node_summary(node) for node in result.nodes],
        facets={facet: dict(counts) for facet, counts in result.facets.items()},
        did_you_mean=list(result.did_you_mean),
        next_cursor=cursor_of(following, digest) if result.nodes and following < result.total else None,
    )


@router.get("/units", responses=problem_documentation(404, 422))
def list_units(hosted: TheCatalogue) -> schemas.Units:
    """The units that the catalogue knows."""
    return schemas.Units(units=[presenting.unit_schema(unit) for unit in hosted.catalogue.vocabulary.distinct_units])


@router.get("/quantities", responses=problem_documentation(404, 422))
def list_quantities(hosted: TheCatalogue) -> schemas.Quantities:
    """The quantities that the units measure."""
    quantities = hosted.catalogue.vocabulary.quantities.values()
    return schemas.Quantities(quantities=[presenting.quantity_schema(quantity) for quantity in quantities])


def find_node(catalogue: Catalogue, path: str) -> Node:
    """The node at a path. Raises NotFound with the nearest paths."""
    node = catalogue.get(path)
    if node is None:
        shown = path if len(path) <= _LONGEST_NAME else f"{path[:_LONGEST_NAME]}…"
        near = nearest(path[:_LONGEST_NAME], catalogue.nodes, limit=5, cutoff=60)
        raise NotFound(f"There is no node {shown!r} in catalogue {catalogue.name!r}.", near)
    return node


def _root(catalogue: Catalogue) -> Node:
    if not catalogue.roots:
        raise NotFound(f"Catalogue {catalogue.name!r} has no tree; its findings say why.")
    return catalogue.roots[0]


def _is_larger(node: Node, depth: int, limit: int) -> bool:
    """Whether a tree down to a depth has more nodes than a limit."""
    level, count = [node], 1
    for _ in range(depth):
        level = [child for each in level for child in each.children]
        count += len(level)
        if count > limit:
            return True
        if not level:
            break
    return False
