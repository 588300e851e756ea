"""The route that exports a catalogue in any format."""

import io
from collections.abc import Iterable, Iterator, Mapping
from types import MappingProxyType
from typing import Annotated, Any, NamedTuple

from fastapi import APIRouter, Path, Request
from fastapi.responses import Response, StreamingResponse

from sigcat.api.answers.negotiation import caching_headers
from sigcat.api.answers.problems import problem_documentation
from sigcat.api.requests.dependencies import TheCatalogue, TheExportQueue, TheSettings
from sigcat.catalogue.exporting.export import exported, refuse_unfit
from sigcat.catalogue.exporting.exporter import Exporter, Option
from sigcat.catalogue.exporting.exporters import EXPORTERS, exporter_named
from sigcat.catalogue.exporting.files import zipped
from sigcat.catalogue.exporting.options import option_named
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.errors import UsageError

router = APIRouter(prefix="/api/v1/catalogues/{catalogue}", tags=["exports"])

_BLOCK = 256 * 1024
_TRUTH = {"": True, "true": True, "yes": True, "1": True, "false": False, "no": False, "0": False}
_TYPES: Mapping[str, dict[str, Any]] = {
    "flag": {"type": "boolean"}, "switch": {"type": "boolean"}, "number": {"type": "integer"},
    "texts": {"type": "array", "items": {"type": "string"}},
}  # fmt: skip


def _is_offered(option: Option) -> bool:
    """Whether a request can give the option: those that name files of the machine it cannot."""
    return option.kind in ("flag", "switch", "text", "name", "texts", "number", "choice")


def _spelled(option: Option) -> str:
    return option.name.replace("-", "_")


def _documentation() -> dict[str, Any]:
    """Every option as a parameter, with the formats that take it."""
    takers: dict[str, list[tuple[Exporter, Option]]] = {}
    for exporter in EXPORTERS.values():
        for option in filter(_is_offered, exporter.options):
            takers.setdefault(_spelled(option), []).append((exporter, option))
    return {"parameters": [_parameter(name, taken) for name, taken in takers.items()]}


def _parameter(name: str, taken: list[tuple[Exporter, Option]]) -> dict[str, Any]:
    option = taken[0][1]
    schema = dict(_TYPES.get(option.kind, {"type": "string"}))
    if option.choices and option.kind == "texts":
        schema["items"] = {"type": "string", "enum": list(option.choices)}
    elif option.choices:
        schema["enum"] = list(option.choices)
    formats = "every format" if len(taken) > len(EXPORTERS) - 3 else ", ".join(exporter.name for exporter, _ in taken)
    description = f"{option.text[:1].upper()}{option.text[1:]} ({formats})."
    return {"name": name, "in": "query", "required": False, "description": description, "schema": schema}


def _content_schema(media_type: str) -> dict[str, str]:
    return {"type": "object"} if media_type.endswith("json") else {"type": "string", "format": "binary"}


_MEDIA_TYPES = tuple(dict.fromkeys(exporter.media_type for exporter in EXPORTERS.values()))


@router.get(
    "/export/{format}",
    response_class=Response,
    responses={
        200: {
            "description": "The file, byte for byte as `vspec export` writes it; of a folder or several files, a zip.",
            "content": {media_type: {"schema": _content_schema(media_type)} for media_type in _MEDIA_TYPES},
            "headers": {
                "Sigcat-Warnings": {
                    "description": "How many warnings there are; JSON, which is sent while it is written, has none.",
                    "schema": {"type": "integer"},
                }
            },
        },
        **problem_documentation(400, 404, 422, 503),
    },
    openapi_extra=_documentation(),
)
async def export_catalogue(
    request: Request,
    hosted: TheCatalogue,
    settings: TheSettings,
    queue: TheExportQueue,
    format: Annotated[str, Path(description=f"One of {', '.join(EXPORTERS)}.", examples=["json"], max_length=100)],  # noqa: A002 - the name in the address
) -> Response:
    """A catalogue in another format. JSON is sent while it is written."""
    exporter = exporter_named(format)
    options = _options(exporter, request.query_params.multi_items())
    catalogue = hosted.catalogue
    if request.state.is_head:
        refuse_unfit(catalogue, exporter)
        media_type = "application/zip" if exporter.is_folder else exporter.media_type
        return Response(media_type=media_type, headers=caching_headers(request))
    if exporter.stream is not None and (parts := exporter.stream(catalogue, options)) is not None:
        refuse_unfit(catalogue, exporter)
        return _sent(request, parts, f"{catalogue.roots[0].name}{exporter.suffix}", exporter.media_type)
    key = (catalogue, exporter.name, repr(sorted(options.items())))
    export = await queue.run_once(key, _exported, catalogue, exporter.name, options, settings.heavy_seconds)
    count = {"Sigcat-Warnings": str(export.warnings)}
    return _sent(request, _blocks(export.data), export.name, export.media_type, count)


class _OneFile(NamedTuple):
    """An export as one file, be it an archive of several."""

    name: str
    media_type: str
    data: bytes
    warnings: int


def _exported(catalogue: Catalogue, format_name: str, options: Mapping[str, Any], seconds: float) -> _OneFile:
    files, findings = exported(catalogue, format_name, options, timeout=seconds)
    exporter = exporter_named(format_name)
    if exporter.is_folder or len(files) > 1:
        name = f"{catalogue.roots[0].name}-{exporter.name}.zip"
        return _OneFile(name, "application/zip", zipped(files), len(findings))
    return _OneFile(files[0].name, exporter.media_type, files[0].data, len(findings))


def _options(exporter: Exporter, given: Iterable[tuple[str, str]]) -> dict[str, Any]:
    """Options as the exporter takes them. Raises UsageError for one that it does not have."""
    known = {_spelled(option): option for option in exporter.options if _is_offered(option)}
    options: dict[str, Any] = {}
    for name, text in given:
        option = option_named(name, known, exporter)
        value = _value(option, text)
        options[option.name] = [*options.get(option.name, []), value] if option.kind == "texts" else value
    return options


def _value(option: Option, text: str) -> Any:
    if option.kind in ("flag", "switch"):
        if text.lower() not in _TRUTH:
            raise UsageError(f"{_spelled(option)} must be true or false, not {text[:80]!r}.")
        return _TRUTH[text.lower()]
    if option.kind == "number":
        if not (text.isascii() and text.isdecimal() and len(text) < 10):
            raise UsageError(f"{_spelled(option)} must be a whole number, not {text[:80]!r}.")
        return int(text)
    return text


def _sent(
    request: Request, parts: Iterable[bytes], name: str, media_type: str, more: Mapping[str, str] = MappingProxyType({})
) -> Response:
    safe = "".join(sign if sign.isascii() and (sign.isalnum() or sign in "._-") else "_" for sign in name)
    headers = {**caching_headers(request), "Content-Disposition": f'attachment; filename="{safe}"', **more}
    return StreamingResponse(parts, media_type=media_type, headers=headers)


def _blocks(data: bytes) -> Iterator[bytes]:
    buffer = io.BytesIO(data)
    while block := buffer.read(_BLOCK):
        yield block
