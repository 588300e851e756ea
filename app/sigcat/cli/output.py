"""Write results: to standard output, or to a file that appears whole or not at all."""

import errno
import os
import sys
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from io import BytesIO, FileIO
from pathlib import Path
from typing import BinaryIO

from sigcat.cli.ended_by_signals import ended_by_signals
from sigcat.errors import InputRefused, UsageError, must_be_a_file
from sigcat.findings import Finding
from sigcat.text_lines import lines_of

_WRITABLE = 0o222
_MOST_BYTES = 10_000_000
"""Size of a file whose lines are printed with its errors."""


def write_text(text: str, output: Path | None) -> None:
    """Write `text`, as UTF-8 with `\\n` at the ends of lines, to `output` or to standard output."""
    if output is None or str(output) == "-":
        encoding = sys.stdout.encoding or "utf-8"
        with suppress(AttributeError, OSError, ValueError):  # no file, or no such thing here
            os.set_blocking(sys.stdout.fileno(), True)  # a slow reader is waited for; some build servers ask not to
        sys.stdout.write(text.encode(encoding, "backslashreplace").decode(encoding))
    else:
        write_bytes(text.encode("utf-8", "backslashreplace"), output)


def discard_output() -> None:
    """Let the rest of the output go nowhere: its reader has gone, as `head` does, and Python would complain at exit."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def write_bytes(data: bytes, output: Path | None) -> None:
    """Write `data` to `output`, or to standard output.

    A regular file is replaced when the new one is complete, through links too. One with several names (hard links), or in a
    folder that may not be written, gets the new content in place. A device or a pipe is written to. Missing folders are
    created.
    """
    with opened(output) as file:
        file.write(data)


def write_lines(lines: Iterable[str], output: Path | None) -> None:
    """Write lines as they come, however many: to standard output, or to a file that appears when all are there."""
    if output is None or str(output) == "-":
        sys.stdout.writelines(lines)
        return
    with opened(output) as file:
        file.writelines(line.encode() for line in lines)


@contextmanager
def opened(output: Path | None) -> Iterator[BinaryIO]:
    """Open standard output, or a file that appears when the block ends without an error, as `write_bytes` does."""
    if output is None or str(output) == "-":
        sys.stdout.flush()
        yield sys.stdout.buffer
        return
    if output.is_dir():
        raise UsageError(must_be_a_file(output))
    is_regular = output.is_file() or not output.exists()
    with _replacing(_target(output)) if is_regular else output.open("wb") as file:
        yield file


def _target(output: Path) -> Path:
    """The regular file to write, links followed. Its folder is created, unless a link leads to one that is missing."""
    target = Path(os.path.realpath(output))
    if output.is_symlink() and not target.parent.is_dir():
        raise UsageError(f"{output} leads to {target.parent}: there is no such folder")
    make_folder(target.parent)
    return target


def make_folder(folder: Path) -> None:
    """Create the folder to write to, and those above it. Raises UsageError if a file is in the way."""
    for path in (folder, *folder.parents):
        if path.exists():
            if not path.is_dir():
                raise UsageError(f"{path} must be a folder, not a file")
            break
    folder.mkdir(parents=True, exist_ok=True)


@contextmanager
def _replacing(target: Path) -> Iterator[BinaryIO]:
    """A file that takes the place of another one when the block ends without an error."""
    from sigcat.temporary_files import fragment_of, is_locked_here, remove_fragments

    temporary = fragment_of(target)
    with _named_as(target), ended_by_signals():
        if _is_written_in_place(target):
            with _in_place(target) as file:
                yield file
            return
        try:
            remove_fragments(target)
            with temporary.open("xb") as file:
                is_locked_here(file.fileno())  # as long as it is open: others leave it alone
                yield file
            if target.exists():
                temporary.chmod(target.stat().st_mode & 0o777)
            _put_in_place(temporary, target)
        finally:
            temporary.unlink(missing_ok=True)


def _is_written_in_place(target: Path) -> bool:
    """Whether a file keeps its place: it has other names, or its folder may not be written. Raises UsageError if it is read-only."""
    if not target.exists():
        return False
    status = target.stat()
    if not os.access(target, os.W_OK) or not status.st_mode & _WRITABLE:  # root may write all, and should not
        raise UsageError(f"{target} is read-only: run `chmod u+w` on it, or name another file")
    return status.st_nlink > 1 or not os.access(target.parent, os.W_OK)


@contextmanager
def _in_place(target: Path) -> Iterator[BinaryIO]:
    """A file that keeps its place: its content is replaced at the end, and put back if that fails."""
    made = BytesIO()
    yield made
    before = target.read_bytes()
    with target.open("r+b", buffering=0) as file:
        try:
            _overwrite(file, made.getvalue())
        except BaseException:
            _overwrite(file, before)  # needs no more room than it has
            raise


def _overwrite(file: FileIO, data: bytes) -> None:
    file.seek(0)
    left = memoryview(data)
    while left:
        left = left[file.write(left) :]
    file.truncate(len(data))


@contextmanager
def _named_as(target: Path) -> Iterator[None]:
    """Name the file that the user knows in errors of a temporary one beside it, and in those that name none: no space left."""
    try:
        yield
    except OSError as error:
        if error.filename is None or Path(str(error.filename)).name.startswith(f".{target.name}."):
            raise OSError(error.errno, error.strerror, str(target)) from error
        raise


def _put_in_place(temporary: Path, target: Path) -> None:
    import shutil

    try:
        temporary.replace(target)
    except OSError as error:
        if error.errno != errno.EBUSY:  # a single file that is mounted into a container cannot be replaced
            raise
        shutil.copyfile(temporary, target)


def could_not_run(error: InputRefused) -> UsageError:
    """Error of a command whose configuration or rules cannot be used; the findings are printed."""
    print_findings(error.findings)
    return UsageError(str(error))


def print_findings(findings: Iterable[Finding]) -> None:
    """Print each finding to standard error; below an error its line, as `sigcat lint` does."""
    listed = tuple(findings)
    sources = _sources_of_errors(listed)
    for finding in listed:
        print(finding.line_of_text, file=sys.stderr)
        if finding.severity == "error" and finding.file in sources:
            from sigcat.rules.reports.text import excerpt

            print(excerpt(finding, sources[finding.file]), end="", file=sys.stderr)


def _sources_of_errors(findings: Iterable[Finding]) -> Mapping[str, Sequence[str]]:
    """Lines of the files with errors. Most commands have none, and load nothing for them."""
    errors = [each for each in findings if each.severity == "error" and _is_small_file(each.file)]
    if not errors:
        return {}
    from sigcat.rules.report import sources_of

    return {name: lines_of(text) for name, text in sources_of(errors).items()}


def _is_small_file(name: str) -> bool:
    """Whether a file can be read for its lines: a pipe would block, and a trace may be larger than memory."""
    try:
        return Path(name).is_file() and Path(name).stat().st_size <= _MOST_BYTES
    except (OSError, ValueError):
        return False
