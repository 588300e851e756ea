"""Headers that replace names of the generated code: the cause of errors that a compiler reports anywhere."""

import re
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from sigcat import codes
from sigcat.adapter.core.core_files import core_files
from sigcat.adapter.core.plan import CorePlan
from sigcat.adapter.core.planned_core import derive
from sigcat.errors import InputRefused
from sigcat.findings import Finding
from sigcat.function.c_project.files import headers_of
from sigcat.function.code_files import missing_files
from sigcat.function.code_variables import unfit_code
from sigcat.function.function_json.code import CodeInterface, is_inside
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.function.function_json.variables import variables
from sigcat.reserved_words import C_KEYWORDS

_COMMENT = re.compile(r"/\*.*?\*/|//[^\n]*", re.DOTALL)
_STRING = re.compile(r'"(?:[^"\\\n]|\\.)*"')
_NAME = re.compile(r"\b[A-Za-z_]\w*", re.ASCII)
_MACRO = re.compile(
    r"^[ \t]*#[ \t]*define[ \t]+(?P<name>[A-Za-z_]\w*)(?P<arguments>\()?[ \t]*(?P<text>[^\n]*)", re.MULTILINE | re.ASCII
)
_WORD = re.compile(r"^[ \t]*typedef\b[^;{}]*\b(?P<name>bool|true|false)[ \t]*;", re.MULTILINE)
_OWN = re.compile(r"^[ \t]*#[ \t]*(?:include|define|undef|ifdef|ifndef|if|elif)\b[^\n]*", re.MULTILINE)
_CONDITION = re.compile(r"[ \t]*#[ \t]*(?P<word>if|ifdef|ifndef|endif)\b")
_UNDEFINED = re.compile(r"^[ \t]*#[ \t]*undef[ \t]+([A-Za-z_]\w*)", re.MULTILINE | re.ASCII)


class _Clash(NamedTuple):
    """A name that a header defines."""

    finding: Finding
    is_certain: bool
    """Whether no condition and no later line of the header decides, and the generated code cannot have it as it is."""


def code_problems(function: ResolvedFunction) -> Iterator[Finding]:
    """Findings about the files of the code beside a declaration: those that are missing, types of variables, functions, replaced names."""
    yield from missing_files(function)
    yield from unfit_code(function)
    code = function.function.code
    if code is not None and function.origin is not None and code.headers:
        yield from _certain_clashes(function)


def _certain_clashes(function: ResolvedFunction) -> Iterator[Finding]:
    try:
        plan = derive(function).plan
    except InputRefused:  # which a finding of lint explains, or the command that generates
        return
    made = core_files(plan)
    text = f"{made.header.data.decode()}\n{made.source.data.decode()}"
    folder = Path(function.document.name).parent
    yield from (each.finding for each in _clashes(function, plan, folder, text) if each.is_certain)


def clashes(function: ResolvedFunction, plan: CorePlan, folder: Path, generated: str) -> Iterator[Finding]:
    """A finding at each line of a header that defines a name which the generated code has for something else."""
    yield from (each.finding for each in _clashes(function, plan, folder, generated))


def _clashes(function: ResolvedFunction, plan: CorePlan, folder: Path, generated: str) -> Iterator[_Clash]:
    code = function.function.code or CodeInterface(signature="")
    if not all(map(is_inside, (*(code.headers or ()), *(code.include_folders or ())))):
        return
    headers = headers_of(folder, code.headers or (), code.include_folders or ()) or {}
    meant = {name for each in variables(function.function) for name in _NAME.findall(each.expression)}
    bare = _bare(generated)
    used = set(_NAME.findall(bare)) - meant - {call.symbol for call in plan.calls}
    for path, text in headers.items():
        yield from _of_header(str(folder / path), text, used, bare)


def _of_header(file: str, text: str, used: set[str], generated: str) -> Iterator[_Clash]:
    bare = _COMMENT.sub(lambda match: "\n" * match[0].count("\n"), text)
    conditional, undefined = _conditional_lines(bare), set(_UNDEFINED.findall(bare))
    for match in _MACRO.finditer(bare):
        if match["name"] in used:
            message = f"The macro {match['name']!r} replaces a name of the generated code."
            fix = f"Rename it, or add `#undef {match['name']}` at the end of the header."
            line = _line(bare, match.start("name"))
            is_certain = line not in conditional and match["name"] not in undefined and _breaks(match, generated)
            yield _Clash(codes.HEADER_REPLACES_NAME.finding(message, file, line, fix=fix), is_certain)
    for match in _WORD.finditer(bare):
        message = f"The header must take {match['name']!r} from <stdbool.h>, which the adapter includes before."
        fix = f"Write `#ifndef {match['name']}` around the typedef, or name the type otherwise."
        line = _line(bare, match.start("name"))
        yield _Clash(codes.HEADER_REPLACES_NAME.finding(message, file, line, fix=fix), line not in conditional)


def _breaks(macro: re.Match[str], generated: str) -> bool:
    """Whether what the macro becomes cannot be in place of a name: another name is the same everywhere."""
    if macro["arguments"]:
        return re.search(rf"\b{macro['name']}[ \t]*\(", generated) is not None
    text = macro["text"].strip()
    return not _NAME.fullmatch(text) or text in C_KEYWORDS


def _conditional_lines(bare: str) -> set[int]:
    """Lines within a condition of the preprocessor, but for that of a guard around the whole header."""
    found: set[int] = set()
    words = [(number, _CONDITION.match(line)) for number, line in enumerate(bare.split("\n"), 1)]
    first = next((number for number, line in enumerate(bare.split("\n"), 1) if line.strip()), 0)
    depth, base = 0, 0
    for number, match in words:
        if match and match["word"] == "endif":
            depth -= 1
        elif match:
            depth += 1
            base = 1 if match["word"] == "ifndef" and number == first else base
        if depth > base:
            found.add(number)
    return found


def _bare(generated: str) -> str:
    """Generated code without comments, texts and what it defines itself."""
    return _OWN.sub("", _STRING.sub("", _COMMENT.sub("", generated)))


def _line(text: str, at: int) -> int:
    return text.count("\n", 0, at) + 1
