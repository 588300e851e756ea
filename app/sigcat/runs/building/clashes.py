"""Headers that replace names of the generated code: the cause of errors that a compiler reports anywhere."""

import re
from collections.abc import Iterator

from sigcat import codes
from sigcat.findings import Finding
from sigcat.function.c_project.files import headers_of
from sigcat.function.function_json.code import CodeInterface
from sigcat.function.function_json.variables import variables
from sigcat.runs.connections import Member

_COMMENT = re.compile(r"/\*.*?\*/|//[^\n]*", re.DOTALL)
_STRING = re.compile(r'"(?:[^"\\\n]|\\.)*"')
_NAME = re.compile(r"\b[A-Za-z_]\w*", re.ASCII)
_MACRO = re.compile(r"^[ \t]*#[ \t]*define[ \t]+(?P<name>[A-Za-z_]\w*)", re.MULTILINE | re.ASCII)
_WORD = re.compile(r"^[ \t]*typedef\b[^;{}]*\b(?P<name>bool|true|false)[ \t]*;", re.MULTILINE)
_OWN = re.compile(r"^[ \t]*#[ \t]*(?:include|define|undef|ifdef|ifndef|if|elif)\b[^\n]*", re.MULTILINE)


def clashes(member: Member, generated: str) -> Iterator[Finding]:
    """A finding at each line of a header that defines a name which the generated code has for something else."""
    code = member.function.function.code or CodeInterface(signature="")
    headers = headers_of(member.folder, code.headers or (), code.include_folders or ()) or {}
    meant = {name for each in variables(member.function.function) for name in _NAME.findall(each.expression)}
    used = set(_NAME.findall(_bare(generated))) - meant - {call.symbol for call in member.plan.calls}
    for path, text in headers.items():
        yield from _of_header(str(member.folder / path), text, used)


def _of_header(file: str, text: str, used: set[str]) -> Iterator[Finding]:
    bare = _COMMENT.sub(lambda match: "\n" * match[0].count("\n"), text)
    for match in _MACRO.finditer(bare):
        if match["name"] in used:
            message = f"The macro {match['name']!r} replaces a name of the generated code."
            fix = f"Rename it, or add `#undef {match['name']}` at the end of the header."
            yield codes.CODE_NOT_COMPILED.finding(message, file, _line(bare, match.start("name")), fix=fix)
    for match in _WORD.finditer(bare):
        message = f"The header must take {match['name']!r} from <stdbool.h>, which the adapter includes before."
        fix = f"Write `#ifndef {match['name']}` around the typedef, or name the type otherwise."
        yield codes.CODE_NOT_COMPILED.finding(message, file, _line(bare, match.start("name")), fix=fix)


def _bare(generated: str) -> str:
    """Generated code without comments, texts and what it defines itself."""
    return _OWN.sub("", _STRING.sub("", _COMMENT.sub("", generated)))


def _line(text: str, at: int) -> int:
    return text.count("\n", 0, at) + 1
