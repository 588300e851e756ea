"""Commands of a build: one that compiles each file, and one that links them."""

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

from sigcat.adapter.core.core_files import RUNTIME_SOURCE
from sigcat.adapter.host.connections import Member
from sigcat.adapter.toolchain import EXACT, Toolchain
from sigcat.function.function_json.code import CodeInterface

_CPP = frozenset((".cc", ".cpp", ".cxx", ".c++"))
_FLAGS = ("-c", "-O2", "-g", *EXACT)
"""`-g`: the linker says at which line a symbol is missing."""
WARNS = "-Wall"
"""Flag of the code of functions, whose warnings are reported; generated code has its tests."""
_DECLARED = "-Werror=implicit-function-declaration"
"""A function without a declaration would return an `int`, whatever it returns: newer compilers of C refuse it by default."""
_OF_CORE = ("-Werror=incompatible-pointer-types", "-Werror=int-conversion", _DECLARED)
"""Checks that older compilers of C do not make by default."""


class Compilation(NamedTuple):
    """A file, and the command that compiles it."""

    member: int | None
    """The function that it belongs to; None: the driver."""
    source: Path
    output: Path
    command: tuple[str, ...]


def is_cpp(source: Path) -> bool:
    """Whether a source is C++."""
    return source.suffix in _CPP or source.suffix == ".C"


def compilations(
    members: Sequence[Member], folder: Path, tools: Toolchain, own: Sequence[str] = ()
) -> Iterator[Compilation]:
    """Commands that compile. Generated files are in the folder, and compiled ones are written there.

    `own` are further flags for the code of functions.
    """
    for name in ("sigcat_driver.c", "sigcat_tables.c", RUNTIME_SOURCE):
        yield _compilation(None, folder / name, folder / f"{name}.o", (), tools)
    for index, member in enumerate(members):
        yield from _of_member(index, member, folder, tools, own)


def _of_member(index: int, member: Member, folder: Path, tools: Toolchain, own: Sequence[str]) -> Iterator[Compilation]:
    code = member.function.function.code or CodeInterface(signature="")
    flags = (*_definitions(code), *_folders(code, member, folder))
    for kind in ("adapter", "driver"):
        found = next(path for path in folder.glob(f"{member.name}_{kind}.*") if path.suffix in (".c", ".cpp"))
        strict = () if is_cpp(found) else _OF_CORE
        yield _compilation(index, found, folder / f"{found.name}.o", (*strict, *flags), tools)
    for number, source in enumerate(code.sources or ()):
        path = member.folder / source
        declared = (WARNS,) if is_cpp(path) else (WARNS, _DECLARED)
        yield _compilation(index, path, folder / f"{member.name}.{number}.o", (*declared, *flags, *own), tools)


def _compilation(member: int | None, source: Path, output: Path, flags: Sequence[str], tools: Toolchain) -> Compilation:
    compiler = tools.compiler(is_cpp=is_cpp(source))
    command = (*compiler, *_FLAGS, *flags, "-o", str(output), str(source.absolute()))
    return Compilation(member, source, output, command)


def _definitions(code: CodeInterface) -> list[str]:
    return [f"-D{each.as_option}" for each in code.definitions or ()]


def _folders(code: CodeInterface, member: Member, folder: Path) -> list[str]:
    """Folders of headers: those of the declaration, then the generated ones."""
    own = [member.folder, *(member.folder / each for each in code.include_folders or ())]
    return [f"-I{each.absolute()}" for each in (*own, folder)]


def linking(
    compiled: Sequence[Compilation], program: Path, tools: Toolchain, flags: Sequence[str] = ()
) -> tuple[str, ...]:
    """The command that links everything."""
    linker = tools.compiler(is_cpp=any(is_cpp(each.source) for each in compiled))
    return (*linker, "-o", str(program), *(str(each.output) for each in compiled), *flags, "-lm")
