"""Mappings of signals to those of CAN, where the tree decides about errors."""

from sigcat.catalogue.composing.compose import compose
from sigcat.catalogue.reading.layers import layer_from_text
from sigcat.data import INTERFACE_RULES
from sigcat.rules.compiled import compiled_rules
from sigcat.rules.linting.posted import lint_text
from sigcat.rules.rule_set import RuleSet

EVERY_RULE = RuleSet(compiled_rules(INTERFACE_RULES))
TREE = """
Vehicle: {type: branch}
Vehicle.Door: {type: branch, instances: ["Row[1,2]", [Left, Right]]}
Vehicle.Door.IsOpen: {type: actuator, datatype: boolean}
Vehicle.IsMoving: {type: sensor, datatype: boolean}
"""


def found(overlay: str) -> list[tuple[str, int, str]]:
    base = compose([layer_from_text(TREE.encode(), "tree", is_overlay=False)])
    findings = lint_text(overlay.encode(), "overlay", base, EVERY_RULE)
    return [(each.rule, each.line, each.message) for each in findings if each.rule.startswith("M")]


def test_instances_that_are_sent_as_one_signal_overwrite_each_other():
    assert found("Vehicle.Door.IsOpen: {type: actuator, datatype: boolean, vss2dbc: {signal: Open}}") == [
        ("M009", 1, "4 instances are sent as Open.")
    ]


def test_one_instance_has_a_signal_of_its_own():
    one = "Vehicle.Door.Row1.Left.IsOpen"
    assert found(f"{one}: {{type: actuator, datatype: boolean, vss2dbc: {{signal: Open}}}}") == []


def test_an_impact_is_named_once():
    profile = "cybersecurity: {impact_profiles: [safety, motion, safety]}"
    assert found(f"Vehicle.IsMoving: {{type: sensor, datatype: boolean, {profile}}}") == [
        ("M201", 1, "`cybersecurity.impact_profiles` must have 'safety' once.")
    ]
