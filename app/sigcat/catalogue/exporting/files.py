"""The files of an export."""

from collections.abc import Iterable
from typing import NamedTuple

from sigcat.findings import Finding


class ExportedFile(NamedTuple):
    """A file of an export. `name` is its path in the export, with slashes."""

    name: str
    data: bytes
    option: str = ""
    """The option that asked for the file, such as `types-output`; empty for the export itself."""


class Export(NamedTuple):
    """Files of an export, the main file first, and the warnings of the exporter."""

    files: tuple[ExportedFile, ...]
    findings: tuple[Finding, ...] = ()


def zipped(files: Iterable[ExportedFile]) -> bytes:
    """The files as a zip archive: equal files make equal bytes."""
    import io
    import zipfile

    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for file in sorted(files):
            entry = zipfile.ZipInfo(file.name, date_time=(1980, 1, 1, 0, 0, 0))
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = 0o644 << 16
            archive.writestr(entry, file.data)
    return buffer.getvalue()
