"""The generated core does what the model does: bit by bit, for functions and traces at random, thousands of lines long.

`make fuzz` tries many more, other ones each time, and makes what it finds smaller.
"""

from pathlib import Path
from tempfile import mkdtemp

import pytest
from hypothesis import HealthCheck, Phase, given, settings
from hypothesis import strategies as st

from sigcat.adapter.toolchain import EXACT
from sigcat.function.function_json.model import FunctionJson, to_json
from tests.adapter.core import core_side
from tests.adapter.core.compared import difference, disagreement
from tests.adapter.core.compilers import SANITIZERS, has_fused_products, sanitizers
from tests.adapter.core.fixed import FIXED
from tests.adapter.core.functions import functions
from tests.adapter.core.script import bits
from tests.adapter.core.subject import subject
from tests.adapter.reference.values.number_format import NumberFormat
from tests.adapter.written import DOUBLE, function, signal, step
from tests.properties import FUZZ, IS_SEARCH, examples

LINES = 5000 if FUZZ else 2000


@pytest.fixture(scope="session")
def flags():
    """Return the compiler options of cores: every available sanitizer."""
    level = "-O2" if FUZZ else "-O0"
    return (level, "-w", *SANITIZERS) if sanitizers() else (level, "-w")


@pytest.mark.parametrize("name", FIXED)
def test_functions_for_each_subject(name, tmp_path, flags):
    assert disagreement(FIXED[name](), 1, LINES, tmp_path, flags) == ""


@given(functions().map(to_json), st.integers(0, 2**32))
@settings(
    examples(12),
    suppress_health_check=list(HealthCheck),
    phases=[Phase.explicit, Phase.generate, *([Phase.shrink] if IS_SEARCH else [])],
)
def test_functions_at_random(tmp_path, flags, document, trace):
    folder = Path(mkdtemp(dir=tmp_path))
    assert disagreement(FunctionJson.model_validate_json(document), trace, LINES, folder, flags) == "", folder


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
