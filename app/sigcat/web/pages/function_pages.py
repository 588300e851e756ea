"""Pages of the functions that the service hosts."""

from collections.abc import Collection, Mapping
from functools import partial
from typing import Annotated, NamedTuple

from fastapi import APIRouter, Depends, Query, Request
from fastapi.responses import FileResponse, JSONResponse, Response

from sigcat.api.requests.dependencies import NamedCatalogue, TheFunctions, TheLibrary, TheWorkQueue
from sigcat.api.requests.thread_turns import InThread, in_thread
from sigcat.catalogue.hosting.library import Hosted, Library
from sigcat.catalogue.hosting.variants import expanded_of
from sigcat.errors import InputRefused, NotFound
from sigcat.function.function_json.model import to_json
from sigcat.function.hosted_runs import HostedRun, HostedRuns, run_named
from sigcat.function.hosting import FunctionLibrary, HostedFunction, function_over, functions_over
from sigcat.limits import NAME_CHARACTERS
from sigcat.web.pictures.interface_diagram import interface_diagram
from sigcat.web.pictures.timeline import time_line
from sigcat.web.rendering import page
from sigcat.web.views.code_view import code_view
from sigcat.web.views.document_tabs import SET_TABS, Tab, chosen_tab, download, open_tab
from sigcat.web.views.function_sets import known_sets
from sigcat.web.views.generated_documents import FUNCTION_JSON, VIEWS, GeneratedDocument, attached, documents_of
from sigcat.web.views.needed_overlays import Need, need_of
from sigcat.web.views.run_view import Asked, RunView, run_view
from sigcat.web.views.source_view import shown_text, source_view

router = APIRouter(route_class=InThread)
_TIME_CHARACTERS = 40
_SOURCE = "source"
"""View of the file as it is."""


@router.get("/functions")
def show_functions(request: Request, hosted: NamedCatalogue, functions: TheFunctions, library: TheLibrary) -> Response:
    """The functions, the operator's own first, and the needs of those that do not build."""
    return page(
        request,
        "functions.html",
        hosted=hosted,
        functions=_over(functions, hosted),
        sets=known_sets(functions.files),
        comparisons=functions.comparisons,
        needs=_needs(functions, hosted, library),
    )


@router.get("/functions.json")
def list_functions(hosted: NamedCatalogue, functions: TheFunctions, library: TheLibrary) -> Response:
    """The same as data."""
    needs = _needs(functions, hosted, library)
    listed = [
        {
            "id": each.id,
            "name": each.name,
            "file": each.file.name,
            "shipped": each.file.is_shipped,
            "ok": each.function is not None,
            "findings": len(each.findings),
            "rejected": len(each.file.rejected),
            "needs": list(needs[each.id].overlays) if each.id in needs else [],
            "runs": [run.id for run in functions.runs_of(each)],
        }
        for each in _over(functions, hosted)
    ]
    return JSONResponse({"functions": listed})


class ShownRun(NamedTuple):
    """A run that a page shows."""

    asked: Asked
    view: RunView


class Part(NamedTuple):
    """The part of a run that a request asks for."""

    signals: tuple[str, ...]
    beside: str
    start: str
    end: str

    def of(self, run: HostedRun, functions: FunctionLibrary, *, with_lines: bool = False) -> Asked:
        """The same of a run."""
        others = tuple(each for each in functions.recordings if each.group == run.group and each.path != run.path)
        return Asked(run, others, *self, with_lines)


def _part(
    signal: Annotated[list[str] | None, Query(description="Signals to draw; without any, the first ones.")] = None,
    beside: Annotated[str, Query(max_length=NAME_CHARACTERS, description="Id of a recording to draw over it.")] = "",
    start: Annotated[str, Query(alias="from", max_length=_TIME_CHARACTERS, description="First time, in s.")] = "",
    end: Annotated[str, Query(alias="to", max_length=_TIME_CHARACTERS, description="Last time, in s.")] = "",
) -> Part:
    return Part(tuple(signal or ()), beside, start, end)


ThePart = Annotated[Part, Depends(_part)]


async def _shown_run(
    request: Request,
    hosted: NamedCatalogue,
    functions: TheFunctions,
    queue: TheWorkQueue,
    part: ThePart,
    function_id: str,
    view: str = "",
    run: Annotated[str, Query(max_length=NAME_CHARACTERS, description="Id of a run; without it, the first.")] = "",
) -> ShownRun | None:
    """The run that is asked for, read in a worker; None where another view is."""
    if view != "run":
        return None
    chosen = await in_thread(request, _function, functions, hosted, function_id.removesuffix(".json"))
    runs = functions.runs_of(chosen)
    if not runs or chosen.resolved is None:
        return None
    asked = part.of(run_named(run, runs), functions)
    return ShownRun(asked, await queue.run(run_view, chosen.resolved, asked))


TheRun = Annotated[ShownRun | None, Depends(_shown_run)]


@router.get("/functions/{function_id}")
def show_function(
    request: Request,
    hosted: NamedCatalogue,
    functions: TheFunctions,
    library: TheLibrary,
    function_id: str,
    run: TheRun,
    view: str = "interfaces",
) -> Response:
    """A function: its interfaces, source with findings, runs, documents. With `.json` after its id, Function JSON."""
    chosen = _function(functions, hosted, function_id.removesuffix(".json"))
    if function_id.endswith(".json"):
        return _as_json(chosen)
    function = chosen.function
    runs = functions.runs_of(chosen) if run or view != "run" else ()
    tabs = _tabs(chosen)
    titles = _titles(tabs, runs) if function else {_SOURCE: tabs[_SOURCE].title}
    wanted = view if function or view != "interfaces" else _SOURCE
    shown = chosen_tab(wanted, titles, tabs)
    return page(
        request,
        "function.html",
        hosted=hosted,
        chosen=chosen,
        functions=_over(functions, hosted),
        sets=known_sets(functions.files),
        need=need_of(chosen, functions.files, expanded_of(hosted.catalogue), library),
        tabs=titles,
        tab=shown,
        diagram=interface_diagram(function) if function else None,
        timeline=time_line([function]) if function else None,
        code=code_view(function) if function else None,
        source=source_view(shown_text(chosen.file.data), chosen.findings),
        opened=open_tab(wanted, tabs[shown], partial(_made, chosen)) if shown in tabs else None,
        runs=runs,
        run=run,
    )


def _tabs(chosen: HostedFunction) -> dict[str, Tab]:
    """Tabs with documents: those of a set, then the file and its Function JSON."""
    source = {_SOURCE: "As written" if chosen.file.is_json else "Declaration"}
    if not chosen.function:
        return {_SOURCE: Tab("Documents", source)}
    return {**SET_TABS, _SOURCE: Tab("Documents", {**source, FUNCTION_JSON: VIEWS[FUNCTION_JSON]})}


def _titles(tabs: Mapping[str, Tab], runs: HostedRuns) -> dict[str, str]:
    """Titles of all tabs of a function that is built."""
    recorded = {"run": "Run" if len(runs) == 1 else "Runs"} if runs else {}
    documented = {name: tab.title for name, tab in tabs.items()}
    return {"interfaces": "Interfaces", "schedule": "Schedule", **recorded, **documented}


def _made(chosen: HostedFunction, views: Collection[str]) -> tuple[GeneratedDocument, ...]:
    """The documents of some views."""
    source = (_source_of(chosen),) if _SOURCE in views else ()
    return (*source, *(documents_of(chosen.resolved, views) if chosen.resolved else ()))


@router.get("/functions/{function_id}/runs.json")
def list_runs(hosted: NamedCatalogue, functions: TheFunctions, function_id: str) -> Response:
    """The stored runs of a function as data."""
    chosen = _function(functions, hosted, function_id)
    listed = [{"id": run.id, "file": run.name, "columns": run.columns} for run in functions.runs_of(chosen)]
    return JSONResponse({"runs": listed})


@router.get("/functions/{function_id}/runs/{run_id}/values.json")
async def list_values(
    request: Request,
    hosted: NamedCatalogue,
    functions: TheFunctions,
    queue: TheWorkQueue,
    part: ThePart,
    function_id: str,
    run_id: str,
) -> Response:
    """The values that the picture of a run draws, as data: at most some thousand changes of each signal."""
    chosen = await in_thread(request, _function, functions, hosted, function_id)
    run = run_named(run_id, functions.runs_of(chosen))
    assert chosen.resolved is not None  # which has runs
    view = await queue.run(run_view, chosen.resolved, part.of(run, functions, with_lines=True))
    return JSONResponse({"signals": [each._asdict() for each in view.lines], "notes": view.notes})


@router.get("/functions/{function_id}/runs/{run_id}")
def download_run(hosted: NamedCatalogue, functions: TheFunctions, function_id: str, run_id: str) -> Response:
    """A stored run as it is."""
    chosen = _function(functions, hosted, function_id)
    run = run_named(run_id, functions.runs_of(chosen))
    try:
        status = run.path.stat()
    except OSError:
        raise NotFound(f"The run {run_id[:100]!r} is no longer there.") from None
    return FileResponse(run.path, media_type="text/csv", filename=f"{run.id}.csv", stat_result=status)


@router.get("/functions/{function_id}/files/{document_id}")
def download_document(hosted: NamedCatalogue, functions: TheFunctions, function_id: str, document_id: str) -> Response:
    """A document of a function, its file as it is, or all of a tab as an archive."""
    chosen = _function(functions, hosted, function_id)
    if document_id == _SOURCE:
        return attached(_source_of(chosen))
    return download(document_id, chosen.name, partial(_made, chosen), _tabs(chosen))


def _over(functions: FunctionLibrary, hosted: Hosted) -> tuple[HostedFunction, ...]:
    return functions_over(functions.files, expanded_of(hosted.catalogue))


def _function(functions: FunctionLibrary, hosted: Hosted, function_id: str) -> HostedFunction:
    return function_over(functions.files, expanded_of(hosted.catalogue), function_id)


def _needs(functions: FunctionLibrary, hosted: Hosted, library: Library) -> dict[str, Need]:
    """Return the needs of each function that does not build, by its id."""
    catalogue = expanded_of(hosted.catalogue)
    found = ((each.id, need_of(each, functions.files, catalogue, library)) for each in _over(functions, hosted))
    return {function_id: need for function_id, need in found if need}


def _source_of(chosen: HostedFunction) -> GeneratedDocument:
    ending, media_type = (".json", "application/json") if chosen.file.is_json else (".yaml", "application/yaml")
    return GeneratedDocument(_SOURCE, _SOURCE, f"{chosen.id}{ending}", media_type, shown_text(chosen.file.data))


def _as_json(chosen: HostedFunction) -> Response:
    if chosen.function is None:
        raise InputRefused(f"{chosen.name} does not fit the catalogue.", chosen.findings)
    return Response(to_json(chosen.function), media_type="application/json")
