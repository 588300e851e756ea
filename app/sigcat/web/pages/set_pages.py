"""Pages of sets of functions: hosted ones by their ids in the address, any others as posted files."""

from collections.abc import Collection, Iterable, Sequence
from functools import partial
from typing import Annotated, Any

from fastapi import APIRouter, Query
from fastapi.responses import JSONResponse, Response

from sigcat.api.answers.serializers import finding_counts
from sigcat.api.requests.dependencies import TheWorkQueue
from sigcat.errors import UsageError
from sigcat.findings import Finding
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.function.hosted_files import HostedFiles
from sigcat.function.hosting import functions_over
from sigcat.limits import PAGE_FINDINGS, PAGE_FUNCTIONS
from sigcat.web.forms import PostedFile
from sigcat.web.pages.checked_text import Asked, Posted, TheAsked, ThePosted
from sigcat.web.pictures.timeline import time_line
from sigcat.web.pictures.wiring_diagram import wiring_diagram
from sigcat.web.rendering import page_for
from sigcat.web.views import signal_conversions
from sigcat.web.views.document_tabs import SET_TABS, chosen_tab, download, open_tab
from sigcat.web.views.function_sets import (
    FunctionSet,
    as_text,
    chosen_files,
    distinct,
    documents_in,
    function_set,
    hosted_set,
    known_sets,
)
from sigcat.web.views.generated_documents import GeneratedDocument, integrations_of
from sigcat.web.views.source_view import SourceView, is_shown_whole, shown_text, source_view

router = APIRouter()
_TITLES = {"files": "Files", **{name: tab.title for name, tab in SET_TABS.items()}}

Chosen = Annotated[list[str] | None, Query(alias="f", description="Ids of functions.")]


@router.get("/wiring")
async def show_wiring(
    asked: TheAsked,
    queue: TheWorkQueue,
    functions: Chosen = None,
    write: Annotated[bool, Query(description="Whether to begin with the user's own functions.")] = False,
    view: str = "files",
) -> Response:
    """A set of functions: providers and consumers, signals from outside, and when each call runs."""
    return await queue.run(_shown, asked, _chosen(functions, asked.files), view, is_writing=write)


@router.post("/wiring")
async def connect_posted(queue: TheWorkQueue, posted: ThePosted) -> Response:
    """The same page for posted functions, together with the hosted ones that are named. They are not stored."""
    return await queue.run(_posted, posted)


@router.get("/wiring/files/{document_id}")
async def download_of_set(asked: TheAsked, queue: TheWorkQueue, document_id: str, functions: Chosen = None) -> Response:
    """A document that is made from a set of functions, as a file."""
    return await queue.run(_hosted_document, asked, _chosen(functions, asked.files), document_id)


@router.get("/wiring.json")
async def get_wiring(asked: TheAsked, queue: TheWorkQueue, functions: Chosen = None) -> Response:
    """The wiring of a set of functions as data."""
    return JSONResponse(await queue.run(_wiring_data, asked, _chosen(functions, asked.files)))


def _shown(asked: Asked, chosen: Sequence[str], view: str, *, is_writing: bool) -> Response:
    together = hosted_set(asked.files, chosen, asked.catalogue)
    return _page(asked, chosen, together, view=view, is_writing=is_writing)


def _posted(posted: Posted) -> Response:
    asked, form = posted.read()
    chosen = tuple(dict.fromkeys(form.every("f")))
    own = distinct((*form.files, *documents_in(form.text("text"))))
    files = (*chosen_files(asked.files, chosen), *own)
    _check_size(files)
    together = function_set(files, asked.catalogue, asked.limits)
    if form.last("download"):
        return _download(together.whole, form.last("download"))
    return _page(asked, chosen, together, own, view=form.last("view", "files"))


def _hosted_document(asked: Asked, chosen: tuple[str, ...], document_id: str) -> Response:
    return _download(hosted_set(asked.files, chosen, asked.catalogue).whole, document_id)


def _page(
    asked: Asked,
    chosen: Sequence[str],
    together: FunctionSet,
    own: Sequence[PostedFile] = (),
    *,
    view: str,
    is_writing: bool = False,
) -> Response:
    functions = functions_over(asked.files, asked.catalogue)
    sets = known_sets(asked.files)
    own_text = as_text(own)
    tab, make = chosen_tab(view, _TITLES, SET_TABS), partial(_documents, together.whole)
    return page_for(
        asked.visit,
        "wiring.html",
        hosted=asked.hosted,
        functions=functions,
        sets=sets,
        comparisons=asked.comparisons,
        set_title="" if own else next((title for title, ids in sets.items() if set(ids) == set(chosen)), ""),
        chosen=chosen,
        own=own,
        is_writing=is_writing or (bool(own) and not together.functions),
        own_text=own_text,
        is_own_text_shown=is_shown_whole(own_text),
        **_findings(together.findings, own),
        wiring=together.wiring,
        conversions=signal_conversions,
        diagram=wiring_diagram(together.wiring),
        timeline=time_line(together.functions),
        tabs=_TITLES,
        tab=tab,
        view=view,
        opened=open_tab(view, SET_TABS[tab], make) if tab in SET_TABS and together.whole else None,
        made_from=[function.name for function in together.whole],
        ids={each.name: each.id for each in functions if each.id in chosen},
    )


def _findings(findings: Sequence[Finding], own: Sequence[PostedFile]) -> dict[str, Any]:
    """Return the findings, and the lines of posted files where they are."""
    return {
        "findings": findings[:PAGE_FINDINGS],
        "finding_total": len(findings),
        "counts": finding_counts(findings),
        "sources": _sources(own, findings),
        "anchors": {file.name: _anchor(index) for index, file in enumerate(own)},
    }


def _sources(files: Sequence[PostedFile], findings: Sequence[Finding]) -> list[tuple[str, str, SourceView]]:
    """Name, anchor of the lines, and lines of each posted file."""
    return [
        (file.name, _anchor(index), source_view(shown_text(file.data), _of(file, findings)))
        for index, file in enumerate(files)
    ]


def _anchor(index: int) -> str:
    return f"file-{index + 1}"


def _of(file: PostedFile, findings: Iterable[Finding]) -> list[Finding]:
    return [finding for finding in findings if finding.file == file.name]


def _chosen(functions: Sequence[str] | None, files: HostedFiles) -> tuple[str, ...]:
    """The functions that are asked for; without any, the first set that pages offer."""
    first = next(iter(known_sets(files).values()), tuple(file.id for file in files[:PAGE_FUNCTIONS]))
    chosen = tuple(dict.fromkeys(functions or first))
    _check_size(chosen)
    return chosen


def _check_size(functions: Sequence[object]) -> None:
    if len(functions) > PAGE_FUNCTIONS:
        raise UsageError(f"A set must have at most {PAGE_FUNCTIONS} functions.")


def _documents(functions: Sequence[ResolvedFunction], views: Collection[str]) -> Sequence[GeneratedDocument]:
    return integrations_of(functions, "FunctionSet", views) if functions else ()


def _download(functions: Sequence[ResolvedFunction], document_id: str) -> Response:
    return download(document_id, "FunctionSet", partial(_documents, functions), SET_TABS)


def _wiring_data(asked: Asked, chosen: tuple[str, ...]) -> dict[str, object]:
    wiring = hosted_set(asked.files, chosen, asked.catalogue).wiring
    return {
        "functions": list(wiring.functions),
        "links": [
            {
                "path": link.path,
                "from": link.provider.function,
                "to": link.consumer.function,
                "mismatches": [mismatch.message for mismatch in link.mismatches],
            }
            for link in wiring.links
        ],
        "fromOutside": [{"path": end.identity, "to": end.function} for end in wiring.from_outside],
        "toOutside": [{"path": end.identity, "from": end.function} for end in wiring.to_outside],
        "rivals": [{"path": each.path, "providers": list(each.functions)} for each in wiring.rivals],
    }
