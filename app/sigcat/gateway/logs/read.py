"""The frames of a log, read by the form that its name says."""

import gzip
import zlib
from collections.abc import Callable, Iterable, Iterator, Mapping
from io import BufferedReader, RawIOBase
from pathlib import Path
from typing import IO, cast

from sigcat.catalogue.network.can_database import NEEDED
from sigcat.errors import UsageError
from sigcat.findings import Finding
from sigcat.gateway.frames import Frame, Passed, frame_of
from sigcat.gateway.logs.lines import Lines
from sigcat.gateway.logs.not_text import refuse_bytes
from sigcat.gateway.logs.problems import (
    CutLog,
    DamagedLog,
    MalformedLines,
    NoLog,
    damaged,
    ends_early,
    no_log,
)
from sigcat.names import with_article

_CHUNK = 32 * 1024
_GZIP = b"\x1f\x8b"
"""First bytes of a packed file."""


def _candump(lines: Lines) -> Iterable[Frame | Passed]:
    from sigcat.gateway.logs.candump import Candump

    return Candump(lines)


def _asc(lines: Lines) -> Iterable[Frame | Passed]:
    from sigcat.gateway.logs.asc import Asc

    return Asc(lines)


def _csv(lines: Lines) -> Iterable[Frame | Passed]:
    from sigcat.gateway.logs.tables import CsvLog

    return CsvLog(lines)


def _trc(lines: Lines) -> Iterable[Frame | Passed]:
    from sigcat.gateway.logs.tables import Trc

    return Trc(lines)


def _blf(file: IO[bytes]) -> Iterator[Frame | Passed]:
    from sigcat.gateway.logs.blf import BlfLog

    for message in BlfLog(cast("BufferedReader", file)):
        yield frame_of(message, first_channel=1)


def _sqlite(path: Path) -> Iterator[Frame | Passed]:
    from sigcat.gateway.logs.tables import sqlite_frames

    return sqlite_frames(path)


def _mdf(path: Path) -> Iterator[Frame | Passed]:
    from sigcat.gateway.logs.tables import mdf_frames

    return mdf_frames(path)


_OF_LINES: Mapping[str, Callable[[Lines], Iterable[Frame | Passed]]] = {
    ".asc": _asc, ".csv": _csv, ".log": _candump, ".trc": _trc,
}  # fmt: skip
_OF_BYTES: Mapping[str, Callable[[IO[bytes]], Iterator[Frame | Passed]]] = {".blf": _blf}
_OF_PATHS: Mapping[str, Callable[[Path], Iterator[Frame | Passed]]] = {".db": _sqlite, ".mf4": _mdf}
_TITLES = {".log": "candump"}
CSV_HEADER = b"timestamp,arbitration_id,"
"""First line of a log in CSV; a trace begins with `time`."""
_PACKED = (*_OF_LINES, *_OF_BYTES)
"""Forms that may be packed with gzip."""


def read_log(path: Path, findings: list[Finding]) -> Iterator[Frame | Passed]:
    """Yield the records of a log in its order, and add problems to `findings`. Raises UsageError."""
    form = _form(path)
    try:
        yield from _frames(path, form, findings)
    except ImportError:
        raise UsageError(NEEDED) from None
    except NoLog as error:
        message = f"The file must be {with_article(_TITLES.get(form, form[1:].upper()))} log: {error}."
        findings.append(no_log(path, message, error.fix or "Name the file that the tool has logged."))
    except CutLog as error:
        findings.append(ends_early(path, str(error)))
    except DamagedLog as error:
        findings.append(damaged(path, str(error)))
    except EOFError:
        findings.append(ends_early(path, "the packed file stops before its end"))
    except (zlib.error, gzip.BadGzipFile):
        findings.append(damaged(path, "gzip cannot unpack it") if _is_packed(path) else _not_packed(path))


def is_log(path: Path) -> bool:
    """Whether a file is a log by its name; one in CSV, which a trace is too, by how it begins."""
    name = path.name.lower()
    form = next((form for form in (*_PACKED, *_OF_PATHS) if name.removesuffix(".gz").endswith(form)), None)
    if form != ".csv":
        return form is not None
    try:
        with _opened(path) as file:
            return file.read(len(CSV_HEADER)) == CSV_HEADER
    except (OSError, EOFError, zlib.error):
        return False


def _form(path: Path) -> str:
    name = path.name.lower()
    form = next((form for form in _PACKED if name.removesuffix(".gz").endswith(form)), None)
    form = form or next((form for form in _OF_PATHS if name.endswith(form)), None)
    if form is None:
        forms = ", ".join(sorted((*_PACKED, *_OF_PATHS)))
        raise UsageError(
            f"{path} must end in {forms}, or in {', '.join(sorted(_PACKED))} and .gz, which tell its format"
        )
    return form


def _frames(path: Path, form: str, findings: list[Finding]) -> Iterator[Frame | Passed]:
    if form in _OF_PATHS:
        yield from _OF_PATHS[form](path)
        return
    with _opened(path) as file:
        yield from _OF_BYTES[form](file) if form in _OF_BYTES else _of_lines(path, form, file, findings)


def _opened(path: Path) -> IO[bytes]:
    if path.suffix.lower() != ".gz":
        return path.open("rb")
    return BufferedReader(cast("RawIOBase", gzip.open(path, "rb")), _CHUNK)  # reads lines faster than gzip does


def _is_packed(path: Path) -> bool:
    with path.open("rb") as file:
        return file.read(len(_GZIP)) == _GZIP


def _not_packed(path: Path) -> Finding:
    message = "The file must be packed with gzip, as its name says, and is not."
    return no_log(path, message, f"If it is a log as it is, name it {path.name[: -len('.gz')]}.")


def _of_lines(path: Path, form: str, file: IO[bytes], findings: list[Finding]) -> Iterator[Frame | Passed]:
    """A reader stops at the first line that it cannot read: it is iterated again, from the next one on."""
    refuse_bytes(path, cast("BufferedReader", file).peek(_CHUNK))
    lines = Lines(file)
    reader = _OF_LINES[form](lines)
    malformed = MalformedLines(path, form, findings)
    is_frame = False
    while not lines.is_at_end:
        try:
            for frame in reader:
                is_frame = True
                yield frame
        except (EOFError, zlib.error, gzip.BadGzipFile):
            raise
        except Exception as error:  # noqa: BLE001 — readers raise whatever a line makes them meet
            is_frame = False
            malformed.add(lines.number, error)
    malformed.close(lines.too_long, lines.number if is_frame and not lines.is_whole else None)
