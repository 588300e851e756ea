"""What is imported is enough for the core of an adapter, which compiles with the code."""

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
SHAPES = {"globals": GLOBALS, "externs": EXTERNS, "pointers": POINTERS, "arguments": ARGUMENTS, "class": CLASS}


@pytest.mark.parametrize("shape", SHAPES)
def test_the_core_compiles_with_the_code(shape, tmp_path):
    for name, text in SHAPES[shape].items():
        (tmp_path / name).write_text(text)
    assert main(["function", "new", "Driving", "--from-c", str(tmp_path)]) == 0
    assert "TODO" not in (tmp_path / "function.yaml").read_text()
    assert main(["generate", "core", str(tmp_path / "function.yaml"), "-o", str(tmp_path)]) == 0
    sources = [file for file in tmp_path.iterdir() if file.suffix in (".c", ".cpp")]
    assert len(sources) == 2
    for source in sources:
        compiled(source)


def compiled(source: Path) -> None:
    found = toolchain()
    command = found.cpp if source.suffix == ".cpp" else found.c
    options = ["-Wall", "-Wextra", "-Werror", "-Wno-unused-parameter", "-c", "-I.", "-o", "object.o"]
    done = subprocess.run(
        [*command, *options, source.name], cwd=source.parent, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
