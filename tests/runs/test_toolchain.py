"""Which compiler is used: the one that is named, else one of the system, else the one from PyPI."""

import sys
from pathlib import Path

import pytest

from sigcat.errors import UsageError
from sigcat.runs import toolchain
from sigcat.runs.toolchain import compiler


@pytest.fixture
def machine(tmp_path, monkeypatch):
    """A machine with programs of these names only, and no ziglang."""
    monkeypatch.setattr(toolchain, "find_spec", lambda name: None)

    def with_programs(*names):
        for name in names:
            (tmp_path / name).write_text("#!/bin/sh\n")
            (tmp_path / name).chmod(0o755)
        return {"PATH": str(tmp_path)}

    return with_programs


@pytest.mark.parametrize(
    ("language", "programs", "expected"),
    [
        ("C", ("clang", "gcc"), "gcc"),
        ("C", ("clang",), "clang"),
        ("C", ("clang", "cc"), "cc"),
        ("C++", ("gcc", "clang++"), "clang++"),
    ],
)
def test_a_compiler_of_the_system_is_used(machine, language, programs, expected):
    assert [Path(part).name for part in compiler(language, machine(*programs))] == [expected]


def test_the_environment_names_another_one_with_arguments(machine):
    assert compiler("C", {**machine("gcc", "ccache"), "CC": "ccache gcc -m32"}) == ("ccache", "gcc", "-m32")


def test_a_named_compiler_that_is_not_there_is_told(machine):
    with pytest.raises(UsageError, match="CXX must name a compiler: 'icc' cannot be run"):
        compiler("C++", {**machine("g++"), "CXX": "icc"})


def test_the_compiler_from_pypi_is_the_last_resort(machine, monkeypatch):
    monkeypatch.setattr(toolchain, "find_spec", lambda name: object() if name == "ziglang" else None)
    assert compiler("C++", machine()) == (sys.executable, "-m", "ziglang", "c++")


def test_without_any_one_line_says_how_to_get_one(machine):
    with pytest.raises(UsageError, match="there is no C compiler: install gcc or clang, or run `pip install ziglang`"):
        compiler("C", machine())
