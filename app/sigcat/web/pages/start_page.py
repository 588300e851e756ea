"""The start page: catalogues and functions that the service hosts, and their findings at a glance."""

from fastapi import APIRouter, Request
from fastapi.responses import Response

from sigcat.api.answers.serializers import finding_counts
from sigcat.api.requests.dependencies import TheFunctions, TheLibrary
from sigcat.api.requests.thread_turns import InThread
from sigcat.web.rendering import page
from sigcat.web.views.function_states import function_states

router = APIRouter(route_class=InThread)


@router.get("/")
def show_start(request: Request, library: TheLibrary, functions: TheFunctions) -> Response:
    """Catalogues with the findings of reading them, and functions with their errors."""
    return page(
        request,
        "start.html",
        catalogues=[(each, finding_counts(each.rejected or each.catalogue.findings)) for each in library],
        functions=function_states(functions.files, library),
    )
