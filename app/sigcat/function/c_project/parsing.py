"""Parse the files of a project in a separate process, within limits: the files may contain anything."""

import json
import re
import subprocess
import sys
import time
from collections.abc import Container, Iterable, Iterator, Mapping, Sequence
from importlib.util import find_spec
from math import ceil
from pathlib import Path
from typing import Any, NamedTuple

from sigcat import codes
from sigcat.errors import InputRefused, UsageError
from sigcat.findings import Finding
from sigcat.function.c_project.declarations import CompilerError, Declarations, declarations_from
from sigcat.function.c_project.files import CodeFiles
from sigcat.limits import CODE_MEGABYTES, CODE_SECONDS
from sigcat.open_files import made_once

_WORKER = "sigcat.function.c_project.libclang.worker"
_TARGETS = {
    "x86_64-unknown-linux-gnu": "64 bit, with a long of 64 bit",
    "i386-unknown-linux-gnu": "32 bit",
    "x86_64-pc-windows-msvc": "64 bit, with a long of 32 bit",
    "msp430-unknown-elf": "16 bit",
}
"""Machines by the names that clang has for them. The first one is that on which most people build."""
_CLASS = re.compile(r"^[ \t]*(?:class|namespace)\s+\w|^[ \t]*(?:public|private)\s*:", re.MULTILINE)
_COMMENT = re.compile(r"/\*.*?\*/|//[^\n]*", re.DOTALL)


class Parsed(NamedTuple):
    """Declarations of the code, on the machine for which it was made."""

    declarations: Declarations
    machine: str = ""
    """In words, where it is not one of 64 bit with a long of 64 bit."""


def parse(files: CodeFiles) -> Parsed:
    """Parse for the first machine that the code does not refuse. Raises UsageError, InputRefused."""
    if find_spec("clang") is None:
        raise UsageError("reading C code needs the extra `c`: run `pip install 'sigcat[c]'`")
    end = time.monotonic() + CODE_SECONDS
    (first, _), *others = _TARGETS.items()
    declarations = _parsed(files, first, end)
    paths = (*files.sources, *_orphans(files, declarations))
    refused = {first: len(_refusals(declarations))}
    for target, _ in others:
        if not min(refused.values()):
            break
        refused[target] = len(_refusals(_answer(files, paths, target, end, declarations=False)))
    best = min(refused, key=lambda target: refused[target])
    return Parsed(declarations) if best == first else Parsed(_parsed(files, best, end), _TARGETS[best])


def parse_unit(files: CodeFiles, path: str) -> Declarations:
    """Parse one of the files for the first machine. Raises InputRefused."""
    return _answer(files, (path,), next(iter(_TARGETS)), time.monotonic() + CODE_SECONDS)


def _refusals(declarations: Declarations) -> list[CompilerError]:
    return [error for error in declarations.errors if error.is_own]


def _parsed(files: CodeFiles, target: str, end: float) -> Declarations:
    """Parse the sources, then the headers that none of them includes."""
    found = _answer(files, files.sources, target, end)
    headers = _orphans(files, found)
    return _joined(found, _answer(files, headers, target, end)) if headers else found


def _orphans(files: CodeFiles, declarations: Declarations) -> list[str]:
    """Headers that no file includes."""
    known = {each for included in declarations.included.values() for each in included}
    return [path for path in files.texts if path not in known and path not in files.sources]


def _joined(first: Declarations, second: Declarations) -> Declarations:
    return Declarations(
        functions=(*first.functions, *second.functions),
        variables=(*first.variables, *second.variables),
        classes=(*first.classes, *second.classes),
        records={**second.records, **first.records},
        enumerations={**second.enumerations, **first.enumerations},
        errors=(*first.errors, *second.errors),
        included={**second.included, **first.included},
    )


def _answer(
    files: CodeFiles, paths: Sequence[str], target: str, end: float, *, declarations: bool = True
) -> Declarations:
    request = {
        "texts": dict(files.texts),
        "units": [(path, _language(path, files)) for path in paths],
        "folders": files.folders,
        "target": target,
        "definitions": files.definitions,
        "megabytes": CODE_MEGABYTES,
        "seconds": ceil(CODE_SECONDS),
        "declarations": declarations,
    }
    text = json.dumps(request)
    return made_once(
        ("C code", tuple(paths), target), text, lambda: declarations_from(_run(text, end - time.monotonic()))
    )


def _run(request: str, seconds: float) -> Mapping[str, Any]:
    """Run the worker. `-P`: no file in the current folder can pass for a module."""
    command = [sys.executable, "-P", "-X", "utf8", "-m", _WORKER]
    try:
        worker = subprocess.run(  # noqa: S603 - our own script
            command, input=request.encode(), capture_output=True, timeout=max(seconds, 0.001), check=False
        )
    except subprocess.TimeoutExpired:
        raise _refused(f"clang took longer than {CODE_SECONDS:g} s to parse the code; it was stopped.") from None
    if worker.returncode:
        raise _refused(f"clang could not parse the code: {_last_line(worker)}.")
    answer: Mapping[str, Any] = json.loads(worker.stdout)
    return answer


def _refused(message: str) -> InputRefused:
    finding = codes.CODE_UNPARSED.finding(message, fix="Name the folder of one model, with its headers and sources.")
    return InputRefused("the code cannot be imported", (finding,))


def _last_line(worker: "subprocess.CompletedProcess[bytes]") -> str:
    lines = worker.stderr.decode("utf-8", "replace").split("\n")
    told = next((line.strip() for line in reversed(lines) if line.strip()), "")
    if worker.returncode < 0 or "MemoryError" in told or "LLVM ERROR" in told:
        return f"it crashed or needed more than {CODE_MEGABYTES:,} MB of memory"
    return told.rstrip(".") or f"exit status {worker.returncode}"


def _language(path: str, files: CodeFiles) -> str:
    """Return the language of a file; of a header, that of the only sources, or that of its text."""
    suffix = Path(path).suffix.lower()
    if suffix != ".h":
        return "c" if suffix == ".c" else "c++"
    languages = {"c" if Path(each).suffix.lower() == ".c" else "c++" for each in files.sources}
    if languages == {"c++"} or _CLASS.search(_COMMENT.sub("", files.texts[path])):
        return "c++"
    return "c"


def missing_includes(declarations: Declarations) -> Iterator[Finding]:
    """Headers that the folder lacks, each once. Those of the system are not expected there."""
    told = set(_OF_THE_SYSTEM)
    for error in declarations.errors:
        match = _MISSING.match(error.message)
        name = match["path"] if match else ""
        if not name.endswith((".h", ".hpp")) or "/" in name or name in told:
            continue
        told.add(name)
        message = f"The folder must have {name!r}, which is included here."
        at = (error.place.file, error.place.line, error.column)
        if name in _OF_SIMULINK:
            fix = "It is a part of MATLAB, without a type of an interface; the code needs it to be compiled."
            yield codes.INCLUDE_NOT_FOUND.graded("info").finding(message, *at, fix=fix)
        else:
            fix = "Import the folder that has it too, if the interface needs its types."
            yield codes.INCLUDE_NOT_FOUND.finding(message, *at, fix=fix)


def syntax_error(errors: Iterable[CompilerError], files: Container[str]) -> CompilerError | None:
    """The first place in files that is not C. None if a header is not found: then the compiler does not know all macros."""
    known = [error for error in errors if error.place.file in files]
    if any(_MISSING.match(error.message) for error in known if not lacks_system_header(error)):
        return None
    return next((error for error in known if error.is_syntax), None)


def lacks_system_header(error: CompilerError) -> bool:
    """Whether the error is about a header of the system, which no folder of code has."""
    match = _MISSING.match(error.message)
    return match is not None and match["path"] in _OF_THE_SYSTEM


_MISSING = re.compile(r"'(?P<path>[^']*)' file not found")
_OF_THE_SYSTEM = frozenset((
    "assert.h", "complex.h", "ctype.h", "errno.h", "fenv.h", "inttypes.h", "locale.h", "math.h", "pthread.h", "sched.h",
    "semaphore.h", "setjmp.h", "signal.h", "stdarg.h", "stdatomic.h", "stdio.h", "tgmath.h", "time.h", "unistd.h", "wchar.h",
))  # fmt: skip
"""Headers of C and POSIX that sigcat has no need of."""
_OF_SIMULINK = frozenset((
    "fixedpoint.h", "rt_logging.h", "rtw_continuous.h", "rtw_matlogging.h", "rtw_solver.h", "simstruc.h", "tmwtypes.h",
))  # fmt: skip
