"""Inputs that routes take from a request: the hosted catalogue, the posted text."""

import asyncio
from collections.abc import AsyncIterator, Callable, Mapping
from functools import lru_cache
from http import HTTPStatus
from types import MappingProxyType
from typing import Annotated, Any, Concatenate, NamedTuple, ParamSpec, TypeVar

from fastapi import Depends, Path, Query, Request
from starlette.exceptions import HTTPException

from sigcat.api.answers.negotiation import VARY_OF_304
from sigcat.api.answers.problems import BodyRefused, problem_documentation
from sigcat.api.answers.versions import state_of, version_of
from sigcat.api.requests.clients import client_of
from sigcat.api.requests.held_bodies import HeldBodies, Hold
from sigcat.api.requests.preconditions import is_known, refuse_unless_matched
from sigcat.api.service_rules import ServiceRules
from sigcat.api.settings import Settings
from sigcat.api.work.queue import ClientQueue, WorkQueue
from sigcat.api.work.quotas import mark_quota
from sigcat.catalogue.hosting.library import Hosted, Library
from sigcat.catalogue.hosting.variants import MARK, find_hosted
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.search import index_of
from sigcat.errors import NotFound
from sigcat.function.hosting import FunctionLibrary
from sigcat.limits import NAME_CHARACTERS, Limits

_Found = TypeVar("_Found")
_Further = ParamSpec("_Further")
_NEVER_CHANGES = "max-age=31536000, immutable"


def library_of(request: Request) -> Library:
    """The library that the service hosts."""
    library: Library = request.app.state.library
    return library


def functions_of(request: Request) -> FunctionLibrary:
    """The functions that the service hosts."""
    functions: FunctionLibrary = request.app.state.functions
    return functions


def settings_of(request: Request) -> Settings:
    """The settings of the service."""
    settings: Settings = request.app.state.settings
    return settings


def rules_of(request: Request) -> ServiceRules:
    """The rules of the service."""
    rules: ServiceRules = request.app.state.rules
    return rules


def queue_of(request: Request) -> ClientQueue:
    """The queue of work that takes long, for who asks."""
    queue: WorkQueue = request.app.state.work_queue
    return queue.of(client_of(request))


async def _queue(request: Request) -> ClientQueue:
    return _marked(request, request.app.state.work_queue)


async def _export_queue(request: Request) -> ClientQueue:
    return _marked(request, request.app.state.export_queue)


def _marked(request: Request, queue: WorkQueue) -> ClientQueue:
    """The queue for who asks; the answer names the quota."""
    client = client_of(request)
    mark_quota(request, queue.quota_of(client))
    return queue.of(client)


def _at_once(found: Callable[[Request], _Found]) -> Any:
    """A dependency on the result of a function that takes no time."""

    async def dependency(request: Request) -> _Found:
        return found(request)

    return Depends(dependency)


# Dependencies are coroutines throughout: FastAPI sends plain functions through a pool of threads, each of them.
# They take what they need from the request: each dependency of a dependency costs as much as a small answer.
TheLibrary = Annotated[Library, _at_once(library_of)]
TheFunctions = Annotated[FunctionLibrary, _at_once(functions_of)]
TheSettings = Annotated[Settings, _at_once(settings_of)]
TheRules = Annotated[ServiceRules, _at_once(rules_of)]
TheWorkQueue = Annotated[ClientQueue, Depends(_queue)]
TheExportQueue = Annotated[ClientQueue, Depends(_export_queue)]
CatalogueId = Annotated[
    str,
    Path(
        description="Id of a hosted catalogue; with `~vehicle.ID` and `~state.STATE` behind it, that of a vehicle; with "
        "`~without.OVERLAY`, without that overlay; with `~folded`, "
        "with instances as they were written; with `@VERSION`, of that state of it and no other.",
        examples=["interfaces"],
        max_length=NAME_CHARACTERS,
    ),
]


def hosted_at(name: str, library: Library) -> tuple[Hosted, bool]:
    """The catalogue that `ID` or `ID@VERSION` names, and whether a version was named. Raises NotFound."""
    catalogue_id, at, version = name.rpartition("@")
    if not at:
        return find_hosted(library, name), False
    hosted = find_hosted(library, catalogue_id)
    current = version_of(hosted)
    if version != current:
        message = f"The version of catalogue {catalogue_id!r} must be {current!r}, not {version[:80]!r}."
        raise NotFound(message, (f"{catalogue_id}@{current}",))
    return hosted._replace(rejected=()) if hosted.rejected else hosted, True


async def catalogue_at(name: str, library: Library, queue: ClientQueue) -> tuple[Hosted, bool]:
    """The same as `hosted_at`; a variant, which may have to be composed, waits for its turn."""
    return await queue.run_here(_variant_at, name, library) if MARK in name else hosted_at(name, library)


def _variant_at(name: str, library: Library) -> tuple[Hosted, bool]:
    hosted, is_fixed = hosted_at(name, library)
    index_of(hosted.catalogue)
    assert hosted.catalogue.digest
    return hosted, is_fixed


async def any_catalogue(catalogue: CatalogueId, request: Request) -> Hosted:
    """The hosted catalogue named in the address."""
    return (await catalogue_at(catalogue, library_of(request), queue_of(request)))[0]


async def hosted_catalogue(catalogue: CatalogueId, request: Request) -> Hosted:
    """The hosted catalogue named in the address; 304 if the client holds the same state of it."""
    hosted = await catalogue_of_node(catalogue, request)
    judge_conditions(request)
    return hosted


async def catalogue_of_node(catalogue: CatalogueId, request: Request) -> Hosted:
    """The same where a node is looked for: conditions are evaluated once it is found (RFC 9110, 13.2.1)."""
    hosted, is_fixed = await catalogue_at(catalogue, library_of(request), queue_of(request))
    mark_catalogue(request, hosted, is_fixed=is_fixed)
    return hosted


def mark_catalogue(request: Request, hosted: Hosted, *, is_fixed: bool) -> None:
    """Keep the headers for an answer about a catalogue, and which it is."""
    mark_state(request, state_of(hosted), is_fixed=is_fixed)
    request.state.hosted = hosted


def mark_state(request: Request, version: str, *, is_fixed: bool) -> None:
    """Keep the headers for the answer."""
    request.state.caching = headers_of_state(version, settings_of(request).reading, is_fixed=is_fixed)


@lru_cache(64)
def headers_of_state(version: str, reading: str, *, is_fixed: bool) -> Mapping[str, str]:
    """Headers of an answer about a state. Where reading needs a token, no cache may keep an answer for others."""
    reach = "private" if reading == "token" else "public"
    lasting = f"{reach}, {_NEVER_CHANGES}" if is_fixed else "no-cache" if reach == "public" else "private, no-cache"
    return {"ETag": f'W/"{version}"', "Cache-Control": lasting}


def judge_conditions(request: Request) -> None:
    """Raises a 304 if the client holds the state that was marked, a 412 if it wants another one."""
    headers: Mapping[str, str] = request.state.caching
    refuse_unless_matched(request.headers.get("if-match"), headers["ETag"])
    if is_known(request.headers.get("if-none-match", ""), headers["ETag"]):
        raise HTTPException(HTTPStatus.NOT_MODIFIED, headers={**headers, "Vary": VARY_OF_304})


TheCatalogue = Annotated[Hosted, Depends(hosted_catalogue)]
CatalogueOfNode = Annotated[Hosted, Depends(catalogue_of_node)]
AnyCatalogue = Annotated[Hosted, Depends(any_catalogue)]


async def named_catalogue(
    request: Request,
    catalogue: Annotated[
        str | None,
        Query(max_length=NAME_CHARACTERS, description="Id of a hosted catalogue; without it, the default one."),
    ] = None,
) -> Hosted:
    """The hosted catalogue that a posted text is checked against."""
    library = library_of(request)
    return library.default if catalogue is None else (await catalogue_at(catalogue, library, queue_of(request)))[0]


NamedCatalogue = Annotated[Hosted, Depends(named_catalogue)]


FileName = Annotated[str, Query(max_length=NAME_CHARACTERS, description="What findings call the text.")]


async def posted_body(request: Request) -> AsyncIterator[bytes]:
    """The body, whatever it is, not longer than the limit and within its time. It counts until the request is answered.

    Raises Busy at once without room for the work that it is for.
    """
    client = client_of(request)
    held: HeldBodies = request.app.state.held_bodies
    mark_quota(request, held.quota_of(client))
    queue_of(request).refuse_more()
    with held.of(client) as hold:
        yield await _body(request, hold)


async def _refuse_no_text(request: Request) -> None:
    """Raises BodyRefused for a form, and where no body was sent at all: an empty text has a length, 0."""
    if request.headers.get("content-type", "").startswith("multipart/"):
        detail = "The body must be the text itself, not a form. Use `curl --data-binary @FILE`."
        raise BodyRefused(HTTPStatus.UNSUPPORTED_MEDIA_TYPE, detail)
    if "content-length" not in request.headers and "transfer-encoding" not in request.headers:
        raise BodyRefused(HTTPStatus.UNPROCESSABLE_ENTITY, "The body must be the text. Use `curl --data-binary @FILE`.")


async def posted_text(
    _: Annotated[None, Depends(_refuse_no_text)], body: Annotated[bytes, Depends(posted_body)]
) -> bytes:
    """The same; its media type does not matter, as long as it is the bare text."""
    return body


async def _body(request: Request, hold: Hold) -> bytes:
    settings = settings_of(request)
    if request.headers.get("content-encoding", "identity") != "identity":
        raise BodyRefused(HTTPStatus.UNSUPPORTED_MEDIA_TYPE, "The body must not be compressed. Send it as it is.")
    declared = request.headers.get("content-length", "")
    if declared.isdecimal() and len(declared) <= len(str(settings.body_bytes)) + 1:
        _check_length(int(declared), request, settings)
    elif declared:
        _check_length(settings.body_bytes + 1, request, settings)
    try:
        async with asyncio.timeout(settings.body_seconds):
            return await _read(request, settings, hold)
    except TimeoutError:
        detail = f"The body must arrive within {settings.body_seconds:g} seconds."
        raise BodyRefused(HTTPStatus.REQUEST_TIMEOUT, detail, headers={"Connection": "close"}) from None


async def _read(request: Request, settings: Settings, hold: Hold) -> bytes:
    body = bytearray()
    async for chunk in request.stream():
        hold(len(chunk))
        body += chunk
        _check_length(len(body), request, settings)
    return bytes(body)


PostedText = Annotated[bytes, Depends(posted_text)]
PostedBody = Annotated[bytes, Depends(posted_body)]


class PostedWork(NamedTuple):
    """A posted text with what every work on it takes: the catalogue that it is checked against, limits, and a queue."""

    text: bytes
    hosted: Hosted
    limits: Limits
    queue: ClientQueue

    async def run(
        self,
        function: Callable[Concatenate[bytes, str, Catalogue, Limits, _Further], _Found],
        name: str,
        *further: _Further.args,
        **options: _Further.kwargs,
    ) -> _Found:
        """Return a function's result about the text, which findings call by its name, from a worker process."""
        known = self.text, name, self.hosted.catalogue, self.limits
        return await self.queue.run(function, *known, *further, **options)


async def _posted_work(request: Request, text: PostedText, hosted: NamedCatalogue) -> PostedWork:
    return PostedWork(text, hosted, settings_of(request).limits, await _queue(request))


ThePostedWork = Annotated[PostedWork, Depends(_posted_work)]


def takes_text(
    description: str, example: str, *statuses: int, answers: Mapping[int | str, dict[str, Any]] = MappingProxyType({})
) -> dict[str, Any]:
    """The documentation of an operation that takes a text: sent unchanged, like its file, whatever its name.

    It may answer with problems of any posted text, and of these statuses.
    """
    content: dict[str, Any] = {"schema": {"type": "string", "format": "binary"}}
    if example:
        content["example"] = example
    body = {"required": True, "description": description, "content": {"application/octet-stream": content}}
    return {
        "responses": {**answers, **problem_documentation(*_OF_TEXTS, *statuses)},
        "openapi_extra": {"requestBody": body},
    }


_OF_TEXTS = (408, 413, 415, 422, 503)


def _check_length(length: int, request: Request, settings: Settings) -> None:
    """Raises BodyRefused. A client that sends all the same may continue for a while: closed at once, it would not read why."""
    if length > settings.body_bytes:
        detail = f"The body must have at most {settings.body_bytes:,} bytes."
        headers = {"Connection": "close"} if "expect" in request.headers else None
        raise BodyRefused(HTTPStatus.REQUEST_ENTITY_TOO_LARGE, detail, headers=headers)
