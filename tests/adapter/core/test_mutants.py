"""Faults in the generated C are found: each mutant prints something else than the model in one of its scripts.

A usual run tries some of them, `make slow` all.
"""

import re
import subprocess
from collections.abc import Mapping
from functools import cache

import pytest

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
def texts(function: str) -> Mapping[str, str]:
    """The generated core and its runtime, before anything is broken in them."""
    return core_side.texts(made(function))


@cache
def script(function: str, seed: int) -> Script:
    return Tracer(made(function), seed).script(LINES)


def test_there_are_many_and_each_has_a_name_of_its_own():
    assert len({mutant.name for mutant in MUTANTS}) == len(MUTANTS) > 100


def test_a_mutant_changes_the_text():
    assert [mutant.name for mutant in MUTANTS if not broken(mutant, texts(mutant.function))] == []


@pytest.mark.parametrize("mutant", TRIED, ids=lambda mutant: mutant.name)
def test_a_mutant_is_found(mutant: Mutant, tmp_path):
    def change(given: Mapping[str, str]) -> Mapping[str, str]:
        return broken(mutant, given)

    program = core_side.compiled(made(mutant.function), tmp_path, ("-O0", "-w"), change=change)
    assert any(is_found(mutant.function, seed, program) for seed in SEEDS)


def broken(mutant: Mutant, given: Mapping[str, str]) -> Mapping[str, str]:
    """The texts with the fault."""
    changed = {
        name: re.sub(mutant.pattern, mutant.replacement, text, count=mutant.most) for name, text in given.items()
    }
    assert changed != given, "nothing to replace"
    return changed


def is_found(function: str, seed: int, program) -> bool:
    try:
        printed = core_side.run(program, script(function, seed))
    except (AssertionError, subprocess.TimeoutExpired):
        return True
    return difference(made(function), script(function, seed), printed) != ""
