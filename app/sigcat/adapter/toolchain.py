"""The C and C++ compiler: the one that CC and CXX name, the system's, or the one of PyPI."""

import os
import shlex
import shutil
import sys
from collections.abc import Mapping
from importlib.util import find_spec
from typing import NamedTuple

from sigcat.errors import UsageError

EXACT = ("-ffp-contract=off",)
"""Flags that keep a product and a sum as two roundings: part of every command that compiles a core."""

_PAIRS = (("gcc", "g++"), ("clang", "clang++"), ("cc", "c++"))
_ZIG = "ziglang"
_MISSING = "No C compiler found. Install gcc or clang, or run `pip install 'sigcat[simulate]'`, or name one in CC."


class Toolchain(NamedTuple):
    """Commands that compile C and C++, to which flags and files are added."""

    c: tuple[str, ...]
    cpp: tuple[str, ...]
    """The C++ compiler of the same maker, unless CXX names another one; empty if there is none."""

    def compiler(self, *, is_cpp: bool) -> tuple[str, ...]:
        """The one for a language. Raises UsageError if there is none."""
        if is_cpp and not self.cpp:
            raise UsageError(f"No C++ compiler found next to {self.c[0]!r}. Name one in CXX.")
        return self.cpp if is_cpp else self.c

    @property
    def is_zig(self) -> bool:
        """Whether it is the one of PyPI. It has no address sanitizer, and compiles for this very processor."""
        return _ZIG in self.c


def toolchain(environment: Mapping[str, str] = os.environ) -> Toolchain:
    """The compilers. Raises UsageError if there are none."""
    named = {variable: _compiler_of_variable(variable, environment) for variable in ("CC", "CXX")}
    known = [found for found in (*(_pair(c, environment) for c, _ in _PAIRS), packaged()) if found]
    c = named["CC"] or (known[0].c if known else _alone(environment))
    if c is None:
        raise UsageError(_MISSING)
    return Toolchain(c, named["CXX"] or _beside(c, known))


def packaged() -> Toolchain | None:
    """The compilers of the package `ziglang`, if it is installed."""
    if find_spec(_ZIG) is None:
        return None
    command = (sys.executable, "-m", _ZIG)
    # Undefined behaviour is a matter of tests, which ask for its detection themselves.
    return Toolchain((*command, "cc", "-fno-sanitize=undefined"), (*command, "c++", "-fno-sanitize=undefined"))


def _compiler_of_variable(variable: str, environment: Mapping[str, str]) -> tuple[str, ...] | None:
    command = tuple(shlex.split(environment.get(variable, "")))
    if command and shutil.which(command[0], path=environment.get("PATH")) is None:
        raise UsageError(f"{variable} must name a compiler, not {command[0]!r}: there is no such program.")
    return command or None


def _pair(c: str, environment: Mapping[str, str]) -> Toolchain | None:
    cpp = dict(_PAIRS)[c]
    has_both = all(shutil.which(name, path=environment.get("PATH")) for name in (c, cpp))
    return Toolchain((c,), (cpp,)) if has_both else None


def _alone(environment: Mapping[str, str]) -> tuple[str, ...] | None:
    """A compiler for C alone: many machines have gcc without g++."""
    return next(((c,) for c, _ in _PAIRS if shutil.which(c, path=environment.get("PATH"))), None)


def _beside(c: tuple[str, ...], known: list[Toolchain]) -> tuple[str, ...]:
    """The C++ compiler that belongs to a C compiler, or else any, or none."""
    same = [found.cpp for found in known if found.c[0] == c[0]]
    return next(iter([*same, *(found.cpp for found in known)]), ())
