"""Errors of a compiler in generated code, reported at the declaration that the code was generated from."""

import re
from collections.abc import Iterator, Mapping, Sequence
from itertools import islice
from pathlib import Path
from typing import NamedTuple

from sigcat import codes
from sigcat.adapter.core.clashes import clashes
from sigcat.adapter.core.core_files import CoreFiles, runtime_files
from sigcat.adapter.files import GeneratedFile
from sigcat.adapter.host.connections import Member
from sigcat.errors import InputRefused
from sigcat.findings import Finding
from sigcat.function.document.document import Pointer
from sigcat.function.function_json.walk import parts
from sigcat.limits import COMPILER_WARNINGS
from sigcat.runs.building.commands import WARNS, Compilation
from sigcat.runs.building.diagnostics import Diagnostic, diagnostics, warnings

_CODE: Pointer = ("Code",)
"""Origin of a line of generated code that no interface causes."""


_SHARED = frozenset(file.name for file in runtime_files())
"""Files of all cores, whose macros check variables."""


class Said(NamedTuple):
    """Output of a compiler or the linker."""

    compilation: Compilation | None
    """None: the linker."""
    text: str
    has_failed: bool


class _Generated(NamedTuple):
    """A generated file, and the function that it belongs to."""

    member: Member
    file: GeneratedFile
    origins: Mapping[tuple[str, int], Pointer]

    def line(self, number: int) -> str:
        lines = self.file.data.decode().splitlines()
        return lines[number - 1] if number <= len(lines) else ""


def refused(failed: Sequence[Said], members: Sequence[Member], cores: Sequence[CoreFiles]) -> InputRefused:
    """Return the error to raise: a finding for each error, or the compiler's output if it has none of the usual form."""
    generated = {
        file.name: _Generated(member, file, core.origins)
        for member, core in zip(members, cores, strict=True) for file in (core.header, core.source)
    }  # fmt: skip
    told = [tuple(_causes(said, members)) or tuple(_findings(said, members, generated)) for said in failed]
    findings = tuple(dict.fromkeys(finding for each in told for finding in each))  # the first error causes others
    words = "" if findings else f"\n{failed[0].text.strip()}"
    return InputRefused(f"The functions cannot be run: {_doing(failed[0], generated)} failed.{words}", findings)


def warned(said: Sequence[Said], members: Sequence[Member]) -> Iterator[Finding]:
    """A note for each warning about code of the functions; of very many, the first ones."""
    of_code = (each for each in said if each.compilation is not None and WARNS in each.compilation.command)
    found = dict.fromkeys(each for one in of_code for each in warnings(one.text))
    for each in islice(found, COMPILER_WARNINGS):
        message = _sentence(each.message, "compiler")
        yield codes.COMPILER_WARNING.finding(message, _as_given(each.file, members), each.line, each.column)


def _causes(said: Said, members: Sequence[Member]) -> Iterator[Finding]:
    """Names that headers replace, if generated code does not compile: these explain all errors there."""
    one = said.compilation
    if one is None or one.member is None or not one.source.stem.endswith(("_adapter", "_driver")):
        return
    member = members[one.member]
    header = one.source.with_name(member.plan.header_file)
    yield from clashes(member.function, member.plan, member.folder, f"{header.read_text()}\n{one.source.read_text()}")


def _doing(said: Said, generated: Mapping[str, _Generated]) -> str:
    if said.compilation is None:
        return "linking"
    source = said.compilation.source
    return f"compiling the adapter {source.name}" if source.name in generated else f"compiling {source}"


def _findings(said: Said, members: Sequence[Member], generated: Mapping[str, _Generated]) -> Iterator[Finding]:
    placed = [(found, generated.get(Path(found.file).name)) for found in diagnostics(said.text)]
    pointers = [_pointer(found, file) if file else () for found, file in placed]
    is_linked = said.compilation is None
    has_interfaces = any(pointer not in ((), _CODE) for pointer in pointers)
    for (found, file), pointer in zip(placed, pointers, strict=True):
        message = _sentence(found.message, "linker" if is_linked else "compiler")
        is_shared = Path(found.file).name in _SHARED
        if has_interfaces and (is_shared or (file is not None and pointer == _CODE)):
            continue  # an assertion about a variable that is wrong, which is reported at its interface
        if is_shared and said.compilation is not None and said.compilation.member is not None:
            function = members[said.compilation.member].function
            yield function.finding(codes.CODE_UNFIT, _CODE, message, "Correct the code, or its declaration.")
            continue
        if file is not None:
            fix = (
                "Define it in a file of `sources`, or correct this line."
                if is_linked
                else "Correct this line, or the code."
            )
            yield file.member.function.finding(codes.CODE_UNFIT, pointer, message, fix)
        else:
            yield codes.CODE_NOT_COMPILED.finding(message, _as_given(found.file, members), found.line, found.column)


def _as_given(file: str, members: Sequence[Member]) -> str:
    """A file beside a declaration, as seen from where the user is."""
    path = Path(file)
    folders = (member.folder for member in members if path.is_relative_to(member.folder.absolute()))
    return next((str(folder / path.relative_to(folder.absolute())) for folder in folders), file)


def _sentence(message: str, tool: str) -> str:
    """Without the option that made it an error."""
    text = re.sub(r" \[-W[^]]*\]$", "", message)
    return f"The {tool} says: {text}{'' if text.endswith(('?', '.')) else '.'}"


# -- where it was declared ----------------------------------------------------------------------------------------


def _pointer(found: Diagnostic, file: _Generated) -> Pointer:
    """Return the origin of a line: the expression in C of an interface, if the line has it; else the code."""
    pointer = file.origins.get((file.file.name, found.line), _CODE)
    item = next((item for at, item in parts(file.member.function.function) if at == pointer), None)
    line = file.line(found.line)
    for name, info in type(item).model_fields.items() if item else ():
        value = getattr(item, name)
        if isinstance(value, str) and (name.endswith("variable") or name == "symbol") and value in line:
            return (*pointer, info.alias or name)
    return pointer
