"""Mappings of network values."""

import math

import pytest

from sigcat.catalogue.network.mapping import mapping_of
from sigcat.catalogue.network.markers import means_no_value, with_markers
from sigcat.catalogue.network.network_values import NetworkValue, Unfit, value_of

NAMES = {4: "GEAR_D", 2: "GEAR_P", 3: "GEAR_R", 7: "GEAR_SNA"}


def made(attribute, given, network, datatype="float", allowed=(), names=NAMES):
    mapping = mapping_of(attribute, {"signal": "S", **given})
    assert mapping is not None
    marked = with_markers(mapping, datatype, names, lambda raw: raw < 1000)
    try:
        return value_of(network, marked, datatype, frozenset(allowed))
    except Unfit as reason:
        return str(reason)


def number(physical, raw=None, name=None):
    return NetworkValue(physical if raw is None else raw, physical, name)


GEARS = {"transform": {"mapping": [{"from": "GEAR_D", "to": 1}, {"from": "GEAR_P", "to": 0}, {"from": 7, "to": -1}]}}


@pytest.mark.parametrize(
    ("network", "value"),
    [
        (number(4, name="GEAR_D"), 1),
        (number(2, name="GEAR_P"), 0),
        (number(7), -1),
        (number(7, name="GEAR_R"), -1),
        (number(9, name="GEAR_SNA"), "not among the listed values"),
        (number(9), "not among the listed values"),
    ],
)
def test_kuksa_looks_for_a_name_or_a_number(network, value):
    assert made("dbc2vss", GEARS, network, "int8") == value


def test_the_first_of_two_items_for_one_value_counts():
    given = {"transform": {"mapping": [{"from": 3, "to": 7}, {"from": 3, "to": 8}]}}
    assert made("dbc", given, number(3), "int8") == 7


def test_without_a_transform_a_text_gets_the_name_and_a_number_the_number():
    network = number(4.5, raw=4, name="GEAR_D")
    assert made("dbc2vss", {}, network, "string") == "GEAR_D"
    assert made("dbc2vss", {}, network, "uint8") == 4
    assert made("dbc2vss", {}, number(4.5), "float") == 4.5
    assert made("dbc2vss", {}, number(4.5), "string") == "numbers without a name where a text belongs"


def test_a_name_that_is_not_allowed_is_no_value():
    assert made("dbc2vss", {}, number(0, name="OFF"), "string", ["OFF", "ON"]) == "OFF"
    assert made("dbc2vss", {}, number(7, name="SNA"), "string", ["OFF", "ON"]) == "not among the `allowed` values"


REPRESENTED = {"transform": {"representation": [{"value": 0, "text": "OFF"}, {"value": 1, "text": "ON"}]}}
GEAR = {"transform": {"representation": [{"value": 1, "text": "GEAR_D"}, {"value": 0, "text": "GEAR_P"}]}}
TILT = {"transform": {"math": "floor((x*40)-100)", "representation": [{"value": 255, "text": "Invalid"}]}}


def test_a_representation_gives_a_text_for_the_number_that_was_transmitted():
    assert made("network_serialization", REPRESENTED, number(0.5, raw=1), "string") == "ON"
    assert made("network_serialization", REPRESENTED, number(2), "string") == "not among the listed values"


def test_a_representation_gives_a_number_for_a_name_of_the_network():
    """As the gear of the profile's own page."""
    assert made("network_serialization", GEAR, number(4, name="GEAR_D"), "int8") == 1
    assert made("network_serialization", GEAR, number(2, name="GEAR_P"), "int8") == 0
    assert made("network_serialization", GEAR, number(7, name="GEAR_SNA"), "int8") == "not among the listed values"


def test_beside_a_formula_a_representation_says_which_numbers_are_words():
    """Like the tilt on the profile's page: 2 V are -20 %, and a transmitted 255 is not a tilt."""
    assert made("network_serialization", TILT, number(2.0, raw=100), "int8") == -20
    assert made("network_serialization", TILT, number(5.1, raw=255), "int8") == "words where a number belongs"


MARKED = {"transform": {"representation": [{"value": 65535, "text": "SNA"}]}}
MARKED_GEAR = {"transform": {"representation": [{"value": 0, "text": "PARK"}, {"value": 7, "text": "NOT_VALID"}]}}


@pytest.mark.parametrize(
    ("network", "names", "value"),
    [
        (number(12.5, raw=1250), {65535: "SNA"}, 12.5),
        (NetworkValue(65535, 655.35, "SNA", is_within=False), {65535: "SNA"}, "words where a number belongs"),
        (number(655.35, raw=65535), {}, "words where a number belongs"),
        (number(655.35, raw=65535, name="Other"), {65535: "Other"}, "words where a number belongs"),
    ],
)
def test_a_marker_of_a_representation_is_never_a_value(network, names, value):
    found = made("network_serialization", MARKED, network, "double", names=names)
    assert found == value


def test_a_representation_that_says_what_the_database_says_is_a_list_of_values_and_markers():
    names = {0: "PARK", 7: "NOT_VALID"}
    made_of = [
        made("network_serialization", MARKED_GEAR, number(raw, name=names.get(raw)), "int8", names=names)
        for raw in (0, 7, 3)
    ]
    assert made_of == [0, "words where a number belongs", "not among the listed values"]


@pytest.mark.parametrize(
    "name", ["SNA", "Signal not available", "GEAR_INVALID", "ErrorValue", "NotDefined", "n/a", "SIG_NOT_AVAIL"]
)
def test_names_that_say_that_there_is_no_value(name):
    assert means_no_value(name)


@pytest.mark.parametrize("name", ["DRIVE", "Validated", "Naples", "Unknownish", "Terror", "NotActive"])
def test_names_that_are_values(name):
    assert not means_no_value(name)


NAMED = NetworkValue(65535, 655.35, "SNA", is_within=False)


@pytest.mark.parametrize("attribute", ["dbc2vss", "network_serialization"])
def test_a_number_that_the_database_names_is_no_number_for_a_formula(attribute):
    given = {"transform": {"math": "x/3.6"}}
    assert made(attribute, given, NAMED) == "named by the database, and not a number for `math`"
    assert made(attribute, given, number(3.0, name="SLOW")) == "named by the database, and not a number for `math`"


@pytest.mark.parametrize("attribute", ["dbc2vss", "network_serialization"])
def test_a_named_number_that_limits_exclude_is_a_text_and_not_a_number(attribute):
    assert made(attribute, {}, NAMED) == "outside of the limits that the database states"
    assert made(attribute, {}, NAMED, "string") == "SNA"
    listed = {"transform": {"mapping": [{"from": "SNA", "to": -1}]}}
    assert made("dbc2vss", listed, NAMED, "int8") == -1


@pytest.mark.parametrize(
    ("datatype", "physical", "value"),
    [
        ("uint8", 2.5, 2),
        ("uint8", 3.5, 4),
        ("uint8", 255.4, 255),
        ("uint8", 255.6, "not held by the datatype"),
        ("uint8", -1.0, "not held by the datatype"),
        ("uint8", math.nan, "not held by the datatype"),
        ("uint64", 2**64 - 1, 2**64 - 1),
        ("boolean", 0.0, False),
        ("boolean", 3.0, True),
        ("float", 0.1, 0.10000000149011612),
        ("float", 1e300, "not held by the datatype"),
        ("double", 0.1, 0.1),
        ("float", math.inf, math.inf),
    ],
)
def test_a_number_becomes_one_of_the_datatype(datatype, physical, value):
    assert made("dbc2vss", {}, number(physical), datatype) == value


def test_where_a_formula_has_no_value_nothing_comes():
    assert made("dbc2vss", {"transform": {"math": "1/x"}}, number(0.0)) == "no result of `math`"
    assert made("dbc2vss", {"transform": {"math": "1e400"}}, number(1.0)) == "no result of `math`"
    assert made("dbc2vss", {"transform": {"math": "1e308*10*x"}}, number(1.0)) == "no result of `math`"


@pytest.mark.parametrize(
    ("attribute", "given", "interval", "on_change"),
    [
        ("dbc2vss", {}, 1000, False),
        ("dbc2vss", {"on_change": True}, 0, True),
        ("dbc2vss", {"on_change": False}, 1000, False),
        ("dbc2vss", {"interval_ms": 100}, 100, False),
        ("dbc2vss", {"interval_ms": 0}, 0, False),
        ("dbc2vss", {"interval_ms": 100, "on_change": True}, 100, True),
        ("network_serialization", {}, 0, True),
        ("network_serialization", {"on_change": False}, 0, False),
        ("network_serialization", {"interval_ms": 100}, 100, False),
        ("network_serialization", {"interval_ms": 100, "on_change": True}, 100, True),
    ],
)
def test_what_is_not_said_of_times_is_as_each_mapping_has_it(attribute, given, interval, on_change):
    mapping = mapping_of(attribute, {"signal": "S", **given})
    assert mapping is not None
    assert (mapping.interval, mapping.on_change) == (interval * 1_000_000, on_change)


@pytest.mark.parametrize(
    "given",
    [
        None,
        "S",
        {},
        {"signal": ""},
        {"signal": 3},
        {"signal": "S", "transform": {"math": "x +"}},
        {"signal": "S", "transform": {}},
    ],
)
def test_what_cannot_be_read_is_no_mapping(given):
    assert mapping_of("dbc2vss", given) is None
