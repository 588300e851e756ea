"""Routes about pending versions: those that wait for approvals, and the decisions of owners."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Annotated

from fastapi import APIRouter, Query, Request
from fastapi.responses import Response

from sigcat.api.answers import registry_schemas as schemas
from sigcat.api.answers.negotiation import JSON, answer, json_bytes
from sigcat.api.answers.problems import reads
from sigcat.api.middleware.registry_access import Approver, Reader, Writer
from sigcat.api.requests.hosted_registry import TheRegistry
from sigcat.api.requests.thread_turns import InThread
from sigcat.api.routes.registry_writing import CHANGED, AnyVersion, GroupName, Text, changed, in_turn
from sigcat.limits import PARAMETER_CHARACTERS
from sigcat.registry.reference import KIND_OF, reference_of

if TYPE_CHECKING:
    from sigcat.registry.decisions.approvals import Decided
    from sigcat.registry.storing.ledger import Registry

router = APIRouter(prefix="/api/v1/registry", tags=["registry"], route_class=InThread)
_VALID_DAYS = 30
Owner = Annotated[Text, Query(description="Owner of functions that it breaks; without it, that of the token.")]
Content = Annotated[
    Text, Query(description="SHA-256 of the content that must be pending; without it, whatever is pending.")
]


@router.get("/pending", dependencies=[Reader], **reads(schemas.RegistryPendingList, 404))
def list_pending_versions(request: Request, registry: TheRegistry) -> Response:
    """Versions that wait for approvals, with the decisions about their content."""
    from sigcat.api.answers import registry_answers

    with registry.reading() as connection:
        return answer(request, registry_answers.pending_versions(connection))


@router.get("/deprecations", dependencies=[Reader], **reads(schemas.RegistryDeprecationList, 404))
def list_deprecations(request: Request, registry: TheRegistry) -> Response:
    """Deprecated versions, the owners that use them, and which of them acknowledged it."""
    from sigcat.api.answers import registry_answers

    with registry.reading() as connection:
        return answer(request, registry_answers.deprecated_versions(connection))


@router.post("/acknowledge", response_model=schemas.RegistryChange, responses=CHANGED)
async def acknowledge_deprecation(
    writer: Approver,
    reference: AnyVersion,
    owner: Annotated[Text, Query(description="Owner of functions that use it; without it, that of the token.")] = "",
    group: GroupName = "functions",
) -> Response:
    """Record that an owner of functions knows of the deprecation of a version that they use."""
    from sigcat.registry.decisions.acknowledgements import acknowledge

    kind, named, team = KIND_OF[group], reference_of(reference), owner or writer.author.owner
    return await changed(writer, lambda written: acknowledge(written, kind, named, team))


@router.post("/approve", response_model=schemas.RegistryDecision, responses=CHANGED)
async def approve_version(
    writer: Approver,
    reference: AnyVersion,
    owner: Owner = "",
    group: GroupName = "functions",
    content_digest: Content = "",
    valid_days: Annotated[int, Query(ge=0, description="Days until the approval ends.")] = _VALID_DAYS,
) -> Response:
    """Approve the content of a pending version. It is published when the same bytes are published again."""
    from sigcat.registry.decisions.approvals import approve

    kind, named, team = KIND_OF[group], reference_of(reference), owner or writer.author.owner
    return await _decided(writer, lambda written: approve(written, kind, named, team, valid_days, content_digest))


@router.post("/reject", response_model=schemas.RegistryDecision, responses=CHANGED)
async def reject_version(
    writer: Approver,
    reference: AnyVersion,
    reason: Annotated[str, Query(max_length=PARAMETER_CHARACTERS, description="Reason, which the next publish has.")],
    owner: Owner = "",
    group: GroupName = "functions",
    content_digest: Content = "",
) -> Response:
    """Reject the content of a pending version."""
    from sigcat.registry.decisions.approvals import reject

    kind, named, team = KIND_OF[group], reference_of(reference), owner or writer.author.owner
    return await _decided(writer, lambda written: reject(written, kind, named, team, reason, content_digest))


async def _decided(writer: Writer, decide: "Callable[[Registry], Decided]") -> Response:
    return Response(json_bytes(await in_turn(writer.request, lambda: _decision(writer, decide))), media_type=JSON)


def _decision(writer: Writer, decide: "Callable[[Registry], Decided]") -> schemas.RegistryDecision:
    from sigcat.api.answers.registry_answers import decision

    decided = decide(writer.written)
    with writer.registry.reading() as connection:
        return decision(connection, decided)
