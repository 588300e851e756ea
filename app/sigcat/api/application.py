"""The REST service: routes over a library, and nothing else."""

import asyncio
import logging
import os
from collections.abc import AsyncIterator, Iterator, Mapping, Sequence
from contextlib import asynccontextmanager, contextmanager
from functools import cache
from math import ceil
from typing import Any

from anyio.to_thread import current_default_thread_limiter
from fastapi import APIRouter, Depends, FastAPI
from fastapi.middleware.cors import CORSMiddleware
from fastapi.routing import APIRoute
from starlette.routing import BaseRoute
from starlette.types import ASGIApp, Receive, Scope, Send

from sigcat import __version__
from sigcat.api.answers.problems import install_problems
from sigcat.api.connections.http import ConnectionRules
from sigcat.api.connections.open_connections import OpenConnections
from sigcat.api.connections.open_files import connections_allowed
from sigcat.api.connections.refusals import Refusals
from sigcat.api.connections.request_starts import RequestStarts
from sigcat.api.connections.trusted_proxies import trusted_by
from sigcat.api.connections.unread_answers import UnreadAnswers
from sigcat.api.hangup import reloading_at_hangup
from sigcat.api.middleware import metrics
from sigcat.api.middleware.access import ReadAccess
from sigcat.api.middleware.answer_cache import AnswerCache
from sigcat.api.middleware.metrics import SHARED_FOLDER, Metrics
from sigcat.api.middleware.packing import Packing
from sigcat.api.middleware.request_headers import RequestHeaders
from sigcat.api.middleware.request_log import RequestLog
from sigcat.api.middleware.request_notes import RequestNotes
from sigcat.api.openapi_document import openapi_document
from sigcat.api.requests.event_watch import EventWatch
from sigcat.api.requests.held_bodies import HeldBodies
from sigcat.api.requests.hosted_registry import HostedRegistry
from sigcat.api.requests.query_parameters import refuse_unknown
from sigcat.api.requests.thread_turns import THREADS
from sigcat.api.routes import (
    catalogues,
    changes,
    contract,
    exports,
    functions,
    health,
    integration,
    lint,
    registry_approvals,
    registry_events,
    registry_reading,
    registry_writing,
    reloading,
    rules,
    viss,
)
from sigcat.api.routes.shortcuts import Shortcuts
from sigcat.api.service_rules import service_rules
from sigcat.api.settings import DEFAULT_SETTINGS, Settings
from sigcat.api.tracing import telemetry
from sigcat.api.work.queue import WorkQueue
from sigcat.api.work.turns import Turns
from sigcat.api.work.worker import EXPORTS
from sigcat.catalogue.hosting.library import Library
from sigcat.function.hosting import FunctionLibrary
from sigcat.limits import EVENT_WAITS
from sigcat.project.project import RegistrySettings
from sigcat.rules.linting.options import NO_OPTIONS, LintOptions

_DESCRIPTION = """\
A catalogue of vehicle signals and function interfaces: trees of the COVESA Vehicle Signal Specification with
overlays, rules for names and fields, and functions built from them.

Every error is `application/problem+json` (RFC 9457) and gives the error, its place and the fix.
"""


_PACKED_IN_THREAD = 32 * 1024
"""Bytes of an answer from which on a thread packs it: a millisecond on the event loop."""
_FILES = 4
"""Threads that read files: what takes turns leaves these free."""
_log = logging.getLogger("sigcat")
_SENDABLE = ("Authorization", "Content-Type", "If-None-Match", "X-Request-Id", "traceparent", "tracestate")
"""Headers that pages of other origins may send."""
_READABLE = ("ETag", "Link", "RateLimit", "RateLimit-Policy", "Retry-After", "Sigcat-Warnings", "X-Request-Id")
"""Headers that pages of other origins may read."""
_ROUTERS = (
    catalogues.listing, catalogues.router, changes.router, exports.router, reloading.router, reloading.of_functions, viss.router, rules.router,
    lint.router, functions.router, registry_writing.router, registry_approvals.router, registry_events.router, registry_reading.router, integration.router, health.router, contract.router,
)  # fmt: skip

_MODULES_OF_REGISTRY = (
    "sigcat.api.answers.registry_answers",
    "sigcat.registry.posted",
    "sigcat.api.routes.registry_writing",
)
"""Imported for work only where there is a registry: they load SQLAlchemy."""
_MODULES_OF_WORK = tuple(module.__name__ for module in (changes, exports, functions, integration, lint))


class Service(FastAPI):
    """FastAPI without its outer layers: `RequestLog` answers errors, and what reads a body bounds it."""

    _first_layer: ASGIApp | None = None

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass a request to the first layer; through all those of FastAPI where requests are traced."""
        if self._first_layer is None or scope["type"] != "http":
            await super().__call__(scope, receive, send)
            return
        scope["app"] = self
        await self._first_layer(scope, receive, send)

    def build_middleware_stack(self) -> ASGIApp:
        """Build the layers, and keep the first of those that were added here."""
        stack = super().build_middleware_stack()
        layer: Any = stack
        if not self.state.is_traced:
            first: Any = self.user_middleware[0].cls
            while not isinstance(layer, first):
                layer = layer.app
            self._first_layer = layer
        return stack


def create_app(
    library: Library,
    settings: Settings = DEFAULT_SETTINGS,
    functions: FunctionLibrary | None = None,
    registry: RegistrySettings | None = None,
    lint: LintOptions = NO_OPTIONS,
) -> Service:
    """The API over a library. Pages for people are put on top of it by `sigcat.web.site.create_site`."""
    tracing = telemetry()
    app = Service(
        title="sigcat",
        version=__version__,
        description=_DESCRIPTION,
        openapi_url=None,  # `routes/contract.py` has it
        generate_unique_id_function=_operation_id,
        telemetry=tracing,
        lifespan=_running,
    )
    app.state.is_traced = tracing["tracing"]
    app.state.library = library
    app.state.functions = functions or FunctionLibrary(catalogues=library)
    app.state.registry = HostedRegistry(registry) if registry else None
    app.state.settings = settings
    app.state.rules = service_rules(lint)
    app.state.modules_of_work = [*_MODULES_OF_WORK, *(_MODULES_OF_REGISTRY if registry else ())]
    app.state.rehearsals = tuple
    app.state.work_queue = _queue(settings.heavy_requests, settings)
    app.state.export_queue = _queue(settings.exports, settings, EXPORTS)
    app.state.reading_turns = Turns(settings.long_answers, settings.heavy_waiting, settings.client_share)
    app.state.thread_turns = Turns(THREADS, ceil(settings.connections / settings.client_share), settings.client_share)
    app.state.registry_turns = Turns(1, settings.heavy_waiting, settings.client_share)
    app.state.event_turns = Turns(EVENT_WAITS, 0, settings.client_share)
    app.state.event_watch = EventWatch()
    app.state.held_bodies = HeldBodies(settings.bodies_bytes)
    app.state.metrics = Metrics(library, app.state.functions, app.state.work_queue, app.state.export_queue)
    app.state.request_notes = RequestNotes(app.state.metrics)
    app.router.routes.extend(_routes(settings.metrics))
    install_problems(app)
    app.openapi = lambda: openapi_document(app)  # type: ignore[method-assign]
    _wrap(app, library, settings)
    return app


@cache
def _routes(has_metrics: bool) -> Sequence[BaseRoute]:
    """Routes of the API. FastAPI analyzes them at the first request; all services of a process share the result."""
    all_routers = APIRouter(generate_unique_id_function=_operation_id)
    for router in (*_ROUTERS, *([metrics.router] if has_metrics else [])):
        all_routers.include_router(router, dependencies=[Depends(refuse_unknown)])
    all_routers.include_router(exports.unknown_formats)
    return (*all_routers.routes, contract.WHOLE_SERVICE)


def _queue(at_once: int, settings: Settings, kind: str = "") -> WorkQueue:
    return WorkQueue(
        at_once,
        settings.heavy_waiting,
        seconds=settings.heavy_seconds,
        memory=settings.heavy_bytes,
        share=settings.client_share,
        kind=kind,
    )


def _wrap(app: FastAPI, library: Library, settings: Settings) -> None:
    """Add the middleware around the routes; the one that is added last is passed first."""
    app.add_middleware(Shortcuts, library=library, settings=settings)
    app.add_middleware(Packing, minimum_size=1000, compresslevel=5, thread_minimum_size=_PACKED_IN_THREAD)
    app.add_middleware(AnswerCache, library=library, most_bytes=settings.cache_bytes)
    app.add_middleware(RequestHeaders)
    if settings.reading == "token":
        app.add_middleware(ReadAccess, settings=settings)
    app.add_middleware(RequestLog, notes=app.state.request_notes)
    if settings.origins:  # around all of these: a page has to be able to read why it was refused
        app.add_middleware(
            CORSMiddleware,
            allow_origins=list(settings.origins),
            allow_methods=["GET", "POST"],
            allow_headers=_SENDABLE,
            expose_headers=_READABLE,
        )


@asynccontextmanager
async def _running(app: FastAPI) -> AsyncIterator[Mapping[str, ConnectionRules]]:
    """Have processes for work ready while the service runs, and give the server what it hands to each connection."""
    current_default_thread_limiter().total_tokens = THREADS + _FILES
    with _ready_for_work(app), reloading_at_hangup(app.state.library, app.state.functions):
        rules = _connection_rules(app)
        sharing = asyncio.create_task(_share_gauges(app.state.metrics))
        yield {"connection_rules": rules}
        sharing.cancel()


async def _share_gauges(metrics: Metrics) -> None:
    """Write the gauges for the other workers once a second, if there are any."""
    while SHARED_FOLDER in os.environ:
        metrics.refresh()
        await asyncio.sleep(1)


@contextmanager
def _ready_for_work(app: FastAPI) -> Iterator[None]:
    """Workers get ready in the background: the service does not wait for them when it starts."""
    queues: tuple[WorkQueue, ...] = (app.state.work_queue, app.state.export_queue)
    values = [app.state.rules, *(hosted.catalogue for hosted in app.state.library)]
    warming = asyncio.create_task(queues[0].warm(app.state.modules_of_work, values, app.state.rehearsals()))
    yield
    warming.cancel()
    for queue in queues:
        queue.close()


def _connection_rules(app: FastAPI) -> ConnectionRules:
    settings: Settings = app.state.settings
    most = connections_allowed(settings.connections)
    if most < settings.connections:
        _log.warning(
            "the system allows %d connections, not %d: raise its limit of open files", most, settings.connections
        )
    connections = OpenConnections(most, settings.client_connections, trusted_by(settings.trusted_proxies))
    app.state.metrics.watch_connections(connections.__len__)
    refusals = Refusals(app.state.request_notes, settings.root_path)
    unread = UnreadAnswers(settings.unread_bytes)
    return ConnectionRules(
        connections, RequestStarts(), unread, refusals, settings.head_seconds, settings.unread_seconds
    )


def _operation_id(route: APIRoute) -> str:
    """Name of the route's function: what a generated client calls its method."""
    return route.name
