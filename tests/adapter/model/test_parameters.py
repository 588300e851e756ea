"""Section 11: parameters."""

import math

import pytest

from tests.adapter.model.driven import Driven
from tests.adapter.reference.parts.errors import Stage
from tests.adapter.reference.running import Stored
from tests.adapter.written import FLOAT, U8, U16, array, call, error, function, parameter, step

KM = {"VssDatatype": "double", "ConversionFactor": "1/1000", "ConversionOffset": "0"}
"""The code has m, the catalogue km."""


def stored(**parameters):
    return {"stored": Stored(0, parameters)}


@pytest.mark.parametrize(
    ("given", "expected"),
    [(None, 650.0), (0.4, 400.0), (0.1, 700.0), (math.nan, 700.0)],
    ids=["nothing is stored", "stored", "out of range", "NaN"],
)
def test_what_a_parameter_starts_with(given, expected):
    item = parameter("Size", low=300, high=1500, Default=700, InitValue=650, **KM)
    run = Driven(function(step(item))).start(**stored(**({} if given is None else {"Size": given})))
    assert run.variables["size"] == expected


def test_a_stored_value_that_is_out_of_range_is_an_error():
    document = function(step(parameter("Size", RangeError="E"), error("E")))
    for value, stage in ((101.0, Stage.FAILED), (100.0, Stage.PASSED)):
        run = Driven(document).start(**stored(Size=value))
        run.steps(0)
        assert run.stage("E") is stage
    run = Driven(document).start()
    run.steps(0)
    assert run.stage("E") is Stage.NOT_TESTED


def test_init_may_clear_them_and_steps_may_overwrite_them():
    document = function(call("Init", "Init"), step(parameter("Size", InitValue=5)), step(name="Other"))
    clear = {"F_Init": 0, "F_Step": 1, "F_Other": 2}
    run = Driven(document, **{name: (lambda v, n=n: v.update(size=n)) for name, n in clear.items()}).start()
    assert run.variables["size"] == 5.0
    run.steps(0)
    assert (run.seen[-1]["size"], run.variables["size"]) == (5.0, 1)
    run.steps(0)
    assert run.seen[-1]["size"] == 1


def test_all_are_set_or_none():
    run = Driven(function(step(parameter("A"), parameter("B")))).start()
    assert not run.adapter.set_parameters({"A": 5.0, "B": 101.0})
    run.steps(0)
    assert (run.variables["a"], run.variables["b"]) == (0.0, 0.0)
    assert run.adapter.set_parameters({"A": 5.0, "B": 100.0})
    assert run.variables["a"] == 0.0
    run.steps(10)
    assert (run.variables["a"], run.variables["b"]) == (5.0, 100.0)


def test_a_parameter_of_two_calls_is_one():
    run = Driven(function(step(parameter("A"), name="One"), step(parameter("A"), name="Two"))).start()
    run.adapter.set_parameters({"A": 5.0})
    run.steps(0, 0)
    assert [each["a"] for each in run.seen] == [5.0, 5.0]


def learning(**fields):
    item = parameter("Mass", U16, 0, 3000, Attribute="LearningParameter", InitValue=1000, **fields)
    return Driven(function(step(item), call("Terminate", "Shutdown")))


@pytest.mark.parametrize(("learned", "expected"), [(1500, 1.5), (3000, 3.0), (3001, 1.2)])
def test_what_was_learned_is_stored_in_the_unit_of_the_catalogue_if_it_is_in_range(learned, expected):
    run = learning(**KM).start(**stored(Mass=1.2))
    assert run.variables["mass"] == 1200
    run.variables["mass"] = learned
    run.steps(0)
    assert run.variables["mass"] == learned
    run.adapter.terminate(5)
    assert run.adapter.stored.parameters == {"Mass": expected}


def test_elements_come_from_the_default_where_no_start_value_says_otherwise():
    row = array("DT_Row", FLOAT, 3)
    item = parameter("A", "DT_Row", 0, 0, DefaultText="[1, 2.5]", RangeErrorAction="Default")
    run = Driven(function(step(item), datatypes=(row,))).start()
    assert run.variables["a"] == (1.0, 2.5, 2.5)
    assert run.adapter.set_parameters({"A": (1e30, -5.0, 0.0)})
    assert not run.adapter.set_parameters({"A": (1.0, math.nan, 0.0)})


def test_an_enumeration_without_a_name_is_out_of_range():
    run = Driven(function(step(parameter("A", U8, 0, 3)))).start()
    assert not run.adapter.set_parameters({"A": 4})
