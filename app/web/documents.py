"""The documents that are made from functions, each to be read, copied and downloaded."""

from collections.abc import Sequence
from typing import NamedTuple
from urllib.parse import quote

from starlette.responses import Response

from app.adapter.arxml.generate import generate
from app.errors import InputRefused
from app.findings import Finding
from app.function.model import FunctionJson, to_json
from app.integration.autosar_adaptive.derive import derive
from app.integration.deployment import DEFAULT_DEPLOYMENT
from app.integration.platforms import Platform, integrate


class MadeDocument(NamedTuple):
    """A document. Its text is empty if it could not be made; the findings say why."""

    id: str
    """Name in addresses."""
    view: str
    """Documents of one view are shown together."""
    title: str
    """Title of the view."""
    file: str
    """Name of the file when it is downloaded."""
    media_type: str
    text: str
    findings: tuple[Finding, ...] = ()


JSON = "application/json"


def documents_of(function: FunctionJson) -> tuple[MadeDocument, ...]:
    """Every document of a function."""
    name = function.info.function_name
    text = _text(to_json(function))
    own = MadeDocument("function-json", "function-json", "Function JSON", f"{name}.json", JSON, text)
    return (own, *integrations_of((function,), name))


def integrations_of(functions: Sequence[FunctionJson], name: str) -> tuple[MadeDocument, ...]:
    """What is made from functions for each platform, as it is without a deployment file."""
    adaptive = _integration("autosar-adaptive", "AUTOSAR adaptive", functions, name)
    return (adaptive, _integration("ros2", "ROS 2", functions, name), *_arxml(functions))


def attached(document: MadeDocument) -> Response:
    """The document as a file to be kept."""
    disposition = f"attachment; filename*=UTF-8''{quote(document.file, safe='')}"
    content = document.text.encode("utf-8", "replace")
    return Response(content, media_type=document.media_type, headers={"Content-Disposition": disposition})


def _integration(platform: Platform, title: str, functions: Sequence[FunctionJson], name: str) -> MadeDocument:
    document = MadeDocument(platform, platform, title, f"{name}.{platform}.json", JSON, "")
    try:
        made = integrate(platform, functions, DEFAULT_DEPLOYMENT)
    except InputRefused as refused:
        return document._replace(findings=tuple(refused.findings))
    return document._replace(text=_text(made.document), findings=made.findings)


def _arxml(functions: Sequence[FunctionJson]) -> tuple[MadeDocument, ...]:
    try:
        files = generate(derive(functions, DEFAULT_DEPLOYMENT).model)
    except InputRefused as refused:
        return (MadeDocument("arxml", "arxml", "ARXML", "", "", "", tuple(refused.findings)),)
    return tuple(
        MadeDocument(file.name, "arxml", "ARXML", file.name, "application/xml", _text(file.data)) for file in files
    )


def _text(data: bytes) -> str:
    return data.decode("utf-8", "replace")
