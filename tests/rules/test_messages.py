"""Messages of the checks, read aloud: what must be, what is, and never a proposal of the thing itself."""

import pytest

from sigcat.catalogue.composing.compose import compose
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.model.vocabulary import EMPTY
from sigcat.catalogue.reading.layers import layer_from_text
from sigcat.data import INTERFACE_RULES
from sigcat.rules.compiled import compiled_rules
from sigcat.rules.linting.posted import lint_text
from sigcat.rules.rule_set import RuleSet

EVERY_RULE = RuleSet(compiled_rules(INTERFACE_RULES))
TREE = """\
Vehicle: {type: branch, description: A vehicle.}
Vehicle.Speed: {type: sensor, datatype: float, description: Its speed.}
"""


@pytest.fixture(scope="module")
def tree() -> Catalogue:
    return compose([layer_from_text(TREE.encode(), "tree.vspec", is_overlay=False)], EMPTY)


@pytest.mark.parametrize(
    ("overlay", "expected"),
    [
        ("Vehicle.Sped:\n  delete: true\n", "2:3: warning O102 The overlay deletes 'Vehicle.Sped', which does not exist. Did you mean 'Vehicle.Speed'?"),
        ("Vehicle.Sped: {type: sensor, delete: true}\n", "1:30: warning O102 The overlay deletes 'Vehicle.Sped', which does not exist. Did you mean 'Vehicle.Speed'?"),
        ("Vehicle.Cabn.Sped: {delete: true}\n", "1:21: warning O102 The overlay deletes 'Vehicle.Cabn.Sped', which does not exist. Did you mean 'Vehicle.Speed'?"),
        ("Vehicle.Sped: {comment: Of the vehicle.}\n", "1:1: error O101 The overlay changes 'Vehicle.Sped', which does not exist. Did you mean 'Vehicle.Speed'? Give it a `type` if it is a new node."),
    ],
)  # fmt: skip
def test_a_node_that_is_not_there_is_one_finding_with_the_node_that_was_meant(tree, overlay, expected):
    assert [finding.line_of_text for finding in lint_text(overlay.encode(), "o", tree, EVERY_RULE)] == [f"o:{expected}"]


@pytest.mark.parametrize(
    ("attribute", "expected"),
    [
        ("maximum: 3", "V117 Unknown attribute `maximum`. Add it to `extended-attributes` of [lint] in sigcat.toml, or remove it."),
        ("ASILlevel: E", "I101 `ASILlevel` must be QM, A, B, C or D, not 'E'."),
        ("ASILlevel: ASIL B", "I101 `ASILlevel` must be QM, A, B, C or D, not 'ASIL B'. Write B."),
        ("resolution: fine", "I101 `resolution` must be a number in the unit of the interface, not 'fine'."),
    ],
)  # fmt: skip
def test_an_attribute_says_what_it_must_be(tree, attribute, expected):
    findings = lint_text(f"Vehicle.Speed:\n  {attribute}\n".encode(), "o", tree, EVERY_RULE)
    assert expected in {f"{finding.rule} {finding.message} {finding.fix}".rstrip() for finding in findings}


@pytest.mark.parametrize("is_tree", [True, False])
def test_an_empty_text_says_what_to_send(tree, is_tree):
    (finding,) = lint_text(b" \n", "o", tree, EVERY_RULE, is_tree=is_tree)
    kind = "a tree" if is_tree else "an overlay"
    assert finding.line_of_text == f"o:1:1: error Q003 The text must not be empty. Send the text of {kind}."
