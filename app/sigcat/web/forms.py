"""What a browser posts: the fields and files of a form."""

from http import HTTPStatus
from typing import NamedTuple
from urllib.parse import parse_qsl

from python_multipart.multipart import parse_options_header
from starlette.formparsers import MultiPartException
from starlette.requests import Request
from starlette.types import Message

from sigcat.api.answers.problems import BodyRefused
from sigcat.api.requests.dependencies import catalogue_at
from sigcat.api.work.queue import ClientQueue
from sigcat.catalogue.hosting.library import Hosted, Library
from sigcat.errors import UsageError
from sigcat.limits import FORM_FIELDS

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


async def read_form(body: bytes, content_type: str) -> Form:
    """A posted form, url-encoded or, with files, multipart (RFC 7578). Raises BodyRefused for anything else, and UsageError."""
    kind, options = parse_options_header(content_type)
    boundary = options.get(b"boundary", b"")
    if kind == b"multipart/form-data" and boundary:
        return await _multipart(body, boundary)
    if kind != b"application/x-www-form-urlencoded":
        raise BodyRefused(HTTPStatus.UNSUPPORTED_MEDIA_TYPE, _NO_FORM)
    try:
        pairs = parse_qsl(body.decode("utf-8", "replace"), keep_blank_values=True, max_num_fields=FORM_FIELDS)
    except ValueError:
        raise UsageError(f"The form must have at most {FORM_FIELDS} fields.") from None
    return Form(tuple(pairs))


async def form_catalogue(form: Form, library: Library, queue: ClientQueue) -> Hosted:
    """The catalogue that a form names, or the default one."""
    name = form.last("catalogue")
    return (await catalogue_at(name, library, queue))[0] if name else library.default


async def _multipart(body: bytes, boundary: bytes) -> Form:
    """The fields and files. Starlette reads the text as Latin-1, which keeps every byte; all of it is UTF-8."""
    if b"\r\n--" + boundary + b"--" not in b"\r\n" + body:
        raise UsageError("The form must end with its boundary: a part of it is missing.")

    async def receive() -> Message:
        return {"type": "http.request", "body": body, "more_body": False}

    content_type = b'multipart/form-data; charset=latin-1; boundary="' + boundary + b'"'
    request = Request({"type": "http", "headers": [(b"content-type", content_type)]}, receive)
    fields: list[tuple[str, str]] = []
    files: list[PostedFile] = []
    try:
        async with request.form(max_files=FORM_FIELDS, max_fields=FORM_FIELDS, max_part_size=len(body)) as form:
            for name, value in form.multi_items():
                if isinstance(value, str):
                    fields.append((_utf8(name), _utf8(value)))
                elif (data := await value.read()) or value.filename:  # with neither, no file was chosen
                    files.append(PostedFile(_utf8(value.filename or "file"), data))
    except MultiPartException as error:
        raise UsageError(f"The form cannot be read. {error.message}") from None
    return Form(tuple(fields), tuple(files))


def _utf8(latin: str) -> str:
    return latin.encode("latin-1").decode("utf-8", "replace")
