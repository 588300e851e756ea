"""The compilers of this machine: those that CC and CXX name, else gcc or clang, else the one that PyPI has."""

import os
import shlex
import shutil
import sys
from collections.abc import Mapping
from importlib.util import find_spec
from typing import Literal, NamedTuple

from sigcat.errors import UsageError

Language = Literal["C", "C++"]
Command = tuple[str, ...]


class _Names(NamedTuple):
    variable: str
    """Environment variable that names the compiler."""
    programs: tuple[str, ...]
    zig: str
    """What ziglang calls it."""


_NAMES: Mapping[Language, _Names] = {
    "C": _Names("CC", ("cc", "gcc", "clang"), "cc"),
    "C++": _Names("CXX", ("c++", "g++", "clang++"), "c++"),
}


def compiler(language: Language, environment: Mapping[str, str] = os.environ) -> Command:
    """The command that compiles and links. Raises UsageError if there is none."""
    names = _NAMES[language]
    if named := shlex.split(environment.get(names.variable, "")):
        return _named(named, names.variable, environment)
    for program in names.programs:
        if found := shutil.which(program, path=environment.get("PATH", "")):
            return (found,)
    if find_spec("ziglang") is not None:
        return (sys.executable, "-m", "ziglang", names.zig)
    advice = f"install gcc or clang, or run `pip install ziglang`; {names.variable} may name another one"
    raise UsageError(f"there is no {language} compiler: {advice}")


def _named(command: list[str], variable: str, environment: Mapping[str, str]) -> Command:
    """A compiler that the user names, perhaps with arguments: `CC="ccache gcc"`."""
    if shutil.which(command[0], path=environment.get("PATH", "")) is None:
        raise UsageError(f"{variable} must name a compiler: {command[0]!r} cannot be run")
    return tuple(command)
