"""Routes that have the files of a catalogue, or those of the functions, read again."""

from fastapi import APIRouter

from sigcat.api.answers import schemas
from sigcat.api.answers.problems import problem_documentation
from sigcat.api.answers.serializers import catalogue_detail, listed_findings
from sigcat.api.middleware.access import needs
from sigcat.api.requests.dependencies import AnyCatalogue, TheFunctions, TheLibrary, TheWorkQueue

router = APIRouter(prefix="/api/v1/catalogues/{catalogue}", tags=["operation"])
of_functions = APIRouter(prefix="/api/v1/functions", tags=["operation"])


@router.post(
    "/reload",
    responses=problem_documentation(401, 403, 404, 422, 503),
    dependencies=list(needs("reload")),
)
async def reload_catalogue(hosted: AnyCatalogue, library: TheLibrary, queue: TheWorkQueue) -> schemas.Catalogue:
    """Read the files again. With errors in them the last good state stays, and `rejected` says why.

    Of several workers or replicas, the one that answers reloads; the others follow with `watch`, or when asked too.
    """
    fresh = await queue.run_here(library.reload, hosted.source.id)
    return catalogue_detail(fresh)


@of_functions.post(
    "/reload",
    responses=problem_documentation(401, 403, 503),
    dependencies=list(needs("reload")),
)
async def reload_functions(functions: TheFunctions, queue: TheWorkQueue) -> schemas.FunctionFileList:
    """Read the function files of the configured folders again, and see which runs are there.

    Of one that broke the last good state stays, and `rejected` says why. What is wrong with others, their pages say.
    """
    files = await queue.run_here(functions.reload)
    return schemas.FunctionFileList(
        functions=[
            schemas.FunctionFile(id=each.id, file=each.name, rejected=listed_findings(each.rejected)) for each in files
        ],
        runs=[schemas.FunctionRun(id=each.id, file=each.name) for each in functions.runs],
    )
