"""Pages of functions: the shipped ones, and how a set of them is wired."""

from typing import Annotated
from urllib.parse import quote

from fastapi import APIRouter, Query, Request
from fastapi.responses import JSONResponse, Response

from app.api.requests import TheLibrary
from app.catalogue.hosting import Hosted, Library
from app.errors import NotFound, UsageError
from app.function.model import FunctionJson, to_json
from app.function.wiring import connect
from app.names import nearest
from app.web.documents import MadeDocument, documents_of, integrations_of
from app.web.interface_diagram import interface_diagram
from app.web.rendering import page
from app.web.shelf import FILE, from_shelf, shelf
from app.web.source_view import source_view
from app.web.timeline import time_line
from app.web.variants import find_hosted
from app.web.wiring_diagram import wiring_diagram

router = APIRouter()
ECO_CONTROL = ("eco_control_mpc", "core_acc")
"""The set that is shown when none is chosen."""
_MOST_FUNCTIONS = 20

Named = Annotated[str | None, Query(description="Id of a catalogue; without it, the default one.")]


@router.get("/functions")
def show_functions(request: Request, library: TheLibrary, catalogue: Named = None) -> Response:
    """The functions that sigcat ships."""
    hosted = named(library, catalogue)
    return page(request, "functions.html", hosted=hosted, functions=shelf(hosted.catalogue), eco_control=ECO_CONTROL)


@router.get("/functions/{function_id}")
def show_function(
    request: Request, library: TheLibrary, function_id: str, view: str = "interfaces", catalogue: Named = None
) -> Response:
    """A function: its interfaces, its source with findings, its documents. With `.json` after its id, Function JSON."""
    hosted = named(library, catalogue)
    shelved = from_shelf(hosted.catalogue, function_id.removesuffix(".json"))
    if function_id.endswith(".json") and shelved.function is not None:
        return Response(to_json(shelved.function), media_type="application/json")
    function = shelved.function
    documents = documents_of(function) if function else ()
    views = ("interfaces", "source", *dict.fromkeys(document.view for document in documents))
    if view not in views:
        raise NotFound(f"There is no view {view!r} of {shelved.name}.", nearest(view[:100], views))
    return page(
        request,
        "function.html",
        hosted=hosted,
        shelved=shelved,
        view=view if function or view != "interfaces" else "source",
        diagram=interface_diagram(function) if function else None,
        timeline=time_line([function]) if function else None,
        source=source_view(shelved.text, shelved.findings),
        file=FILE,
        documents=documents,
    )


@router.get("/functions/{function_id}/files/{document_id}")
def download_document(library: TheLibrary, function_id: str, document_id: str, catalogue: Named = None) -> Response:
    """A document of a function, or its declaration, as a file."""
    shelved = from_shelf(named(library, catalogue).catalogue, function_id)
    if document_id == "source":
        return _download(
            MadeDocument("source", "source", "Declaration", f"{function_id}.yaml", "application/yaml", shelved.text)
        )
    known = {document.id: document for document in documents_of(shelved.function)} if shelved.function else {}
    if document_id not in known:
        raise NotFound(f"There is no document {document_id!r} of {shelved.name}.", nearest(document_id[:100], known))
    return _download(known[document_id])


@router.get("/wiring")
def show_wiring(
    request: Request,
    library: TheLibrary,
    functions: Annotated[list[str] | None, Query(alias="f", description="Ids of functions.")] = None,
    catalogue: Named = None,
) -> Response:
    """A set of functions: who provides what to whom, what comes from outside, and when each call runs."""
    hosted = named(library, catalogue)
    chosen = tuple(dict.fromkeys(functions or ECO_CONTROL))
    if len(chosen) > _MOST_FUNCTIONS:
        raise UsageError(f"A set has {_MOST_FUNCTIONS} functions at most.")
    shelved = [from_shelf(hosted.catalogue, each) for each in chosen]
    built: list[FunctionJson] = [each.function for each in shelved if each.function is not None]
    wiring = connect(built)
    return page(
        request,
        "wiring.html",
        hosted=hosted,
        functions=shelf(hosted.catalogue),
        chosen=chosen,
        unbuilt=[each for each in shelved if each.function is None],
        wiring=wiring,
        diagram=wiring_diagram(wiring),
        timeline=time_line(built),
        documents=[document for document in integrations_of(built, "FunctionSet") if document.text] if built else (),
        ids={each.name: each.id for each in shelved},
        is_eco_control=set(chosen) == set(ECO_CONTROL),
    )


@router.get("/wiring/files/{document_id}")
def download_of_set(
    library: TheLibrary,
    document_id: str,
    functions: Annotated[list[str] | None, Query(alias="f")] = None,
    catalogue: Named = None,
) -> Response:
    """A document that is made from a set of functions, as a file."""
    tree = named(library, catalogue).catalogue
    shelved = [from_shelf(tree, each) for each in dict.fromkeys((functions or ECO_CONTROL)[:_MOST_FUNCTIONS])]
    built = [each.function for each in shelved if each.function is not None]
    known = {document.id: document for document in integrations_of(built, "FunctionSet") if document.text}
    if document_id not in known:
        raise NotFound(f"There is no document {document_id!r} of these functions.", nearest(document_id[:100], known))
    return _download(known[document_id])


@router.get("/wiring.json")
def get_wiring(
    library: TheLibrary, functions: Annotated[list[str] | None, Query(alias="f")] = None, catalogue: Named = None
) -> Response:
    """The wiring of a set of functions as data."""
    tree = named(library, catalogue).catalogue
    shelved = [from_shelf(tree, each) for each in dict.fromkeys((functions or ECO_CONTROL)[:_MOST_FUNCTIONS])]
    wiring = connect([each.function for each in shelved if each.function is not None])
    links = [
        {"path": link.path, "from": link.provider.function, "to": link.consumer.function, "flaws": list(link.flaws)}
        for link in wiring.links
    ]
    outside = {
        "fromOutside": [{"path": end.path, "to": end.function} for end in wiring.from_outside],
        "toOutside": [{"path": end.path, "from": end.function} for end in wiring.to_outside],
    }
    rivals = [{"path": path, "providers": list(names)} for path, names in wiring.rivals]
    return JSONResponse({"functions": list(wiring.functions), "links": links, **outside, "rivals": rivals})


def named(library: Library, catalogue: str | None) -> Hosted:
    """The catalogue with an id, or the default one."""
    return library.default if catalogue is None else find_hosted(library, catalogue)


def _download(document: MadeDocument) -> Response:
    disposition = f"attachment; filename*=UTF-8''{quote(document.file, safe='')}"
    content = document.text.encode("utf-8", "replace")
    return Response(content, media_type=document.media_type, headers={"Content-Disposition": disposition})
