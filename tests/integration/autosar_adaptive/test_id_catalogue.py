"""Ids of an id catalogue, CSV or an earlier ARXML, are kept, and given to nothing else."""

import pytest

from sigcat.adapter.autosar_adaptive.arxml.adaptive_arxml import generate
from sigcat.adapter.autosar_adaptive.arxml.reading import read_arxml
from sigcat.errors import InputRefused
from sigcat.integration.autosar_adaptive.someip.id_catalogue import read_csv
from sigcat.limits import DEFAULT_LIMITS
from sigcat.platforms.deployment_file import DEFAULT_DEPLOYMENT
from sigcat.platforms.table import PLATFORMS
from tests.integration.autosar_adaptive.identifiers import identifiers_of
from tests.integration.autosar_adaptive.sets import at, deployed, derive, examples, function

PATHS = [f"Vehicle.Branch.Signal{i}" for i in range(900)]


def read(text):
    return read_csv(text.encode(), "ids.csv", DEFAULT_LIMITS)


def with_files(*files, deployment=DEFAULT_DEPLOYMENT):
    add = PLATFORMS["autosar-adaptive"].with_identifiers
    assert add is not None
    return add(deployment, files, DEFAULT_LIMITS)


def refused(*files):
    with pytest.raises(InputRefused) as caught:
        with_files(*files)
    return [(finding.rule, finding.line) for finding in caught.value.findings]


# -- what a catalogue does ----------------------------------------------------------------------------------------


def test_a_name_of_the_set_has_the_id_of_the_catalogue():
    ids = {"VehicleBranchService": 4660, "VehicleBranchService:instance": 7, "VehicleBranchService.Branch_B": 32769,
           "VehicleBranchService.Events": 3}  # fmt: skip
    catalogue = deployed(autosarAdaptive={"identifierCatalogue": ids | {"OtherService": 9, "OtherService.X": 32770}})
    derived = derive([function(signals=[at("Vehicle.Branch.B")])], catalogue)
    assert identifiers_of(derived.model) == ids
    assert [finding.rule for finding in derived.findings] == []


def test_ids_of_names_that_the_set_does_not_have_are_given_to_nothing_else():
    wished = identifiers_of(derive([function(signals=[at(path) for path in PATHS[:40]])]).model)
    elsewhere = {
        key.replace("Branch_", "Old_").replace("VehicleBranchService:", "Old:"): number
        for key, number in wished.items()
    }
    catalogue = {"Old": wished["VehicleBranchService"], **{k: v for k, v in elsewhere.items() if k not in wished}}
    made = identifiers_of(
        derive(
            [function(signals=[at(path) for path in PATHS[:40]])],
            deployed(autosarAdaptive={"identifierCatalogue": catalogue}),
        ).model
    )
    assert made.keys() == wished.keys()
    assert not {key for key in made if made[key] == wished[key]} - {
        "VehicleBranchService.Events",
        "VehicleBranchService:instance",
    }


def test_the_deployment_goes_before_the_catalogue():
    settings = {"identifiers": {"VehicleBranchService": 5000}, "identifierCatalogue": {"VehicleBranchService": 6000}}
    derived = derive([function(signals=[at("Vehicle.Branch.B")])], deployed(autosarAdaptive=settings))
    assert identifiers_of(derived.model)["VehicleBranchService"] == 5000


@pytest.mark.parametrize(
    "settings",
    [
        {"identifierCatalogue": {"VehicleBranchService": 3}},
        {"identifierCatalogue": {"VehicleBranchService.Branch_A": 32769, "VehicleBranchService.Branch_B": 32769}},
        {
            "identifiers": {"VehicleBranchService.Branch_A": 32769},
            "identifierCatalogue": {"VehicleBranchService.Gone": 32769},
        },
    ],
)
def test_ids_that_cannot_be_are_refused(settings):
    functions = [function(signals=[at("Vehicle.Branch.A"), at("Vehicle.Branch.B")])]
    found = [finding.rule for finding in derive(functions, deployed(autosarAdaptive=settings)).findings]
    assert found == ["A009"]


def test_a_full_catalogue_leaves_no_id_and_that_is_told():
    full = {f"S{number}": number for number in range(0x0100, 0xFEFF + 1)}
    derived = derive([function(signals=[at("Vehicle.A.B")])], deployed(autosarAdaptive={"identifierCatalogue": full}))
    assert [finding.rule for finding in derived.findings] == ["A009"]


# -- as CSV -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "text",
    [
        "name,id\nA,4660\nA.B,0x8001\n",
        "\ufeffId;Owner;Name\r\n0x1234;Us;A\r\n\r\n32769;;A.B\r\n",
        'name,id\n"A", 4660\n A.B ,0X8001,more\n',
    ],
)
def test_csv_has_names_and_ids_in_any_order(text):
    assert read(text) == {"A": 4660, "A.B": 32769}


@pytest.mark.parametrize(
    ("text", "lines"),
    [
        ("", [1]),
        ("service,number\nA,1\n", [1]),
        ("name,id\nA,\nB,0\nC,65535\nD,x\n,5\nE\nF,1\n", [2, 3, 4, 5, 6, 7]),
        ("name,id\nA,1\nA,1\nA,2\n", [4]),
        ("name,id\nA,-1\nB,1_0\nC,１\n", [2, 3, 4]),
    ],
)
def test_what_is_no_id_is_told_at_its_line(text, lines):
    assert refused((text.encode(), "ids.csv")) == [("A009", line) for line in lines]


@pytest.mark.parametrize("data", [b"\xff\xfe\x00", b'name,id\n"A' + b"x" * 200_000])
def test_what_is_no_csv_is_refused(data):
    assert [rule for rule, _ in refused((data, "ids.csv"))] == ["A009"]


def test_two_files_that_disagree_are_refused():
    one, two = (b"name,id\nA,1\nB,2\n", "one.csv"), (b"name,id\nB,2\nA,3\n", "two.csv")
    assert refused(one, two) == [("A009", 0)]


# -- as ARXML -----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("release", ["R20-11", "R23-11"])
def test_earlier_arxml_has_all_ids_that_it_was_made_with(release):
    model = derive(examples()).model
    (file,) = [file for file in generate(model, release) if file.name == "deployment.arxml"]
    assert read_arxml(file.data, file.name, DEFAULT_LIMITS) == identifiers_of(model)


def test_of_several_instances_that_of_the_component_is_taken():
    settings = {
        "identifiers": {"WheelService:instance": 20},
        "components": {"Wheel": {"processes": {"ARearWheel": {"WheelService": 3}}}},
    }
    derived = derive([function("Wheel", [at("Vehicle.A.B", "Provider")])], deployed(autosarAdaptive=settings))
    (file,) = [file for file in generate(derived.model) if file.name == "deployment.arxml"]
    assert read_arxml(file.data, file.name, DEFAULT_LIMITS)["WheelService:instance"] == 20


def test_ids_of_earlier_arxml_stay_whatever_is_added():
    before = derive([function(signals=[at(path) for path in PATHS[100:300]])]).model
    files = [(file.data, file.name) for file in generate(before)]
    after = derive([function(signals=[at(path) for path in PATHS[:300]])], with_files(*files))
    assert identifiers_of(before).items() <= identifiers_of(after.model).items()


@pytest.mark.parametrize("data", [b"<", b"<html/>", b"<?xml version='1.0'?><AUTOSAR/>", b"<\xff"])
def test_what_is_no_arxml_is_refused(data):
    with pytest.raises(InputRefused, match="must be ARXML"):
        with_files((data, "old.arxml"))
