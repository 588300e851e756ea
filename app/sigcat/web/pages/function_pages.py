"""Pages of the functions that sigcat ships."""

from fastapi import APIRouter, Request
from fastapi.responses import JSONResponse, Response

from sigcat.api.requests.dependencies import NamedCatalogue
from sigcat.errors import InputRefused, NotFound
from sigcat.function.function_json.model import to_json
from sigcat.names import nearest
from sigcat.web.pictures.interface_diagram import interface_diagram
from sigcat.web.pictures.timeline import time_line
from sigcat.web.rendering import page
from sigcat.web.views.documents import VIEWS, MadeDocument, attached, chosen_view, documents_of
from sigcat.web.views.shelf import FILE, Shelved, from_shelf, shelf
from sigcat.web.views.source_view import source_view

router = APIRouter()


@router.get("/functions")
def show_functions(request: Request, hosted: NamedCatalogue) -> Response:
    """The functions that sigcat ships."""
    return page(request, "functions.html", hosted=hosted, functions=shelf(hosted.catalogue))


@router.get("/functions.json")
def list_functions(hosted: NamedCatalogue) -> Response:
    """The same as data."""
    listed = [
        {"id": each.id, "name": each.name, "ok": each.function is not None, "findings": len(each.findings)}
        for each in shelf(hosted.catalogue)
    ]
    return JSONResponse({"functions": listed})


@router.get("/functions/{function_id}")
def show_function(request: Request, hosted: NamedCatalogue, function_id: str, view: str = "interfaces") -> Response:
    """A function: its interfaces, its source with findings, its documents. With `.json` after its id, Function JSON."""
    shelved = from_shelf(hosted.catalogue, function_id.removesuffix(".json"))
    if function_id.endswith(".json"):
        return _as_json(shelved)
    function = shelved.function
    views = {"interfaces": "Interfaces", "source": "Declaration", **VIEWS} if function else {"source": "Declaration"}
    shown = chosen_view(view, views) if function or view != "interfaces" else "source"
    return page(
        request,
        "function.html",
        hosted=hosted,
        shelved=shelved,
        views=views,
        view=shown,
        diagram=interface_diagram(function) if function else None,
        timeline=time_line([function]) if function else None,
        source=source_view(shelved.text, shelved.findings),
        file=FILE,
        documents=documents_of(function, shown) if function and shown in VIEWS else (),
    )


@router.get("/functions/{function_id}/files/{document_id}")
def download_document(hosted: NamedCatalogue, function_id: str, document_id: str) -> Response:
    """A document of a function, or its declaration, as a file."""
    shelved = from_shelf(hosted.catalogue, function_id)
    if document_id == "source":
        return attached(MadeDocument("source", "source", f"{function_id}.yaml", "application/yaml", shelved.text))
    known = {document.id: document for document in documents_of(shelved.function)} if shelved.function else {}
    if document_id not in known:
        raise NotFound(f"There is no document {document_id!r} of {shelved.name}.", nearest(document_id[:100], known))
    return attached(known[document_id])


def _as_json(shelved: Shelved) -> Response:
    if shelved.function is None:
        raise InputRefused(f"{shelved.name} does not fit the catalogue.", shelved.findings)
    return Response(to_json(shelved.function), media_type="application/json")
