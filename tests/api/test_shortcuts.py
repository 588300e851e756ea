"""Shortcuts, the cache and the layers that are skipped change nothing: not the answers, the log or the metrics."""

from collections.abc import Iterable, Iterator, Mapping
from itertools import product
from typing import Any, NamedTuple

import httpx

from sigcat.api.answers.versions import state_of
from sigcat.api.application import Service, create_app
from sigcat.api.middleware.answer_cache import AnswerCache
from sigcat.api.middleware.request_notes import Note
from sigcat.api.routes.shortcuts import Shortcuts
from sigcat.catalogue.hosting.library import Library
from tests.api.conftest import SETTINGS
from tests.own_loop import run

CATALOGUES = "/api/v1/catalogues"
NODES = f"{CATALOGUES}/small/nodes"
SEARCH = f"{CATALOGUES}/small/search"
ADDRESSES = (
    f"{NODES}/Vehicle.Sped", f"{NODES}/{'a' * 300}", f"{NODES}/%00", f"{NODES}/", NODES,
    f"{NODES}/Vehicle.Speed?colour=red", f"{CATALOGUES}/smal/nodes/Vehicle", f"{CATALOGUES}/{'a' * 300}/nodes/Vehicle",
    f"{CATALOGUES}/small~without.overlay/nodes/Vehicle.Speed", f"{CATALOGUES}/small@1/nodes/Vehicle.Speed",
    f"{CATALOGUES}/broken/nodes/Vehicle", f"{CATALOGUES}/bare/nodes/Vehicle.Speed", f"{CATALOGUES}/small/nothing/Vehicle",
    f"{SEARCH}?q=vehicle", f"{SEARCH}?q=Vehicle+Speed", f"{SEARCH}?q=speed+door+vehicle+left", f"{SEARCH}?q=sped", f"{SEARCH}?q=",
    f"{SEARCH}?q=speed&limit=2", f"{SEARCH}?q=speed&q=door", f"{SEARCH}?q=speed&type=sensor", f"{SEARCH}?q={'speed+' * 30}speed",
    f"{SEARCH}?q={'a' * 1000}", f"{CATALOGUES}/smal/search?q=speed", f"{CATALOGUES}/small~without.overlay/search?q=speed",
    "/health", "/health/live", "/healthz", "/nothing",
)  # fmt: skip
OTHER_METHODS = ("POST", "DELETE", "OPTIONS", "INVENTED")
FORMS = ("*/*", "application/json", "application/yaml", "text/csv", "image/png", "text/csv;q=0.5, application/json")
PACKINGS = ("identity", "gzip")

Request = tuple[str, str, Mapping[str, str]]


class Exchanged(NamedTuple):
    """An answer, and the line of it in the log."""

    status: int
    headers: list[tuple[str, str]]
    body: object
    note: Note


def requests(library: Library) -> Iterator[Request]:
    """Nodes and searches that have shortcuts, and all that is nearly so."""
    hosted = library.get("small")
    addresses = (*(f"{NODES}/{path}" for path in hosted.catalogue.nodes), *ADDRESSES)
    tags: tuple[dict[str, str], ...] = (
        {},
        {"If-None-Match": f'W/"{state_of(hosted)}"'},
        {"If-Match": '"another"'},
        {"If-None-Match": "*"},
    )
    for address, method, tag in product(addresses, ("GET", "HEAD"), tags):
        yield method, address, {"Accept-Encoding": "identity", **tag}
    yield from ((method, address, {}) for method, address in product(OTHER_METHODS, addresses))
    for address, form, packing in product(addresses, FORMS, PACKINGS):
        yield "GET", address, {"Accept": form, "Accept-Encoding": packing}


def exchanged(app: Service, asked: Iterable[Request]) -> list[Exchanged]:
    """Send requests one after the other."""
    notes: list[Note] = []
    app.state.request_notes.log = notes.append

    async def send() -> list[Exchanged]:
        transport = httpx.ASGITransport(app, raise_app_exceptions=False)
        async with httpx.AsyncClient(transport=transport, base_url="http://sigcat") as client:
            answers = [await client.request(method, address, headers=dict(given)) for method, address, given in asked]
        return [_without_chance(answer, note) for answer, note in zip(answers, notes, strict=True)]

    return run(send())


def _without_chance(answer: httpx.Response, note: Note) -> Exchanged:
    """Remove the id and the time of a request, and the length of an answer that has the id in it."""
    is_problem = answer.headers.get("content-type") == "application/problem+json"
    chance = {"x-request-id", *(["content-length"] if is_problem else [])}
    body: Any = answer.json() if is_problem and answer.content else answer.content
    headers = sorted((name, value) for name, value in answer.headers.multi_items() if name not in chance)
    assert answer.headers["x-request-id"] == note.request_id
    if isinstance(body, dict):
        assert body.pop("request_id") == note.request_id
    return Exchanged(answer.status_code, headers, body, note._replace(request_id="", seconds=0))


def counts(app: Service) -> dict[tuple[str, tuple[tuple[str, str], ...]], float]:
    """Numbers of requests in the metrics."""
    names = ("sigcat_requests_total", "sigcat_request_seconds_count")
    samples = (sample for family in app.state.metrics.registry.collect() for sample in family.samples)
    return {(each.name, tuple(sorted(each.labels.items()))): each.value for each in samples if each.name in names}


def whole_way(library: Library) -> Service:
    """Make the same service, in which each request passes all layers and is answered by its operation."""
    app = create_app(library, SETTINGS)
    app.state.is_traced = True  # its layers are then those of FastAPI
    skipped: tuple[Any, ...] = (Shortcuts, AnswerCache)
    app.user_middleware[:] = [each for each in app.user_middleware if each.cls not in skipped]
    return app


def without_quotas(exchanged: Exchanged) -> Exchanged:
    """An answer from the cache uses no quota, and names none."""
    return exchanged._replace(headers=[pair for pair in exchanged.headers if not pair[0].startswith("ratelimit")])


def test_a_shortcut_is_as_the_whole_way(library: Library) -> None:
    asked = [*requests(library)]
    shortened = create_app(library, SETTINGS.model_copy(update={"cache_bytes": 0}))
    whole = whole_way(library)
    for request, short, long in zip(asked, exchanged(shortened, asked), exchanged(whole, asked), strict=True):
        assert short == long, request
    assert counts(shortened) == counts(whole)


def test_the_cache_is_as_the_whole_way(library: Library) -> None:
    asked = 2 * [*requests(library)]
    keeping, whole = create_app(library, SETTINGS), whole_way(library)
    for request, kept, made in zip(asked, exchanged(keeping, asked), exchanged(whole, asked), strict=True):
        assert without_quotas(kept) == without_quotas(made), request
    assert counts(keeping) == counts(whole)
