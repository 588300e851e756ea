"""Names are what the generators of ROS 2 accept, whatever they were made from."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sigcat.integration.ros2.names import (
    CONSTANT,
    FIELD,
    LONGEST,
    MESSAGE,
    constant_name,
    field_name,
    message_name,
    package_name,
    topic_name,
)
from sigcat.reserved_words import CPP_KEYWORDS, PYTHON_KEYWORDS
from tests.integration.ros2.functions import document, function, signal

HOSTILE = st.one_of(
    st.text(max_size=300), st.sampled_from(["*/ #include <x>", '"><script>', "a__b_", "9", "_", "Ä", ""])
)


@pytest.mark.parametrize(
    ("source", "name"),
    [
        ("CylP", "cyl_p"),
        ("MapDataSpdUnitTyp", "map_data_spd_unit_typ"),
        ("IsABSActive", "is_abs_active"),
        ("Switch", "switch_value"),
        ("Global", "global_value"),
        ("In", "in_value"),
        ("1stRow", "value_1_st_row"),
        ("Errno", "errno_value"),
    ],
)
def test_a_field_is_lower_snake_case_and_no_keyword(source, name):
    assert field_name(source).text == name


def test_a_changed_name_says_why():
    assert field_name("Switch").reason == "'switch' is a reserved word of C++"
    assert field_name("CylP").reason == ""
    assert field_name("CylP", {"cyl_p"}) == ("cyl_p_2", "'cyl_p' is taken")


def test_messages_that_differ_in_case_alone_get_two_names():
    assert message_name("ADASMap", {"adasmap"}).text == "ADASMap2"


def test_a_constant_keeps_its_spelling_if_it_can():
    assert constant_name("NOT_IN_MAP").text == "NOT_IN_MAP"
    assert constant_name("kmPerHour").text == "KM_PER_HOUR"
    assert constant_name("NULL").text == "NULL_VALUE"
    assert constant_name("2WD").text == "VALUE_2_WD"


@given(HOSTILE)
def test_every_text_becomes_a_name_that_rosidl_accepts(source):
    for name, pattern in (
        (field_name(source), FIELD),
        (package_name(source), FIELD),
        (message_name(source), MESSAGE),
        (constant_name(source), CONSTANT),
    ):
        assert pattern.fullmatch(name.text), name
        assert len(name.text) <= LONGEST + 10
        assert name.text not in CPP_KEYWORDS | PYTHON_KEYWORDS


@given(st.lists(HOSTILE, max_size=8))
def test_names_beside_each_other_differ(sources):
    taken: set[str] = set()
    for source in sources:
        name = field_name(source, taken).text
        assert name not in taken
        taken.add(name)


@given(st.lists(HOSTILE, min_size=1, max_size=4))
def test_topics_are_made_of_field_names(segments):
    name = topic_name(*segments)
    assert all(FIELD.fullmatch(segment) for segment in name.split("/"))


def test_the_package_has_no_name_of_the_c_code():
    """It is a namespace of C++ beside them."""
    taken = function(signal(Variable="acc.speed"), name="Acc")
    assert document([taken])["NodePackageList"][0]["Name"] == "acc_2"
