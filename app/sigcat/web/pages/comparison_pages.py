"""Pages of comparisons of platforms: what `sigcat compare` has stored beside functions. Nothing is built, and nothing runs."""

from fastapi import APIRouter, Request
from fastapi.responses import Response

from sigcat.api.requests.dependencies import NamedCatalogue, TheFunctions, TheWorkQueue
from sigcat.catalogue.hosting.library import Hosted
from sigcat.comparison.report.html import fragment
from sigcat.comparison.report.model import read_report
from sigcat.errors import InputRefused, NotFound
from sigcat.function.hosted_comparisons import HostedComparison, HostedComparisons, comparison_named
from sigcat.function.hosted_files import HostedFiles
from sigcat.function.hosting import functions_over
from sigcat.limits import COMPARISON_BYTES
from sigcat.web.rendering import page_for
from sigcat.web.views.function_sets import known_sets
from sigcat.web.visits import Visit, visit_of

router = APIRouter()


@router.get("/functions/sets/{set_id}/compare")
async def show_comparison(
    request: Request, hosted: NamedCatalogue, functions: TheFunctions, queue: TheWorkQueue, set_id: str
) -> Response:
    """Show the results of platforms with a set of functions: behaviour, faults, timing, load and effort."""
    chosen = comparison_named(set_id, functions.comparisons)
    return await queue.run(_page, visit_of(request), hosted, functions.files, functions.comparisons, chosen)


@router.get("/functions/sets/{set_id}/compare.json")
async def download_comparison(functions: TheFunctions, queue: TheWorkQueue, set_id: str) -> Response:
    """The same as data, as `sigcat compare` wrote it."""
    return await queue.run(_file, comparison_named(set_id, functions.comparisons))


def _page(
    visit: Visit, hosted: Hosted, files: HostedFiles, comparisons: HostedComparisons, chosen: HostedComparison
) -> Response:
    try:
        report, problem = read_report(_bytes(chosen), chosen.name), ""
    except InputRefused as refused:
        report, problem = None, str(refused)
    return page_for(
        visit,
        "comparison.html",
        hosted=hosted,
        functions=functions_over(files, hosted.catalogue),
        sets=known_sets(files),
        comparisons=comparisons,
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
