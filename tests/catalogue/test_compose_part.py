"""An overlay that is checked alone has the same findings as within the whole tree."""

import json

from hypothesis import example, given
from hypothesis import strategies as st

from sigcat.catalogue.composing.compose import compose
from sigcat.catalogue.composing.compose_part import compose_part
from sigcat.catalogue.model.vocabulary import EMPTY
from sigcat.catalogue.reading.layers import layer_from_text
from tests.catalogue.comparing.running import signal
from tests.catalogue.trees import ROOT, catalogue_of
from tests.properties import examples

PATHS = st.sampled_from(
    ["Vehicle", "Vehicle.A", "Vehicle.A.B", "Vehicle.A.B.C", "Vehicle.A.B.D", "Vehicle.A.Row1", "Vehicle.A.Row1.B", "Vehicle.*",
     "Vehicle.A.*", "Vehicle..X", "Vehicle.A..X", "Other", "Other.A", "Nowhere.A", "Nowhere.B.C", "Nowhere.B.D", "Nowhere.B..X"]
)  # fmt: skip
ATTRIBUTES = st.fixed_dictionaries(
    {},
    optional={
        "type": st.sampled_from(["branch", "sensor", "attribute", "struct", "property", "wheel"]),
        "datatype": st.sampled_from(["uint8", "string", "float", "flaot"]),
        "description": st.just("A thing."),
        "instances": st.sampled_from(["Row[1,2]", ["Left", "Right"]]),
        "delete": st.booleans(),
        "min": st.integers(-1, 300),
        "unit": st.just("km"),
    },
)
OVERLAYS = st.dictionaries(PATHS, ATTRIBUTES, max_size=6)
TREES = OVERLAYS.map(lambda nodes: {"Vehicle": {"type": "branch"}, **nodes})
BRANCH_OF_THE_TREE_MISSES = {"Vehicle": {"type": "branch"}, "Vehicle.A.B.C": {}}
BRANCH_OF_INSTANCES_MISSES = {"Vehicle": {"type": "branch", "instances": "Row[1,2]"}, "Vehicle.A.B.C": {}}
MEETS_IT_HIGHER_UP = {"Vehicle.A.B": {}, "Vehicle": {"type": "sensor"}}


@given(TREES.map(json.dumps), OVERLAYS.map(json.dumps))
@example(json.dumps(BRANCH_OF_THE_TREE_MISSES), json.dumps(MEETS_IT_HIGHER_UP))
@example(json.dumps(BRANCH_OF_INSTANCES_MISSES), '{"Vehicle.A": {"type": "sensor"}}')
@examples(200)
def test_the_findings_of_an_overlay_are_those_that_it_has_in_the_whole(tree, overlay):
    base = catalogue_of(tree)
    layer = layer_from_text(overlay.encode(), "posted")
    whole = compose([*base.layers, layer], base.vocabulary, expanded=False)
    part = compose_part(base, layer)
    in_part, in_whole = (
        {finding for finding in found if finding.file == "posted"} for found in (part.findings, whole.findings)
    )
    assert in_part == in_whole
    assert {p: d.values for p, d in part.definitions.items()} == {p: d.values for p, d in whole.definitions.items()}


def test_a_branch_that_the_tree_lacks_is_the_fault_of_the_tree_with_an_overlay_that_comes_nearer_to_it_too():
    base = catalogue_of(json.dumps(BRANCH_OF_THE_TREE_MISSES))
    layer = layer_from_text(b'{"Vehicle.A.B": {"type": "branch", "description": "B."}}', "posted")
    whole = compose([*base.layers, layer], base.vocabulary)
    missing = [finding for finding in whole.findings if finding.path == "Vehicle.A"]
    assert [(finding.file, "Vehicle.A.B.C" in finding.message) for finding in missing] == [("tree", True)]


def test_only_what_the_overlay_reaches_is_in_the_tree_and_the_branches_beside():
    names = "".join(f"Vehicle.{name}:\n  type: branch\n  description: A branch.\n" for name in ("A", "A.B", "C"))
    part = compose_part(
        catalogue_of(ROOT + names + signal("Vehicle.A.Mass")), layer_from_text(signal("Vehicle.C.D").encode(), "posted")
    )
    assert list(part.nodes) == ["Vehicle", "Vehicle.A", "Vehicle.C", "Vehicle.C.D"]
    assert part.findings == ()


def test_an_overlay_may_use_the_struct_types_of_the_catalogue():
    types = (
        "Types:\n  type: branch\n  description: Types.\nTypes.Place:\n  type: struct\n  description: A place.\n"
        "Types.Place.X:\n  type: property\n  datatype: float\n  description: X.\n"
    )
    layers = [layer_from_text(text.encode(), "tree", is_overlay=False) for text in (ROOT, types)]
    base = compose(layers[:1], EMPTY, layers[1:])
    signal = "Vehicle.Place:\n  type: sensor\n  datatype: Types.Place\n  description: Where it is.\n"
    assert compose_part(base, layer_from_text(signal.encode(), "posted")).findings == ()
