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
from sigcat.web.views.generated_documents import VIEWS, GeneratedDocument, attached, chosen_view, documents_of
from sigcat.web.views.shipped_functions import FILE, ShippedFunction, shipped_function, shipped_functions
from sigcat.web.views.source_view import source_view

router = APIRouter()


@router.get("/functions")
def show_functions(request: Request, hosted: NamedCatalogue) -> Response:
    """The functions that sigcat ships."""
    return page(request, "functions.html", hosted=hosted, functions=shipped_functions(hosted.catalogue))


@router.get("/functions.json")
def list_functions(hosted: NamedCatalogue) -> Response:
    """The same as data."""
    listed = [
        {"id": each.id, "name": each.name, "ok": each.function is not None, "findings": len(each.findings)}
        for each in shipped_functions(hosted.catalogue)
    ]
    return JSONResponse({"functions": listed})


@router.get("/functions/{function_id}")
def show_function(request: Request, hosted: NamedCatalogue, function_id: str, view: str = "interfaces") -> Response:
    """A function: its interfaces, its source with findings, its documents. With `.json` after its id, Function JSON."""
    shipped = shipped_function(hosted.catalogue, function_id.removesuffix(".json"))
    if function_id.endswith(".json"):
        return _as_json(shipped)
    function = shipped.function
    views = {"interfaces": "Interfaces", "source": "Declaration", **VIEWS} if function else {"source": "Declaration"}
    shown = chosen_view(view, views) if function or view != "interfaces" else "source"
    return page(
        request,
        "function.html",
        hosted=hosted,
        shipped=shipped,
        functions=shipped_functions(hosted.catalogue),
        views=views,
        view=shown,
        diagram=interface_diagram(function) if function else None,
        timeline=time_line([function]) if function else None,
        source=source_view(shipped.text, shipped.findings),
        file=FILE,
        documents=documents_of(shipped.resolved, shown) if shipped.resolved and shown in VIEWS else (),
    )


@router.get("/functions/{function_id}/files/{document_id}")
def download_document(hosted: NamedCatalogue, function_id: str, document_id: str) -> Response:
    """A document of a function, or its declaration, as a file."""
    shipped = shipped_function(hosted.catalogue, function_id)
    if document_id == "source":
        return attached(GeneratedDocument("source", "source", f"{function_id}.yaml", "application/yaml", shipped.text))
    known = {document.id: document for document in documents_of(shipped.resolved)} if shipped.resolved else {}
    if document_id not in known:
        raise NotFound(f"There is no document {document_id!r} of {shipped.name}.", nearest(document_id[:100], known))
    return attached(known[document_id])


def _as_json(shipped: ShippedFunction) -> Response:
    if shipped.function is None:
        raise InputRefused(f"{shipped.name} does not fit the catalogue.", shipped.findings)
    return Response(to_json(shipped.function), media_type="application/json")
