"""Every error as RFC 9457 problem details, `application/problem+json`."""

import logging
from collections.abc import Iterable
from http import HTTPStatus
from typing import Any

from fastapi import FastAPI, Request
from fastapi.exceptions import RequestValidationError
from fastapi.responses import Response
from starlette.exceptions import HTTPException
from starlette.requests import ClientDisconnect

from sigcat import codes
from sigcat.api.answers import schemas
from sigcat.api.answers.negotiation import offered
from sigcat.api.answers.serializers import listed_findings, plain_text
from sigcat.api.validation import reason_of
from sigcat.api.work.refusals import RETRY_SECONDS
from sigcat.errors import InputRefused, NoRoom, NotFound, RegistryUnusable, SigcatError, ToolCrashed
from sigcat.findings import Finding

MEDIA_TYPE = "application/problem+json"
PROBLEM: dict[str, Any] = {"content": {MEDIA_TYPE: {"schema": {"$ref": "#/components/schemas/Problem"}}}}
"""Content of an OpenAPI response that is a problem."""
_LOG = logging.getLogger("sigcat")

KINDS: dict[int, tuple[str, str]] = {
    400: ("bad-request", "Bad request"),
    401: ("unauthorized", "Authentication required"),
    403: ("forbidden", "The request is not allowed"),
    404: ("not-found", "Not found"),
    405: ("method-not-allowed", "Method not allowed"),
    406: ("not-acceptable", "Not acceptable"),
    408: ("request-timeout", "Request timed out"),
    409: ("conflict", "Conflict with what is published"),
    412: ("precondition-failed", "Precondition failed: version mismatch"),
    413: ("body-too-large", "Body too large"),
    415: ("unsupported-media-type", "Unsupported media type"),
    422: ("invalid-input", "Invalid input"),
    429: ("too-many-requests", "Too many requests of one client"),
    431: ("headers-too-large", "Headers too large"),
    500: ("internal-error", "Internal error"),
    503: ("busy", "Service busy"),
    507: ("no-temporary-space", "No room on the disk"),
}
"""Name in the problem's `type` and its title, by status."""


_STATUS_BY_RULE: dict[str, int] = {codes.OWNED_BY_ANOTHER.id: 403, codes.VERSION_TAKEN.id: 409}
"""Statuses of refused inputs about which a finding says more than that they are invalid."""
_STATUSES: dict[type[SigcatError], int] = {NoRoom: 507, ToolCrashed: 500}
ANSWERED = (SigcatError, RequestValidationError, HTTPException, ClientDisconnect, Exception)
"""Exceptions that are answered. A client that is gone reads nothing, but its request is not a failure of the service."""


class BodyRefused(HTTPException):
    """A posted body is too large (413) or of a kind that is not read (415)."""


def problem_of(
    status: int, detail: str, findings: Iterable[Finding] = (), nearest: Iterable[str] = ()
) -> schemas.Problem:
    """A problem with the type and title of its status."""
    kind, title = KINDS.get(status, (f"status-{status}", HTTPStatus(status).phrase))
    return schemas.Problem(
        type=f"/problems/{kind}",
        title=title,
        status=status,
        detail=plain_text(detail),
        findings=listed_findings(tuple(findings)),
        nearest=[plain_text(name) for name in nearest],
    )


def problem_from(error: Exception) -> schemas.Problem:
    """The problem for an exception. One of other code is an internal error without details."""
    if isinstance(error, NotFound):
        return problem_of(404, str(error), nearest=error.nearest)
    if isinstance(error, InputRefused):
        return _unusable_registry(error) if isinstance(error, RegistryUnusable) else _refused_input(error)
    if isinstance(error, SigcatError):
        return problem_of(_STATUSES.get(type(error), HTTPStatus.UNPROCESSABLE_ENTITY), str(error))
    if isinstance(error, RequestValidationError):
        findings = [_invalid(each) for each in error.errors()]
        return problem_of(422, " ".join(finding.message for finding in findings), findings)
    if isinstance(error, ClientDisconnect):
        error = BodyRefused(HTTPStatus.BAD_REQUEST, "The connection must stay open until the body is whole.")
    if isinstance(error, HTTPException):
        return problem_of(error.status_code, _detail_of(error))
    return problem_of(500, "The server failed; its log says why.")


def install_problems(app: FastAPI) -> None:
    """Answer every exception with a problem."""
    for kind in ANSWERED:
        app.add_exception_handler(kind, answer_problem)


def problem_documentation(*statuses: int) -> dict[int | str, dict[str, Any]]:
    """The `responses` of an operation that may answer with problems of these statuses."""
    return {status: {"description": KINDS[status][1], "model": schemas.Problem} for status in statuses}


def header_documentation(description: str, kind: str = "string") -> dict[str, Any]:
    """A header of an answer, in the OpenAPI document."""
    return {"description": description, "schema": {"type": kind}}


def reads(model: Any, *statuses: int, is_table: bool = False) -> dict[str, Any]:
    """The documentation of an operation that answers with a model, also as YAML, and a table also as CSV, or with problems."""
    return {"response_model": model, "responses": offered(is_table=is_table) | problem_documentation(406, *statuses)}


async def answer_problem(request: Request, error: Exception) -> Response:
    """The problem document for an exception, its `type` below the path under which the service is mounted.

    What failed inside goes to the log.
    """
    headers = headers_of(error)
    if isinstance(error, HTTPException) and error.status_code < HTTPStatus.BAD_REQUEST:
        return Response(status_code=error.status_code, headers=headers)
    problem = problem_from(error)
    address = request.scope.get("root_path", "").rstrip("/") + problem.type
    problem = problem.model_copy(update={"type": address, "request_id": getattr(request.state, "request_id", "")})
    if problem.status >= HTTPStatus.INTERNAL_SERVER_ERROR:
        _log_failure(request, problem, error)
    return Response(problem.model_dump_json(), problem.status, media_type=MEDIA_TYPE, headers=headers)


def headers_of(error: Exception) -> dict[str, str]:
    """The headers of a problem. Where GET is allowed, HEAD is: the same without its body."""
    headers: dict[str, str] = dict(getattr(error, "headers", None) or {})
    if isinstance(error, RegistryUnusable) and not error.is_full:
        headers["Retry-After"] = str(RETRY_SECONDS)
    if "GET" in (methods := headers.get("Allow", "").split(", ")):
        headers["Allow"] = ", ".join(sorted({*methods, "HEAD"}))
    return headers


def _refused_input(error: InputRefused) -> schemas.Problem:
    statuses = (_STATUS_BY_RULE[each.rule] for each in error.findings if each.rule in _STATUS_BY_RULE)
    return problem_of(next(statuses, 422), str(error), error.findings)


def _unusable_registry(error: RegistryUnusable) -> schemas.Problem:
    """The problem without the name of the database, which is in the log."""
    findings = [finding._replace(file="") for finding in error.findings]
    status = HTTPStatus.INSUFFICIENT_STORAGE if error.is_full else HTTPStatus.SERVICE_UNAVAILABLE
    return problem_of(status, "The registry cannot be used now.", findings)


def _log_failure(request: Request, problem: schemas.Problem, error: Exception) -> None:
    if problem.status == HTTPStatus.INTERNAL_SERVER_ERROR:
        _LOG.error(
            "%s %s failed [%s]", request.method[:20], request.scope["path"][:500], problem.request_id, exc_info=error
        )
    if isinstance(error, RegistryUnusable):
        _LOG.error("%s [%s]", error.findings[0].line_of_text, problem.request_id)
    elif problem.status == HTTPStatus.INSUFFICIENT_STORAGE:
        _LOG.error("%s [%s]", problem.detail, problem.request_id)


def _invalid(error: dict[str, Any]) -> Finding:
    """A part of the request that did not fit, as a finding; the pointer leads to the parameter."""
    where = [str(part) for part in error["loc"]]
    name = where[-1] if where else ""
    pointer = "".join("/" + part.replace("~", "~0").replace("/", "~1") for part in where)
    reason = reason_of(error)
    if error["type"] == "extra_forbidden":
        fix = error.get("ctx", {}).get("hint", "")
        return codes.PARAMETER_THAT_DOES_NOT_FIT.finding(f"Unknown parameter {name!r}.", pointer=pointer, fix=fix)
    return codes.PARAMETER_THAT_DOES_NOT_FIT.finding(f"Parameter {name!r}: {reason}.", pointer=pointer)


def _detail_of(error: HTTPException) -> str:
    if isinstance(error, BodyRefused):
        return error.detail
    if error.status_code == HTTPStatus.NOT_FOUND:
        return "No page or operation has this address. /openapi.json lists the operations."
    if error.status_code == HTTPStatus.METHOD_NOT_ALLOWED:
        return "This address does not allow the method; the header `Allow` lists those that it does."
    return str(error.detail)
