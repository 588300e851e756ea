"""Section 4: conversion, and section 14: bits."""

import math
import struct
from fractions import Fraction

import pytest

from tests.adapter.model.driven import Driven
from tests.adapter.reference.values.number_format import NumberFormat
from tests.adapter.written import (
    BOOL,
    DOUBLE,
    FLOAT,
    S16,
    U8,
    U16,
    U32,
    U64,
    array,
    enumeration,
    function,
    output,
    signal,
    step,
    structure,
    symbols,
)

INFINITE, NAN = math.inf, math.nan
LARGEST = struct.unpack("f", bytes.fromhex("ffff7f7f"))[0]
SCALED = {"Factor": "0.01", "Offset": "-100"}
TO_KMH = {"ConversionFactor": "18/5", "ConversionOffset": "0"}
"""The code has m/s, the catalogue km/h."""


def received(value, datatype, wire, **fields):
    """Value in the code."""
    run = Driven(function(step(signal("A", datatype, VssDatatype=wire, **fields)))).start()
    run.receive("A", value, 0)
    run.steps(0)
    return run.seen[-1]["a"]


def sent(value, datatype, wire, **fields):
    """Value in the catalogue."""
    document = function(step(output("A", datatype, VssDatatype=wire, **fields)))
    run = Driven(document, F_Step=lambda variables: variables.update(a=value)).start()
    run.steps(0)
    return run.adapter.out["A"]


@pytest.mark.parametrize(
    ("value", "datatype", "wire", "fields", "expected"),
    [
        (-99.995, U16, "double", SCALED, 0),  # exactly between 0 and 1, and 0 is even
        (-99.985, U16, "double", SCALED, 2),
        (-1000.0, U16, "double", SCALED, 0),
        (1000.0, U16, "float", SCALED, 65535),
        (INFINITE, U16, "float", SCALED, 65535),
        (-INFINITE, S16, "float", {}, -32768),
        (NAN, U16, "float", {**SCALED, "Default": 5}, 10500),
        (NAN, U16, "float", {**SCALED, "InitValue": 5}, 10500),
        (NAN, U16, "float", {}, 0),
        (2.5, U8, "float", {}, 2),
        (3.5, U8, "double", {}, 4),
        (300, U8, "uint16", {}, 255),
        (-5, U8, "int16", {}, 0),
        (2**64 - 1, U64, "uint64", {}, 2**64 - 1),
        (2**63, S16, "uint64", {}, 32767),
        (2**25 + 3, FLOAT, "uint32", {}, float(2**25 + 4)),
        (2**60 + 2**36 + 1, FLOAT, "uint64", {}, float(2**60 + 2**37)),  # through a double it would be 2**60
        (1e300, FLOAT, "double", {}, LARGEST),
        (-1e300, FLOAT, "double", {}, -LARGEST),
        (3.4028235677973366e38, FLOAT, "double", {}, LARGEST),
        (INFINITE, FLOAT, "double", {}, INFINITE),
        (1e-45, FLOAT, "double", {}, struct.unpack("f", bytes((1, 0, 0, 0)))[0]),
        (1e-46, FLOAT, "double", {}, 0.0),
        (0.1, FLOAT, "double", {}, struct.unpack("f", struct.pack("f", 0.1))[0]),
        (5, BOOL, "uint8", {}, 1),
        (0.0, BOOL, "float", {}, 0),
        (NAN, BOOL, "float", {}, 1),
        (1, DOUBLE, "boolean", {}, 1.0),
        (1, U8, "boolean", {}, 1),
        (100.0, DOUBLE, "float", TO_KMH, 100.0 * float(Fraction(5, 18))),
        (36.1, DOUBLE, "double", TO_KMH, 36.1 * float(Fraction(5, 18))),
        (123.45, DOUBLE, "double", {"Factor": "0.01", "Offset": "123.45"}, 123.45 * 100.0 + -12345.0),
    ],
)
def test_what_is_received(value, datatype, wire, fields, expected):
    assert received(value, datatype, wire, **fields) == expected


def test_a_product_is_rounded_before_the_offset_is_added():
    assert received(123.45, DOUBLE, "double", Factor="0.01", Offset="123.45") == 0.0


@pytest.mark.parametrize(
    ("value", "datatype", "wire", "fields", "expected"),
    [
        (10000, U16, "float", SCALED, 0.0),
        (1, U16, "double", SCALED, 1 * 0.01 + -100.0),
        (10.0, FLOAT, "float", TO_KMH, 36.0),
        (10.0, FLOAT, "uint8", TO_KMH, 36),
        (1000.0, FLOAT, "uint8", TO_KMH, 255),
        (NAN, FLOAT, "uint8", {**TO_KMH, "Default": 5}, 18),
    ],
)
def test_what_is_sent(value, datatype, wire, fields, expected):
    assert sent(value, datatype, wire, **fields) == expected


@pytest.mark.parametrize("value", [-0.0, 5e-324, INFINITE])
def test_the_same_scale_and_datatype_keep_the_bits(value):
    assert struct.pack("d", received(value, DOUBLE, "double")) == struct.pack("d", value)


def test_a_negative_zero_stays_one_where_only_the_format_changes():
    assert math.copysign(1, received(-0.0, FLOAT, "double")) == -1.0
    assert math.copysign(1, received(-0.0, DOUBLE, "float", **TO_KMH)) == -1.0


CODE = enumeration("DT_Gear", "int8_t", PARK=-1, DRIVE=5)
WIRE = symbols(PARK=0, DRIVE=1, REVERSE=2)


def test_enumerations_are_converted_by_name():
    document = function(
        step(signal("A", "DT_Gear", VssDatatype="string", VssSymbols=WIRE), output("B", "DT_Gear", VssSymbols=WIRE, VssDatatype="uint16")),
        datatypes=(CODE,),
    )  # fmt: skip
    run = Driven(document, F_Step=lambda variables: variables.update(b=-1)).start()
    run.receive("A", 1, 0)
    run.steps(0)
    assert run.seen[-1]["a"] == 5
    assert run.adapter.out["B"] == 0


def test_elements_and_members_are_converted_each():
    point = structure("DT_Point", x=FLOAT, rows=("DT_Rows",))
    document = function(
        step(signal("A", "DT_Points"), signal("B", "DT_Rows", VssDatatype="float[]", **TO_KMH)),
        datatypes=(point, array("DT_Rows", U8, 2), array("DT_Points", "DT_Point", 2)),
    )
    run = Driven(document).start()
    run.receive("A", (1.5, 1, 2, 2.5, 3, 4), 0)
    run.receive("B", (36.0, 72.0), 0)
    run.steps(0)
    assert run.seen[-1] == {"a": (1.5, 1, 2, 2.5, 3, 4), "b": (10, 20)}


def test_scaled_64_bit_integers_are_refused():
    with pytest.raises(ValueError, match="64-bit"):
        Driven(function(step(signal("A", U64, VssDatatype="double", Factor="2"))))


@pytest.mark.parametrize(
    ("datatype", "fields", "value", "is_within"),
    [
        ("double", {"Max": 69.44444444444444}, 250.0, True),
        ("double", {"Max": 69.44444444444444}, math.nextafter(250.0, 300), False),
        ("uint8", {"Max": 69.44444444444444}, 250, True),
        ("uint8", {"Max": 69.44444444444444}, 251, False),
        ("uint8", {"Max": 27.7}, 99, True),
        ("uint8", {"Max": 27.7}, 100, False),
    ],
)
def test_limits_are_those_of_the_catalogue_though_the_document_has_rounded_ones(datatype, fields, value, is_within):
    assert (
        received(value, DOUBLE, datatype, **TO_KMH, **fields, RangeErrorAction="Default", Default=-1) != -1
    ) is is_within


def test_a_substitute_is_sent_as_the_catalogue_has_it():
    assert sent(NAN, DOUBLE, "double", **TO_KMH, Default=69.44444444444444, RangeErrorAction="Default") == 250.0


def test_where_there_is_no_catalogue_the_code_says_what_is_received():
    assert received(1234, U16, None, **SCALED) == 1234


@pytest.mark.parametrize("bits", [0x00000001, 0x007FFFFF, 0x3DCCCCCD, 0x7F7FFFFF])
def test_floats_are_rounded_to_the_nearest_ties_to_even(bits):
    low, high = (Fraction(struct.unpack("f", struct.pack("I", each))[0]) for each in (bits - 1, bits))
    even = low if bits % 2 else high
    between = (low + high) / 2
    nudge = (high - low) / 10**9
    nearest = NumberFormat("float").nearest
    assert [nearest(each) for each in (between, between - nudge, between + nudge)] == [
        float(even),
        float(low),
        float(high),
    ]


@pytest.mark.parametrize("number", [Fraction(1, 3), Fraction(2**53 + 1), Fraction(1, 2**1074 * 3), Fraction(10) ** 300])
def test_doubles_are_those_of_python(number):
    assert NumberFormat("double").nearest(number) == float(number)


def test_integers_of_32_bits_are_exact_in_a_double():
    assert received(2**32 - 1, U32, "double") == 2**32 - 1
