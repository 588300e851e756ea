"""A core with float arithmetic is at most 1 ulp of float away from the one with double arithmetic (section 4)."""

import math
import random
import struct
import subprocess
from fractions import Fraction
from functools import cache
from itertools import product
from pathlib import Path
from typing import NamedTuple

import pytest

from sigcat.adapter.core.c.values.conversions import converted
from sigcat.adapter.core.c.values.literals import literal
from sigcat.adapter.core.core_files import RUNTIME_SOURCE, runtime_files
from sigcat.adapter.core.numbers import DOUBLE, FLOAT, NumberType, nearest_float, number_type
from sigcat.adapter.core.plan import Element
from sigcat.adapter.toolchain import EXACT, toolchain
from sigcat.function.function_json.conversion import IDENTITY, Linear, between
from tests.adapter.core.compilers import STRICT

STRICT_FLOAT = (*STRICT, "-Wdouble-promotion", "-Wno-unused-parameter", "-Wno-overflow")
FORMATS = {"boolean": "?", "uint8": "B", "int8": "b", "uint16": "H", "int16": "h", "uint32": "I", "int32": "i",
           "uint64": "Q", "int64": "q", "float": "f"}  # fmt: skip
NARROW = ("boolean", "uint8", "int8", "uint16", "int16", "uint32", "int32", "float")
LARGEST, TINY = 3.4028234663852886e38, 2.0**-149
SPLIT = 2.0**-43
"""Deviation where product and offset cancel each other, in relation to the offset."""


def unit(source: str, target: str) -> Linear:
    found = between(source, target)
    assert found is not None
    return found


CONVERSIONS = {
    "km/h to m/s": unit("km/h", "m/s"), "m/s to km/h": unit("m/s", "km/h"),
    "degrees to radians": unit("degrees", "radians"), "ps to w": unit("ps", "w"),
    "celsius to fahrenheit": unit("celsius", "fahrenheit"), "fahrenheit to celsius": unit("fahrenheit", "celsius"),
    "a hundredth": Linear(Fraction(1, 100)), "a half less forty": Linear(Fraction(1, 2), Fraction(-40)),
    "minus 0.1": Linear(Fraction(-1, 10)), "to kelvin": Linear(Fraction(1), Fraction(27315, 100)),
    "less forty": Linear(Fraction(1), Fraction(-40)), "thousands": Linear(Fraction(1000)),
    "much larger": Linear(Fraction(10**18), Fraction(1, 3)), "much smaller": Linear(Fraction(3, 10**18), Fraction(10**15)),
    "near a half": Linear(Fraction(16777217, 2**25)), "same scale": IDENTITY, "a long way round": Linear(Fraction(4194301, 2**22), Fraction(-123456789, 1000)),
}  # fmt: skip


class Case(NamedTuple):
    """A conversion between two types."""

    name: str
    source: NumberType
    target: NumberType
    conversion: Linear

    def expression(self, arithmetic: NumberType) -> str:
        element = Element(self.source, self.target, self.conversion, arithmetic=arithmetic)
        return converted("value", element, literal(7, self.target))


def cases(name: str) -> list[Case]:
    """A conversion between all types that can have it."""
    types = {known: each for known in FORMATS if (each := number_type(known))}
    sources = FORMATS if CONVERSIONS[name] == IDENTITY else NARROW
    return [
        Case(f"{name}: {source} to {target}", types[source], types[target], CONVERSIONS[name])
        for source, target in product(sources, FORMATS)
    ]


@cache
def values(of: NumberType, conversion: Linear) -> list[float]:
    """Limits, powers of two, zeros and limits of the converted number, each with its neighbours; and others by a fixed seed."""
    chosen = random.Random(f"{of.name} {conversion}")
    if of.is_boolean:
        return [False, True]
    zero = -conversion.offset / conversion.factor
    targets = [Fraction(0), *(sign * Fraction(2) ** power - shift for power in (7, 8, 15, 16, 31, 32, 63, 64, 128)
                    for sign in (1, -1) for shift in (0, Fraction(1, 2), 1))]  # fmt: skip
    marks = [zero, *(conversion.inverse(target) for target in targets)]
    if of.is_integer:
        low, high = int(of.smallest), int(of.largest)
        around = [round(mark) + step for mark in marks for step in range(-3, 4)]
        found = [0, 1, low, low + 1, high - 1, high, *around, *(chosen.randint(low, high) for _ in range(400))]
        found += [sign * (2**power + step) for power in range(64) for step in (-1, 0, 1) for sign in (1, -1)]
        return [number for number in found if low <= number <= high]
    floats = [0.0, -0.0, math.inf, -math.inf, math.nan, LARGEST, -LARGEST, TINY, -TINY]
    near = [nearest_float(mark) for mark in marks if abs(mark) <= LARGEST]
    near += [2.0**power for power in range(-149, 128)] + [number / 4 for number in range(-40, 41)]
    floats += [neighbour(number, step) for number in near for step in range(-3, 4)]
    floats += [chosen.uniform(-1, 1) * 2.0 ** chosen.randint(-30, 30) for _ in range(600)]
    floats += [chosen.uniform(-1, 1) * 2.0 ** chosen.randint(-149, 127) for _ in range(200)]
    return [unpacked("f", struct.pack("f", number)) for number in floats]


def unpacked(form: str, data: bytes) -> float:
    return float(*struct.unpack(form, data))


def ordinal(number: float) -> int:
    """Place of a float among all floats."""
    bits = int(*struct.unpack("i", struct.pack("f", number)))
    return bits if bits >= 0 else -(bits & 0x7FFFFFFF)


def neighbour(number: float, step: int) -> float:
    place = ordinal(number) + step
    return unpacked("f", struct.pack("I", place if place >= 0 else -place | 0x80000000))


def computed(tried: list[Case], arithmetic: NumberType, folder: Path) -> list[tuple[float, ...]]:
    """Results of cases, by the compiled expressions of an arithmetic."""
    folder.mkdir()
    for file in runtime_files(arithmetic):
        (folder / file.name).write_bytes(file.data)
    (folder / "cases.c").write_text(program(tried, arithmetic))
    strict = STRICT_FLOAT if arithmetic == FLOAT else ("-w",)
    command = [*toolchain().c, "-std=c99", "-O0", *strict, *EXACT, "cases.c", RUNTIME_SOURCE, "-o", "cases", "-lm"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    inputs = b"".join(packed(case) for case in tried)
    printed = subprocess.run([folder / "cases"], input=inputs, capture_output=True, check=True).stdout
    found, place = [], 0
    for case in tried:
        form = f"={len(values(case.source, case.conversion))}{FORMATS[case.target.name]}"
        found.append(struct.unpack_from(form, printed, place))
        place += struct.calcsize(form)
    return found


def packed(case: Case) -> bytes:
    numbers = values(case.source, case.conversion)
    return struct.pack(f"={len(numbers)}{FORMATS[case.source.name]}", *numbers)


def program(tried: list[Case], arithmetic: NumberType) -> str:
    lines = ['#include "sigcat_core_functions.h"', "#include <stdio.h>"]
    calls = []
    for number, case in enumerate(tried):
        count = len(values(case.source, case.conversion))
        lines += [f"static {case.target.c} case_{number}({case.source.c} value) {{ return {case.expression(arithmetic)}; }}",
                  f"static void run_{number}(void) {{ {case.source.c} value; int i; for (i = 0; i < {count}; i++) {{",
                  "    if (fread(&value, sizeof(value), 1U, stdin) == 1U) {",
                  f"        const {case.target.c} result = case_{number}(value);",
                  "        (void)fwrite(&result, sizeof(result), 1U, stdout); } } }"]  # fmt: skip
        calls.append(f"    run_{number}();")
    return "\n".join([*lines, "int main(void) {", *calls, "    return 0;", "}", ""])


@pytest.mark.parametrize("name", CONVERSIONS)
def test_a_conversion_in_float_is_at_most_one_ulp_away(name, tmp_path):
    tried = cases(name)
    near, found = (computed(tried, each, tmp_path / each.name) for each in (DOUBLE, FLOAT))
    for case, *results in zip(tried, near, found, strict=True):
        rows = zip(values(case.source, case.conversion), *results, strict=True)
        assert [(case.name, *row) for row in rows if not agree(case, *row)] == []


def agree(case: Case, value: float, near: float, found: float) -> bool:
    if case.conversion == IDENTITY or not math.isfinite(value):
        return near == found or (math.isnan(near) and math.isnan(found))
    factor, offset = map(float, case.conversion)
    exact = float(value) * factor + offset
    cancelled = SPLIT * abs(offset)
    if case.target == FLOAT:
        if abs(exact) >= LARGEST * (1 + 2.0**-22):  # saturated
            return found == near == math.copysign(LARGEST, exact)
        return abs(ordinal(found) - ordinal(near)) <= 1 or abs(found - near) <= cancelled
    if case.target.is_boolean:
        return near == found or abs(exact) <= max(TINY, cancelled)
    if abs(exact) > LARGEST:
        return found == near
    near_exact = nearest_float(Fraction(exact))
    lower, upper = (max(-LARGEST, min(neighbour(near_exact, step) + step * cancelled, LARGEST)) for step in (-1, 1))
    return saturated(lower, case.target) <= found <= saturated(upper, case.target)


def saturated(number: float, target: NumberType) -> int:
    return int(min(max(Fraction(round(number)), target.smallest), target.largest))


def test_a_product_has_no_second_float_and_an_offset_has():
    by_name = {case.name: case for name in CONVERSIONS for case in cases(name)}
    assert by_name["km/h to m/s: float to float"].expression(FLOAT) == "(value * 0.2777778F)"
    assert "Sigcat_Scaled" in by_name["fahrenheit to celsius: uint8 to float"].expression(FLOAT)
    assert by_name["less forty: uint8 to float"].expression(FLOAT) == "((float)value + -40.0F)"
    assert "Sigcat_RestOfUint32(value)" in by_name["a hundredth: uint32 to float"].expression(FLOAT)
