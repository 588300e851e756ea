"""Frames of a log or of a bus, read with python-can one after the other: a log of any size takes the same memory.

Of a log that is damaged, all that can be read is read; what cannot is a finding, the same one at most a hundred times.
"""

import gzip
import zlib
from collections.abc import Iterator
from io import BufferedReader
from pathlib import Path
from typing import IO, Any, NamedTuple, cast

from sigcat import codes
from sigcat.catalogue.network.can_database import NEEDED
from sigcat.errors import UsageError
from sigcat.findings import Finding
from sigcat.gateway.log_lines import CutLine, LogLines
from sigcat.limits import LOG_FINDINGS

FORMS = (".asc", ".blf", ".log")
"""Endings of logs: those of Vector, as text and as bytes, and that of candump; each may be packed with gzip."""
_COARSE = 4_000_000
"""Seconds beyond which a double holds no nanoseconds: such times are of a calendar, and logged in microseconds."""


_GZIP = b"\x1f\x8b"
"""How a file begins that is packed."""


class Frame(NamedTuple):
    """A frame of data."""

    time: int
    """In ns, as the log has it."""
    identifier: int
    is_extended: bool
    data: bytes
    channel: str


class Passed(NamedTuple):
    """Something else of a bus: `error`, or `remote` for a request that has no data."""

    kind: str


def read_log(path: Path, findings: list[Finding]) -> Iterator[Frame | Passed]:
    """What a log has, in its order; what is wrong with it is added to `findings`. Raises UsageError."""
    form = _form(path)
    with _opened(path) as file:
        yield from _packed(path, (_read_bytes if form == ".blf" else _read_lines)(path, form, file, findings), findings)


def _packed(path: Path, frames: Iterator[Frame | Passed], findings: list[Finding]) -> Iterator[Frame | Passed]:
    """Frames until the packing of the log ends, or is damaged."""
    try:
        yield from frames
    except EOFError:
        findings.append(_ends_early(path, "the packed file stops before its end"))
    except (zlib.error, gzip.BadGzipFile):
        with path.open("rb") as file:
            is_packed = file.read(len(_GZIP)) == _GZIP
        findings.append(_damaged(path, "gzip cannot unpack it") if is_packed else _not_packed(path))


def _form(path: Path) -> str:
    name = path.name.lower().removesuffix(".gz")
    form = next((form for form in FORMS if name.endswith(form)), None)
    if form is None:
        raise UsageError(f"{path} must end in {', '.join(FORMS)}, or in one of them and .gz: that says what it is")
    return form


def _opened(path: Path) -> IO[bytes]:
    return cast("IO[bytes]", gzip.open(path, "rb")) if path.suffix.lower() == ".gz" else path.open("rb")


def _ends_early(path: Path, why: str) -> Finding:
    message = f"The log ends in the middle: {why}."
    return codes.LOG_MALFORMED.finding(message, str(path), fix="What comes before it was read.")


def _damaged(path: Path, why: str) -> Finding:
    message = f"The log is damaged: {why}. What follows was not read."
    rule = codes.LOG_MALFORMED.graded("error")  # the rest is there, and is lost
    return rule.finding(message, str(path), fix="Record it anew, or have its tool repair it.")


def _not_packed(path: Path) -> Finding:
    message = "The file must be packed with gzip, as its name says, and is not."
    return _no_log(path, message, f"If it is a log as it is, name it {path.name[: -len('.gz')]}.")


def _no_log(path: Path, message: str, fix: str) -> Finding:
    return codes.LOG_MALFORMED.graded("error").finding(message, str(path), fix=fix)


# -- text ---------------------------------------------------------------------------------------------------------


def _read_lines(path: Path, form: str, file: IO[bytes], findings: list[Finding]) -> Iterator[Frame | Passed]:
    """A reader stops at the first line that it cannot read: it is asked again, from the next one on."""
    lines = LogLines(file, is_asc=form == ".asc")
    reader = _reader(form, lines)
    malformed = 0
    while not lines.is_at_end:
        try:
            for message in reader:
                yield frame_of(message, first_channel=int(form == ".asc"))
        except (EOFError, zlib.error, gzip.BadGzipFile):
            raise
        except Exception as error:  # noqa: BLE001 — readers raise whatever a line makes them meet
            malformed += 1
            if malformed <= LOG_FINDINGS:
                why = error if isinstance(error, CutLine) else f"it must be like {_LIKE[form]}"
                message = f"The line is no frame: {why}."
                findings.append(codes.LOG_MALFORMED.finding(message, str(path), lines.number, 1))
    too_long = "The line is too long to be a frame."
    findings += [codes.LOG_MALFORMED.finding(too_long, str(path), number, 1) for number in lines.too_long]
    if malformed > LOG_FINDINGS:
        message = f"{malformed - LOG_FINDINGS:,} more lines are no frames."
        findings.append(codes.LOG_MALFORMED.finding(message, str(path)))


_LIKE = {
    ".log": "`(0.100000) can0 1A0#0102`",
    ".asc": "`0.100000 1 1A0 Rx d 2 01 02`",
}
"""A frame of each form."""


def _reader(form: str, lines: LogLines) -> Any:
    try:
        from can.io import ASCReader, CanutilsLogReader
    except ImportError:
        raise UsageError(NEEDED) from None
    return (ASCReader if form == ".asc" else CanutilsLogReader)(cast("Any", lines))


# -- bytes --------------------------------------------------------------------------------------------------------


def _read_bytes(path: Path, _form: str, file: IO[bytes], findings: list[Finding]) -> Iterator[Frame | Passed]:
    from sigcat.gateway.blf_log import BlfLog, CutLog, DamagedLog, NoLog

    try:
        for message in BlfLog(cast("BufferedReader", file)):
            yield frame_of(message, first_channel=1)
    except NoLog as error:
        findings.append(
            _no_log(path, f"The file must be a BLF log: {error}.", "Name the file that the tool has logged.")
        )
    except CutLog as error:
        findings.append(_ends_early(path, str(error)))
    except DamagedLog as error:
        findings.append(_damaged(path, str(error)))


def frame_of(message: Any, *, first_channel: int = 0) -> Frame | Passed:
    """A message of python-can as a frame. Channels of Vector's logs begin at 1, and python-can counts them from 0."""
    if message.is_error_frame:
        return Passed("error")
    if message.is_remote_frame:
        return Passed("remote")
    number = message.channel
    channel = "" if number is None else str(number + first_channel if isinstance(number, int) else number)
    return Frame(
        in_nanoseconds(message.timestamp), message.arbitration_id, message.is_extended_id, bytes(message.data), channel
    )


def in_nanoseconds(seconds: float) -> int:
    """A time of python-can, which is a double: the decimal that was logged, as near as a double holds it."""
    return round(seconds * 1e9) if -_COARSE < seconds < _COARSE else round(seconds * 1e6) * 1000
