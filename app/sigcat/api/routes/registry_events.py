"""The changes of the registry as events, for clients that wait for the next one."""

import asyncio
from typing import Annotated

from fastapi import APIRouter, Query, Request
from fastapi.responses import Response

from sigcat.api.answers import registry_schemas as schemas
from sigcat.api.answers.negotiation import JSON, json_bytes
from sigcat.api.answers.problems import problem_documentation
from sigcat.api.middleware.registry_access import Reader
from sigcat.api.requests.clients import client_of
from sigcat.api.requests.dependencies import TheSettings
from sigcat.api.requests.event_watch import event_watch_of
from sigcat.api.requests.hosted_registry import HostedRegistry, TheRegistry
from sigcat.api.requests.thread_turns import in_thread
from sigcat.api.routes.catalogues import page_size
from sigcat.api.work.turns import Turns
from sigcat.limits import EVENT_SECONDS

router = APIRouter(prefix="/api/v1/registry", tags=["registry"], dependencies=[Reader])
_MOST = 2**31 - 1


@router.get("/events", response_model=schemas.RegistryEventList, responses=problem_documentation(401, 404, 429, 503))
async def list_registry_events(
    request: Request,
    registry: TheRegistry,
    settings: TheSettings,
    after: Annotated[
        int, Query(ge=0, le=_MOST, description="`epoch` of the answer before; 0: from the first event on.")
    ] = 0,
    wait: Annotated[
        int, Query(ge=0, le=EVENT_SECONDS, description="Seconds to wait for an event, if there is none yet.")
    ] = 0,
    limit: Annotated[
        int | None, Query(ge=1, description="Events in one answer, at most the setting `results`; without it 50.")
    ] = None,
) -> Response:
    """Changes behind an entry of the log as CloudEvents 1.0, in order: at once, or as soon as there is one."""
    loop = asyncio.get_running_loop()
    size, end = page_size(limit, settings), loop.time() + wait
    found = await in_thread(request, _events, registry, after, size)
    if not found.registry_events and wait and found.epoch == after:
        turns: Turns = request.app.state.event_turns
        watch = event_watch_of(request)
        async with turns.turn(client_of(request)):
            while not (found.registry_events or watch.is_closed) and (left := end - loop.time()) > 0:
                await watch.wait(after, lambda: _last_number(registry), left)
                found = await in_thread(request, _events, registry, after, size)
    return Response(json_bytes(found), media_type=JSON, headers={"Cache-Control": "no-store"})


def _events(registry: HostedRegistry, after: int, most: int) -> schemas.RegistryEventList:
    from sigcat.api.answers.registry_answers import events

    with registry.reading() as connection:
        return events(connection, after, most)


def _last_number(registry: HostedRegistry) -> int:
    from sigcat.registry.storing.ledger import last_number

    with registry.reading() as connection:
        return last_number(connection)
