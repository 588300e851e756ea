"""The documents that are made from functions, each to be read, copied and downloaded."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import NamedTuple
from urllib.parse import quote

from starlette.responses import Response

from sigcat.adapter.autosar_adaptive.arxml.generate import generate
from sigcat.errors import InputRefused, NotFound
from sigcat.findings import Finding
from sigcat.function.function_json.model import FunctionJson, to_json
from sigcat.integration.autosar_adaptive.derive import derive
from sigcat.integration.deployment import DEFAULT_DEPLOYMENT
from sigcat.integration.platforms import Platform, integrate
from sigcat.names import nearest


class MadeDocument(NamedTuple):
    """A document. Its text is empty if it could not be made; the findings say why."""

    id: str
    """Name in addresses."""
    view: str
    """Documents of one view are shown together."""
    file: str
    """Name of the file when it is downloaded."""
    media_type: str
    text: str
    findings: tuple[Finding, ...] = ()


JSON = "application/json"
VIEWS = {
    "function-json": "Function JSON", "autosar-adaptive": "AUTOSAR adaptive", "ros2": "ROS 2", "arxml": "ARXML",
}  # fmt: skip
"""The views, with what each is called."""
SET_VIEWS = {view: title for view, title in VIEWS.items() if view != "function-json"}
"""Those of a set of functions."""


def chosen_view(given: str, views: Iterable[str]) -> str:
    """The view that an address or a form names. Raises NotFound with the nearest ones."""
    if given not in views:
        raise NotFound(f"There is no view {given[:100]!r} of it.", nearest(given[:100], views))
    return given


def documents_of(function: FunctionJson, view: str = "") -> tuple[MadeDocument, ...]:
    """The documents of a function: those of one view, or all."""
    name = function.info.function_name
    return ((_function_json(function),) if view in ("", "function-json") else ()) + integrations_of(
        (function,), name, view
    )


def integrations_of(functions: Sequence[FunctionJson], name: str, view: str = "") -> tuple[MadeDocument, ...]:
    """What is made from functions for each platform, as it is without a deployment file."""
    makers: Mapping[str, Callable[[], tuple[MadeDocument, ...]]] = {
        "autosar-adaptive": lambda: (_integration("autosar-adaptive", functions, name),),
        "ros2": lambda: (_integration("ros2", functions, name),),
        "arxml": lambda: _arxml(functions),
    }
    return tuple(document for each, make in makers.items() if view in ("", each) for document in make())


def attached(document: MadeDocument) -> Response:
    """The document as a file to be kept."""
    disposition = f"attachment; filename*=UTF-8''{quote(document.file, safe='')}"
    content = document.text.encode("utf-8", "replace")
    return Response(content, media_type=document.media_type, headers={"Content-Disposition": disposition})


def _function_json(function: FunctionJson) -> MadeDocument:
    name = f"{function.info.function_name}.json"
    return MadeDocument("function-json", "function-json", name, JSON, _text(to_json(function)))


def _integration(platform: Platform, functions: Sequence[FunctionJson], name: str) -> MadeDocument:
    document = MadeDocument(platform, platform, f"{name}.{platform}.json", JSON, "")
    try:
        made = integrate(platform, functions, DEFAULT_DEPLOYMENT)
    except InputRefused as refused:
        return document._replace(findings=tuple(refused.findings))
    return document._replace(text=_text(made.document), findings=made.findings)


def _arxml(functions: Sequence[FunctionJson]) -> tuple[MadeDocument, ...]:
    try:
        files = generate(derive(functions, DEFAULT_DEPLOYMENT).model)
    except InputRefused as refused:
        return (MadeDocument("arxml", "arxml", "", "", "", tuple(refused.findings)),)
    return tuple(MadeDocument(file.name, "arxml", file.name, "application/xml", _text(file.data)) for file in files)


def _text(data: bytes) -> str:
    return data.decode("utf-8", "replace")
