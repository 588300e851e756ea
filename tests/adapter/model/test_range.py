"""Section 5: range."""

import math

import pytest

from tests.adapter.model.driven import Driven
from tests.adapter.reference.parts.errors import Stage
from tests.adapter.written import (
    FLOAT,
    U8,
    Json,
    array,
    enumeration,
    error,
    function,
    output,
    queue,
    signal,
    step,
    structure,
)

OUT = error("Out")
NAN, INFINITE = math.nan, math.inf
LIMITED = {"Min": 0, "Max": 10, "Default": 2, "InitValue": 3}
NAMES = enumeration("DT_Gear", PARK=0, DRIVE=5)


def given(document, *values):
    """Return the values that calls see for these inputs."""
    run = Driven(document).start()
    for t, value in enumerate(values):
        run.receive("A", value, t * 10)
        run.steps(t * 10)
    return run


def one(datatype=FLOAT, **fields):
    """A function with one input, and one error."""
    return function(step(signal("A", datatype, **fields), OUT), datatypes=(NAMES, array("DT_Ten", FLOAT, 10)))


@pytest.mark.parametrize(
    ("value", "action", "expected"),
    [
        (0.0, "Default", 0.0), (10.0, "Default", 10.0), (-0.0, "Default", -0.0),
        (math.nextafter(10, 11), "Default", 2.0), (-5e-324, "Default", 2.0), (11.0, "Init", 3.0),
        (NAN, "Default", 2.0), (INFINITE, "Init", 3.0), (-INFINITE, "Default", 2.0),
    ],
)  # fmt: skip
def test_a_value_outside_is_replaced_and_one_at_a_limit_is_not(value, action, expected):
    run = given(one("DT_Float64", **LIMITED, RangeErrorAction=action), value)
    assert run.seen[-1]["a"] == expected


@pytest.mark.parametrize(
    ("fields", "expected"),
    [
        ({"RangeErrorAction": "Default", "InitValue": 3}, 3.0), ({"RangeErrorAction": "Init", "Default": 2}, 2.0),
        ({"RangeErrorAction": "Default"}, 0.0), ({"RangeError": "Out"}, 99.0), ({}, 99.0),
    ],
    ids=["default, else init", "init, else default", "else 0", "no action", "no check"],
)  # fmt: skip
def test_what_replaces_it(fields, expected):
    assert given(one(Min=0, Max=10, **fields), 99.0).seen[-1]["a"] == expected


def test_a_tenth_lies_within_a_limit_of_a_tenth():
    tenth = 0.10000000149011612
    assert given(one(Max=0.1, RangeErrorAction="Default", Default=9), tenth).seen[-1]["a"] == tenth


def test_limits_of_integers_are_rounded_inward():
    seen = [given(one(U8, Min=1.5, Max=3.5, RangeErrorAction="Default"), value).seen[-1]["a"] for value in (1, 2, 3, 4)]
    assert seen == [0, 2, 3, 0]


def test_a_check_without_limits_lets_no_nan_pass():
    assert given(one(RangeErrorAction="Default", Default=2), NAN).seen[-1]["a"] == 2.0
    assert math.isnan(given(one(Min=0), NAN).seen[-1]["a"])


def test_a_value_that_passes_is_limited_to_its_type():
    fields = {"Min": 0, "Max": 10, "RangeError": "Out", "VssDatatype": "float"}
    run = given(one(U8, **fields), 1000.0)
    assert (run.seen[-1]["a"], run.stage("Out")) == (255, Stage.FAILED)


def test_one_element_outside_replaces_all():
    document = one("DT_Ten", Min=0, Max=10, RangeErrorAction="Default", DefaultElements="[1, 2]")
    values = (0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 10.5)
    assert given(document, values).seen[-1]["a"] == (1.0, *[2.0] * 9)


def test_members_have_limits_of_their_own():
    point = structure("DT_Point", x=(FLOAT, -1, 1), y=FLOAT)
    fields: Json = {"RangeErrorAction": "Init", "InitElements": '{"x": 0.5, "y": 7}', "Min": 0, "Max": 0}
    document = function(step(signal("A", "DT_Point", **fields)), datatypes=(point,))
    run = given(document, (1.0, 99.0), (1.5, 99.0), (0.0, NAN))
    assert [each["a"] for each in run.seen] == [(1.0, 99.0), (0.5, 7.0), (0.5, 7.0)]


def test_a_number_without_a_name_leaves_the_value_before_or_is_replaced():
    assert [each["a"] for each in given(one("DT_Gear"), 5, 7).seen] == [5, 5]
    assert given(one("DT_Gear", RangeErrorAction="Default", Default=5), 7).seen[-1]["a"] == 5


def test_min_and_max_of_an_enumeration_say_nothing():
    assert given(one("DT_Gear", Min=1, Max=2, RangeErrorAction="Default"), 5).seen[-1]["a"] == 5


def test_what_replaces_an_output_is_sent_and_the_variable_stays():
    document = function(step(output("A", Min=0, Max=10, Default=2, RangeErrorAction="Default", RangeError="Out"), OUT))
    run = Driven(document, F_Step=lambda variables: variables.update(a=11.0)).start()
    run.steps(0)
    assert (run.adapter.out["A"], run.variables["a"], run.adapter.out["Out"]) == (2.0, 11.0, 1)


def test_an_output_without_a_name_is_sent_as_before():
    document = function(step(output("A", "DT_Gear", InitValue=5)), datatypes=(NAMES,))
    run = Driven(document, F_Step=lambda variables: variables.update(a=3)).start()
    run.steps(0)
    assert run.adapter.out["A"] == 5


def test_the_error_stays_as_long_as_no_other_value_comes_and_is_not_tested_before_the_first():
    run = Driven(one(Min=0, Max=10, RangeError="Out")).start()
    run.steps(0)
    assert run.stage("Out") is Stage.NOT_TESTED
    run.receive("A", 11.0, 5)
    run.steps(10, 20)
    assert run.stage("Out") is Stage.FAILED
    run.receive("A", 1.0, 25)
    run.steps(30)
    assert run.stage("Out") is Stage.PASSED


def test_of_queued_values_each_is_a_value_and_any_makes_the_error():
    fields: Json = {"Min": 0, "Max": 10, "Default": 7, "RangeErrorAction": "Default", "RangeError": "Out"}
    run = Driven(function(step(queue("A", 5, ValuesPerStep=3, **fields), OUT))).start()
    for value in (1, 99, 3):
        run.receive("A", value, 0)
    run.steps(0)
    assert (run.seen[-1]["a"], run.stage("Out")) == ((1, 7, 3), Stage.FAILED)


def test_init_is_not_checked():
    assert Driven(one(Min=5, Max=10, InitValue=1, RangeErrorAction="Default")).start().variables["a"] == 1.0


def test_an_error_of_an_immediate_input_is_known_when_the_call_has_ended():
    run = Driven(one(Min=0, Max=10, RangeError="Out", Access="Immediate")).start()
    run.receive("A", 11.0, 0)
    name = run.due(0)
    run.adapter.set_input(name, 0)
    run.adapter.begin(name, 0)
    assert run.stage("Out") is Stage.NOT_TESTED
    run.adapter.get_output(name, 0)
    assert run.stage("Out") is Stage.FAILED
