"""Files of pages that are the same for all: what a request for one may say is checked as elsewhere."""

from fastapi.responses import Response
from starlette.datastructures import Headers, QueryParams
from starlette.staticfiles import StaticFiles
from starlette.types import Receive, Scope, Send

from sigcat.api.requests.preconditions import refuse_unless_matched
from sigcat.api.requests.query_parameters import refuse_others


class CheckedStaticFiles(StaticFiles):
    """Takes no parameters, heeds `If-Match`, and sends no parts of files: they are small."""

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer with a whole file, as RFC 9110 (14.2) allows to whoever asks for a range of it."""
        headers = [pair for pair in scope["headers"] if pair[0] != b"range"]
        await super().__call__({**scope, "headers": headers}, receive, send)

    async def get_response(self, path: str, scope: Scope) -> Response:
        """The file. Raises RequestValidationError, or HTTPException."""
        refuse_others(QueryParams(scope["query_string"]), ())
        response = await super().get_response(path, scope)
        response.headers["Accept-Ranges"] = "none"
        refuse_unless_matched(Headers(scope=scope).get("if-match"), response.headers.get("etag", ""))
        return response
