"""The whole service: the API, and pages for people on top of it."""

from collections.abc import Iterator, Sequence
from functools import cache, partial
from http import HTTPStatus
from itertools import islice
from pathlib import Path

from fastapi import APIRouter, Depends, FastAPI, Request
from fastapi.responses import Response
from starlette.exceptions import HTTPException
from starlette.routing import BaseRoute

from sigcat.api.answers.problems import ANSWERED, answer_problem, headers_of, problem_from
from sigcat.api.application import create_app
from sigcat.api.requests.thread_turns import in_thread
from sigcat.api.settings import DEFAULT_SETTINGS, Settings
from sigcat.api.work.references import Work
from sigcat.api.work.refusals import Busy
from sigcat.catalogue.hosting.library import Library
from sigcat.function.hosted_files import HostedFiles
from sigcat.function.hosting import FunctionLibrary
from sigcat.project.project import RegistrySettings
from sigcat.rules.linting.options import NO_OPTIONS, LintOptions
from sigcat.web.pages import (
    api_reference,
    basket_pages,
    catalogue_change_pages,
    catalogue_pages,
    documentation_pages,
    function_pages,
    node_pages,
    openid_pages,
    platform_comparison_pages,
    proposal_pages,
    registry_forms,
    registry_login,
    registry_pages,
    rule_pages,
    set_pages,
    start_page,
    try_pages,
    vehicle_pages,
)
from sigcat.web.rendering import compile_templates, problem_page
from sigcat.web.security_headers import SecurityHeaders
from sigcat.web.static_files import CheckedStaticFiles
from sigcat.web.visits import refuse_unknown

_PAGES = (
    start_page,
    platform_comparison_pages,
    function_pages,
    set_pages,
    try_pages,
    catalogue_change_pages,
    node_pages,
    basket_pages,
    proposal_pages,
    registry_login,
    registry_forms,
    registry_pages,
    catalogue_pages,
    rule_pages,
    api_reference,
    documentation_pages,
    vehicle_pages,
)
_STATIC = Path(__file__).parent / "static"


def create_site(
    library: Library,
    settings: Settings = DEFAULT_SETTINGS,
    functions: FunctionLibrary | None = None,
    registry: RegistrySettings | None = None,
    lint: LintOptions = NO_OPTIONS,
) -> FastAPI:
    """The API with the browser pages. Without functions given: those that sigcat ships; `lint` has the rules of a project."""
    app = create_app(library, settings, functions, registry, lint)
    app.state.modules_of_work += [
        platform_comparison_pages.__name__,
        function_pages.__name__,
        catalogue_change_pages.__name__,
        node_pages.__name__,
        proposal_pages.__name__,
        registry_pages.__name__,
        registry_forms.__name__,
        basket_pages.__name__,
        set_pages.__name__,
        try_pages.__name__,
    ]
    if registry is not None:
        app.state.modules_of_work.append(registry_pages.VIEWS)
    app.state.rehearsals = partial(_rehearsals, app, library, settings)
    app.router.routes.extend(_routes())
    app.mount("/static", CheckedStaticFiles(directory=_STATIC), name="static")
    app.add_middleware(SecurityHeaders)
    for kind in ANSWERED:
        app.add_exception_handler(kind, _answer)
    return app


@cache
def _routes() -> Sequence[BaseRoute]:
    """Routes of the pages, which all services of a process share."""
    all_routers = APIRouter()
    all_routers.include_router(openid_pages.router, include_in_schema=False)  # a provider may send invented parameters
    for module in _PAGES:
        all_routers.include_router(module.router, include_in_schema=False, dependencies=[Depends(refuse_unknown)])
    return tuple(all_routers.routes)


def _rehearsals(app: FastAPI, library: Library, settings: Settings) -> Iterator[Work]:
    """Load the modules that make the first pages of workers slow."""
    yield Work(compile_templates, (), {})
    for hosted in islice(library, 1):  # the one over which most try something
        files: HostedFiles = app.state.functions.files
        yield Work(try_pages.rehearse, (hosted.catalogue, app.state.rules, files, settings.limits), {})


async def _answer(request: Request, error: Exception) -> Response:
    """A problem document for programs, a page for people."""
    path = request.scope["path"].removeprefix(request.scope.get("root_path", ""))
    is_for_programs = path.startswith(("/api/", "/health", "/metrics", "/openapi.json", "/rows/")) or path.endswith(
        ".json"
    )
    if is_for_programs or (isinstance(error, HTTPException) and error.status_code < HTTPStatus.BAD_REQUEST):
        return await answer_problem(request, error)
    problem = problem_from(error)
    if problem.status >= HTTPStatus.INTERNAL_SERVER_ERROR:
        await answer_problem(request, error)
    try:
        return await in_thread(request, problem_page, request, problem, headers_of(error))
    except Busy:  # pages cannot even say so
        return await answer_problem(request, error)
