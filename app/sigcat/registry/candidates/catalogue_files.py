"""A catalogue as one document with all of its files: a service composes it from these files alone."""

import errno
import json
import os
import re
from collections.abc import Mapping
from pathlib import Path, PurePosixPath
from typing import Annotated, Any, NamedTuple

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from sigcat import codes
from sigcat.catalogue.hosting.source import Source, load
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.data import OVERLAYS, VSPEC
from sigcat.errors import InputRefused
from sigcat.findings import Finding, has_errors
from sigcat.limits import NAME_CHARACTERS, Limits
from sigcat.temporary_files import temporary_folder

ENDING = ".catalogue.json"
"""End of the names of such documents, after the name of the tree."""
_DEEPEST = 16
"""Folders above the tree in which its files may be. The temporary folder has as many, so that no `..` of a name leaves it."""

_Name = Annotated[str, Field(min_length=1, max_length=NAME_CHARACTERS)]


class _Document(BaseModel):
    """Names are relative to the folder of the tree, with `/`; what sigcat ships is below `sigcat/`."""

    model_config = ConfigDict(extra="forbid", frozen=True, strict=True)

    name: _Name
    release: str = ""
    has_standard_units: bool = True
    tree: _Name
    overlays: list[_Name] = []
    units: list[_Name] = []
    quantities: list[_Name] = []
    types: list[_Name] = []
    include_dirs: list[_Name] = []
    files: dict[_Name, str]


_LISTS = ("overlays", "units", "quantities", "types", "include_dirs")
"""Fields with paths, of a document as of a source."""


class SentCatalogue(NamedTuple):
    """A catalogue that was sent, and its content as the registry stores it."""

    catalogue: Catalogue
    content: bytes


def content_of_files(files: Mapping[str, str]) -> bytes:
    """The content of a catalogue: every file that it was read from."""
    return json.dumps({"files": files}, ensure_ascii=False, indent=1).encode()


def files_of(catalogue: Catalogue) -> Mapping[str, str]:
    """Texts of a catalogue's files by their names, which are the same on every machine."""
    paths = [Path(file.name) for file in catalogue.files]
    return {_name_of(path, paths[0].parent): path.read_bytes().decode("utf-8") for path in paths}


def document_of(source: Source, catalogue: Catalogue) -> bytes:
    """The document to send of a catalogue, which was read from a source without errors."""
    folder = Path(catalogue.files[0].name).parent
    document = _Document(
        name=catalogue.name,
        release=source.release,
        has_standard_units=source.has_standard_units,
        tree=_name_of(Path(catalogue.files[0].name), folder),
        files=dict(files_of(catalogue)),
        **{kind: [_name_of(path, folder) for path in getattr(source, kind)] for kind in _LISTS},
    )
    return document.model_dump_json().encode()


def sent_catalogue(data: bytes, name: str, limits: Limits) -> SentCatalogue:
    """The catalogue of a document. Raises InputRefused for one that is malformed, or whose catalogue has errors."""
    document = _read(data, name)
    with temporary_folder("sigcat-catalogue-") as place:
        top = Path(place).resolve()
        folder = top.joinpath(*(["above"] * _DEEPEST), "tree")
        _write(document, folder, name)
        catalogue = load(_source(document, folder), limits)
    if has_errors(catalogue.findings):
        raise InputRefused(
            "the catalogue has errors", tuple(_as_sent(each, top, folder) for each in catalogue.findings)
        )
    return SentCatalogue(catalogue, content_of_files(document.files))


def _as_sent(finding: Finding, top: Path, folder: Path) -> Finding:
    """A finding with the names that were sent, in place of those below the temporary folder."""

    def sent(text: str) -> str:
        return re.sub(rf"{re.escape(str(top))}[^\s'`]*", lambda match: os.path.relpath(match[0], folder), text)

    return finding._replace(file=sent(finding.file), message=sent(finding.message), fix=sent(finding.fix))


def _read(data: bytes, name: str) -> _Document:
    try:
        document = _Document.model_validate_json(data)
    except ValidationError as error:
        first = error.errors(include_url=False)[0]
        place = ".".join(map(str, first["loc"])) or "the document"
        message = f"{place} of a catalogue is invalid: {first['msg']}."
        raise _refused(message, name) from None
    listed = (getattr(document, kind) for kind in _LISTS if kind != "include_dirs")
    for each in (document.tree, *(one for names in listed for one in names)):
        if each not in document.files:
            raise _refused(f"`files` must have {each!r}, which the catalogue names.", name)
    for each in (*document.files, *document.include_dirs):
        if not _is_inside(each):
            raise _refused(f"{each[:80]!r} must be a relative path with `/`.", name)
    return document


def _refused(message: str, name: str) -> InputRefused:
    finding = codes.VALUE_UNFIT.finding(message, name, fix="Publish the catalogue with `sigcat publish`.")
    return InputRefused("the catalogue cannot be read", (finding,))


def _is_inside(name: str) -> bool:
    """Whether a name is relative and goes up at its beginning only, by a few folders."""
    parts = name.split("/")
    rest = parts[_ups(name) :]
    is_plain = all(part and part not in (".", "..") for part in rest) and not set(name) & {"\\", "\0", ":"}
    return bool(rest) and is_plain and _ups(name) <= _DEEPEST


def _ups(name: str) -> int:
    """Folders that a name goes up."""
    parts = name.split("/")
    return next((number for number, part in enumerate(parts) if part != ".."), len(parts))


def _write(document: _Document, folder: Path, name: str) -> None:
    """Write the files below a folder. Raises InputRefused for names that no folder can have together."""
    try:
        for each, text in document.files.items():
            path = _path(folder, each)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8", newline="")
    except OSError as error:
        if error.errno not in (errno.EEXIST, errno.ENOTDIR, errno.EISDIR, errno.ENAMETOOLONG):
            raise
        message = f"The names of the files must fit into a folder, but {each[:80]!r} does not: {error.strerror}."
        raise _refused(message, name) from None


def _path(folder: Path, name: str) -> Path:
    return Path(os.path.normpath(folder / PurePosixPath(name)))


def _source(document: _Document, folder: Path) -> Source:
    """The source of the catalogue whose files are below a folder."""
    lists: dict[str, Any] = {kind: tuple(_path(folder, each) for each in getattr(document, kind)) for kind in _LISTS}
    return Source(
        document.name,
        document.name,
        _path(folder, document.tree),
        release=document.release,
        has_standard_units=document.has_standard_units,
        **lists,
    )


def _name_of(file: Path, folder: Path) -> str:
    """The name of a file of a catalogue, which is the same on every machine."""
    for shipped in (VSPEC, OVERLAYS):
        if file.is_relative_to(shipped):
            return f"sigcat/{shipped.name}/{file.relative_to(shipped).as_posix()}"
    return Path(os.path.relpath(file, folder)).as_posix()
