"""What the routes take from a request: the hosted catalogue, the posted text."""

import hashlib
from http import HTTPStatus
from typing import Annotated, Any

from fastapi import Depends, Path, Query, Request, Response
from starlette.exceptions import HTTPException

from app import __version__
from app.api.problems import BodyRefused
from app.api.rulebook import RuleBook
from app.api.settings import Settings
from app.catalogue.hosting import Hosted, Library

TEXT_TYPES = ("text/yaml", "application/yaml", "application/json")


def library_of(request: Request) -> Library:
    """The library that the service hosts."""
    library: Library = request.app.state.library
    return library


def settings_of(request: Request) -> Settings:
    """The settings of the service."""
    settings: Settings = request.app.state.settings
    return settings


def rules_of(request: Request) -> RuleBook:
    """The rules of the service."""
    rules: RuleBook = request.app.state.rules
    return rules


TheLibrary = Annotated[Library, Depends(library_of)]
TheSettings = Annotated[Settings, Depends(settings_of)]
TheRules = Annotated[RuleBook, Depends(rules_of)]
CatalogueId = Annotated[str, Path(description="Id of a hosted catalogue.", examples=["interfaces"])]


def version_of(hosted: Hosted) -> str:
    """A digest of all that is shown of a catalogue: content, files with their positions, findings."""
    parts = [__version__, hosted.source.title, hosted.catalogue.digest]
    parts += [layer.digest for layer in hosted.catalogue.layers]
    parts += [file.digest for file in hosted.catalogue.vocabulary.files]
    parts += [repr(hosted.rejected)] if hosted.rejected else []
    return hashlib.sha256("\n".join(parts).encode("utf-8", "replace")).hexdigest()[:24]


def hosted_catalogue(catalogue: CatalogueId, library: TheLibrary, request: Request, response: Response) -> Hosted:
    """The hosted catalogue named in the address; 304 if the client holds the same state of it."""
    hosted = library.get(catalogue)
    tag = f'"{version_of(hosted)}"'
    headers = {"ETag": tag, "Cache-Control": "no-cache"}
    known = [each.strip().removeprefix("W/") for each in request.headers.get("if-none-match", "").split(",")]
    if tag in known:
        raise HTTPException(HTTPStatus.NOT_MODIFIED, headers=headers)
    response.headers.update(headers)
    return hosted


TheCatalogue = Annotated[Hosted, Depends(hosted_catalogue)]


def named_catalogue(
    library: TheLibrary,
    catalogue: Annotated[
        str | None, Query(description="Id of a hosted catalogue; without it, the default one.")
    ] = None,
) -> Hosted:
    """The hosted catalogue that a posted text is judged against."""
    return library.default if catalogue is None else library.get(catalogue)


NamedCatalogue = Annotated[Hosted, Depends(named_catalogue)]


async def posted_text(request: Request, settings: TheSettings) -> bytes:
    """The body, not longer than the limit. Its media type does not matter, as long as it is the bare text."""
    if request.headers.get("content-type", "").startswith("multipart/"):
        detail = "Post the bare text, not a form: curl --data-binary @FILE."
        raise BodyRefused(HTTPStatus.UNSUPPORTED_MEDIA_TYPE, detail)
    if request.headers.get("content-encoding", "identity") != "identity":
        raise BodyRefused(HTTPStatus.UNSUPPORTED_MEDIA_TYPE, "Post the text uncompressed.")
    declared = request.headers.get("content-length", "")
    if declared.isdecimal() and len(declared) <= len(str(settings.body_bytes)) + 1:
        _check_length(int(declared), settings)
    elif declared:
        _check_length(settings.body_bytes + 1, settings)
    body = bytearray()
    async for chunk in request.stream():
        body += chunk
        _check_length(len(body), settings)
    return bytes(body)


PostedText = Annotated[bytes, Depends(posted_text)]


def text_body(description: str, example: str) -> dict[str, Any]:
    """The OpenAPI description of a posted text."""
    content = {
        media_type: {"schema": {"type": "string"}, **({"example": example} if example and "yaml" in media_type else {})}
        for media_type in TEXT_TYPES
    }
    return {"requestBody": {"required": True, "description": description, "content": content}}


def _check_length(length: int, settings: Settings) -> None:
    if length > settings.body_bytes:
        detail = f"The text has more than {settings.body_bytes:,} bytes, which is the limit."
        raise BodyRefused(HTTPStatus.REQUEST_ENTITY_TOO_LARGE, detail, headers={"Connection": "close"})
