"""Written cells can be read again, bit by bit."""

import math
import struct
from collections.abc import Sequence

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sigcat.adapter.host.shapes import Array, Number, Record, Shape, packing
from sigcat.runs.recording.cells import cell_of, value_of

NAMED = Number("uint8", (("LOW", 0), ("HIGH", 7), ('a"b,c', 9)))
SHAPES: Sequence[Shape] = [
    *(Number(name) for name in ("boolean", "uint8", "int64", "uint64", "float", "double")),
    NAMED,
    Array(Number("float"), 3),
    Array(NAMED, 2),
    Record((("X", Number("float")), ("Kinds", Array(NAMED, 2)), ("Point", Record((("Y", Number("int16")),))))),
]
MOST_BYTES = max(packing(shape).struct.size for shape in SHAPES)


@pytest.mark.parametrize("shape", SHAPES, ids=str)
@given(st.binary(min_size=MOST_BYTES, max_size=MOST_BYTES))
def test_a_value_is_read_as_it_was_written(shape, data):
    form = packing(shape)
    value = form.unpack(data[: form.struct.size])
    again = form.unpack(form.pack(value_of(cell_of(value, shape), shape)))
    assert form.pack(again) == form.pack(value) or "nan" in repr(value)
    assert repr(again) == repr(value)


@given(st.integers(0, 2**31 - 1))
def test_a_float_has_as_few_digits_as_give_it_again(bits):
    (number,) = struct.unpack("<f", struct.pack("<I", bits))
    text = cell_of(number, Number("float"))
    mantissa = text.partition("e")[0].replace(".", "").strip("0")
    assert struct.pack("<f", float(text)) == struct.pack("<f", number) or math.isnan(number)
    assert len(mantissa) <= 9


@pytest.mark.parametrize(
    ("number", "text"),
    [
        (0.1, "0.1"),
        (-0.0, "-0.0"),
        (0.0, "0.0"),
        (1e-45, "1e-45"),
        (16777216.0, "16777216.0"),
        (3.4028234663852886e38, "3.4028235e+38"),
    ],
)
def test_a_float_stands_there_as_one_would_write_it(number, text):
    assert cell_of(struct.unpack("<f", struct.pack("<f", number))[0], Number("float")) == text


BETWEEN = "1.00000005960464477539062500001"
"""Just above the middle of two floats, which its double is."""


@pytest.mark.parametrize(
    ("text", "nearest"),
    [
        (BETWEEN, "3f800001"),
        ("1.000000059604644775390625", "3f800000"),
        ("1.00000005960464477539062499999", "3f800000"),
        (f"-{BETWEEN}", "bf800001"),
        ("16777217.0000000000000000001", "4b800001"),
        ("16777217", "4b800000"),
        ("7.006492321624085354618647916449580656401309709382578858785341419448955413429303e-46", "00000000"),
        ("7.006492321624085354618647916449580656401309709382578858785341419448955413429304e-46", "00000001"),
        ("340282356779733661637539395458142568447", "7f7fffff"),
    ],
)
def test_a_float_is_rounded_once(text, nearest):
    for shape, cell in ((Number("float"), text), (Array(Number("float"), 1), f"[{text}]")):
        packed = packing(shape).pack(value_of(cell, shape))
        assert struct.unpack("<I", packed) == (int(nearest, 16),)
