"""One table says what a datatype is called everywhere."""

import pytest

from sigcat.catalogue.model.datatypes import INTEGER_RANGES
from sigcat.function.function_json.datatypes.primitive_types import PRIMITIVES
from sigcat.integration.datatypes import BY_VSS, SPELLINGS, of_reference
from tests.published.schemas import WORDS


def test_every_primitive_of_vss_has_a_row():
    assert set(BY_VSS) == {*INTEGER_RANGES, "boolean", "float", "double", "string"} == {row.vss for row in PRIMITIVES}


@pytest.mark.parametrize("column", ["vss", "reference", "c", "cpp", "autosar", "adaptive", "ros2"])
def test_no_two_rows_are_called_the_same(column):
    names = [getattr(row, column) for row in SPELLINGS]
    assert len(set(names)) == len(names)


def test_the_words_are_those_of_the_published_schema():
    assert {row.adaptive for row in SPELLINGS} - {"string"} == {*WORDS["numeric type"]["enum"]} - {"float32"}


@pytest.mark.parametrize(
    ("reference", "c_definition", "vss"),
    [
        ("DT_UInt8", "uint8_t", "uint8"),
        ("DT_SInt64", "double", "double"),
        ("DT_Bool", "unsigned char", "boolean"),
        ("DT_Speed", "unsigned short int", "uint16"),
        ("DT_Float32", "", "float"),
        ("DT_UInt64", "Unsigned double", "uint64"),
        ("DT_Thing", "struct Thing", None),
    ],
)
def test_the_c_definition_decides_where_the_name_disagrees(reference, c_definition, vss):
    found = of_reference(reference, c_definition)
    assert (found.vss if found else None) == vss
