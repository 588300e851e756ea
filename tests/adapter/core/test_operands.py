"""Variables that are expressions: an index follows the whole of them."""

from pathlib import Path

from sigcat.cli import main

FUNCTION = """\
function: Demo
description: A demonstration.
responsible: Demo team
code: {signature: globals, headers: [demo.h], sources: [demo.c]}
components:
  - name: Demo
    runnables:
      - interface: Step
        data:
          - {path: Vehicle.Demo.Two, role: consumed, provider: Bench, variable: '*v', init: [1, 2]}
define:
  data:
    Vehicle.Demo: {type: branch, description: Signals of the demonstration.}
    Vehicle.Demo.Two: {datatype: 'float[]', arraysize: 2, asil: B, description: The input.}
  scheduling:
    Step: {description: Works., asil: B, cycleTime: 20}
"""


def test_an_element_is_one_of_the_array_that_a_pointer_points_at(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    Path("demo.function.yaml").write_text(FUNCTION)
    Path("demo.h").write_text("typedef float Arr[2];\nextern Arr *v;\nvoid Demo_Step(void);\n")
    Path("demo.c").write_text('#include "demo.h"\nstatic Arr a;\nArr *v = &a;\nvoid Demo_Step(void) {}\n')
    assert main(["generate", "core", "demo.function.yaml", "-o", "out"]) == 0
    text = Path("out/Demo_adapter.c").read_text()
    assert "(*v)[i] = self->received.Two.value[i];" in text
    assert "*v[i]" not in text.replace("(*v)[i]", "")
