"""While it is compiled, a core holds the declaration against the function's own variables."""

import subprocess

import pytest

from sigcat.adapter.core.core_files import core_files
from sigcat.adapter.core.planned_core import derive
from sigcat.adapter.toolchain import toolchain
from tests.adapter.written import (
    BOOL,
    DOUBLE,
    FLOAT,
    S16,
    U8,
    U16,
    U32,
    array,
    enumeration,
    function,
    output,
    queue,
    signal,
    step,
)
from tests.function.shipped import resolved

DATATYPES = (
    array("DT_Floats", FLOAT, 3), array("DT_Bytes", U8, 3), enumeration("DT_Gear", PARK=0, DRIVE=5),
    enumeration("DT_Far", "int16_t", NEAR=0, FAR=300), enumeration("DT_Signed", "int8_t", UNKNOWN=-1, ONE=1), enumeration("DT_Bit", OFF=0, ON=1),
    enumeration("DT_Half", LOW=0, HIGH=200),
)  # fmt: skip
READ = {
    "as declared": (signal("A", FLOAT), "float a;", ""),
    "wider": (signal("A", FLOAT), "double a;", ""),
    "narrower": (signal("A", DOUBLE), "float a;", "io.a must be double"),
    "a narrower integer": (signal("A", U16), "uint8_t a;", "io.a must be uint16_t"),
    "a bit field": (signal("A", U8), "unsigned a : 3;", ""),
    "a flag in whatever": (signal("A", BOOL), "int a;", ""),
    "an enumeration of C": (signal("A", "DT_Gear"), "enum { PARK, DRIVE } a;", ""),
    "an array": (signal("A", "DT_Floats"), "float a[3];", ""),
    "a shorter array": (signal("A", "DT_Floats"), "float a[2];", "io.a must have 3 elements"),
    "a longer array": (signal("A", "DT_Floats"), "float a[4];", "io.a must have 3 elements"),
    "elements that are narrower": (signal("A", "DT_Floats"), "uint8_t a[3];", "io.a[0] must be float"),
    "a pointer for an array": (signal("A", "DT_Floats"), "float *a;", "io.a must have 3 elements"),
    "queued values": (queue("A", 4, U8, ValuesPerStep=3), "uint8_t a[5];", ""),
    "no room for queued values": (queue("A", 4, U8, ValuesPerStep=3), "uint8_t a[2];", "io.a must have at least 3 elements"),
    "a pointer with room by chance": (queue("A", 4, U8, ValuesPerStep=3), "uint8_t *a;", "io.a must have at least 3 elements"),
    "a number beyond the variable": (signal("A", "DT_Far"), "uint8_t a;", "io.a must be an integer that holds 0 to 300"),
    "a number within the variable": (signal("A", "DT_Far"), "int16_t a;", ""),
    "a number of either sign": (signal("A", "DT_Signed"), "int8_t a;", ""),
    "a count in any integer that holds it": (queue("A", 400, U8, ValuesPerStep=200, CountVariable="io.n"), "uint8_t a[200]; int16_t n;", ""),
    "a count beyond the variable": (
        queue("A", 400, U8, ValuesPerStep=300, CountVariable="io.n"), "uint8_t a[300], n;",
        "io.n must be an integer that holds 0 to 300",
    ),
    "one place for queued values": (queue("A", 4, U8, ValuesPerStep=3), "uint8_t a;", "subscript"),
}  # fmt: skip
WRITTEN = {
    "as declared": (output("A", U8), "uint8_t a;", ""),
    "wider": (output("A", FLOAT), "double a;", "io.a must be float"),
    "narrower": (output("A", U16), "uint8_t a;", ""),
    "a bit field": (output("A", U8), "unsigned a : 3;", ""),
    "a number beyond the variable": (
        output("A", "DT_Far"),
        "uint8_t a;",
        "io.a must be an integer that holds 0 to 300",
    ),
    "room for a whole queue": (
        queue("A", 4, U8, "Provider", CountVariable="io.n"),
        "uint8_t a[3], n;",
        "io.a must have at least 4 elements",
    ),
}
KINDS = {
    "a signed one": (signal("A", U32), "int32_t a;", "io.a must be uint32_t"),
    "a signed one that is wider": (signal("A", U16), "volatile int32_t a;", ""),
    "an unsigned one": (signal("A", S16), "uint32_t a;", "io.a must be int16_t"),
    "an integer for a float": (signal("A", FLOAT), "int a;", "io.a must be float"),
    "a float for an integer": (signal("A", U16), "double a;", "io.a must be uint16_t"),
    "a boolean for an integer": (signal("A", U8), "bool a;", "io.a must be uint8_t"),
    "a float for a flag": (signal("A", BOOL), "float a;", "io.a must be an integer"),
    "a float for an enumeration": (signal("A", "DT_Gear"), "float a;", "io.a must be an integer"),
    "a number beyond the signed variable": (signal("A", "DT_Half"), "int8_t a;", "io.a must be an integer that holds 0 to 200"),
    "a negative number": (signal("A", "DT_Signed"), "uint8_t a;", "io.a must be an integer that holds -1 to 1"),
    "a negative number for a wide one": (signal("A", "DT_Signed"), "uint64_t a;", "io.a must be an integer that holds -1 to 1"),
    "an enumeration in a flag": (signal("A", "DT_Gear"), "bool a;", "io.a must be an integer that holds 0 to 5"),
    "an enumeration of two in a flag": (signal("A", "DT_Bit"), "bool a;", ""),
    "a count in a flag": (queue("A", 4, U8, ValuesPerStep=3, CountVariable="io.n"), "uint8_t a[3]; bool n;", "io.n must be an integer that holds 0 to 3"),
    "a count beyond the signed variable": (
        queue("A", 400, U8, ValuesPerStep=200, CountVariable="io.n"), "uint8_t a[200]; int8_t n;",
        "io.n must be an integer that holds 0 to 200",
    ),
    "a character": (signal("A", U8), "char a;", ""),
    "signed elements": (signal("A", "DT_Bytes"), "int8_t a[3];", "io.a[0] must be uint8_t"),
    "provided unsigned and narrower": (output("A", S16), "uint8_t a;", ""),
    "provided unsigned": (output("A", S16), "uint16_t a;", "io.a must be int16_t"),
    "provided signed and narrower": (output("A", U16), "int8_t a;", "io.a must be uint16_t"),
    "provided a float from an integer": (output("A", FLOAT), "uint16_t a;", "io.a must be float"),
}  # fmt: skip
NAMED = {
    "at least": "as_many_elements_as_declared",
    "elements": "as_many_elements_as_declared",
    "holds": "must_be_an_integer_that_holds_its_numbers",
    "must be": "than_declared",
}
"""Names of arrays in C99, which has no message, by the message of C11."""
CASES = [*(READ.items()), *((f"provided {name}", case) for name, case in WRITTEN.items())]


@pytest.mark.parametrize("standard", ["c99", "c11"])
@pytest.mark.parametrize(("item", "members", "expected"), [case for _, case in CASES], ids=[name for name, _ in CASES])
def test_a_size_that_is_not_the_declared_one_does_not_compile(item, members, expected, standard, tmp_path):
    done = compiled(item, members, f"-std={standard}", tmp_path)
    assert (done.returncode == 0) is (expected == ""), done.stderr
    if standard == "c11":
        assert expected in done.stderr
    elif expected not in ("", "subscript"):
        assert NAMED[next(word for word in NAMED if word in expected)] in done.stderr


@pytest.mark.parametrize("standard", ["c11", "gnu99"])
@pytest.mark.parametrize(("item", "members", "expected"), KINDS.values(), ids=KINDS)
def test_a_kind_or_sign_that_is_not_the_declared_one_does_not_compile(item, members, expected, standard, tmp_path):
    done = compiled(item, members, f"-std={standard}", tmp_path)
    assert (done.returncode == 0) is (expected == ""), done.stderr
    assert expected in done.stderr


@pytest.mark.parametrize(("item", "members", "expected"), KINDS.values(), ids=KINDS)
def test_so_it_is_in_a_class_of_cpp(item, members, expected, tmp_path):
    (tmp_path / "f.hpp").write_text(
        f"#include <cstdint>\nclass F {{ public: struct {{ {members} }} io; void F_Step(); }};\n"
    )
    code = {"Signature": "Class", "ClassName": "F", "Headers": ["f.hpp"]}
    done = compile_core(step({**item, "Variable": "io.a"}), code, ["-std=c++17"], tmp_path)
    assert (done.returncode == 0) is (expected == ""), done.stderr
    assert expected in done.stderr


def compiled(item, members, standard, tmp_path):
    (tmp_path / "f.h").write_text(
        f"#include <stdbool.h>\n#include <stdint.h>\ntypedef struct {{ {members} }} Io;\nvoid F_Step(Io *io);\n"
    )
    code = {"Signature": "Pointers", "Headers": ["f.h"], "Objects": [{"Name": "io", "Type": "Io"}]}
    call = step({**item, "Variable": "io.a"}, Arguments=["io"])
    return compile_core(call, code, [standard, "-pedantic"], tmp_path)


def compile_core(call, code, options, tmp_path):
    files = core_files(derive(resolved(function(call, datatypes=DATATYPES, Code=code))).plan)
    for file in files.files:
        (tmp_path / file.name).write_bytes(file.data)
    compiler = toolchain().cpp if files.source.name.endswith(".cpp") else toolchain().c
    command = [*compiler, *options, "-Werror", "-c", files.source.name, "-o", "core.o"]
    return subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
