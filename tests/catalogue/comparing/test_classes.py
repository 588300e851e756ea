"""The class table: documented as it is in the code, and complete."""

from pathlib import Path

import pytest

from sigcat.catalogue.comparing.changes import CLASSES, at_least, same, worst
from sigcat.catalogue.comparing.compatibility import ROWS, TABLE, Vocabularies, attribute_changes
from sigcat.catalogue.comparing.diff import compare
from sigcat.catalogue.comparing.diff_report import class_table
from sigcat.catalogue.composing.compose import compose
from sigcat.catalogue.model.definition import CORE_ATTRIBUTES
from sigcat.catalogue.model.vocabulary import EMPTY, Unit, Vocabulary
from sigcat.catalogue.reading.layers import layer_from_text
from sigcat.catalogue.reading.statement import Origin
from tests.catalogue.trees import ROOT

DOCUMENT = Path(__file__).parents[3] / "docs" / "reference" / "compatibility.md"


def test_the_documented_table_is_that_of_the_code():
    assert class_table() in DOCUMENT.read_text()


def test_every_rule_has_a_name_of_its_own():
    assert len(ROWS) == len(TABLE)


def test_classes_go_from_the_worst_to_the_most_harmless():
    assert worst(["text", "risky", "compatible"]) == "risky"
    assert worst([]) == "text"
    assert [at_least(compatibility, "risky") for compatibility in CLASSES] == [True, True, False, False]


def rule(attribute, old, new, **others):
    """Rule and class of one changed attribute of an actuator, unless others say another type."""
    both = {"type": "actuator", **others}
    (change,) = attribute_changes({**both, attribute: old}, {**both, attribute: new})
    return change.rule, change.compatibility


IN_THE_NODES = {"delete", "instantiate", "instances", "is_instance", "instances_relation", "type"}
"""Attributes whose changes are changes of nodes, or are separate cases."""


@pytest.mark.parametrize("attribute", sorted(CORE_ATTRIBUTES - IN_THE_NODES))
def test_every_attribute_of_vss_that_changes_has_a_row(attribute):
    assert rule(attribute, None, "x")[0] in ROWS


@pytest.mark.parametrize("value", [3, "x", ["x"], {"x": 1}, True, float("nan"), [["x"], {}]])
@pytest.mark.parametrize("attribute", sorted(CORE_ATTRIBUTES - {"instances"}))
def test_values_that_have_no_sense_are_compared_all_the_same(attribute, value):
    for other in (None, 4, "y", ["y"], {"y": 2}, {"x": 2}):
        old, new = {"type": "sensor", attribute: other}, {"type": "sensor", attribute: value}
        assert all(change.rule in ROWS for change in (*attribute_changes(old, new), *attribute_changes(new, old)))


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        (["A", "B"], ["B", "A"], "values-reordered"),
        (["A"], ["B", "A"], "values-added"),
        (["A", "B"], ["A", "C"], "values-removed"),
        ([1], [True], "values-removed"),
    ],
)
def test_the_worst_of_several_reasons_decides(old, new, expected):
    assert rule("allowed", old, new)[0] == expected


def test_the_class_of_a_range_depends_on_the_type():
    assert rule("max", 9, 8) == ("range-narrowed", "breaking")
    assert rule("max", 9, 8, type="sensor") == ("range-narrowed", "compatible")
    assert rule("max", 9, 8, type="property") == ("range-narrowed", "breaking")


def test_a_bound_that_the_datatype_has_anyway_is_text():
    assert rule("min", None, -128, datatype="int8[]") == ("range-respelled", "text")
    assert rule("min", None, -127, datatype="int8") == ("range-narrowed", "breaking")


def test_numbers_are_equal_by_value_and_true_is_no_number():
    assert same(1, 1.0)
    assert same(float("nan"), float("nan"))
    assert not same(1, True)
    assert not same([0], [False])
    assert same({"a": [1, 2]}, {"a": [1.0, 2]})
    assert not same({"a": 1}, {"b": 1})


def vocabulary(*units):
    entries = [Unit(key, name, "", "length", ("numeric",), "", Origin("", 0, 0)) for key, name in units]
    return Vocabulary({name: u for u in entries for name in (u.key.lower(), u.name)}, {}, (), ())


@pytest.mark.parametrize(
    ("old", "new", "old_units", "new_units", "expected"),
    [
        ("celsius", "Celsius", EMPTY, EMPTY, "unit-respelled"),
        ("km", "m", EMPTY, EMPTY, "unit"),
        ("m", "metre", vocabulary(("m", "Metre")), vocabulary(("metre", "metre")), "unit-respelled"),
        ("km", "m", vocabulary(("km", "kilometre")), vocabulary(("m", "metre")), "unit"),
        ("mpg", "mpg-us", EMPTY, vocabulary(("mpg-us", "mpg")), "unit-respelled"),
    ],
)
def test_a_unit_with_another_key_is_another_unit_unless_the_units_say_otherwise(
    old, new, old_units, new_units, expected
):
    vocabularies = Vocabularies(old_units, new_units)
    (change,) = attribute_changes({"type": "sensor", "unit": old}, {"type": "sensor", "unit": new}, vocabularies)
    assert change.rule == expected


def test_a_property_more_breaks_a_struct():
    def catalogue(properties):
        struct = "T:\n  type: branch\nT.Place:\n  type: struct\n" + "".join(
            f"T.Place.{name}:\n  type: property\n  datatype: {datatype}\n" for name, datatype in properties.items()
        )
        signal = ROOT + "Vehicle.Place:\n  type: sensor\n  datatype: T.Place\n"
        layers = [layer_from_text(text.encode(), "text", is_overlay=False) for text in (signal, struct)]
        return compose(layers[:1], types=layers[1:])

    changes = compare(catalogue({"X": "float"}), catalogue({"X": "double", "Y": "float"}))
    assert [(c.path, c.kind, c.rule, c.compatibility) for c in changes] == [
        ("T.Place.X", "changed", "datatype", "breaking"),
        ("T.Place.Y", "added", "property-added", "breaking"),
    ]
