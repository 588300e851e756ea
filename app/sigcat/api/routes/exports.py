"""The routes that export a catalogue: one for each format, with the options of that format and no others."""

import io
from collections.abc import Iterable, Iterator, Mapping
from types import MappingProxyType
from typing import Annotated, Any, NamedTuple

from fastapi import APIRouter, Query, Request
from fastapi.responses import Response, StreamingResponse

from sigcat.api.answers import schemas
from sigcat.api.answers.negotiation import caching_headers
from sigcat.api.answers.problems import problem_documentation
from sigcat.api.requests.dependencies import TheCatalogue, TheExportQueue, TheSettings
from sigcat.api.requests.export_options import export_query, given_options
from sigcat.api.requests.thread_turns import InThread, parts_in_turn
from sigcat.catalogue.exporting.export import exported, refuse_unfit
from sigcat.catalogue.exporting.exporter import Exporter
from sigcat.catalogue.exporting.exporters import EXPORTERS, exporter_named
from sigcat.catalogue.exporting.files import zipped
from sigcat.catalogue.model.catalogue import Catalogue

router = APIRouter(prefix="/api/v1/catalogues/{catalogue}", tags=["exports"], route_class=InThread)
unknown_formats = APIRouter(prefix="/api/v1/catalogues/{catalogue}", route_class=InThread)
"""Comes after the others, and takes whatever parameters are meant for a format that is not there."""

_BLOCK = 256 * 1024
_ZIP = "application/zip"
_BYTES = {"schema": {"type": "string", "format": "binary"}}
_COUNTED = {"Sigcat-Warnings": {"description": "How many warnings there are.", "schema": {"type": "integer"}}}


def _add_exporter(exporter: Exporter) -> None:
    """The operation of a format: each has its own address, options and media type. JSON is sent while it is written."""
    options = export_query(exporter)

    async def export_catalogue(
        request: Request,
        hosted: TheCatalogue,
        settings: TheSettings,
        queue: TheExportQueue,
        query: Annotated[options, Query()],  # type: ignore[valid-type]
    ) -> Response:
        catalogue, given = hosted.catalogue, given_options(query, exporter)
        if request.state.is_head:
            refuse_unfit(catalogue, exporter, given)
            return _head(request, exporter.media_type)
        if exporter.stream is not None and (parts := exporter.stream(catalogue, given)) is not None:
            refuse_unfit(catalogue, exporter, given)
            return _sent(request, parts, f"{catalogue.roots[0].name}{exporter.suffix}", exporter.media_type)
        key = (catalogue, exporter.name, repr(sorted(given.items())))
        bounds = settings.heavy_seconds, settings.heavy_bytes
        export = await queue.run_once(key, _exported, catalogue, exporter.name, given, *bounds)
        count = {"Sigcat-Warnings": str(export.warnings)}
        return _sent(request, _blocks(export.data), export.name, export.media_type, count)

    router.get(
        f"/export/{exporter.name}",
        name=f"export_{exporter.name}",
        description=f"The catalogue as {exporter.text}, byte for byte as `{exporter.same_as}` writes it.",
        response_class=Response,
        responses={200: _documentation(exporter), **problem_documentation(404, 422, 503, 507)},
    )(export_catalogue)


def _documentation(exporter: Exporter) -> dict[str, Any]:
    """Return the description of the answer for OpenAPI."""
    if exporter.stream is not None:
        return {"description": "The file, sent while it is written.", "model": schemas.VssTree}
    described = {"description": "The file.", "headers": _COUNTED}
    if exporter.media_type == "application/schema+json":
        return {**described, "content": {exporter.media_type: {"schema": {"$ref": "#/components/schemas/JsonSchema"}}}}
    if exporter.is_folder:
        return {**described, "description": "The files, as a zip.", "content": {_ZIP: _BYTES}}
    is_text = exporter.media_type.startswith("text/")  # clients read nothing else as text
    content = {exporter.media_type: {"schema": {"type": "string"}} if is_text else _BYTES}
    if exporter.has_types_beside:
        content[_ZIP] = _BYTES
        described["description"] = "The file; of a catalogue with struct types, a zip of several."
    return {**described, "content": content}


for each in EXPORTERS.values():
    _add_exporter(each)


@unknown_formats.get("/export/{format}", include_in_schema=False)
def refuse_format(format: str) -> None:  # noqa: A002 - the name in the address
    """Raises NotFound with the formats that may have been meant."""
    exporter_named(format)


def _head(request: Request, media_type: str) -> Response:
    """Return the answer to HEAD. The export's length is not known, so it is absent (RFC 9110, 8.6)."""
    head = Response(media_type=media_type, headers=caching_headers(request))
    del head.headers["content-length"]
    return head


class _OneFile(NamedTuple):
    """An export as one file, be it an archive of several."""

    name: str
    media_type: str
    data: bytes
    warnings: int


def _exported(
    catalogue: Catalogue, format_name: str, options: Mapping[str, Any], seconds: float, memory: int
) -> _OneFile:
    files, findings = exported(catalogue, format_name, options, timeout=seconds, memory=memory)
    exporter = exporter_named(format_name)
    if exporter.is_folder or len(files) > 1:
        name = f"{catalogue.roots[0].name}-{exporter.name}.zip"
        return _OneFile(name, _ZIP, zipped(files), len(findings))
    return _OneFile(files[0].name, exporter.media_type, files[0].data, len(findings))


def _sent(
    request: Request, parts: Iterable[bytes], name: str, media_type: str, more: Mapping[str, str] = MappingProxyType({})
) -> Response:
    safe = "".join(sign if sign.isascii() and (sign.isalnum() or sign in "._-") else "_" for sign in name)
    headers = {**caching_headers(request), "Content-Disposition": f'attachment; filename="{safe}"', **more}
    return StreamingResponse(parts_in_turn(request, iter(parts)), media_type=media_type, headers=headers)


def _blocks(data: bytes) -> Iterator[bytes]:
    buffer = io.BytesIO(data)
    while block := buffer.read(_BLOCK):
        yield block
