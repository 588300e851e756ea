"""A limit or start value beyond the largest float is a finding. Code with the largest float as a limit runs."""

import pytest

from sigcat.cli import main
from tests.needs import c_compiler

FUNCTION = """\
function: Demo
description: A demonstration.
responsible: Demo team
code: {{signature: globals, headers: [demo.h], sources: [demo.c]}}
components:
  - name: Demo
    runnables:
      - interface: Step
        data:
          - {{path: Vehicle.Demo.In, role: consumed, provider: Bench, variable: a, init: 0, rangeErrorAction: Init{code}}}
          - {{path: Vehicle.Demo.Out, role: provided, variable: b}}
define:
  data:
    Vehicle.Demo: {{type: branch, description: Signals of the demonstration.}}
    Vehicle.Demo.In: {{datatype: float, unit: m/s, asil: B, description: The input.{catalogue}}}
    Vehicle.Demo.Out: {{datatype: float, unit: m/s, asil: B, description: The output.}}
  scheduling:
    Step: {{description: Works., asil: B, cycleTime: 20}}
"""
BEYOND = {
    "in the catalogue": ("", ", max: 1.0e+39", "error V030 `max` 1e+39 does not fit float (numbers up to ±3.4028235e+38)."),
    "a default": ("", ", default: -1.0e+39", "error V030 Default -1e+39 does not fit float"),
    "in the code": (", max: 1.0e+39", "", "error F020 `max` 1e+39 does not fit float"),
    "in the unit of the code": (", unit: km/h", ", min: -1.0e+38", "error F020 `min` -3.6e+38 does not fit float"),
    "with a factor": (", factor: 1.0e-10", ", max: 1.0e+30", "error F020 `max` 1e+30 does not fit float"),
    "the largest one": (", max: 3.4028235e+38", "", ""),
}  # fmt: skip


@pytest.mark.parametrize(("code", "catalogue", "expected"), BEYOND.values(), ids=BEYOND)
def test_a_limit_that_no_float_holds_is_found_once(code, catalogue, expected, tmp_path, capsys):
    file = tmp_path / "demo.function.yaml"
    file.write_text(FUNCTION.format(code=code, catalogue=catalogue))
    main(["lint", str(file), "--isolated"])
    out = capsys.readouterr().out
    assert expected in out
    assert (out.count("does not fit float") == 1) is (expected != ""), out


@c_compiler
def test_the_largest_float_is_a_limit_of_code_that_runs(tmp_path, capsys):
    (tmp_path / "demo.h").write_text("extern float a, b;\nvoid Demo_Step(void);\n")
    (tmp_path / "demo.c").write_text('#include "demo.h"\nfloat a, b;\nvoid Demo_Step(void) { b = a; }\n')
    file, trace = tmp_path / "demo.function.yaml", tmp_path / "trace.csv"
    file.write_text(FUNCTION.format(code="", catalogue=", max: 3.4028235e+38, min: -3.4028235e+38"))
    trace.write_text("time,Vehicle.Demo.In\n0,3.4028235e+38\n0.02,-inf\n")
    assert main(["lint", str(file), "--isolated"]) == 0, capsys.readouterr().out
    capsys.readouterr()
    assert main(["simulate", str(file), "--trace", str(trace), "--isolated"]) == 0
    assert capsys.readouterr().out.split()[1:] == ["0.000000000,Demo_Step,3.4028235e+38", "0.020000000,Demo_Step,0.0"]
