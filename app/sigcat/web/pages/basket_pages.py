"""The basket: chosen signals, and files made of them. The service keeps nothing: the choice is in the address."""

from collections.abc import Callable, Mapping
from http import HTTPStatus
from typing import Annotated, NamedTuple

from fastapi import APIRouter, Query, Request
from fastapi.responses import RedirectResponse, Response

from sigcat.api.requests.dependencies import AnyCatalogue, TheWorkQueue
from sigcat.catalogue.hosting.library import Hosted
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.errors import NotFound
from sigcat.limits import BASKET_CHARACTERS
from sigcat.names import nearest
from sigcat.web.addresses import Addresses
from sigcat.web.basket import read_basket
from sigcat.web.rendering import page_for, text_file
from sigcat.web.views.chosen_signals import (
    ChosenSignals,
    chosen_signals,
    signals_csv,
    signals_function,
    signals_overlay,
)
from sigcat.web.visits import Visit, visit_of

router = APIRouter()


class Download(NamedTuple):
    """A file that is made of a basket."""

    media_type: str
    about: str
    text: Callable[[Catalogue, ChosenSignals], str]


DOWNLOADS: Mapping[str, Download] = {
    "overlay.vspec": Download("text/plain", "Overlay with all attributes, to edit", signals_overlay),
    "signals.csv": Download("text/csv", "Table for a spreadsheet", lambda _, chosen: signals_csv(chosen)),
    "function.yaml": Download(
        "application/yaml",
        "Function that consumes or provides them, to complete",
        lambda _, chosen: signals_function(chosen),
    ),
}


@router.get("/basket/{catalogue}")
async def show_basket(
    request: Request,
    hosted: AnyCatalogue,
    queue: TheWorkQueue,
    add: Annotated[str, Query(max_length=BASKET_CHARACTERS, description="Further paths, also in lines.")] = "",
) -> Response:
    """The chosen signals with their number, and what can be made of them."""
    visit = visit_of(request)
    if add:
        basket = visit.basket.with_all(read_basket(add).paths)
        to = Addresses(visit.below, read_basket(basket.text))
        return RedirectResponse(to.basket_page(hosted.source.id), HTTPStatus.SEE_OTHER)
    return await queue.run(_page, visit, hosted)


@router.get("/basket/{catalogue}/{file}")
async def download_basket(request: Request, hosted: AnyCatalogue, queue: TheWorkQueue, file: str) -> Response:
    """The chosen signals as a file."""
    if file not in DOWNLOADS:
        raise NotFound(f"A basket has no file {file[:100]!r}.", nearest(file[:100], DOWNLOADS))
    return await queue.run(_download, visit_of(request), hosted, file)


def _page(visit: Visit, hosted: Hosted) -> Response:
    chosen = chosen_signals(hosted.catalogue, visit.basket.paths)
    return page_for(visit, "basket.html", hosted=hosted, chosen=chosen, downloads=DOWNLOADS)


def _download(visit: Visit, hosted: Hosted, file: str) -> Response:
    made = DOWNLOADS[file]
    text = made.text(hosted.catalogue, chosen_signals(hosted.catalogue, visit.basket.paths))
    return text_file(text, file, made.media_type)
