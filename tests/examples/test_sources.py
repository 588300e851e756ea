"""The C sources of the examples are what projects accept: no warnings, no heap, no undefined behaviour, the same bits everywhere."""

import math
import random
import subprocess
from collections.abc import Sequence
from functools import cache

import pytest

from tests.examples.compiled import C99, CPP17, SOURCES, answer, object_file, program
from tests.examples.signals import POINTS, AccInputs, MpcInputs, WheelInputs
from tests.needs import C_COMPILERS, c_compiler, object_reader, slow

pytestmark = c_compiler

FUNCTIONS = sorted(SOURCES)
ODD = (math.nan, math.inf, -math.inf, -0.0, 5e-324, 1e30, -1e30, 20.5)
BUILDS = [
    (compiler, (optimization, *language))
    for compiler in C_COMPILERS
    for optimization in ("-O0", "-O2")
    for language in (C99, CPP17)
]
USUAL = [("-O0", *C99), ("-O2", *CPP17)]
"""Options of each compiler; `make slow` uses all of them."""
SANITIZERS = ("-g", "-fsanitize=address,undefined,float-cast-overflow", "-fno-sanitize-recover=all", *C99)
LIBRARY = {"sqrt", "fabs", "memcpy", "memset"}
"""Library functions that the functions may need. A compiler copies structs by the last two."""


@cache
def steps(function: str) -> Sequence[Sequence[float]]:
    """Inputs as they come on the road, and such as never should."""
    make, dice = (
        {"core_acc": acc, "eco_control_mpc": mpc, "wheel_speed_calculation": wheels}[function],
        random.Random(1),
    )
    return [odd(make(dice), dice) for _ in range(3000 if function != "eco_control_mpc" else 600)]


def odd(values: Sequence[float], dice: random.Random) -> Sequence[float]:
    """One value in a few steps is invalid. Modes and flags, which are integers, stay integers."""
    place, changed = dice.randrange(len(values)), list(values)
    if isinstance(changed[place], float) and dice.random() < 0.2:
        changed[place] = dice.choice(ODD)
    return changed


def acc(dice: random.Random) -> Sequence[float]:
    return AccInputs(
        brake_pressure=12.0 * (dice.random() < 0.01),
        steering_angle=dice.uniform(-1, 1),
        acceleration=dice.uniform(-3, 2),
        speed=dice.uniform(0, 40),
        set_speed=dice.uniform(0, 40),
        is_enabled=int(dice.random() < 0.95),
        unit=dice.choice((0, 1, 3)),
        distance=dice.choice((0.0, dice.uniform(0, 150))),
        proposal=dice.uniform(-3, 2),
        mode=dice.choice((2, 2, 2, 2, 1, 0)),
        invalid=int(dice.random() < 0.01),
    )


def mpc(dice: random.Random) -> Sequence[float]:
    altitudes, altitude = [], 100.0
    for _ in range(POINTS):
        altitude += dice.uniform(-1.5, 1.5)
        altitudes.append(altitude)
    return MpcInputs(
        instance=dice.randrange(2),
        speed=dice.uniform(0, 40),
        set_speed=dice.choice((22.0, 30.0)),
        energy_weight=dice.random(),
        altitudes=tuple(altitudes),
    ).values


def wheels(dice: random.Random) -> Sequence[float]:
    turning = WheelInputs(*(dice.uniform(-320, 320) for _ in range(4)))
    return turning._replace(mode=dice.randrange(3), rear_left_invalid=dice.randrange(2))


@pytest.mark.parametrize("function", FUNCTIONS)
@pytest.mark.parametrize(
    ("compiler", "options"),
    [pytest.param(*build, marks=() if build[1] in USUAL else slow) for build in BUILDS],
    ids=lambda value: "".join(value[-1:] if value in C_COMPILERS else value[:2]),
)
def test_every_build_compiles_without_a_warning_and_answers_with_the_same_bits(function, compiler, options):
    expected = answer(program(function), steps(function))
    assert len({expected[at : at + 8] for at in range(0, len(expected), 8)}) > 50
    assert answer(program(function, options, compiler), steps(function)) == expected


@pytest.mark.parametrize("function", FUNCTIONS)
def test_nothing_is_undefined_and_no_memory_but_its_own_is_touched(function):
    try:
        path = program(function, SANITIZERS)
    except AssertionError as error:
        if "asan" in str(error) or "ubsan" in str(error):
            pytest.skip("the sanitizers of the C compiler: install libasan and libubsan")
        raise
    answer(path, steps(function))


def symbols(function: str, kinds: str) -> set[str]:
    """Names in what a function is compiled to, of these kinds of `nm`."""
    told = subprocess.run(["nm", object_file(function)], check=True, capture_output=True, text=True).stdout
    return {line.split()[-1] for line in told.splitlines() if line.split()[-2] in kinds}


@object_reader
@pytest.mark.parametrize("function", FUNCTIONS)
def test_the_library_is_needed_for_square_roots_alone(function):
    assert symbols(function, "U") <= LIBRARY


@object_reader
def test_a_reentrant_function_has_no_variables_of_its_own():
    assert symbols("eco_control_mpc", "BbDdCc") == set()
    assert symbols("core_acc", "BbDdCc") >= {"core_inputs", "core_outputs"}
