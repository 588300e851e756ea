"""The generated core does what the model does: bit by bit, for functions and traces at random, thousands of lines long.

`make fuzz` tries many more (SIGCAT_FUZZ is their number), other ones each time, and makes what it finds smaller.
"""

import os
import secrets

import pytest
from hypothesis import HealthCheck, Phase, given, seed, settings
from hypothesis import strategies as st

from sigcat.adapter.model.values.number_format import NumberFormat
from sigcat.adapter.toolchain import EXACT
from sigcat.function.function_json.model import FunctionJson
from tests.adapter.core import core_side
from tests.adapter.core.compared import difference, disagreement
from tests.adapter.core.fixed import FIXED
from tests.adapter.core.functions import functions
from tests.adapter.core.judges import SANITIZERS, has_fused_products, sanitizers
from tests.adapter.core.script import bits
from tests.adapter.core.subject import subject
from tests.adapter.written import DOUBLE, function, signal, step

FUZZ = int(os.environ.get("SIGCAT_FUZZ", "0"))
LINES = 5000 if FUZZ else 2000
FIRST = secrets.randbelow(2**32) if FUZZ else 0
"""The first seed: a fuzzing run has others than the one before, and names them by its tests."""
SEEDS = range(FIRST, FIRST + (FUZZ or 6))


@pytest.fixture(scope="session")
def flags():
    """How cores are compiled: with every sanitizer that there is."""
    level = "-O2" if FUZZ else "-O0"
    return (level, "-w", *SANITIZERS) if sanitizers() else (level, "-w")


@pytest.mark.parametrize("name", FIXED)
def test_functions_for_each_subject(name, tmp_path, flags):
    assert disagreement(FIXED[name](), 1, LINES, tmp_path, flags) == ""


@pytest.mark.parametrize("number", SEEDS)
def test_functions_at_random(number, tmp_path, flags):
    count = iter(range(10**6))

    @seed(number)
    @settings(
        max_examples=20 if FUZZ else 2,
        database=None,
        suppress_health_check=list(HealthCheck),
        phases=[Phase.generate, Phase.shrink] if FUZZ else [Phase.generate],
    )
    @given(functions(), st.integers(0, 2**32))
    def agree(document: FunctionJson, trace: int) -> None:
        folder = tmp_path / str(next(count))
        folder.mkdir()
        assert disagreement(document, trace, LINES, folder, flags) == "", folder

    agree()


def test_a_product_is_not_fused_with_the_sum_on_a_processor_that_could(tmp_path):
    if not has_fused_products():
        pytest.skip("a processor with fused multiply-add: this one has none, or its compiler does not tell")
    made = subject(function(step(signal("A", DOUBLE, VssDatatype="double", Factor="0.01", Offset="123.45"))))
    value = bits(123.45, NumberFormat("double"))
    script = [("init", 0, 0), ("start", 0), ("receive", 0, value, 0), ("next", 0), ("advance", 0, 0)]
    for flags, is_same in ((EXACT, True), (("-ffp-contract=fast",), False)):
        folder = tmp_path / str(is_same)
        program = core_side.compiled(made, folder, ("-O2", "-march=native", "-w"), exact=flags)
        assert (difference(made, script, core_side.run(program, script)) == "") is is_same


def test_sanitizers_are_there():
    if not sanitizers():
        pytest.skip("address and undefined-behaviour sanitizers: install gcc or clang with them")
