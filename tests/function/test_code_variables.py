"""Lint compares variables with the headers that declare them, by kind, sign and size."""

import pytest

from sigcat.cli import main

FUNCTION = """\
function: Demo
description: A demonstration.
responsible: Demo team
code: {{signature: globals, headers: [Demo.h], includeFolders: [code]}}
components:
  - name: Demo
    runnables:
      - interface: Step
        data:
          - {{path: Vehicle.Demo.In, role: {role}, provider: Bench, variable: {variable}{more}}}
define:
  data:
    Vehicle.Demo: {{type: branch, description: Signals of the test.}}
    Vehicle.Demo.In: {{datatype: {datatype}, asil: QM, description: A signal of the test.}}
  scheduling:
    Step: {{description: Works., asil: QM, cycleTime: 20, priority: 1}}
"""
HEADER = """\
#pragma once
#include <math.h>
#include "types.h"
extern int32_t sum;
extern uint32_t count;
extern float ratio;
extern boolean_T flag;
extern volatile unsigned char level;
typedef enum { M_OFF, M_ON } md_t;
extern md_t mode;
extern struct Bus { short a; unsigned b : 3; } bus;
extern char letter;
"""
CASES = {
    "the same": ("uint32", "consumed", "count", "", ""),
    "signed": ("uint32", "consumed", "sum", "", "'sum' must be uint32_t; the header has int."),
    "unsigned": ("int32", "provided", "count", "", "'count' must be int32_t"),
    "unsigned and wider than what it is read from": ("int16", "consumed", "count", "", "'count' must be int16_t"),
    "an integer for a float": ("float", "consumed", "sum", "", "'sum' must be float"),
    "a float for an integer": ("int32", "consumed", "ratio", "", "Give `datatype: float`"),
    "a float for a flag": ("boolean", "consumed", "ratio", "", "'ratio' must be an integer"),
    "a narrower member": ("int32", "consumed", "bus.a", "", "'bus.a' must be int32_t; the header has short"),
    "a narrower output": ("int32", "provided", "bus.a", "", ""),
    "a bit field": ("uint8", "consumed", "bus.b", "", ""),
    "a character": ("uint8", "consumed", "letter", "", ""),
    "a variable that no header has": ("uint8", "consumed", "nothing", "", ""),
    "defined with its type": ("uint8", "consumed", "level", ", definedBy: adapter, cType: volatile unsigned char", ""),
    "defined without its qualifier": ("uint8", "consumed", "level", ", definedBy: adapter, cType: unsigned char", "clang says"),
    "defined with another type": ("boolean", "consumed", "flag", ", definedBy: adapter", "Give the type of the header as `cType`"),
    "a type that is not there": ("boolean", "consumed", "flag", ", definedBy: adapter, cType: bolean_T", "unknown type name 'bolean_T'"),
}  # fmt: skip


@pytest.mark.parametrize(("datatype", "role", "variable", "more", "expected"), CASES.values(), ids=CASES)
def test_a_type_that_is_not_that_of_the_header_is_found(datatype, role, variable, more, expected, tmp_path, capsys):
    file = project(tmp_path, HEADER)
    file.write_text(FUNCTION.format(datatype=datatype, role=role, variable=variable, more=more))
    main(["lint", str(file)])
    out = capsys.readouterr().out
    assert ("F211" in out) is (expected != ""), out
    assert expected in out
    if expected:
        assert "function.yaml:10:" in out


def test_headers_that_are_incomplete_are_not_compared(tmp_path, capsys):
    file = project(tmp_path, f'#include "missing.h"\n{HEADER}')
    file.write_text(FUNCTION.format(datatype="uint32", role="consumed", variable="sum", more=""))
    main(["lint", str(file)])
    assert "F211" not in capsys.readouterr().out


@pytest.mark.parametrize("variable", ["nothing", "bus.c"])
@pytest.mark.parametrize("is_complete", [True, False], ids=["complete", "without a header of the system"])
def test_a_variable_that_no_header_declares_is_found_where_all_headers_are_there(
    variable, is_complete, tmp_path, capsys
):
    file = project(tmp_path, HEADER if not is_complete else HEADER.replace("#include <math.h>\n", ""))
    file.write_text(FUNCTION.format(datatype="int32", role="consumed", variable=variable, more=""))
    assert main(["lint", str(file)]) == is_complete
    out = capsys.readouterr().out
    assert (
        f"function.yaml:10:80: error T010 The headers must declare '{variable}'; clang says: " in out
    ) is is_complete


def project(folder, header):
    (folder / "code").mkdir()
    (folder / "code" / "Demo.h").write_text(header)
    (folder / "code" / "types.h").write_text("#include <stdint.h>\ntypedef unsigned char boolean_T;\n")
    return folder / "function.yaml"
