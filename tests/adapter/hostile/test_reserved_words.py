"""Signals may have any name of the language, of the compiler and of the standard headers: the core compiles."""

import re
import subprocess

import pytest

from sigcat.adapter.core.core_files import core_files
from sigcat.adapter.core.planned_core import derive
from sigcat.adapter.toolchain import toolchain
from sigcat.function.document.document import Document, Position
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.reserved_words import C_KEYWORDS, CPP_KEYWORDS, is_reserved
from tests.integration.autosar_adaptive.sets import function, parameter, signal

HEADERS = ("assert", "errno", "float", "inttypes", "limits", "math", "stdbool", "stddef", "stdint", "stdio", "stdlib", "string", "time")  # fmt: skip
TYPES = (
    "uint8_t",
    "int_fast16_t",
    "uintptr_t",
    "size_t",
    "ptrdiff_t",
    "max_align_t",
    "char8_t",
    "wchar_t",
    "float_t",
    "FILE",
    "time_t",
)


def macros(tmp_path, *, is_cpp):
    """Names that the compiler and the headers define, but for those that C reserves for them."""
    source = tmp_path / ("macros.cpp" if is_cpp else "macros.c")
    source.write_text("".join(f"#include <{name}.h>\n" for name in HEADERS))
    standard = "-std=gnu++17" if is_cpp else "-std=gnu11"
    command = [*toolchain().compiler(is_cpp=is_cpp), standard, "-dM", "-E", str(source)]
    found = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    return sorted(name for name in set(re.findall(r"#define (\w+)", found)) if not name.startswith("_"))


def compiled(names, tmp_path, *, is_cpp):
    """Compile a core with a signal and a parameter of each name."""
    (tmp_path / "f.h").write_text(
        "#include <stdbool.h>\n#include <stdint.h>\ntypedef struct { float a[4000]; } Io;\n"
        + ("class F { public: Io io; void F_Step(void); };\n" if is_cpp else "extern Io io;\nvoid F_Step(void);\n")
    )
    signals = [signal(name, Variable=f"io.a[{index}]") for index, name in enumerate(names)]
    tuned = [parameter(Name=f"{name}", Variable=f"io.a[{index + 2000}]") for index, name in enumerate(names)]
    code = {"Signature": "Class", "ClassName": "F"} if is_cpp else {"Signature": "Globals"}
    made = function(
        "F", signals=signals[::2], contract={"ParameterList": tuned[1::2]}, Code={**code, "Headers": ["f.h"]}
    )
    document = Document("f.json", "", None, (), lambda pointer, *, of_key=False: Position())
    files = core_files(derive(ResolvedFunction(made, document)).plan)
    for file in files.files:
        (tmp_path / file.name).write_bytes(file.data)
    standard = "-std=gnu++17" if is_cpp else "-std=gnu11"
    command = [*toolchain().compiler(is_cpp=is_cpp), standard, "-fsyntax-only", files.source.name]
    return subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)


@pytest.mark.parametrize("is_cpp", [False, True], ids=["c", "c++"])
def test_a_core_with_signals_and_parameters_of_all_these_names_compiles(is_cpp, tmp_path):
    words = sorted({*C_KEYWORDS, *CPP_KEYWORDS, *TYPES, "linux", "unix", *macros(tmp_path, is_cpp=is_cpp)})
    assert len(words) > 500
    for shift in (words, words[1:]):
        done = compiled(shift, tmp_path, is_cpp=is_cpp)
        assert done.returncode == 0, done.stderr[:2000]


@pytest.mark.parametrize("is_cpp", [False, True], ids=["c", "c++"])
def test_every_macro_of_the_headers_is_reserved(is_cpp, tmp_path):
    assert [name for name in macros(tmp_path, is_cpp=is_cpp) if not is_reserved(name)] == []
