"""Fields and files of a posted form. It is taken apart in a worker: a hostile one takes seconds."""

import asyncio
from collections.abc import AsyncGenerator
from http import HTTPStatus
from typing import NamedTuple
from urllib.parse import unquote_to_bytes

from python_multipart.multipart import parse_options_header
from starlette.datastructures import FormData, Headers
from starlette.formparsers import MultiPartException, MultiPartParser

from sigcat.api.answers.problems import BodyRefused
from sigcat.api.requests.dependencies import hosted_at
from sigcat.catalogue.hosting.library import Hosted, Library
from sigcat.errors import UsageError
from sigcat.limits import FORM_FIELDS

_PIECE = 64 * 1024
_NO_FORM = (
    "A page takes a form, as browsers send it: `application/x-www-form-urlencoded`, or `multipart/form-data` with its "
    "boundary. Programs post a text to an address below `/api/`."
)


class PostedFile(NamedTuple):
    """A file of a form, with the name that it has where it was taken from."""

    name: str
    data: bytes


class Form(NamedTuple):
    """The fields in their order, and the files."""

    fields: tuple[tuple[str, str], ...]
    files: tuple[PostedFile, ...] = ()

    def every(self, name: str) -> tuple[str, ...]:
        """All values of a field."""
        return tuple(value for field, value in self.fields if field == name)

    def last(self, name: str, otherwise: str = "") -> str:
        """The last value of a field."""
        return next(iter(reversed(self.every(name))), otherwise)

    def text(self, name: str) -> str:
        """The last value of a field of several lines, which browsers end with CR and LF."""
        return self.last(name).replace("\r\n", "\n")


EMPTY = Form(())
"""A form before anything is typed."""


class PostedForm(NamedTuple):
    """A form as it was posted."""

    body: bytes
    boundary: bytes
    """Separator of its parts, if it is multipart (RFC 7578); else it is url-encoded."""


def posted_form(body: bytes, content_type: str) -> PostedForm:
    """The form in a body. Raises BodyRefused for what is not a form."""
    kind, options = parse_options_header(content_type)
    boundary = options.get(b"boundary", b"") if kind == b"multipart/form-data" else b""
    if not boundary and kind != b"application/x-www-form-urlencoded":
        raise BodyRefused(HTTPStatus.UNSUPPORTED_MEDIA_TYPE, _NO_FORM)
    return PostedForm(body, boundary)


def read_form(posted: PostedForm) -> Form:
    """The fields and files of a form. Raises UsageError for one that is broken or has too many of them."""
    if posted.boundary:
        return _multipart(posted.body, posted.boundary)
    parts = posted.body.split(b"&", FORM_FIELDS)
    if len(parts) > FORM_FIELDS:
        raise UsageError(f"The form must have at most {FORM_FIELDS} fields.")
    pairs = (part.partition(b"=") for part in parts if part)
    return Form(tuple((_unquoted(name), _unquoted(value)) for name, _, value in pairs))


def _unquoted(text: bytes) -> str:
    """Text without its escapes, such as `%C3%A4`. It is decoded in pieces: a list of a million escapes takes 250 MB."""
    decoded, start = bytearray(), 0
    while start < len(text):
        end = text.find(b"%", start + _PIECE)
        piece = text[start : end if end >= 0 else len(text)]
        decoded += unquote_to_bytes(piece.replace(b"+", b" "))
        start += len(piece)
    return decoded.decode("utf-8", "replace")


def form_catalogue(form: Form, library: Library) -> Hosted:
    """The catalogue that a form names, or the default one."""
    name = form.last("catalogue")
    return hosted_at(name, library)[0] if name else library.default


def _multipart(body: bytes, boundary: bytes) -> Form:
    """The fields and files. Starlette reads the text as Latin-1, which keeps every byte; all of it is UTF-8."""
    if b"\r\n--" + boundary + b"--" not in b"\r\n" + body:
        raise UsageError("The form must end with its boundary: a part of it is missing.")

    try:
        form = asyncio.run(_parts(body, boundary))
    except MultiPartException as error:
        raise UsageError(f"The form cannot be read. {error.message}") from None
    fields: list[tuple[str, str]] = []
    files: list[PostedFile] = []
    for name, value in form.multi_items():
        if isinstance(value, str):
            fields.append((_utf8(name), _utf8(value)))
        elif (data := value.file.read()) or value.filename:  # with neither, no file was chosen
            files.append(PostedFile(_utf8(value.filename or "file"), data))
    return Form(tuple(fields), tuple(files))


class _InMemory(MultiPartParser):
    """Starlette's, which writes files beyond a megabyte to the disk in another thread."""

    def __init__(self, body: bytes, boundary: bytes) -> None:
        content_type = b'multipart/form-data; charset=latin-1; boundary="' + boundary + b'"'
        self.spool_max_size = self.max_file_size = len(body) + 1
        super().__init__(
            Headers(raw=[(b"content-type", content_type)]),
            _one_chunk(body),
            max_files=FORM_FIELDS,
            max_fields=FORM_FIELDS,
            max_part_size=len(body),
        )


async def _parts(body: bytes, boundary: bytes) -> FormData:
    return await _InMemory(body, boundary).parse()


async def _one_chunk(body: bytes) -> AsyncGenerator[bytes, None]:
    yield body


def _utf8(latin: str) -> str:
    return latin.encode("latin-1").decode("utf-8", "replace")
