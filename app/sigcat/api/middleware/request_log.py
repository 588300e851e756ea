"""First step of every request: it gets an id, and its result is counted and logged."""

import asyncio
import re
from collections.abc import Callable
from time import perf_counter
from typing import Any

from fastapi import Request
from starlette.types import ASGIApp, Message, Receive, Scope, Send

from sigcat.api.answers.problems import answer_problem
from sigcat.api.middleware.request_notes import NO_ROUTE, Note, RequestNotes, new_request_id
from sigcat.api.tracing import name_span
from sigcat.api.work.quotas import quota_headers
from sigcat.api.work.refusals import Busy

_CLIENT_LEFT = 499
"""Status in the log if the client was gone before the answer. It is never sent; other servers log the same number."""
_GIVEN_ID = re.compile(rb"[A-Za-z0-9._-]{8,64}")


class RequestLog:
    """Gives each request an id, counts it and logs it. HEAD is GET of which the body is not sent."""

    def __init__(self, app: ASGIApp, notes: RequestNotes) -> None:
        self._app = app
        self._notes = notes

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass a request on."""
        if scope["type"] != "http":
            await self._app(scope, receive, send)
            return
        began = perf_counter()
        method = scope["method"]
        asked = {**scope, "method": "GET"} if method == "HEAD" else scope
        state: dict[str, Any] = asked.setdefault("state", {})
        state["is_head"] = method == "HEAD"
        request_id = state["request_id"] = _request_id(asked)
        header = (b"x-request-id", request_id.encode())
        has_left: Callable[[], bool] = state.get("has_left", bool)
        status = 0

        async def noting_send(message: Message) -> None:
            nonlocal status
            if has_left():
                return
            if message["type"] != "http.response.start":
                await send({**message, "body": b""} if method == "HEAD" else message)
                return
            quotas = state.get("quotas")
            state["trace_id"] = name_span(method, _route_of(asked), request_id)
            message["headers"] = [
                *message.get("headers", ()),
                header,
                *(quota_headers(quotas.values()) if quotas else ()),
            ]
            await send(message)  # the client may leave before it has read earlier answers
            status = message["status"]

        try:
            await self._app(asked, receive, noting_send)
        except asyncio.CancelledError:
            if has_left():
                return
            if status:  # the server stops, and `stop_seconds` are over
                raise
            response = await answer_problem(Request(asked), Busy("The service is stopping. Try again."))
            await response(asked, receive, noting_send)
        except Exception as error:
            if status:  # the server closes the connection, and logs the error
                raise
            response = await asked["app"].exception_handlers[Exception](Request(asked), error)
            await response(asked, receive, noting_send)
        finally:
            self._note(asked, method, status or (_CLIENT_LEFT if has_left() else 500), perf_counter() - began)

    def _note(self, scope: Scope, method: str, status: int, seconds: float) -> None:
        state = scope["state"]
        client = scope.get("client") or ("", 0)
        trace = state.get("trace_id", "")
        route = _route_of(scope)
        self._notes.add(Note(state["request_id"], method, scope["path"], route, status, seconds, client[0], "", trace))


def _route_of(scope: Scope) -> str:
    return scope["state"].get("route") or getattr(scope.get("route"), "path", "") or NO_ROUTE


def _request_id(scope: Scope) -> str:
    """The id that a proxy gave, if it looks like one; or a new one."""
    for name, value in scope["headers"]:
        if name == b"x-request-id" and _GIVEN_ID.fullmatch(value):
            given: str = value.decode("ascii")
            return given
    return new_request_id()
