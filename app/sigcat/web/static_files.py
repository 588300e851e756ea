"""Files of pages that are the same for all: what a request for one may say is checked as elsewhere."""

from fastapi.responses import Response
from starlette.datastructures import Headers, QueryParams
from starlette.staticfiles import StaticFiles
from starlette.types import Scope

from sigcat.api.requests.preconditions import refuse_unless_matched
from sigcat.api.requests.query_parameters import refuse_others


class CheckedStaticFiles(StaticFiles):
    """Takes no parameters, and heeds `If-Match`."""

    async def get_response(self, path: str, scope: Scope) -> Response:
        """The file. Raises RequestValidationError, or HTTPException."""
        refuse_others(QueryParams(scope["query_string"]), ())
        response = await super().get_response(path, scope)
        refuse_unless_matched(Headers(scope=scope).get("if-match"), response.headers.get("etag", ""))
        return response
