"""Before the first value: where its number is certain, it stands where the received ones do, and no step asks for it."""

import pytest

from sigcat.adapter.core.core_files import core_files
from sigcat.adapter.core.planned_core import derive
from sigcat.function.function_file import checked_file
from tests.function.shipped import interfaces

FUNCTION = """\
function: Watch
description: Looks at the speed.
responsible: A team
code: {{signature: globals, headers: [watch.h]}}
components:
  - name: Watch
    runnables:
      - interface: Step
        symbol: watch
        data: [{{path: Vehicle.Speed, role: consumed, variable: speed, {scale}, min: 0, max: 100, init: {init}}}]
define:
  scheduling:
    Step: {{description: Looks., cycleTime: 10, asil: QM}}
"""


def source(scale: str, init: str) -> str:
    example = FUNCTION.format(scale=scale, init=init)
    checked = checked_file(example.encode(), "function.yaml", interfaces())
    assert checked.sound is not None, checked.findings
    files = core_files(derive(checked.sound).plan).files
    return next(file.data.decode() for file in files if file.name.endswith(".c"))


@pytest.mark.parametrize(
    ("scale", "init", "received"),
    [
        ("unit: km/h, datatype: float", "7", "7.0F"),
        ("unit: m/s, datatype: float", "0", "0.0F"),
        ("unit: m/s, datatype: int16", "0", "0.0F"),
    ],
)
def test_one_that_the_conversion_makes_of_a_received_number_stands_there(scale, init, received):
    text = source(scale, init)
    assert f"self->received.Speed.value = {received};" in text
    assert "is_there" not in text


@pytest.mark.parametrize(
    ("scale", "init"),
    [
        ("unit: m/s, datatype: float", "7"),
        ("unit: km/h, datatype: float, factor: -1", "0"),
        ("unit: km/h, datatype: float, offset: 20", "0"),
    ],
)
def test_another_one_is_asked_for(scale, init):
    """No product with a negative factor is the zero without a sign."""
    assert "reception.is_there" in source(scale, init)


@pytest.mark.parametrize(
    ("scale", "unit"),
    [("unit: km/h, datatype: uint8, factor: 0.5", "km/h to 0.5 km/h"), ("unit: m/s, datatype: int16, factor: 0.01, offset: 2", "km/h to 0.01 m/s, 0 is 2 m/s")],
    ids=["factor", "offset"],
)  # fmt: skip
def test_constants_of_a_scaled_number_say_its_step(scale, unit):
    assert unit in source(scale, "7")
