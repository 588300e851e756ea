"""Pages and answers that a thread makes: clients take turns, so that many requests of one do not delay the others."""

from collections.abc import AsyncIterator, Callable, Coroutine, Iterator
from inspect import Parameter, iscoroutinefunction, signature
from typing import Annotated, Any, ParamSpec, TypeVar

from fastapi import Depends, Request
from fastapi.concurrency import run_in_threadpool
from fastapi.responses import Response
from fastapi.routing import APIRoute

from sigcat.api.answers.negotiation import ANY, JSON
from sigcat.api.requests.clients import client_of
from sigcat.api.work.quotas import mark_quota
from sigcat.api.work.turns import Turns
from sigcat.catalogue.model.catalogue import Node

THREADS = 4
"""Threads that work at once: they share one core, so more would delay all of them, and the reading meanwhile."""
_FEW_CHILDREN = 100
_ASKING = "asking"
_Arguments = ParamSpec("_Arguments")
_Result = TypeVar("_Result")


class InThread(APIRoute):
    """A route whose function, unless it is a coroutine, runs in a thread when it is the turn of who asks."""

    def __init__(self, path: str, endpoint: Callable[..., Any], **options: Any) -> None:
        super().__init__(path, endpoint if iscoroutinefunction(endpoint) else _in_turn(endpoint), **options)


async def in_thread(
    request: Request,
    function: Callable[_Arguments, _Result],
    /,
    *arguments: _Arguments.args,
    **options: _Arguments.kwargs,
) -> _Result:
    """Return a function's result from a thread, when it is the client's turn. Raises Busy if too many wait."""
    turns: Turns = request.app.state.thread_turns
    return await to_the_end(request, turns, "answers", lambda: run_in_threadpool(function, *arguments, **options))


async def to_the_end(
    request: Request, turns: Turns, quota: str, begin: Callable[[], Coroutine[Any, Any, _Result]]
) -> _Result:
    """Return the result of work that keeps its turn until it ends; the answer names the quota. Raises Busy if too many wait."""
    client = client_of(request)
    mark_quota(request, turns.quota_of(client, quota))
    return await turns.to_the_end(client, begin)


def has_turn(request: Request) -> bool:
    """Whether who asks may have one more answer made; if so, the answer names the quota, as `in_thread` does."""
    turns: Turns = request.app.state.thread_turns
    quota = turns.quota_of(client_of(request), "answers")
    if quota.remaining() < 1:
        return False
    mark_quota(request, quota)
    return True


async def parts_in_turn(request: Request, parts: Iterator[bytes]) -> AsyncIterator[bytes]:
    """An answer that is sent while it is made: each part of it has a separate turn."""
    while (part := await in_thread(request, next, parts, None)) is not None:
        yield part


def is_for_the_loop(request: Request, node: Node) -> bool:
    """Whether an answer about a node costs so little that it is made on the event loop: as JSON, with few children."""
    return has_few_children(node) and request.headers.get("accept", ANY) in (ANY, JSON)


def has_few_children(node: Node) -> bool:
    """Whether an answer about a node is short."""
    return len(node.children) <= _FEW_CHILDREN


async def _asking(request: Request) -> Request:
    return request


def _in_turn(function: Callable[..., Response]) -> Callable[..., Any]:
    """The function as a coroutine that waits for its turn: after what it depends on is there, which may have waited elsewhere."""

    async def answered(**values: Any) -> Response:
        request: Request = values.pop(_ASKING)
        return await in_thread(request, function, **values)

    asked = signature(function)
    asking = Parameter(_ASKING, Parameter.KEYWORD_ONLY, annotation=Annotated[Request, Depends(_asking)])
    answered.__signature__ = asked.replace(parameters=[*asked.parameters.values(), asking])  # type: ignore[attr-defined]
    answered.__name__, answered.__doc__ = function.__name__, function.__doc__
    return answered
