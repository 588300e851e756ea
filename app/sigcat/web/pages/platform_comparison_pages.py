"""Pages of comparisons of platforms: what `sigcat compare` has stored beside functions. Nothing is built, and nothing runs."""

from fastapi import APIRouter
from fastapi.responses import Response

from sigcat.api.requests.dependencies import TheFunctions, TheWorkQueue
from sigcat.comparison.report.html import fragment
from sigcat.comparison.report.model import read_report
from sigcat.errors import InputRefused, NotFound
from sigcat.function.hosted_comparisons import HostedComparison, comparison_named
from sigcat.function.hosting import functions_over
from sigcat.limits import COMPARISON_BYTES
from sigcat.web.pages.checked_text import Asked, TheAsked
from sigcat.web.rendering import page_for
from sigcat.web.views.function_sets import known_sets

router = APIRouter()


@router.get("/functions/sets/{set_id}/compare")
async def show_comparison(asked: TheAsked, queue: TheWorkQueue, set_id: str) -> Response:
    """Show the results of platforms with a set of functions: behaviour, faults, timing, load and effort."""
    return await queue.run(_page, asked, comparison_named(set_id, asked.comparisons))


@router.get("/functions/sets/{set_id}/compare.json")
async def download_comparison(functions: TheFunctions, queue: TheWorkQueue, set_id: str) -> Response:
    """The same as data, as `sigcat compare` wrote it."""
    return await queue.run(_file, comparison_named(set_id, functions.comparisons))


def _page(asked: Asked, chosen: HostedComparison) -> Response:
    try:
        report, problem = read_report(_bytes(chosen), chosen.name), ""
    except InputRefused as refused:
        report, problem = None, str(refused)
    return page_for(
        asked.visit,
        "comparison.html",
        hosted=asked.hosted,
        functions=functions_over(asked.files, asked.hosted.catalogue),
        sets=known_sets(asked.files),
        comparisons=asked.comparisons,
        chosen=chosen,
        report=report,
        problem=problem,
        told=fragment(report) if report else "",
    )


def _file(chosen: HostedComparison) -> Response:
    return Response(_bytes(chosen), media_type="application/json")


def _bytes(chosen: HostedComparison) -> bytes:
    """No more of the file than a comparison may have, and a byte that tells that it has more. Raises NotFound."""
    try:
        with chosen.path.open("rb") as file:
            return file.read(COMPARISON_BYTES + 1)
    except OSError:
        raise NotFound(f"The comparison {chosen.id!r} is gone.") from None
