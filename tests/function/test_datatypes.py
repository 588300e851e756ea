"""Datatypes: what C definitions and references mean."""

import pytest

from sigcat.catalogue.model.datatypes import PRIMITIVES as VSS
from sigcat.function.function_json.datatypes.primitive_types import PRIMITIVES, CType, agree, c_type, reference_type


def test_every_vss_datatype_has_a_row():
    assert {row.vss for row in PRIMITIVES} == VSS - {"numeric"}


@pytest.mark.parametrize("row", PRIMITIVES, ids=lambda row: row.vss)
def test_reference_and_c_definition_of_a_row_agree(row):
    promised, actual = reference_type(row.reference), c_type(row.c)
    assert promised is not None
    assert actual is not None
    assert agree(promised, actual)


@pytest.mark.parametrize(
    ("definition", "meaning"),
    [
        ("unsigned char", CType("unsigned", 8)),
        ("unsigned short int", CType("unsigned", 16)),
        ("int unsigned short", CType("unsigned", 16)),
        ("signed long long", CType("signed", 64)),
        ("long", CType("signed", 0)),
        ("unsigned", CType("unsigned", 32)),
        ("uint16_t", CType("unsigned", 16)),
        ("sint32", CType("signed", 32)),
        ("float64", CType("floating", 64)),
        ("  double ", CType("floating", 64)),
        ("_Bool", CType("boolean", 8)),
        ("const char*", CType("text", 0)),
        ("Unsigned double", None),
        ("unsigned signed int", None),
        ("short long", None),
        ("struct Point", None),
        ("", None),
        ("; system()", None),
    ],
)
def test_a_c_definition_is_understood(definition, meaning):
    assert c_type(definition) == meaning
