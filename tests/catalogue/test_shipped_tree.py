"""The shipped tree restates VSS 6.0: the same facts, with our own descriptions."""

import json
from collections import Counter
from functools import cache

import pytest
import yaml

from sigcat.catalogue.composing.compose import read_catalogue
from sigcat.catalogue.exporting.export_json import tree_data
from sigcat.data import ROOT_FILE, VSPEC
from tests.catalogue.vss_tools_output import Job, outputs
from tests.needs import OFFICIAL, official_releases, slow
from tests.reference_tools import checked_with

TEXTS = ("description", "comment")


@cache
def shipped(*, expanded=True):
    return read_catalogue(ROOT_FILE, expanded=expanded)


def facts(data):
    """An exported tree without its texts."""
    return {key: facts(value) if isinstance(value, dict) else value for key, value in data.items() if key not in TEXTS}


def test_nothing_is_wrong_with_it():
    assert shipped().findings == ()


def test_it_has_so_many_nodes_of_each_type():
    counts = Counter(node.type for node in shipped().nodes.values())
    assert counts == {"branch": 340, "attribute": 130, "sensor": 494, "actuator": 643}


def test_it_has_so_many_leaves_in_each_domain():
    counts = Counter(
        parts[1] if len(parts) > 2 else "(directly below Vehicle)"
        for parts in (node.path.split(".") for node in shipped().nodes.values() if node.is_leaf)
    )
    assert counts == {
        "(directly below Vehicle)": 26,
        "ADAS": 72,
        "Acceleration": 3,
        "AngularVelocity": 3,
        "Body": 93,
        "Cabin": 518,
        "Chassis": 75,
        "Connectivity": 1,
        "ControlUnit": 66,
        "CurrentLocation": 11,
        "Diagnostics": 2,
        "Driver": 6,
        "Exterior": 3,
        "LowVoltageBattery": 4,
        "MotionManagement": 99,
        "Occupant": 60,
        "Powertrain": 196,
        "Service": 3,
        "Trailer": 1,
        "VehicleIdentification": 21,
        "VersionVSS": 4,
    }


@checked_with("releases", "The shipped tree states their facts, units and identifiers")
@pytest.mark.parametrize("expanded", [True, False])
@official_releases
def test_every_fact_is_that_of_the_official_release(expanded):
    official = read_catalogue(OFFICIAL / "v6.0/spec/VehicleSignalSpecification.vspec", expanded=expanded)
    assert facts(tree_data(shipped(expanded=expanded))) == facts(tree_data(official))
    assert list(shipped(expanded=expanded).nodes) == list(official.nodes)


@checked_with("releases", "The shipped tree states their facts, units and identifiers")
@official_releases
@pytest.mark.parametrize("file", ["units.yaml", "quantities.yaml"])
def test_every_unit_and_quantity_is_that_of_the_official_release(file):
    def entries(folder):
        content = yaml.safe_load((folder / file).read_text())
        return {
            key: {name: value for name, value in entry.items() if name not in ("definition", "remark", "comment")}
            for key, entry in content.items()
        }

    official = entries(OFFICIAL / "v6.0/spec")
    if "mpg" in official:  # the one correction: in 6.0 `mpg` shares its name with `mpg-us`, which vss-tools refuses
        official["mpg"]["unit"] = "miles per US gallon (deprecated)"
    assert entries(VSPEC) == official


@checked_with("releases", "The shipped tree states their facts, units and identifiers")
@slow
@official_releases
def test_the_static_ids_are_those_of_the_official_release():
    spec = OFFICIAL / "v6.0/spec/VehicleSignalSpecification.vspec"
    ids = outputs(
        {
            "official": Job("id", OFFICIAL, ["-s", str(spec), "-u", str(VSPEC / "units.yaml")]),
            "shipped": Job("id", VSPEC, ["-s", str(ROOT_FILE)]),
        }
    )

    def static_ids(text):
        assert text is not None
        return {path: entry["staticUID"] for path, entry in yaml.load(text, Loader=yaml.CSafeLoader).items()}

    assert static_ids(ids["shipped"]) == static_ids(ids["official"])


@checked_with("vss-tools", "The shipped tree and overlays are accepted with `--strict`")
def test_vss_tools_takes_it_without_a_complaint():
    output = outputs({"shipped": Job("json", VSPEC, ["-s", str(ROOT_FILE), "--strict"])})["shipped"]
    assert output is not None
    assert json.loads(output) == tree_data(shipped())
