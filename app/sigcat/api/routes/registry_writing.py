"""Routes that change the registry, and those that ask what a change would do."""

from collections.abc import Callable, Sequence
from http import HTTPStatus
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, TypeVar

from fastapi import APIRouter, Query, Request
from fastapi.concurrency import run_in_threadpool
from fastapi.responses import Response

from sigcat.api.answers import registry_schemas, schemas
from sigcat.api.answers.negotiation import JSON, json_bytes
from sigcat.api.answers.problems import problem_documentation
from sigcat.api.answers.serializers import lint_report
from sigcat.api.middleware.registry_access import Administrator, Approver, Publisher, Reader, Writer
from sigcat.api.requests.dependencies import FileName, ThePostedWork, TheWorkQueue, takes_text
from sigcat.api.requests.hosted_registry import HostedRegistry, TheRegistry
from sigcat.api.requests.thread_turns import to_the_end
from sigcat.api.routes.functions import DECLARATION
from sigcat.api.work.turns import Turns
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.errors import UsageError
from sigcat.limits import NAME_CHARACTERS, PARAMETER_VALUES, Limits
from sigcat.project.project import ServerUrl
from sigcat.registry.reference import KIND_OF, reference_of

if TYPE_CHECKING:
    from sigcat.registry.candidates.candidate import Candidate
    from sigcat.registry.storing.database import Snapshot
    from sigcat.registry.storing.entry import Action
    from sigcat.registry.storing.ledger import Registry

router = APIRouter(prefix="/api/v1/registry", tags=["registry"])

_Result = TypeVar("_Result")
_FILES = (
    "A function or an overlay: the text of its file. Or several, as a JSON object with `files`, a list of objects with "
    "`name` and `text`. `sigcat publish` sends a tree with all files of its catalogue as one file `….catalogue.json`."
)
Text = Annotated[str, Query(max_length=NAME_CHARACTERS)]
FunctionVersion = Annotated[
    str, Query(max_length=NAME_CHARACTERS, description="Published version of a function.", examples=["CoreAcc@1.0.0"])
]
AnyVersion = Annotated[
    str, Query(max_length=NAME_CHARACTERS, description="Published version.", examples=["CoreAcc@1.0.0"])
]
LineName = Annotated[str, Query(max_length=NAME_CHARACTERS, description="Vehicle line.", examples=["SUV-2025"])]
GroupName = Annotated[registry_schemas.RegistryGroup, Query(description="Kind of the name.")]
CHANGED = problem_documentation(401, 403, 404, 422, 503, 507)
"""Problems of a change."""
_PUBLISHED: dict[int | str, dict[str, Any]] = {
    200: {"description": "Everything was published before."},
    201: {"model": registry_schemas.RegistryReceipt, "description": "Versions were published."},
    202: {
        "model": registry_schemas.RegistryReceipt,
        "description": "A version is pending until the owners of broken functions approve it.",
    },
}


@router.post(
    "/publish",
    response_model=registry_schemas.RegistryReceipt,
    **takes_text(_FILES, DECLARATION, 401, 403, 404, 409, 507, answers=_PUBLISHED),
)
async def publish_versions(
    writer: Publisher,
    work: ThePostedWork,
    name: FileName = "posted.yaml",
    version: Annotated[Text, Query(description="Version of SemVer 2.0; without it, that of the function file.")] = "",
    owner: Annotated[Text, Query(description="Owner of an overlay; without it, that of the token.")] = "",
    draft: Annotated[bool, Query(description="Publish drafts, which may change.")] = False,
) -> Response:
    """Publish files as versions: all of them, or none. The same bytes again change nothing; other bytes are refused."""
    candidates = await work.run(_candidates, name, version, owner or writer.author.owner)
    receipt = await in_turn(writer.request, lambda: _publish(writer, candidates, is_draft=draft))
    return Response(json_bytes(receipt), _status(receipt), media_type=JSON)


@router.post(
    "/check",
    response_model=schemas.LintReport,
    dependencies=[Reader],
    **takes_text(_FILES, DECLARATION, 401, 403, 404),
)
async def check_versions(registry: TheRegistry, work: ThePostedWork, name: FileName = "posted.yaml") -> Response:
    """Published functions that files would break, in the vehicle lines in which they run. Nothing is published."""
    return Response(await work.run(_report, name, registry.present()), media_type=JSON)


@router.post(
    "/can-i-deploy",
    response_model=registry_schemas.DeploymentAnswer,
    responses=problem_documentation(401, 404, 422, 503),
    dependencies=[Reader],
)
async def can_deploy(
    registry: TheRegistry,
    queue: TheWorkQueue,
    function: FunctionVersion,
    line: LineName,
    others: Annotated[
        list[Text] | None,
        Query(max_length=PARAMETER_VALUES, description="Versions that ship together with it, such as `Advisor@1.0.0`."),
    ] = None,
) -> Response:
    """Whether a version fits every version of other functions that vehicles of the line run. Nothing is recorded."""
    answer = await queue.run(_deployment, registry.present(), (function, *(others or ())), line)
    return Response(answer, media_type=JSON)


@router.post("/record-deployment", response_model=registry_schemas.RegistryChange, responses=CHANGED)
async def record_deployment(writer: Approver, function: FunctionVersion, line: LineName) -> Response:
    """Record that all vehicles of a line run a version, in place of other versions of it."""
    return await _recorded(writer, "deployment", function, line)


@router.post("/record-release", response_model=registry_schemas.RegistryChange, responses=CHANGED)
async def record_release(writer: Approver, function: FunctionVersion, line: LineName) -> Response:
    """Record that vehicles of a line run a version, next to the versions that others keep."""
    return await _recorded(writer, "release", function, line)


@router.post("/support-ended", response_model=registry_schemas.RegistryChange, responses=CHANGED)
async def end_support(writer: Approver, function: FunctionVersion, line: LineName) -> Response:
    """Record that no vehicle of a line runs a version any more."""
    return await _recorded(writer, "support ended", function, line)


@router.post("/deprecate", response_model=registry_schemas.RegistryChange, responses=CHANGED)
async def deprecate_version(
    writer: Publisher,
    reference: AnyVersion,
    group: GroupName = "functions",
    removal: Annotated[Text, Query(description="Day on which its support may end, such as 2027-01-31.")] = "",
    alternative: Annotated[Text, Query(description="Version that replaces it.")] = "",
) -> Response:
    """Mark a version as deprecated."""
    from sigcat.registry.lines import set_state

    kind, named = KIND_OF[group], reference_of(reference)
    return await changed(writer, lambda written: set_state(written, kind, named, "deprecated", removal, alternative))


@router.post("/retire", response_model=registry_schemas.RegistryChange, responses=CHANGED)
async def retire_version(writer: Publisher, reference: AnyVersion, group: GroupName = "functions") -> Response:
    """Mark a version as retired, which no vehicle runs."""
    from sigcat.registry.lines import set_state

    kind, named = KIND_OF[group], reference_of(reference)
    return await changed(writer, lambda written: set_state(written, kind, named, "retired"))


@router.post("/rule", response_model=registry_schemas.RegistryChange, responses=CHANGED)
async def set_compatibility_rule(
    writer: Administrator,
    published: Annotated[Text, Query(description="Published name.", examples=["CoreAcc"])],
    compatibility_rule: Annotated[
        registry_schemas.CompatibilityRule, Query(description="Rule for new versions.", examples=["full"])
    ],
    group: GroupName = "functions",
) -> Response:
    """Set the rule that new versions of a name follow."""
    from sigcat.registry.lines import set_rule

    return await changed(writer, lambda written: set_rule(written, KIND_OF[group], published, compatibility_rule))


# -- writing, one after the other ---------------------------------------------------------------------------------


async def in_turn(request: Request, write: Callable[[], _Result]) -> _Result:
    """Return the result of writing in a thread: one request writes, others wait without a thread."""
    turns: Turns = request.app.state.registry_turns
    return await to_the_end(request, turns, "registry", lambda: run_in_threadpool(write))


async def _recorded(writer: Writer, action: "Action", function: str, line: str) -> Response:
    from sigcat.registry.lines import record

    named = reference_of(function)
    return await changed(writer, lambda written: record(written, action, line, named))


async def changed(writer: Writer, change: "Callable[[Registry], str]") -> Response:
    """Make a change, and answer with the signed head of the log that it returns."""
    made = await in_turn(writer.request, lambda: _with_head(writer.registry, change(writer.written)))
    return Response(json_bytes(made), media_type=JSON)


def _with_head(registry: HostedRegistry, digest: str) -> registry_schemas.RegistryChange:
    from sigcat.api.answers.registry_answers import head_with

    with registry.reading() as connection:
        return registry_schemas.RegistryChange(head=head_with(connection, digest))


def _publish(writer: Writer, candidates: "Sequence[Candidate]", *, is_draft: bool) -> registry_schemas.RegistryReceipt:
    from sigcat.api.answers.registry_answers import receipt
    from sigcat.registry.publish import publish

    published = publish(writer.written, candidates, is_draft=is_draft)
    with writer.registry.reading() as connection:
        return receipt(connection, published)


# -- in a worker --------------------------------------------------------------------------------------------------


def _candidates(
    text: bytes, name: str, catalogue: Catalogue, limits: Limits, version: str, owner: str
) -> "tuple[Candidate, ...]":
    from sigcat.api.requests.registry_files import registry_files
    from sigcat.registry.posted import posted_candidates

    return posted_candidates(registry_files(text, name, limits), catalogue, version, owner, limits)


def _status(receipt: registry_schemas.RegistryReceipt) -> HTTPStatus:
    if any(each.is_pending for each in receipt.versions_posted):
        return HTTPStatus.ACCEPTED
    return HTTPStatus.CREATED if any(each.is_new for each in receipt.versions_posted) else HTTPStatus.OK


def _report(text: bytes, name: str, catalogue: Catalogue, limits: Limits, database: Path | ServerUrl) -> bytes:
    from sigcat.api.requests.registry_files import registry_files
    from sigcat.registry.posted import posted_findings
    from sigcat.registry.storing.database import reading

    files = registry_files(text, name, limits)
    with reading(database) as connection:
        _refuse_empty(connection)
        return json_bytes(lint_report(posted_findings(connection, files, catalogue, limits)))


def _deployment(database: Path | ServerUrl, references: Sequence[str], line: str) -> bytes:
    from sigcat.api.answers.registry_answers import deployment_answer
    from sigcat.registry.storing.database import reading

    with reading(database) as connection:
        _refuse_empty(connection)
        return json_bytes(deployment_answer(connection, references, line))


def _refuse_empty(connection: "Snapshot") -> None:
    """Raises UsageError if nothing is published: then no answer would mean anything."""
    from sigcat.registry.storing.ledger import head

    if head(connection) is None:
        raise UsageError("Nothing is published in the registry, so that the answer is unknown.")
