"""Problems of a log: exceptions of its readers, and the findings that they become."""

from pathlib import Path

from sigcat import codes
from sigcat.findings import Finding
from sigcat.limits import LOG_FINDINGS


class NoLog(Exception):
    """The file is something else; the text says why."""

    def __init__(self, why: str, fix: str = "") -> None:
        super().__init__(why)
        self.fix = fix


class CutLog(Exception):
    """The log ends before it says that it does; the text says where."""


class DamagedLog(Exception):
    """The rest cannot be read; the text says why."""


class CutLine(ValueError):
    """A line that was cut, or is damaged, within its data."""


def ends_early(path: Path, why: str) -> Finding:
    """A log that ends before its end."""
    message = f"The log ends in the middle: {why}."
    return codes.LOG_MALFORMED.finding(message, str(path), fix="What comes before it was read.")


def damaged(path: Path, why: str) -> Finding:
    """A log of which the rest is there, and is lost."""
    message = f"The log is damaged: {why}. What follows was not read."
    return codes.LOG_MALFORMED.graded("error").finding(
        message, str(path), fix="Record it again, or repair it with its tool."
    )


def no_log(path: Path, message: str, fix: str) -> Finding:
    """A file that is something else."""
    return codes.LOG_MALFORMED.graded("error").finding(message, str(path), fix=fix)


class MalformedLines:
    """Findings of lines that are not frames, the same one at most a hundred times."""

    def __init__(self, path: Path, form: str, findings: list[Finding]) -> None:
        self._path = str(path)
        self._form = form
        self._findings = findings
        self._count = 0

    def add(self, line: int, error: Exception) -> None:
        """A line that cannot be read."""
        self._count += 1
        if self._count <= LOG_FINDINGS:
            why = error if isinstance(error, CutLine) else f"it must be like {LIKE[self._form]}"
            self._findings.append(codes.LOG_MALFORMED.finding(f"The line is not a frame: {why}.", self._path, line, 1))

    def close(self, too_long: list[int], uncut: int | None) -> None:
        """Return the findings at the end: lines that are too long, and a last line without an end."""
        text = "The line is too long to be a frame."
        self._findings += [codes.LOG_MALFORMED.finding(text, self._path, number, 1) for number in too_long]
        if uncut is not None:
            text = "The last line has no line break: the log may have been cut there. Its frame was read."
            self._findings.append(codes.LOG_MALFORMED.finding(text, self._path, uncut, 1))
        if self._count > LOG_FINDINGS:
            text = f"{self._count - LOG_FINDINGS:,} more lines are not frames."
            self._findings.append(codes.LOG_MALFORMED.finding(text, self._path))


LIKE = {
    ".log": "`(0.100000) can0 1A0#0102`",
    ".asc": "`0.100000 1 1A0 Rx d 2 01 02`",
    ".csv": "`0.1,0x1a0,0,0,0,2,AQI=`",
    ".trc": "`1 100.000 DT 1 01A0 Rx - 2 01 02`, in the columns that the header names",
}
"""A frame of each form that is text."""
