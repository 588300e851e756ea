"""Parses C and C++ with libclang in a separate process: a request and its answer are JSON.

The request, on standard input, has `texts` (by path; nothing else is read), `units` (paths to parse, each with its
language), `folders` (in which headers are searched), `target` (of clang), `definitions` (of the preprocessor), `megabytes`
(of memory), `seconds` and `declarations`, which is false if only errors are asked for. The answer, on standard output, is
`Declarations`, with the names of its fields.

`python -P -m sigcat.function.c_project.libclang.worker`; nothing else imports this room, as libclang may not be installed.
"""

import json
import sys
from collections.abc import Iterator, Mapping
from contextlib import suppress
from ctypes import c_double, c_int, c_longlong, c_uint, c_void_p
from pathlib import Path
from typing import Any

from clang import cindex
from clang.cindex import Cursor

from sigcat.function.c_project.libclang.answer import ROOT, Answer, Json, inside
from sigcat.function.c_project.libclang.read_declarations import read_declarations

_SYSTEM = "/sigcat-system/"
_SYSTEM_HEADERS = Path(__file__).with_name("system_headers")
"""Parts of headers of the system that declarations need; other headers of the system are skipped.

They include the types of Simulink, which many projects do not pass on. A file of the project takes precedence."""
_KEEP_GOING = 0x200
_ERROR = 3
_MOST_ERRORS = 200


def main() -> None:
    """Answer the request."""
    request = json.load(sys.stdin)
    _bound(request["megabytes"], request["seconds"])
    _declare_calls()
    answer, seen = Answer(), set[str]()
    index = cindex.Index.create()
    system_headers = {each.name: each.read_text("utf-8") for each in _SYSTEM_HEADERS.iterdir()}
    for path, language in request["units"]:
        unit = _parse(index, path, language, request, system_headers)
        _note_includes(unit, answer)
        answer.errors += _errors(unit)
        if request["declarations"]:
            seen |= read_declarations(unit.cursor, seen, answer)
    json.dump(vars(answer), sys.stdout)


def _declare_calls() -> None:
    """Calls of libclang that its Python module leaves out."""
    for name, argument, result in (
        ("clang_Cursor_isFunctionInlined", Cursor, c_uint),
        ("clang_getCursorBinaryOperatorKind", Cursor, c_int),
        ("clang_getCursorUnaryOperatorKind", Cursor, c_int),
        ("clang_Cursor_Evaluate", Cursor, c_void_p),
        ("clang_EvalResult_getKind", c_void_p, c_int),
        ("clang_EvalResult_getAsLongLong", c_void_p, c_longlong),
        ("clang_EvalResult_getAsDouble", c_void_p, c_double),
        ("clang_EvalResult_dispose", c_void_p, None),
    ):
        function = getattr(cindex.conf.lib, name)
        function.argtypes, function.restype = [argument], result


def _bound(megabytes: int, seconds: int) -> None:
    """Bound memory, and the time too: whoever asked may have been killed."""
    with suppress(ImportError, ValueError, OSError):  # not every system has it
        import resource

        resource.setrlimit(resource.RLIMIT_AS, (megabytes << 20, megabytes << 20))
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))


def _parse(index: Any, path: str, language: str, request: Json, system_headers: Mapping[str, str]) -> Any:
    folders = [f"-I{ROOT}{folder}" for folder in request["folders"]]
    options = ["-nostdinc", "-w", "-ferror-limit=0", f"--target={request['target']}", "-isystem", _SYSTEM]
    options += ["-ftemplate-depth=64", "-fconstexpr-depth=64", "-fbracket-depth=256"]
    options += [f"-D{definition}" for definition in request["definitions"]]
    texts = [(ROOT + name, text) for name, text in request["texts"].items()]
    texts += [(_SYSTEM + name, text) for name, text in system_headers.items()]
    return index.parse(ROOT + path, ["-x", language, *options, *folders], texts, _KEEP_GOING)


def _errors(unit: Any) -> Iterator[Json]:
    errors = (each for each in unit.diagnostics if each.severity >= _ERROR)
    for each, _ in zip(errors, range(_MOST_ERRORS), strict=False):
        file = each.location.file.name if each.location.file else ""
        yield {
            "message": each.spelling,
            "place": {"file": inside(file), "line": each.location.line},
            "column": each.location.column,
            "is_own": each.category_name == "User-Defined Issue",
            "is_syntax": each.category_name == "Parse Issue",
        }


def _note_includes(unit: Any, answer: Answer) -> None:
    for each in unit.get_includes():
        included = answer.included.setdefault(inside(each.source.name), [])
        if (path := inside(each.include.name)) and path not in included:
            included.append(path)


if __name__ == "__main__":
    main()
