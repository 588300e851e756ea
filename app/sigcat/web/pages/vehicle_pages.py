"""The vehicles of a catalogue: which of them have a node, as a page and as CSV."""

from typing import Annotated, Literal

from fastapi import APIRouter, Query, Request
from fastapi.responses import Response

from sigcat.api.requests.dependencies import AnyCatalogue, TheLibrary
from sigcat.api.requests.thread_turns import InThread
from sigcat.catalogue.hosting.vehicle_matrix import matrix_csv
from sigcat.limits import PARAMETER_CHARACTERS
from sigcat.web.rendering import page, text_file
from sigcat.web.views.vehicle_view import base_of, chosen_matrix, filters_of, vehicle_view

router = APIRouter(route_class=InThread)
Text = Annotated[str, Query(alias="q", max_length=PARAMETER_CHARACTERS)]
Facts = Annotated[list[str], Query(alias="fact", max_length=20)]
Shown = Annotated[Literal["", "all"], Query(alias="show")]


@router.get("/vehicles/{catalogue}")
def show_vehicles(
    request: Request,
    library: TheLibrary,
    hosted: AnyCatalogue,
    text: Text = "",
    facts: Facts = [],  # noqa: B006 — it is not changed
    shown: Shown = "",
    start: Annotated[int, Query(alias="from", ge=0)] = 0,
) -> Response:
    """A table of nodes and vehicles."""
    base = base_of(library, hosted)
    filters = filters_of(text, facts, is_all=shown == "all")
    return page(
        request,
        "vehicles.html",
        hosted=hosted,
        base=base,
        filters=filters,
        sought=text,
        chosen=[fact for fact in facts if not fact.endswith(":")],
        view=vehicle_view(base, filters, start),
    )


@router.get("/vehicles/{catalogue}/matrix.csv")
def download_vehicles(
    library: TheLibrary,
    hosted: AnyCatalogue,
    text: Text = "",
    facts: Facts = [],  # noqa: B006 — it is not changed
    shown: Shown = "",
) -> Response:
    """The same table as CSV, with all rows and vehicles that the filters leave."""
    base = base_of(library, hosted)
    matrix = chosen_matrix(base, filters_of(text, facts, is_all=shown == "all"))
    return text_file(matrix_csv(matrix), f"{base.source.id}-vehicles.csv", "text/csv")
