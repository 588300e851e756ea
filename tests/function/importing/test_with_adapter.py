"""Imported declarations are enough for the core of an adapter, which compiles with the code."""

import re
import subprocess
from pathlib import Path

import pytest

from sigcat.adapter.toolchain import toolchain
from sigcat.cli import main

TYPES = "typedef struct { double VehSpd; } ExtU_Drive_T;\ntypedef struct { double AccReq; } ExtY_Drive_T;\n"
GLOBALS = {
    "Drive.h": f"#pragma once\n{TYPES}extern ExtU_Drive_T Drive_U;\nextern ExtY_Drive_T Drive_Y;\nextern double Kp;\n"
    "void Drive_initialize(void);\nvoid Drive_step(void);\n",
    "Drive.c": '#include "Drive.h"\nExtU_Drive_T Drive_U;\nExtY_Drive_T Drive_Y;\ndouble Kp = 0.5;\n'
    "void Drive_initialize(void) {}\nvoid Drive_step(void) { Drive_Y.AccReq = Kp * Drive_U.VehSpd; }\n",
}
EXTERNS = {
    "Drive.h": "#pragma once\nextern double VehSpd; /* '<Root>/VehSpd' */\nextern double AccReq;\n"
    "void Drive_initialize(void);\nvoid Drive_step(void);\nvoid Drive_terminate(void);\n",
    "Drive.c": '#include "Drive.h"\ndouble AccReq;\nvoid Drive_initialize(void) {}\n'
    "void Drive_step(void) { AccReq = VehSpd; }\nvoid Drive_terminate(void) {}\n",
}
POINTERS = {
    "Drive.h": f"#pragma once\n{TYPES}typedef struct {{ double Kp; }} P_Drive_T;\n"
    "typedef struct { P_Drive_T *defaultParam; ExtU_Drive_T *inputs; ExtY_Drive_T *outputs; } RT_MODEL_Drive_T;\n"
    "int Drive_initialize(RT_MODEL_Drive_T *const Drive_M);\nvoid Drive_step(RT_MODEL_Drive_T *const Drive_M);\n",
    "Drive.c": '#include "Drive.h"\nint Drive_initialize(RT_MODEL_Drive_T *const Drive_M) { return Drive_M == 0; }\n'
    "void Drive_step(RT_MODEL_Drive_T *const Drive_M)\n"
    "{ Drive_M->outputs->AccReq = Drive_M->defaultParam->Kp * Drive_M->inputs->VehSpd; }\n",
}
ARGUMENTS = {
    "Drive.h": f"#pragma once\n{TYPES}typedef struct {{ double Last; }} DW_Drive_T;\n"
    "typedef struct { DW_Drive_T *dwork; } RT_MODEL_Drive_T;\n"
    "void Drive_init(RT_MODEL_Drive_T *const Drive_M);\n"
    "void Drive_step(RT_MODEL_Drive_T *const Drive_M, const ExtU_Drive_T *Drive_U, ExtY_Drive_T *Drive_Y);\n",
    "Drive.c": '#include "Drive.h"\nvoid Drive_init(RT_MODEL_Drive_T *const Drive_M) { Drive_M->dwork->Last = 0; }\n'
    "void Drive_step(RT_MODEL_Drive_T *const Drive_M, const ExtU_Drive_T *Drive_U, ExtY_Drive_T *Drive_Y)\n"
    "{ Drive_Y->AccReq = Drive_M->dwork->Last = Drive_U->VehSpd; }\n",
}
CLASS = {
    "Drive.hpp": "#pragma once\nnamespace car {\nclass Drive final {\n public:\n"
    "  struct ExtU_Drive_T { double VehSpd; };\n  struct ExtY_Drive_T { double AccReq; };\n"
    "  ExtU_Drive_T Drive_U;\n  ExtY_Drive_T Drive_Y;\n"
    "  void initialize();\n  void step();\n  static void terminate();\n};\n}\n",
    "Drive.cpp": '#include "Drive.hpp"\nvoid car::Drive::initialize() {}\nvoid car::Drive::terminate() {}\n'
    "void car::Drive::step() { Drive_Y.AccReq = Drive_U.VehSpd; }\n",
}
TYPED_EXTERNS = {
    "Drive.h": "#pragma once\ntypedef unsigned char boolean_T;\ntypedef enum { M_OFF, M_ON } md_t;\nenum gear { PARK, DRIVE };\n"
    "struct Bus { short a; boolean_T b[2]; };\ntypedef float vector_T[3];\n"
    "extern boolean_T Enabled;\nextern volatile unsigned char Vol;\nextern md_t Md;\nextern enum gear Gear;\n"
    "extern struct Bus In;\nextern vector_T Acc;\nextern volatile boolean_T Flags[4];\nextern long Count;\nextern long VehSpd;\n"
    "extern float AccReq;\nvoid Drive_initialize(void);\nvoid Drive_step(void);\n",
    "Drive.c": '#include "Drive.h"\nfloat AccReq;\nvoid Drive_initialize(void) {}\nvoid Drive_step(void) '
    "{ AccReq = Enabled + Vol + Md + Gear + In.a + In.b[1] + Acc[2] + Flags[3] + Count + VehSpd; }\n",
}
SHAPES = {
    "globals": GLOBALS,
    "externs": EXTERNS,
    "externs with types": TYPED_EXTERNS,
    "pointers": POINTERS,
    "arguments": ARGUMENTS,
    "class": CLASS,
}


@pytest.mark.parametrize("shape", SHAPES)
def test_the_core_compiles_with_the_code(shape, tmp_path):
    for name, text in SHAPES[shape].items():
        (tmp_path / name).write_text(text)
    assert main(["function", "new", "Driving", "--from-c", str(tmp_path)]) == 0
    define_what_is_to_be_chosen(tmp_path / "function.yaml")
    assert main(["generate", "core", str(tmp_path / "function.yaml"), "-o", str(tmp_path)]) == 0
    sources = [file for file in tmp_path.iterdir() if file.suffix in (".c", ".cpp")]
    assert len(sources) == 3
    for source in sources:
        compiled(source)


def define_what_is_to_be_chosen(file: Path) -> None:
    """Define a signal for each path that is left to choose."""
    text = file.read_text()
    signals = "".join(defined(*each) for each in re.findall(ENTRY, text))
    branch = "    Vehicle.TODO: {type: branch, description: Signals of the test.}\n"
    file.write_text(text.replace("define:\n", f"define:\n  data:\n{branch}{signals}") if signals else text)


ENTRY = r"path: (Vehicle\.TODO\.\w+)\n(?: +(?:role|name|variable|definedBy|cType): .*\n)+ +datatype: (\S+)\n(?: +values: \{(.*)\})?"


def defined(path: str, datatype: str, values: str) -> str:
    size = {"Acc": 3, "Flags": 4, "b": 2}.get(path.rpartition(".")[2], 0)
    keys = (
        f", allowed: [{', '.join(re.findall('[A-Z_]+', values))}]" if values else f", arraysize: {size}" if size else ""
    )
    kind = "string" if values else datatype
    return f"    {path}: {{datatype: '{kind}'{keys}, asil: QM, description: A signal of the test.}}\n"


def test_a_type_of_c_is_a_name_and_no_code(tmp_path, capsys):
    for bad in ("int x; int", "uint8_t *", "const int", "return", "void", "int int", "volatile", "int[2]", "a\\nb"):
        file = tmp_path / "function.yaml"
        file.write_text(
            "function: Demo\ndescription: A demonstration.\nresponsible: Demo team\ncomponents:\n  - name: Demo\n    runnables:\n"
            f'      - {{interface: Step, data: [{{path: Vehicle.Speed, role: consumed, cType: "{bad}"}}]}}\n'
            "define:\n  scheduling:\n    Step: {description: Works., asil: QM, cycleTime: 20, priority: 1}\n"
        )
        assert main(["lint", str(file)]) == 1
        assert "cType` must be" in capsys.readouterr().out, bad


def compiled(source: Path) -> None:
    found = toolchain()
    command = found.cpp if source.suffix == ".cpp" else found.c
    options = ["-Wall", "-Wextra", "-Werror", "-Wno-unused-parameter", "-c", "-I.", "-o", "object.o"]
    done = subprocess.run(
        [*command, *options, source.name], cwd=source.parent, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
