"""What a browser posts: the fields and files of a form."""

import re
from collections.abc import Iterator
from typing import NamedTuple
from urllib.parse import parse_qsl

from sigcat.api.heavy_work import HeavyWork
from sigcat.api.requests.dependencies import catalogue_at
from sigcat.catalogue.hosting.library import Hosted, Library
from sigcat.errors import UsageError

_MOST_PARTS = 40
_MULTIPART = re.compile(r"multipart/form-data;.*\bboundary=\"?([^\";,]{1,70})\"?", re.IGNORECASE)
_PARAMETER = re.compile(rb'\b(name|filename)="([^"\r\n]*)"')
_TOO_MANY = "The form has more fields than there are on the page."


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


def read_form(body: bytes, content_type: str) -> Form:
    """A posted form, url-encoded or, with files, multipart (RFC 7578). Raises UsageError for anything else."""
    multipart = _MULTIPART.match(content_type)
    if multipart:
        return _of_parts(_parts(body, multipart.group(1).encode("latin-1", "replace")))
    try:
        pairs = parse_qsl(body.decode("utf-8", "replace"), keep_blank_values=True, max_num_fields=_MOST_PARTS)
    except ValueError:
        raise UsageError(_TOO_MANY) from None
    return Form(tuple(pairs))


async def form_catalogue(form: Form, library: Library, heavy: HeavyWork) -> Hosted:
    """The catalogue that a form names, or the default one."""
    name = form.last("catalogue")
    return (await catalogue_at(name, library, heavy))[0] if name else library.default


def _parts(body: bytes, boundary: bytes) -> list[bytes]:
    """What stands between the boundaries. What a part says of its own type is not looked at."""
    pieces = (b"\r\n" + body).split(b"\r\n--" + boundary, _MOST_PARTS + 2)
    if len(pieces) > _MOST_PARTS + 2:
        raise UsageError(_TOO_MANY)
    if len(pieces) < 2 or not pieces[-1].startswith(b"--"):
        raise UsageError("The form is not complete: its last boundary is missing.")
    return pieces[1:-1]


def _of_parts(parts: list[bytes]) -> Form:
    fields: list[tuple[str, str]] = []
    files: list[PostedFile] = []
    for name, file, data in _read(parts):
        if file is None:
            fields.append((name, data.decode("utf-8", "replace")))
        elif file or data:  # a field for files in which none was chosen is sent with neither
            files.append(PostedFile(file or "file", data))
    return Form(tuple(fields), tuple(files))


def _read(parts: list[bytes]) -> Iterator[tuple[str, str | None, bytes]]:
    """Name of the field, name of the file if it is one, and the content, of each part."""
    for part in parts:
        head, _, content = part.partition(b"\r\n\r\n")
        given = {key.decode(): value.decode("utf-8", "replace") for key, value in _PARAMETER.findall(head)}
        yield given.get("name", ""), given.get("filename"), content
