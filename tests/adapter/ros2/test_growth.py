"""Packages of a large function take as long as its size lets expect."""

from functools import partial

from sigcat.adapter.ros2.ros2_workspace import generate
from sigcat.limits import DEFAULT_LIMITS
from tests.adapter.ros2.generated import integration
from tests.growth import LINEAR, growth

FUNCTION = """\
function: Many
description: Has many signals.
responsible: Us
code: {{signature: globals, headers: [many.h]}}
components:
  - name: Many
    runnables:
      - interface: Step
        symbol: many_step
        data: [{data}]
define:
  data: {{{definitions}}}
  scheduling:
    Step: {{description: Runs., cycleTime: 20, scheduling: Preemptive, asil: QM}}
"""


def test_ten_times_the_signals_take_about_ten_times_as_long(tmp_path):
    """Half of them are received, half are sent."""

    def generating(count):
        data = [
            f"{{path: Vehicle.In{i}, role: consumed, variable: in{i}, datatype: uint8, provider: Other, init: 0}}, "
            f"{{path: Vehicle.Out{i}, role: provided, variable: out{i}, datatype: uint8}}"
            for i in range(count)
        ]
        paths = [f"Vehicle.{way}{i}" for way in ("In", "Out") for i in range(count)]
        definitions = [f"{path}: {{datatype: uint8, asil: QM, description: A number.}}" for path in paths]
        file = tmp_path / "many.yaml"
        file.write_text(FUNCTION.format(data=", ".join(data), definitions=", ".join(definitions)))
        return partial(generate, integration(file), "ros2.json", DEFAULT_LIMITS, None)

    assert growth(generating, 60) < LINEAR
