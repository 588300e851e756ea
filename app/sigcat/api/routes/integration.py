"""Routes that take functions to Integration JSON, and to the files of a platform."""

import json
from typing import Annotated, Any

from fastapi import APIRouter, Path, Query, Request
from fastapi.responses import Response

from sigcat.adapter.core.cores import cores
from sigcat.api.answers import schemas
from sigcat.api.answers.archives import ZIP, archive
from sigcat.api.answers.problems import problem_documentation
from sigcat.api.answers.serializers import finding_schema
from sigcat.api.requests.dependencies import FileName, PostedText, ThePostedWork, TheSettings, TheWorkQueue, takes_text
from sigcat.api.requests.enumerations import enumeration, one_of
from sigcat.api.requests.function_files import SET, posted_functions
from sigcat.api.requests.thread_turns import InThread
from sigcat.api.routes.functions import DECLARATION
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.findings import Finding
from sigcat.integration.reading import read_functions
from sigcat.integration.report import to_json, to_markdown
from sigcat.limits import NAME_CHARACTERS, Limits
from sigcat.names import camel_case, either, snake_case
from sigcat.platforms.deployment_file import DEFAULT_DEPLOYMENT, read_deployment
from sigcat.platforms.integrate import integrate
from sigcat.platforms.platform import Generator, Integrated, Options, Platform
from sigcat.platforms.schemas import SCHEMAS, schema
from sigcat.platforms.table import PLATFORMS

router = APIRouter(prefix="/api/v1", tags=["integration"], route_class=InThread)

_BODY = (
    f"One function, as `function.yaml` or Function JSON; or a set: {SET}, and, if needed, `deployment`, what differs "
    "from the defaults, and, where the platform has ids, `identifiers`, a list of id catalogues as texts of CSV or "
    "ARXML, and `previous`, the Integration JSON before: services that changed since get a new version."
)


_PLATFORM = enumeration("PlatformName", PLATFORMS, "A platform.")
PlatformName = Annotated[_PLATFORM, Path(description="The platform.")]  # type: ignore[valid-type]
_COUNTED = {"Sigcat-Warnings": {"description": "How many findings there are.", "schema": {"type": "integer"}}}


def _makes(answer: dict[str, Any], body: str = _BODY) -> dict[str, Any]:
    """The documentation of an operation that makes something of functions."""
    return {"response_class": Response, **takes_text(body, DECLARATION, 404, answers={200: answer})}


@router.post(
    "/integrate/{platform}",
    **_makes({"model": schemas.IntegrationJson, "description": "The Integration JSON.", "headers": _COUNTED}),
)
async def integrate_functions(
    work: ThePostedWork, platform: PlatformName, name: FileName = "function.yaml"
) -> Response:
    """Derive the Integration JSON of a function or a set of functions."""
    return await work.run(_integrated, name, platform)


@router.post(
    "/integrate/{platform}/archive",
    **_makes({"description": "A zip of Integration JSON, report and findings.", "content": ZIP, "headers": _COUNTED}),
)
async def integrate_functions_archive(
    work: ThePostedWork, platform: PlatformName, name: FileName = "function.yaml"
) -> Response:
    """Derive the Integration JSON of a function or a set of functions, with the report of every field and the findings."""
    return await work.run(_integrated, name, platform, is_whole=True)


def _add_generator(platform: Platform, generator: Generator, releases: Any) -> None:
    """The route of a generator: each has its own address. `releases` is the type that its releases are of."""

    default = generator.default_release or "that of the Integration JSON"

    async def generate_files(
        text: PostedText,
        settings: TheSettings,
        queue: TheWorkQueue,
        name: FileName = f"{platform.name}.json",
        release: Annotated[
            Annotated[releases, one_of(generator.releases)] | None,
            Query(
                alias=generator.release_word,
                description=f"{generator.release_word.capitalize()} of {platform.title}; {default} if absent.",
                include_in_schema=bool(generator.releases),
            ),
        ] = None,
        bench: Annotated[
            bool,
            Query(
                description=f"Add what builds and runs it without {platform.title}: for desks and tests.",
                include_in_schema=generator.has_bench,
            ),
        ] = False,
    ) -> Response:
        options = Options(release, bench and generator.has_bench)
        return await queue.run(_generated, generator, text, name, settings.limits, options)

    router.post(
        f"/generate/{generator.name}",
        name=f"generate_{snake_case(generator.name)}",
        description=f"Generate the {generator.title} of {generator.target}.",
        response_class=Response,
        **takes_text(
            f"The Integration JSON of {platform.title}.",
            "",
            answers={200: {"description": f"The {generator.title} files as a zip.", "content": ZIP}},
        ),
    )(generate_files)


def _add_generators(word: str) -> None:
    """Add generators of all platforms with one word for their releases: a parameter of one name has one type."""
    pairs = [(p, g) for p in PLATFORMS.values() for g in p.generators if g.release_word == word]
    names = {name: None for _, generator in pairs for name in generator.releases}
    owner = camel_case(pairs[0][0].name)
    titles = dict.fromkeys(platform.title for platform, _ in pairs)
    releases = enumeration(f"{owner}{word.capitalize()}", names, f"A {word} of {either(titles)}.")
    for platform, generator in pairs:
        _add_generator(platform, generator, releases)


for each in dict.fromkeys(g.release_word for platform in PLATFORMS.values() for g in platform.generators):
    _add_generators(each)


@router.post(
    "/generate/core",
    **_makes(
        {"description": "A header and a source for each function, as a zip.", "content": ZIP, "headers": _COUNTED},
        f"One function, as `function.yaml` or Function JSON; or a set: {SET}.",
    ),
)
async def generate_core(work: ThePostedWork, name: FileName = "function.yaml") -> Response:
    """Generate the core of the adapter of each function in C, which every platform calls. Nothing is compiled."""
    return await work.run(_core, name)


@router.get("/schemas")
def list_schemas(request: Request) -> schemas.SchemaList:
    """Addresses of the JSON Schemas of every file format for functions."""
    below = request.scope.get("root_path", "").rstrip("/")
    return schemas.SchemaList(schemas=[f"{below}{router.prefix}/schemas/{name}.json" for name in SCHEMAS])


@router.get("/schemas/{name}.json", responses=problem_documentation(404))
def get_schema(
    name: Annotated[str, Path(description="Name of the format.", examples=["function"], max_length=NAME_CHARACTERS)],
) -> schemas.JsonSchema:
    """The JSON Schema (2020-12) of a file format."""
    return schemas.JsonSchema(schema(name))


def _integrated(
    text: bytes, name: str, catalogue: Catalogue, limits: Limits, platform: str, *, is_whole: bool = False
) -> Response:
    with_identifiers, with_previous = PLATFORMS[platform].with_identifiers, PLATFORMS[platform].with_previous
    known = {"deployment": True, "identifiers": with_identifiers, "previous": with_previous}
    further = tuple(key for key, is_known in known.items() if is_known)
    posted = posted_functions(text, name, limits, further=further)
    functions, findings = read_functions(posted.files, catalogue, limits)
    deployment = read_deployment(*posted.deployment, limits) if posted.deployment else DEFAULT_DEPLOYMENT
    if with_identifiers and posted.identifiers:
        deployment = with_identifiers(deployment, posted.identifiers, limits)
    integrated = integrate(PLATFORMS[platform], functions, deployment, posted.previous, limits)
    count = {"Sigcat-Warnings": str(len(findings) + len(integrated.findings))}
    if not is_whole:
        return Response(integrated.document, media_type="application/json", headers=count)
    return archive(_files(platform, integrated, findings), f"{platform}.zip", count)


def _generated(generator: Generator, text: bytes, name: str, limits: Limits, options: Options) -> Response:
    files = generator.generate(text, name, limits, options)
    return archive({file.name: file.data for file in files}, f"{generator.name}.zip", {})


def _core(text: bytes, name: str, catalogue: Catalogue, limits: Limits) -> Response:
    functions, findings = read_functions(posted_functions(text, name, limits).files, catalogue, limits)
    files, warnings = cores(functions)
    count = {"Sigcat-Warnings": str(len(findings) + len(warnings))}
    return archive({file.name: file.data for file in files}, "core.zip", count)


def _files(platform: str, integrated: Integrated, findings: tuple[Finding, ...]) -> dict[str, bytes]:
    rows = [finding_schema(each).model_dump() for each in (*findings, *integrated.findings)]
    return {
        f"{platform}.json": integrated.document,
        f"{platform}.report.json": to_json(integrated.report),
        f"{platform}.report.md": to_markdown(integrated.report).encode(),
        f"{platform}.findings.json": (json.dumps(rows, indent=2, ensure_ascii=False) + "\n").encode(),
    }
