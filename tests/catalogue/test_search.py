"""Search: every word begins a word of the path, the description or the unit; names first."""

import pytest

from sigcat.catalogue.exporting.static_id import static_id
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


def test_a_name_that_was_given_whole_comes_first_then_names_paths_and_descriptions(index):
    assert paths(index.search("speed")) == [
        "Vehicle.Speed",
        "Vehicle.Wheel.Left.Speed",
        "Vehicle.WheelSpeedLimit",
        "Vehicle.Note",
    ]
    assert paths(index.search("wheel"))[:2] == ["Vehicle.Wheel", "Vehicle.WheelSpeedLimit"]


def test_signals_come_before_branches_and_short_paths_before_long_ones():
    tree = (
        ROOT
        + "Vehicle.Engine:\n  type: branch\n  description: E.\nVehicle.EngineRoom:\n  type: branch\n  description: R.\n"
    )
    tree += sensor("Vehicle.EngineRoom.Heat") + sensor("Vehicle.Engine.EngineHeat") + sensor("Vehicle.EngineCode")
    assert paths(SearchIndex(catalogue_of(tree)).search("engine")) == [
        "Vehicle.Engine",  # called so
        "Vehicle.EngineCode",
        "Vehicle.Engine.EngineHeat",
        "Vehicle.EngineRoom.Heat",
        "Vehicle.EngineRoom",
    ]


def test_instances_of_one_definition_are_one_hit_and_the_first_of_those_that_were_found(index):
    hits = {hit.node.path: hit.instances for hit in index.search("speed").hits}
    assert (hits["Vehicle.Wheel.Left.Speed"], hits["Vehicle.Speed"]) == (2, 1)
    assert [(hit.node.path, hit.instances) for hit in index.search("right speed").hits] == [
        ("Vehicle.Wheel.Right.Speed", 1)
    ]
    result = index.search("speed", {"type": "sensor"})
    assert result.total == len(result.hits) == result.facets["datatype"]["float"] == 4


def test_each_instance_can_be_asked_for(index):
    result = index.search("speed", each_instance=True)
    assert "Vehicle.Wheel.Right.Speed" in paths(result)
    assert result.total == result.facets["datatype"]["float"] == 5


@pytest.mark.parametrize("count", [1, 2, 3, 7, 8, 9, 64])
def test_groups_of_any_size_are_counted_once_whichever_of_them_are_found(count):
    """The sets of groups are made by adding: what one group carries must not reach the next."""
    wheel = "Vehicle.Wheel:\n  type: branch\n  instances: Row[1,{}]\n  description: W.\n" + sensor("Vehicle.Wheel.Load")
    both = ROOT + wheel.format(count) + wheel.format(3).replace("Wheel", "Axle")
    index = SearchIndex(catalogue_of(both))
    for number in range(1, count + 1):
        hits = {hit.node.path: hit.instances for hit in index.search(f"wheel row{number} load").hits}
        starts = [each for each in range(1, count + 1) if str(each).startswith(str(number))]
        assert hits == {f"Vehicle.Wheel.Row{number}.Load": len(starts)}
    assert index.search("load").total == 2


@pytest.mark.parametrize(("text", "path"), [
    ("Vehicle/Wheel/Left/Speed", "Vehicle.Wheel.Left.Speed"),
    ("/vehicle/wheel/left/speed", "Vehicle.Wheel.Left.Speed"),
    ("wheel_left_speed", "Vehicle.Wheel.Left.Speed"),
    ("Wheel_Left_Speed", "Vehicle.Wheel.Left.Speed"),
    ("VehicleWheelServiceProxy::Wheel_Left_Speed", "Vehicle.Wheel.Left.Speed"),
    ("VehicleWheelService/Wheel_Left_Speed", "Vehicle.Wheel.Left.Speed"),
    ("wheel_speed_limit_value", "Vehicle.WheelSpeedLimit"),
    ("VehicleSpeed", "Vehicle.Speed"),
])  # fmt: skip
def test_a_generated_name_finds_what_it_was_made_from(index, text, path):
    assert paths(index.search(text, each_instance=True))[0] == path


def test_a_static_id_finds_its_node(index):
    node = catalogue_of(TREE).nodes["Vehicle.Speed"]
    assert paths(index.search(static_id(node))) == paths(index.search(static_id(node).lower())) == ["Vehicle.Speed"]
    assert index.search("0x00000000").total == 0


def test_an_abbreviation_finds_what_trees_write_out():
    tree = ROOT + sensor("Vehicle.StateOfCharge") + sensor("Vehicle.Socket") + sensor("Vehicle.Charge")
    assert paths(SearchIndex(catalogue_of(tree)).search("SoC")) == ["Vehicle.StateOfCharge", "Vehicle.Socket"]


@pytest.mark.parametrize("text", ["wheel speed", "Wheel.Speed", "SPEED whe", "speed wheel"])
def test_every_word_has_to_begin_a_word_in_any_order_and_case(index, text):
    assert set(paths(index.search(text))) == {
        "Vehicle.WheelSpeedLimit",
        "Vehicle.Wheel.Left.Speed",
        "Vehicle.Note",
    }


def test_a_name_is_found_as_a_whole(index):
    assert paths(index.search("wheelspeedlim")) == ["Vehicle.WheelSpeedLimit"]


@pytest.mark.parametrize("text", ["\0", "speed\0", "vehicle\0 speed"])
def test_a_sign_that_nobody_sees_is_in_no_name(index, text):
    assert index.search(text).total == 0


def test_filters_narrow_and_are_counted(index):
    result = index.search("speed", {"asil": "D"})
    assert paths(result) == ["Vehicle.Speed"]
    assert result.facets["asil"] == {"D": 1}


def test_a_page_begins_where_the_one_before_ended(index):
    everything = paths(index.search("", limit=100, each_instance=True))
    assert everything == list(catalogue_of(TREE).nodes)
    for each_instance in (True, False):
        first, rest = (index.search("", limit=m, offset=n, each_instance=each_instance) for m, n in ((3, 0), (100, 3)))
        assert paths(first) + paths(rest) == paths(index.search("", limit=100, each_instance=each_instance))


def test_a_word_that_is_nowhere_brings_those_near_it(index):
    result = index.search("sped")
    assert result.total == 0
    assert "speed" in result.did_you_mean


@pytest.mark.parametrize(
    ("text", "instead"),
    [
        ("whel sped", "wheel speed"),  # put right, both at once
        ("wheelspeed", None),  # a name unchanged, without its capitals
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
    """Words are stored in blocks of a thousand numbers: a prefix may begin and end anywhere in them."""
    count = 3000
    index = SearchIndex(catalogue_of(ROOT + "".join(sensor(f"Vehicle.S{number}") for number in range(count))))
    for prefix in ("s1", "s12", "s123", "s1234", "s29", "s2999"):
        expected = [f"Vehicle.S{number}" for number in range(count) if f"s{number}".startswith(prefix)]
        assert sorted(paths(index.search(prefix, limit=count))) == sorted(expected)
    assert index.search("text").total == count


def test_a_name_that_was_cut_short_is_completed_where_nothing_is_near():
    assert nearest("v5", ["v5.0", "v4.2", "interfaces"]) == ("v5.0",)
    assert nearest("V1", [f"V10{number}" for number in range(9)]) == ()


def test_labels_of_instances_with_dots_are_searched():
    tree = (
        ROOT
        + "Vehicle.Wheel:\n  type: branch\n  instances: Left..Right\n  description: W.\n"
        + sensor("Vehicle.Wheel.Speed")
    )
    assert paths(SearchIndex(catalogue_of(tree)).search("speed")) == ["Vehicle.Wheel.Left..Right.Speed"]
