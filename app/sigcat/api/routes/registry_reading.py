"""Routes that read the registry: names, versions with their content, users, vehicle lines and the log."""

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING, Annotated, Any

from fastapi import APIRouter, Path, Query, Request
from fastapi.responses import Response
from pydantic import BaseModel, ConfigDict, Field

from sigcat import __version__
from sigcat.api.answers import registry_schemas as schemas
from sigcat.api.answers.negotiation import Data, answer, caching_headers
from sigcat.api.answers.problems import problem_documentation, reads
from sigcat.api.middleware.registry_access import Reader
from sigcat.api.requests.cursors import cursor_of, offset_of
from sigcat.api.requests.dependencies import NamedCatalogue, TheSettings, judge_conditions, mark_state
from sigcat.api.requests.hosted_registry import HostedRegistry, TheRegistry
from sigcat.api.requests.thread_turns import InThread
from sigcat.api.routes.catalogues import mark_next_page, page_size
from sigcat.catalogue.hosting.variants import expanded_of
from sigcat.errors import NotFound
from sigcat.limits import NAME_CHARACTERS, PARAMETER_CHARACTERS

if TYPE_CHECKING:
    from sigcat.registry.storing.database import Snapshot

router = APIRouter(prefix="/api/v1/registry", tags=["registry"], route_class=InThread, dependencies=[Reader])

BYTES, TEXT = "application/octet-stream", "text/plain"
_LOG = "log"
"""State of a cursor of the log, which only grows: its pages stay as they are."""

Name = Annotated[str, Path(description="Published name.", examples=["CoreAcc"], max_length=NAME_CHARACTERS)]
Line = Annotated[str | None, Query(description="Only this line.", examples=["SUV-2025"], max_length=NAME_CHARACTERS)]
VersionId = Annotated[str, Path(description="Version of SemVer 2.0.", examples=["1.0.0"], max_length=NAME_CHARACTERS)]
Group = Annotated[schemas.RegistryGroup, Path(description="Kind of names.", examples=["functions"])]
Inline = Annotated[
    Annotated[str, Field(pattern="^uses$", max_length=4)] | None,
    Query(description="`uses`: with everything that the version uses."),
]


class PageQuery(BaseModel):
    """The requested page of a list."""

    model_config = ConfigDict(extra="forbid")

    limit: int | None = Field(
        None, ge=1, description="Results in one page, at most the setting `results`; without it 50."
    )
    cursor: str | None = Field(None, max_length=NAME_CHARACTERS, description="`next_cursor` of the page before.")


class NamesQuery(PageQuery):
    """The requested page of names, and whether they come with their versions."""

    inline: str | None = Field(
        None, pattern="^versions$", max_length=8, description="`versions`: with the versions of each name."
    )


ThePage = Annotated[PageQuery, Query()]

_CONTENT: dict[int | str, dict[str, Any]] = {
    200: {
        "description": "The published bytes, unchanged.",
        "content": {BYTES: {"schema": {"type": "string", "format": "binary"}}},
    }
}


@router.get("", **reads(schemas.Registry, 404))
def get_registry(request: Request, registry: TheRegistry) -> Response:
    """Number of published names, and the head of the log."""
    from sigcat.api.answers import registry_answers

    return _answered(request, registry, registry_answers.registry)


@router.get("/capabilities", **reads(schemas.RegistryCapabilities))
def get_registry_capabilities(request: Request) -> Response:
    """Parts of xRegistry that the registry has."""
    return answer(request, _CAPABILITIES)


@router.get("/model", **reads(schemas.RegistryModel))
def get_registry_model(request: Request) -> Response:
    """Kinds of names, as xRegistry describes resources."""
    return answer(request, _MODEL)


@router.get("/users", **reads(schemas.RegistryUserList, 404, 422))
def list_registry_users(
    request: Request,
    registry: TheRegistry,
    hosted: NamedCatalogue,
    path: Annotated[
        str,
        Query(
            description="Path of a node, or name of an interface.",
            examples=["Vehicle.Speed"],
            min_length=1,
            max_length=PARAMETER_CHARACTERS,
        ),
    ],
    all_versions: Annotated[
        bool, Query(description="Also versions that are neither the newest nor in a vehicle line.")
    ] = False,
) -> Response:
    """Functions that use a node, a node below it, a struct type, an error or a mode; and what follows from it in others.

    Instances of a definition are those of the catalogue.
    """
    from sigcat.api.answers import registry_answers

    over = expanded_of(hosted.catalogue)
    users = partial(registry_answers.users, path=path, over=over, is_complete=all_versions)
    return _answered(request, registry, users)


@router.get("/lines", **reads(schemas.VehicleLineList, 404))
def list_vehicle_lines(request: Request, registry: TheRegistry, line: Line = None) -> Response:
    """Vehicle lines, and what their vehicles run."""
    from sigcat.api.answers import registry_answers

    return _answered(request, registry, partial(registry_answers.lines, only=line))


@router.get("/log", **reads(schemas.LogPage, 404))
def list_log_entries(request: Request, registry: TheRegistry, settings: TheSettings, query: ThePage) -> Response:
    """The log in its order. Its entries have what it takes to verify the chain and the signatures."""
    from sigcat.api.answers import registry_answers

    after = offset_of(query.cursor, _LOG) if query.cursor else 0
    size = page_size(query.limit, settings)
    with registry.reading() as connection:
        entries = registry_answers.log_entries(connection, after, size + 1)
        _mark(request, connection)
    cursor = cursor_of(entries[size - 1].epoch, _LOG) if len(entries) > size else None
    mark_next_page(request, cursor)
    return answer(request, schemas.LogPage(entries=entries[:size], next_cursor=cursor))


@router.get(
    "/key",
    response_class=Response,
    responses={
        200: {"description": "The public key as PEM.", "content": {TEXT: {"schema": {"type": "string"}}}},
        **problem_documentation(404),
    },
)
def get_registry_key(registry: TheRegistry) -> Response:
    """The Ed25519 key that verifies the signatures of the log. Compare it with one that you got in another way."""
    if registry.settings.key is None:
        raise NotFound("The log is not signed. Make a key with `sigcat registry new-key`, and name it in [registry].")
    from sigcat.registry.storing.signing import public_key, public_text

    return Response(public_text(public_key(registry.settings.key)), media_type=TEXT)


@router.get("/contents", response_class=Response, responses=_CONTENT | problem_documentation(404))
def get_registry_content(
    request: Request,
    registry: TheRegistry,
    digest: Annotated[str, Query(description="SHA-256 of the content.", pattern="^[0-9a-f]{64}$", max_length=64)],
) -> Response:
    """Content by its digest, such as the Function JSON of a version. It never changes."""
    from sigcat.registry.storing.content import content_of, has_content

    with registry.reading() as connection:
        if not has_content(connection, digest):
            raise NotFound("The registry has no content with this digest.")
        data = content_of(connection, digest)
    mark_state(request, digest[:24], is_fixed=True)
    judge_conditions(request)
    return _bytes(request, data)


@router.get("/{group}", **reads(schemas.RegistryNamePage, 404))
def list_registry_names(
    request: Request,
    registry: TheRegistry,
    settings: TheSettings,
    group: Group,
    query: Annotated[NamesQuery, Query()],
) -> Response:
    """Published names, in the order in which they were published."""
    from sigcat.api.answers import registry_answers

    start = offset_of(query.cursor, group) if query.cursor else 0
    with registry.reading() as connection:
        found = registry_answers.names(connection, group, has_versions=query.inline is not None)
        _mark(request, connection)
    end = start + page_size(query.limit, settings)
    cursor = cursor_of(end, group) if end < len(found) else None
    mark_next_page(request, cursor)
    page = schemas.RegistryNamePage(total=len(found), names=found[start:end], next_cursor=cursor)
    return answer(request, page)


@router.get("/{group}/{name}$details", **reads(schemas.RegistryName, 404))
def get_registry_name(request: Request, registry: TheRegistry, group: Group, name: Name) -> Response:
    """A published name, with its default version and its rule."""
    from sigcat.api.answers import registry_answers

    return _answered(request, registry, partial(registry_answers.name, group=group, named=name))


@router.get("/{group}/{name}", response_class=Response, responses=_CONTENT | problem_documentation(404))
def get_default_content(request: Request, registry: TheRegistry, group: Group, name: Name) -> Response:
    """The published bytes of the default version: the newest release that may be deployed."""
    return _content(request, registry, group, name)


@router.get("/{group}/{name}/versions", **reads(schemas.RegistryVersionList, 404))
def list_registry_versions(request: Request, registry: TheRegistry, group: Group, name: Name) -> Response:
    """Versions of a name by precedence."""
    from sigcat.api.answers import registry_answers

    return _answered(request, registry, partial(registry_answers.versions, group=group, named=name))


@router.get("/{group}/{name}/versions/{version}$details", **reads(schemas.RegistryVersion, 404))
def get_registry_version(
    request: Request, registry: TheRegistry, group: Group, name: Name, version: VersionId, inline: Inline = None
) -> Response:
    """A version without its content: state, owner, lines, and on demand its uses."""
    from sigcat.api.answers import registry_answers

    asked = partial(registry_answers.version, group=group, named=name, version_id=version, has_uses=inline is not None)
    return _answered(request, registry, asked)


@router.get(
    "/{group}/{name}/versions/{version}", response_class=Response, responses=_CONTENT | problem_documentation(404)
)
def get_version_content(
    request: Request, registry: TheRegistry, group: Group, name: Name, version: VersionId
) -> Response:
    """The published bytes of a version, unchanged."""
    return _content(request, registry, group, name, version)


def _answered(request: Request, registry: HostedRegistry, found: "Callable[[Snapshot], Data]") -> Response:
    """Return what is found in one state of the registry. Raises a 304 or a 412."""
    with registry.reading() as connection:
        data = found(connection)
        _mark(request, connection)
    return answer(request, data)


def _content(
    request: Request, registry: HostedRegistry, group: schemas.RegistryGroup, name: str, version: str = ""
) -> Response:
    from sigcat.api.answers import registry_answers
    from sigcat.registry.storing.content import content_of

    with registry.reading() as connection:
        published = registry_answers.published_at(connection, group, name, version)
        mark_state(request, published.content[:24], is_fixed=False)
        judge_conditions(request)
        return _bytes(request, content_of(connection, published.content))


def _bytes(request: Request, data: bytes) -> Response:
    return Response(data, media_type=BYTES, headers=caching_headers(request))


def _mark(request: Request, connection: "Snapshot") -> None:
    """Keep the headers of an answer about the registry, whose state is the head of its log. Raises a 304 or a 412."""
    from sigcat.registry.storing.ledger import head

    last = head(connection)
    state = f"{__version__}-{last.hash[:24]}" if last else __version__
    mark_state(request, state, is_fixed=False)
    judge_conditions(request)


_CAPABILITIES: dict[str, Any] = {
    "available": {
        "capabilities": {"mutable": False},
        "entities": {"mutable": True},
        "model": {"mutable": False},
    },
    "compatibilities": {"*": ["backward", "full", "approval", "none"]},
    "flags": ["inline"],
    "formats": [],
    "ignores": [],
    "pagination": True,
    "shortself": False,
    "specversions": ["1.0-rc4"],
    "versionmodes": ["semver"],
}
_MODEL: dict[str, Any] = {
    "description": "Names are unique in the whole registry, so that resources are in no group.",
    "resources": {
        plural: {"plural": plural, "singular": plural.removesuffix("s"), "hasdocument": True, "versionmode": "semver"}
        for plural in ("functions", "overlays", "catalogues")
    },
}
