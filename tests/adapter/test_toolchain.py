"""Choice of the compiler."""

import sys

import pytest

from sigcat.adapter import toolchain as module
from sigcat.adapter.toolchain import Toolchain, packaged, toolchain
from sigcat.errors import UsageError

ZIG = (sys.executable, "-m", "ziglang")


@pytest.fixture
def machine(tmp_path, monkeypatch):
    """A machine with these programs, and with or without the package."""

    def made(*programs, has_package=False, **variables):
        monkeypatch.setattr(module, "find_spec", lambda _: object() if has_package else None)
        for name in programs:
            (tmp_path / name).write_text("#!/bin/sh\n")
            (tmp_path / name).chmod(0o755)
        return {"PATH": str(tmp_path), **variables}

    return made


@pytest.mark.parametrize(
    ("programs", "variables", "expected"),
    [
        (("gcc", "g++", "clang", "clang++"), {}, (("gcc",), ("g++",))),
        (("gcc", "clang", "clang++"), {}, (("clang",), ("clang++",))),
        (("cc", "c++"), {}, (("cc",), ("c++",))),
        (("gcc", "g++", "clang", "clang++"), {"CC": "clang"}, (("clang",), ("clang++",))),
        (("gcc", "g++", "other"), {"CC": "other -m32"}, (("other", "-m32"), ("g++",))),
        (("gcc", "g++", "other"), {"CXX": "other"}, (("gcc",), ("other",))),
        (("gcc", "g++"), {"CC": ""}, (("gcc",), ("g++",))),
        (("gcc",), {}, (("gcc",), ())),
        (("tcc",), {"CC": "tcc"}, (("tcc",), ())),
    ],
)
def test_the_one_that_is_named_or_a_systems(machine, programs, variables, expected):
    assert toolchain(machine(*programs, **variables)) == Toolchain(*expected)


def test_else_the_one_of_pypi(machine):
    found = toolchain(machine(has_package=True))
    assert (found.c[:3], found.cpp[:3], found.is_zig) == (ZIG, ZIG, True)
    assert toolchain(machine("gcc", "g++", has_package=True)) == (("gcc",), ("g++",))
    assert packaged() == found


@pytest.mark.parametrize(
    ("programs", "variables", "words"),
    [
        ((), {}, "No C compiler found. Install gcc or clang"),
        (("g++",), {}, "No C compiler found. Install gcc or clang"),
        (("gcc", "g++"), {"CC": "nowhere"}, "CC must name a compiler, not 'nowhere'"),
        (("gcc", "g++"), {"CXX": "nowhere"}, "CXX must name a compiler, not 'nowhere'"),
    ],
)
def test_one_line_says_that_there_is_none(machine, programs, variables, words):
    with pytest.raises(UsageError, match=words.replace("+", r"\+")) as raised:
        toolchain(machine(*programs, **variables))
    assert "\n" not in str(raised.value)


def test_without_a_compiler_of_cpp_code_in_c_is_compiled(machine):
    tools = toolchain(machine("gcc"))
    assert tools.compiler(is_cpp=False) == ("gcc",)
    with pytest.raises(UsageError, match="No C\\+\\+ compiler found next to 'gcc'"):
        tools.compiler(is_cpp=True)
