"""Requirements for every comparison."""

from functools import partial

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sigcat.catalogue.comparing.diff import compare
from tests.catalogue.comparing.running import changes, signal
from tests.catalogue.trees import ROOT, catalogue_of
from tests.growth import LINEAR, growth
from tests.properties import examples


def kinds(old, new):
    return [(change.kind, change.path) for change in changes(old, new)]


def test_neither_side_needs_to_have_nodes():
    whole, empty = catalogue_of(ROOT), catalogue_of("")
    assert [change.kind for change in compare(empty, whole)] == ["added"]
    assert [change.kind for change in compare(whole, empty)] == ["removed"]
    assert compare(empty, empty) == ()


def test_another_root_is_a_move():
    other = "Car:\n  type: branch\n  description: A vehicle.\n"
    moved = compare(
        catalogue_of(ROOT + signal("Vehicle.A", description="A.")),
        catalogue_of(other + signal("Car.A", description="A.")),
    )
    assert [(c.kind, c.former, c.path, c.leaves) for c in moved] == [("moved", "Vehicle", "Car", 1)]


def test_ignored_attributes_do_not_count():
    old, new = (catalogue_of(ROOT + signal("Vehicle.A", max=maximum)) for maximum in (1, 2))
    assert compare(old, new, frozenset(("max",))) == ()


def test_two_nodes_cannot_move_to_one_place_by_former_path():
    found = changes(
        signal("Vehicle.A") + signal("Vehicle.B"), signal("Vehicle.C", fka="[Vehicle.A, Vehicle.B]", description="C.")
    )
    assert [(c.kind, c.former or c.path) for c in found] == [("moved", "Vehicle.A"), ("removed", "Vehicle.B")]


def test_a_deprecation_that_names_the_node_itself_moves_nothing():
    assert kinds(signal("Vehicle.A", deprecation="moved to A"), "") == [("removed", "Vehicle.A")]
    assert kinds(signal("Vehicle.A", deprecation="moved to nowhere"), "") == [("removed", "Vehicle.A")]


@pytest.mark.parametrize("values", ["fka: Vehicle.A", "fka: [[Vehicle.A], 1]", "deprecation: 1", "fka: {x: 1}"])
def test_advice_of_a_wrong_type_is_no_advice(values):
    name, _, value = values.partition(": ")
    old, new = signal("Vehicle.A", **{name: value}), signal("Vehicle.B", datatype="double", **{name: value})
    assert kinds(old, new) == [("removed", "Vehicle.A"), ("added", "Vehicle.B")]


NAMES = st.sampled_from(["A", "B", "C"])
SIGNALS = st.dictionaries(
    st.tuples(NAMES, NAMES),
    st.fixed_dictionaries({"max": st.integers(0, 2), "description": st.sampled_from(["X.", "Y."])}),
    max_size=6,
)


def tree(signals, instances):
    branches = dict.fromkeys(branch for branch, _ in signals)
    text = "".join(
        f"Vehicle.{b}:\n  type: branch\n  description: B.\n  instances: {instances}\n" for b in branches
    ) + "".join(signal(f"Vehicle.{b}.{n}", **values) for (b, n), values in signals.items())
    return catalogue_of(ROOT + text)


INSTANCES = st.sampled_from(["[]", "[L, R]", "[L]", '["Row[1,2]", [L, R]]'])


@examples(150)
@given(SIGNALS, SIGNALS, INSTANCES, INSTANCES)
def test_every_path_that_one_side_has_alone_is_told_exactly_once(old, new, old_instances, new_instances):
    before, after = tree(old, old_instances), tree(new, new_instances)
    found = compare(before, after)
    explained = [p for c in found for p in (*(c.former_paths if c.kind == "moved" else ()), *c.went)]
    explained += [p for c in found if c.kind == "removed" for p in c.paths]
    gone = {path for path in before.nodes if path not in after.nodes}
    for path in gone:
        assert any(path == top or path.startswith(f"{top}.") for top in explained)
    came = [p for c in found for p in (*(c.paths if c.kind in ("added", "moved") else ()), *c.came)]
    for path in after.nodes.keys() - before.nodes.keys():
        assert any(path == top or path.startswith(f"{top}.") for top in came)
    assert len(explained) == len(set(explained))
    assert len(came) == len(set(came))


@examples(50)
@given(SIGNALS, INSTANCES)
def test_a_tree_does_not_differ_from_one_of_the_same_text(signals, instances):
    assert compare(tree(signals, instances), tree(signals, instances)) == ()


def flat(count, maximum):
    branches = "".join(f"Vehicle.B{n}:\n  type: branch\n  description: B.\n" for n in range(count // 100))
    signals = "".join(signal(f"Vehicle.B{n // 100}.S{n}", max=n % maximum) for n in range(count))
    return catalogue_of(ROOT + branches + signals)


def test_ten_times_the_signals_take_about_ten_times_as_long():
    assert growth(lambda count: partial(compare, flat(count, 7), flat(count, 11)), 500) < LINEAR
