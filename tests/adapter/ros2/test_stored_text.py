"""Stored values mean the same in C++ and in Python: one list of cases, which both read and write."""

import subprocess
from math import inf, nan
from pathlib import Path
from struct import pack, unpack
from typing import Any, NamedTuple, Protocol

import pytest

from sigcat.adapter.ros2.python.support import stored_text
from tests.adapter.ros2.generated import full, write
from tests.needs import CPP_COMPILERS, cpp_compiler

PROGRAM = Path(__file__).parent / "stored_text_program.cpp"
KEPT = b"sigcat 1\n"

FILES = {
    KEPT: KEPT,
    KEPT + b"b: 2\na: 1\n": KEPT + b"a: 1\nb: 2\n",
    KEPT + b"of another version: 1: 2 x\n": KEPT + b"of another version: 1: 2 x\n",
    KEPT + b"a: \n": KEPT + b"a: \n",
    KEPT + b"\xff\xc3\xa4\x00: \xfe\r\x00\n": KEPT + b"\xff\xc3\xa4\x00: \xfe\r\x00\n",
    KEPT + "９: １\u2028\n".encode(): KEPT + "９: １\u2028\n".encode(),
    b"": None,
    b"sigcat 1": None,
    b"sigcat 1\r\n": None,
    b"sigcat 2\n": None,
    b"\xef\xbb\xbfsigcat 1\n": None,
    KEPT + b"a: 1": None,
    KEPT + b"a:1\n": None,
    KEPT + b"a\n": None,
    KEPT + b": 1\n": None,
    KEPT + b"\n": None,
    KEPT + b"a: 1\na: 1\n": None,
}  # fmt: skip
"""Files, and how they are written again; None for those that are broken."""

SINGLE = unpack("f", pack("I", 0x15AE43FE))[0]
"""A number that the shortest text of its neighbour, 7.038531e-26, would give: read as a double, that is halfway."""
VALUES = [
    ("_Bool", "true", True),
    ("_Bool", "false", False),
    *(("_Bool", text, None) for text in ("", "True", "1", "0", " true", "true\r")),
    ("uint8_t", "0", 0),
    ("uint8_t", "255", 255),
    ("int8_t", "-128", -128),
    ("int8_t", "127", 127),
    ("uint16_t", "65535", 65535),
    ("int16_t", "-32768", -32768),
    ("uint32_t", "4294967295", 2**32 - 1),
    ("int32_t", "-2147483648", -(2**31)),
    ("uint64_t", "18446744073709551615", 2**64 - 1),
    ("int64_t", "-9223372036854775808", -(2**63)),
    ("uint8_t", "256", None),
    ("int8_t", "-129", None),
    ("uint32_t", "4294967296", None),
    ("int32_t", "2147483648", None),
    ("uint64_t", "18446744073709551616", None),
    ("int64_t", "9223372036854775808", None),
    ("uint64_t", "9" * 5000, None),
    ("uint64_t", "-1", None),
    *(
        (datatype, text, None)
        for datatype in ("uint16_t", "int32_t")
        for text in ("", "+7", " 7", "7 ", "7\r", "1_0", "７", "٧", "-0", "-", "007", "0x7", "7.0", "7e0", "7\0", "7 7")
    ),
    *(
        (datatype, text, value)
        for datatype in ("float", "double")
        for text, value in {
            "0": 0.0, "-0": -0.0, "7": 7.0, "-7.25": -7.25, "007": 7.0, "1e3": 1e3, "1e+10": 1e10,
            "5e-1": 0.5, "1.25e-01": 0.125, "inf": inf, "-inf": -inf, "nan": nan, "-nan": nan, "1e-400": 0.0,
            "-1e-99999999999999999999": -0.0, "0e99999": 0.0,
        }.items()
    ),
    ("double", "0.1", 0.1),
    ("double", "5e-324", 5e-324),
    ("double", "2.2250738585072014e-308", 2.2250738585072014e-308),
    ("double", "1.7976931348623157e+308", 1.7976931348623157e308),
    ("double", "0." + "0" * 300 + "1" + "0" * 5000, 1e-301),
    ("float", "0.1", unpack("f", pack("f", 0.1))[0]),
    ("float", "1e-45", 2.0**-149),
    ("float", "1e-60", 0.0),
    ("float", "3.4028235e+38", (2 - 2.0**-23) * 2.0**127),
    ("float", "7.038531e-26", SINGLE),
    ("float", "3.4028236e+38", None),
    ("float", "1e39", None),
    ("float", "-1e39", None),
    *(
        (datatype, text, None)
        for datatype in ("float", "double")
        for text in (
            "", "1e400", "-1e400", "1e99999999999999999999", "+7", " 7", "7 ", "7\r", "1_0", "７", "-", ".", ".5", "5.", "1.e5", "1E5", "1e",
            "1e+", "e5", "--1", "0x1p3", "1,5", "1.5.5", "Inf", "infinity", "NaN", "nan(1)", "+inf", "7\0", "1.5f", "1 2",
        )
    ),
    ("float[3]", "1 -2.5 1e-3", [1.0, -2.5, unpack("f", pack("f", 1e-3))[0]]),
    *(
        ("float[3]", text, None)
        for text in ("", "1 2", "1 2 3 4", " 1 2 3", "1 2 3 ", "1  2 3", "1\t2\t3", "1 2 x", "1 2 1e39", "1 2 \u00a03")
    ),
]  # fmt: skip
"""Datatype, text, and the value that it is; None if it is none."""

WRITTEN = [
    0.0,
    -0.0,
    1.0,
    0.1,
    -1e-7,
    1e22,
    100000.0,
    123456.789,
    1 / 3,
    5e-324,
    1.7976931348623157e308,
    inf,
    -inf,
    nan,
]
WRITTEN_SINGLES = [
    0x15AE43FD,
    0x15AE43FE,
    0x7F7FFFFF,
    0x00000001,
    0x80000001,
    0x3DCCCCCD,
    0x00800000,
    0x7F800000,
    0x4B800001,
]


class Language(Protocol):
    """Reader and writer of stored values in a language."""

    def parse(self, data: bytes) -> bytes | None: ...
    def read(self, datatype: str, text: str) -> Any: ...
    def write(self, datatype: str, value: float) -> str: ...


class Python:
    """The module of every package in Python."""

    def parse(self, data: bytes) -> bytes | None:
        """Return the text that would be written from a file again."""
        try:
            return stored_text.stored_text(stored_text.parse(data))
        except stored_text.BrokenFile:
            return None

    def read(self, datatype: str, text: str) -> Any:
        """Return the value of a text in a file."""
        kept = text.encode().decode("ascii", "surrogateescape")
        try:
            if datatype == "float[3]":
                return stored_text.read_texts(kept, "float", 3)
            return stored_text.read_text(kept, datatype)
        except stored_text.BrokenFile:
            return None

    def write(self, datatype: str, value: float) -> str:
        """The text of a value."""
        return stored_text.text_of(value, datatype)


class Cpp(NamedTuple):
    """The source of every package in C++, in a program."""

    program: Path

    def _ask(self, data: bytes, *arguments: str) -> bytes | None:
        done = subprocess.run([self.program, *arguments], input=data, stdout=subprocess.PIPE, check=False)
        assert done.returncode in (0, 1)
        return done.stdout if done.returncode == 0 else None

    def parse(self, data: bytes) -> bytes | None:
        """Return the text that would be written from a file again."""
        return self._ask(data, "parse")

    def read(self, datatype: str, text: str) -> Any:
        """Return the value of a text in a file."""
        told = self._ask(text.encode(), "read", datatype)
        if told is None:
            return None
        if datatype == "_Bool":
            return {"true ": True, "false ": False}[told.decode()]
        values = [_value(datatype, word) for word in told.decode().split()]
        return values if datatype == "float[3]" else values[0]

    def write(self, datatype: str, value: float) -> str:
        """The text of a value."""
        told = self._ask(value.hex().encode(), "write", datatype)
        assert told is not None
        return told.decode()


def _value(datatype: str, word: str) -> float:
    return int(word) if "int" in datatype else float.fromhex(word)


@pytest.fixture(scope="module")
def cpp(tmp_path_factory) -> Cpp:
    """Built from the generated source alone, without ROS."""
    made, folder = full(), tmp_path_factory.mktemp("stored_text")
    names = ("include/full/stored_text.hpp", "src/stored_text.cpp")
    write({name: made[f"full/{name}"] for name in names}, folder)
    command = [*CPP_COMPILERS[0], "-std=c++17", "-Wall", "-Wextra", "-Werror", "-I", folder / "include", PROGRAM]
    subprocess.run([*command, folder / "src/stored_text.cpp", "-o", folder / "program"], check=True)
    return Cpp(folder / "program")


@pytest.fixture(params=["Python", pytest.param("C++", marks=cpp_compiler)])
def language(request) -> Language:
    """Each of the two."""
    return request.getfixturevalue("cpp") if request.param == "C++" else Python()


@pytest.mark.parametrize(("data", "again"), FILES.items())
def test_a_file_has_the_same_lines_and_all_of_them_stay(language, data, again):
    assert language.parse(data) == again


def test_a_value_has_one_text_and_a_text_one_value(language):
    """Compared as text: a zero has a sign, and NaN equals nothing."""
    read = [(datatype, text, language.read(datatype, text)) for datatype, text, _ in VALUES]
    assert list(map(repr, read)) == list(map(repr, VALUES))


@cpp_compiler
@pytest.mark.parametrize(("datatype", "values"), [
    ("double", WRITTEN), ("float", [unpack("f", pack("I", bits))[0] for bits in WRITTEN_SINGLES]),
])  # fmt: skip
def test_what_one_language_has_written_both_read(language, cpp, datatype, values):
    for value in values:
        text = language.write(datatype, value)
        assert repr(Python().read(datatype, text)) == repr(cpp.read(datatype, text)) == repr(value), text
