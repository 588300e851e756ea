"""Faults in the generated C are found: each mutant prints something else than the model in one of its scripts.

A usual run tries some of them, `make slow` all.
"""

import re
import subprocess
from functools import cache

import pytest

from sigcat.adapter.core.generate import core_files
from tests.adapter.core import core_side
from tests.adapter.core.compared import difference
from tests.adapter.core.fixed import FIXED
from tests.adapter.core.mutants import MUTANTS, Mutant
from tests.adapter.core.script import Script
from tests.adapter.core.subject import Subject, subject
from tests.adapter.core.traces import Tracer
from tests.needs import IS_SLOW_RUN

LINES, SEEDS = 3000, (1, 2, 3, 4, 5, 6)
TRIED = MUTANTS if IS_SLOW_RUN else MUTANTS[::11]


@cache
def made(function: str) -> Subject:
    return subject(FIXED[function]())


@cache
def text_of(function: str) -> str:
    """The generated core, before anything is broken in it."""
    files = core_files(made(function).plan)
    (core,) = (file for file in files.files if file.name.startswith("F_adapter.c"))
    return core.data.decode()


@cache
def script(function: str, seed: int) -> Script:
    return Tracer(made(function), seed).script(LINES)


def test_there_are_many_and_each_has_a_name_of_its_own():
    assert len({mutant.name for mutant in MUTANTS}) == len(MUTANTS) > 100


@pytest.mark.parametrize("mutant", MUTANTS, ids=lambda mutant: mutant.name)
def test_a_mutant_changes_the_text(mutant: Mutant):
    assert broken(mutant, text_of(mutant.function))


@pytest.mark.parametrize("mutant", TRIED, ids=lambda mutant: mutant.name)
def test_a_mutant_is_found(mutant: Mutant, tmp_path):
    def change(text: str) -> str:
        return broken(mutant, text)

    program = core_side.compiled(made(mutant.function), tmp_path, ("-O0", "-w"), change=change)
    assert any(is_found(mutant.function, seed, program) for seed in SEEDS)


def broken(mutant: Mutant, text: str) -> str:
    """The text with its fault."""
    changed, count = re.subn(mutant.pattern, mutant.replacement, text, count=mutant.most)
    assert count > 0, "nothing to replace"
    assert changed != text
    return changed


def is_found(function: str, seed: int, program) -> bool:
    try:
        printed = core_side.run(program, script(function, seed))
    except (AssertionError, subprocess.TimeoutExpired):
        return True
    return difference(made(function), script(function, seed), printed) != ""
