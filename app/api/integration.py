"""Routes that take functions to Integration JSON, and to the files of a platform."""

import io
import json
import zipfile
from collections.abc import Mapping
from functools import partial
from typing import Annotated, Any

from fastapi import APIRouter, Path, Query
from fastapi.responses import Response

from app.api.problems import problem_documentation
from app.api.requests import NamedCatalogue, PostedText, TheHeavyWork, text_body
from app.catalogue.hosting import Hosted
from app.errors import InputRefused
from app.findings import Finding, has_errors
from app.function.document import read_json
from app.function.model import FunctionJson
from app.integration.deployment import DEFAULT_DEPLOYMENT, Deployment, read_deployment
from app.integration.platforms import Integrated, Platform, integrate
from app.integration.reading import read_function
from app.integration.report import to_json, to_markdown
from app.integration.schemas import SCHEMAS, schema

router = APIRouter(prefix="/api/v1", tags=["integration"])

_LARGEST_SET = 500
"""Most functions of one request."""
_EXAMPLE = """\
function: WheelSpeedCalculation
version: 1.0.0
description: Turns the rotation of the four wheels into their speeds over ground.
"""
_BODY = (
    "One function, as `function.yaml` or Function JSON; or a set: a JSON object with `functions`, a list of Function "
    "JSON objects and of texts of `function.yaml`, and, if wanted, `deployment`, what differs from the defaults."
)
_ZIP = {"application/zip": {"schema": {"type": "string", "format": "binary"}}}
_MOMENT = (1980, 1, 1, 0, 0, 0)
"""Time of every file in an archive: the same request gives the same bytes."""


@router.post(
    "/integrate/{platform}",
    response_class=Response,
    responses={
        200: {
            "description": "The Integration JSON, or with `archive` a zip of it, the report and the findings.",
            "content": {"application/json": {"schema": {"type": "object"}}, **_ZIP},
            "headers": {
                "Sigcat-Warnings": {"description": "How many findings there are.", "schema": {"type": "integer"}}
            },
        },
        **problem_documentation(400, 404, 413, 415, 422, 503),
    },
    openapi_extra=text_body(_BODY, _EXAMPLE),
)
async def integrate_functions(
    text: PostedText,
    hosted: NamedCatalogue,
    heavy: TheHeavyWork,
    platform: Annotated[Platform, Path(description="The platform.")],
    name: Annotated[str, Query(max_length=300, description="What findings call the text.")] = "function.yaml",
    archive: Annotated[bool, Query(description="Answer with a zip that has the report and the findings too.")] = False,
) -> Response:
    """Derive the Integration JSON of a function or a set of functions."""
    return await heavy.run(partial(_integrated, text, name, hosted, platform, archive=archive))


@router.post(
    "/generate/arxml",
    response_class=Response,
    responses={
        200: {"description": "The ARXML files as a zip.", "content": _ZIP},
        **problem_documentation(413, 415, 422, 503),
    },
    openapi_extra=text_body("The Integration JSON of AUTOSAR adaptive.", ""),
)
async def generate_arxml(
    text: PostedText,
    heavy: TheHeavyWork,
    name: Annotated[str, Query(max_length=300, description="What findings call the text.")] = "autosar-adaptive.json",
) -> Response:
    """Generate the ARXML of AUTOSAR adaptive R23-11."""
    return await heavy.run(partial(_arxml, text, name))


@router.get("/schemas", responses=problem_documentation(404))
def list_schemas() -> list[str]:
    """Addresses of the JSON Schemas of every file format for functions."""
    return [f"{router.prefix}/schemas/{name}.json" for name in SCHEMAS]


@router.get("/schemas/{name}.json", responses=problem_documentation(404))
def get_schema(name: Annotated[str, Path(description="Name of the format.", examples=["function"])]) -> dict[str, Any]:
    """The JSON Schema (2020-12) of a file format."""
    return schema(name)


def _integrated(text: bytes, name: str, hosted: Hosted, platform: Platform, *, archive: bool) -> Response:
    functions, findings, deployment = _posted(text, name, hosted)
    made = integrate(platform, functions, deployment)
    count = {"Sigcat-Warnings": str(len(findings) + len(made.findings))}
    if not archive:
        return Response(made.document, media_type="application/json", headers=count)
    return _archive(_files(platform, made, findings), f"{platform}.zip", count)


def _arxml(text: bytes, name: str) -> Response:
    from app.adapter.arxml.generate import generate
    from app.integration.autosar_adaptive.document import read_integration

    files = generate(read_integration(text, name))
    return _archive({file.name: file.data for file in files}, "arxml.zip", {})


def _posted(text: bytes, name: str, hosted: Hosted) -> tuple[list[FunctionJson], tuple[Finding, ...], Deployment]:
    """The functions of a body, their warnings, and the deployment."""
    parts = _set_of(text, name)
    if parts is None:
        function, findings = read_function(text, name, lambda: hosted.catalogue)
        return [function], findings, DEFAULT_DEPLOYMENT
    functions: list[FunctionJson] = []
    found: list[Finding] = []
    for index, item in enumerate(parts["functions"]):
        data, what = _item(item, f"{name}, function {index + 1}")
        function, findings = read_function(data, what, lambda: hosted.catalogue)
        functions.append(function)
        found.extend(findings)
    deployment = parts.get("deployment")
    if deployment is None:
        return functions, tuple(found), DEFAULT_DEPLOYMENT
    data, what = _item(deployment, f"{name}, deployment")
    return functions, tuple(found), read_deployment(data, what)


def _set_of(text: bytes, name: str) -> Mapping[str, Any] | None:
    """The body, if it is a set: a JSON object with `functions`."""
    if text.lstrip()[:1] != b"{" or b'"functions"' not in text:
        return None
    document = read_json(text, name)
    if has_errors(document.findings):
        raise InputRefused(f"{name} cannot be read.", document.findings)
    value = document.value
    if not isinstance(value, dict) or "functions" not in value:
        return None
    given = value["functions"]
    unknown = sorted(set(value) - {"functions", "deployment"})
    if unknown or not isinstance(given, list) or not 1 <= len(given) <= _LARGEST_SET:
        message = f"A set has `functions`, a list of 1 to {_LARGEST_SET}, and `deployment` if wanted; nothing else."
        pointer = f"/{unknown[0]}" if unknown else "/functions"
        raise InputRefused(message, (Finding("F003", "error", message, name, pointer=pointer),))
    return value


def _item(item: Any, name: str) -> tuple[bytes, str]:
    """A part of a set as the bytes of its file: a text is YAML, anything else JSON."""
    if isinstance(item, str):
        return item.encode("utf-8", "replace"), f"{name}.yaml"
    return json.dumps(item).encode(), f"{name}.json"


def _files(platform: Platform, made: Integrated, findings: tuple[Finding, ...]) -> dict[str, bytes]:
    told = [finding._asdict() for finding in (*findings, *made.findings)]
    return {
        f"{platform}.json": made.document,
        f"{platform}.report.json": to_json(made.report),
        f"{platform}.report.md": to_markdown(made.report).encode(),
        f"{platform}.findings.json": (json.dumps(told, indent=2, ensure_ascii=False) + "\n").encode(),
    }


def _archive(files: Mapping[str, bytes], name: str, headers: Mapping[str, str]) -> Response:
    """A zip of files. The same files give the same bytes."""
    buffer = io.BytesIO()
    entry = partial(zipfile.ZipInfo, date_time=_MOMENT)
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for path, data in files.items():
            archive.writestr(entry(path), data, zipfile.ZIP_DEFLATED)
    disposition = {"Content-Disposition": f'attachment; filename="{name}"'}
    return Response(buffer.getvalue(), media_type="application/zip", headers={**headers, **disposition})
