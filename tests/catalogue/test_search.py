"""Search: every word begins a word of the path, the description or the unit; names first."""

import pytest

from sigcat.catalogue.search import SearchIndex
from sigcat.names import nearest
from tests.catalogue.trees import ROOT, catalogue_of


def sensor(path, description="Text.", extra=""):
    return f"{path}:\n  type: sensor\n  datatype: float\n  description: {description}\n{extra}"


TREE = (
    ROOT
    + "Vehicle.Wheel:\n  type: branch\n  instances: [Left, Right]\n  description: W.\n"
    + sensor("Vehicle.Wheel.Speed", "How fast it turns.")
    + sensor("Vehicle.WheelSpeedLimit", "Not above this.")
    + sensor("Vehicle.Speed", "How fast the vehicle is.", "  ASILlevel: D\n")
    + sensor("Vehicle.Note", "Says the wheel speed in words.")
)


@pytest.fixture(scope="module")
def index():
    return SearchIndex(catalogue_of(TREE))


def paths(result):
    return [node.path for node in result.nodes]


def test_names_come_first_then_paths_then_descriptions_each_in_the_order_of_the_tree(index):
    assert paths(index.search("speed")) == [
        "Vehicle.Wheel.Left.Speed",
        "Vehicle.Wheel.Right.Speed",
        "Vehicle.WheelSpeedLimit",
        "Vehicle.Speed",
        "Vehicle.Note",
    ]
    assert paths(index.search("wheel"))[:2] == ["Vehicle.Wheel", "Vehicle.WheelSpeedLimit"]


@pytest.mark.parametrize("text", ["wheel speed", "Wheel.Speed", "SPEED whe", "speed wheel"])
def test_every_word_has_to_begin_a_word_in_any_order_and_case(index, text):
    assert set(paths(index.search(text))) == {
        "Vehicle.WheelSpeedLimit",
        "Vehicle.Wheel.Left.Speed",
        "Vehicle.Wheel.Right.Speed",
        "Vehicle.Note",
    }


def test_a_name_is_found_as_a_whole(index):
    assert paths(index.search("wheelspeedlim")) == ["Vehicle.WheelSpeedLimit"]


def test_filters_narrow_and_are_counted(index):
    result = index.search("speed", {"asil": "D"})
    assert paths(result) == ["Vehicle.Speed"]
    assert result.facets["asil"] == {"D": 1}


def test_a_page_begins_where_the_one_before_ended(index):
    everything = paths(index.search("", limit=100))
    assert paths(index.search("", limit=3)) + paths(index.search("", limit=100, offset=3)) == everything
    assert everything == list(catalogue_of(TREE).nodes)


def test_a_word_that_is_nowhere_brings_those_near_it(index):
    result = index.search("sped")
    assert result.total == 0
    assert "speed" in result.did_you_mean


@pytest.mark.parametrize(
    ("text", "instead"),
    [
        ("whel sped", "wheel speed"),  # put right, both at once
        ("wheelspeed", None),  # a name as it stands, without its capitals
        ("speedwheel", "speed wheel"),  # taken apart
        ("wheel speed zzz", "wheel speed"),  # left out
        ("zzz", None),
    ],
)
def test_where_nothing_has_all_words_a_text_that_has_results_is_proposed(text, instead):
    index = SearchIndex(catalogue_of(ROOT + sensor("Vehicle.WheelSpeed") + sensor("Vehicle.Mass")))
    result = index.search(text)
    assert result.instead[:1] == ((instead,) if instead else ())
    assert all(index.search(each).total for each in result.instead)


def test_what_is_proposed_meets_the_filters(index):
    assert index.search("sped").instead
    assert index.search("sped", {"type": "branch"}).instead == ()


def test_many_nodes_and_words_are_found_as_few_are():
    """Words stand in blocks of a thousand numbers: a prefix may begin and end anywhere in them."""
    count = 3000
    index = SearchIndex(catalogue_of(ROOT + "".join(sensor(f"Vehicle.S{number}") for number in range(count))))
    for prefix in ("s1", "s12", "s123", "s1234", "s29", "s2999"):
        expected = [f"Vehicle.S{number}" for number in range(count) if f"s{number}".startswith(prefix)]
        assert sorted(paths(index.search(prefix, limit=count))) == sorted(expected)
    assert index.search("text").total == count


def test_a_name_that_was_cut_short_is_completed_where_nothing_is_near():
    assert nearest("v5", ["v5.0", "v4.2", "interfaces"]) == ("v5.0",)
    assert nearest("V1", [f"V10{number}" for number in range(9)]) == ()
