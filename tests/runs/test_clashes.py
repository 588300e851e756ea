"""A header that replaces names of the generated code is reported at its line; names of the code shadow nothing."""

import subprocess

import pytest

from sigcat.adapter.toolchain import toolchain
from sigcat.cli import main

FUNCTION = """\
function: Fan
description: Cools.
responsible: Fan team
code: {{signature: globals, headers: [fan.h], sources: [fan.c]}}
components:
  - name: Fan
    runnables:
      - {{interface: Init, symbol: fan_init}}
      - interface: Step
        symbol: fan_step
        errors: [Late]
        data:
          - {{path: Vehicle.Speed, role: consumed, variable: {name}, datatype: float, timeout: 50, timeoutError: Late, asil: QM}}
      - {{interface: Terminate, symbol: fan_end}}
define:
  errors:
    Late: {{description: The speed is late., maturationTime: 1, resetTime: 1, resetCondition: It is over., severity: Off., asil: QM}}
  scheduling:
    Init: {{description: Prepares., asil: QM, priority: 1, scheduling: Preemptive}}
    Step: {{description: Works., asil: QM, cycleTime: 10, priority: 1, scheduling: Preemptive}}
    Terminate: {{description: Ends., asil: QM, priority: 1, scheduling: Preemptive}}
"""
CALLS = "void fan_init(void);\nvoid fan_step(void);\nvoid fan_end(void);\n"


def project(folder, line, name="speed", meant=None):
    (folder / "fan.h").write_text(
        f"#pragma once\n/* A comment\n   of two lines. */\n{line}\nextern float {meant or name};\n{CALLS}"
    )
    (folder / "fan.c").write_text(
        f'#include "fan.h"\nfloat {meant or name};\nvoid fan_init(void) {{}}\nvoid fan_step(void) {{}}\nvoid fan_end(void) {{}}\n'
    )
    (folder / "function.yaml").write_text(FUNCTION.format(name=name))
    return folder / "function.yaml"


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("#define t 7", "The macro 't' replaces a name of the generated code"),
        ("#define value", "The macro 'value' replaces a name of the generated code"),
        ("#  define self(x) (x)\n#define now 3", "The macro 'now' replaces"),
        ("typedef unsigned char bool;", "must take 'bool' from <stdbool.h>"),
    ],
)
def test_the_cause_is_told_at_the_line_of_the_header(line, message, tmp_path, capsys):
    assert main(["simulate", str(project(tmp_path, line)), "--duration", "0.1"]) == 1
    said = capsys.readouterr().err
    found = [each for each in said.splitlines() if "error" in each]
    assert any(f"fan.h:{4 + line.count(chr(10))}: error F212" in each and message in each for each in found), said
    assert all("fan.h:" in each for each in found), said


@pytest.mark.parametrize(
    "line", ["#define t 7", "#define value", "#define self(x) (x)\n#define now 3", "typedef unsigned char bool;"]
)
def test_lint_reports_the_cause_at_the_line_of_the_header(line, tmp_path, capsys):
    assert main(["lint", str(project(tmp_path, line))]) == 1
    said = capsys.readouterr().out
    assert f"fan.h:{4 + line.count(chr(10))}:" in said
    assert "error F212" in said


@pytest.mark.parametrize(
    "line",
    [
        "#define t own_t",
        "#define t 7\n#undef t",
        "#define now(x) (x)",
        "#ifdef OLD\n#define t 7\n#endif",
        "#ifndef bool\ntypedef unsigned char bool;\n#endif",
    ],
)
def test_lint_does_not_report_what_compiles(line, tmp_path, capsys):
    file = project(tmp_path, line)
    assert main(["lint", str(file)]) == 0, capsys.readouterr().out
    assert main(["simulate", str(file), "--duration", "0.1"]) == 0


def test_a_macro_that_the_declaration_means_is_no_cause(tmp_path, capsys):
    file = project(tmp_path, "#define speed fan_speed\n#define broken(", meant="fan_speed")
    assert main(["simulate", str(file), "--duration", "0.1"]) == 1
    assert "'speed'" not in capsys.readouterr().err


def test_a_variable_of_another_kind_is_told_at_the_line_of_the_interface(tmp_path, capsys):
    file = project(tmp_path, "")
    for name in ("fan.h", "fan.c"):
        code = tmp_path / name
        code.write_text(code.read_text().replace("float speed", "int speed"))
    assert main(["simulate", str(file), "--duration", "0.1"]) == 1
    said = capsys.readouterr().err
    assert "function.yaml:13:" in said
    assert "speed must be float" in said


@pytest.mark.parametrize("name", ["clock", "own_clock", "reception", "entered", "t", "time_out"])
def test_a_variable_with_any_name_is_not_shadowed(name, tmp_path):
    assert main(["generate", "core", str(project(tmp_path, "", name)), "-o", str(tmp_path)]) == 0
    command = [
        *toolchain().c,
        "-std=c11",
        "-Wall",
        "-Wextra",
        "-Wshadow",
        "-Werror",
        "-c",
        "Fan_adapter.c",
        "-o",
        "a.o",
    ]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
