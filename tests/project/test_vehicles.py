"""A vehicle is composed as its equivalent overlay: vss-tools exports the same bytes of both."""

import json
from pathlib import Path
from typing import NamedTuple

import pytest

from sigcat.catalogue.composing.add_overlays import with_overlays
from sigcat.catalogue.hosting.source import load
from sigcat.cli import main
from sigcat.data import ROOT_FILE
from sigcat.project.chosen_tree import source_of_vehicle
from sigcat.project.read_project import read_project
from tests.catalogue.vss_tools_output import Job, outputs
from tests.needs import OFFICIAL, official_releases
from tests.reference_tools import checked_with


class Case(NamedTuple):
    """A vehicle in the project file, and the overlay that says the same."""

    tree: str
    vehicle: str
    overlay: str
    extra: str = ""
    """An overlay that the vehicle is composed `with`."""


def deleted(*paths: str, **_others: str) -> str:
    return "".join(f'"{path}": {{delete: true}}\n' for path in paths)


DOOR_LEAF = "Vehicle.Cabin.Door.Row2.DriverSide.IsOpen"
TRAILER = "Vehicle.Trailer: {type: branch, description: A trailer.}\n"
TRAILER += "Vehicle.Trailer.Load: {type: sensor, datatype: uint16, unit: kg, description: Mass of the load.}\n"

CASES = {
    "nothing": Case("v5.0", "", ""),
    "a leaf": Case("v5.0", 'without = ["Vehicle.Speed"]', deleted("Vehicle.Speed")),
    "a branch": Case("v6.0", 'without = ["Vehicle.ADAS"]', deleted("Vehicle.ADAS")),
    "a wildcard": Case("v6.0", 'without = ["Vehicle.*.Sunroof*"]', deleted("Vehicle.*.Sunroof*")),
    "a definition of instances": Case("shipped", 'without = ["Vehicle.Cabin.Door"]', deleted("Vehicle.Cabin.Door")),
    "an instance": Case(
        "v5.0",
        'without = ["Vehicle.Cabin.Door.Row2"]',
        "Vehicle.Cabin.Door.Row2: {type: branch, description: Doors., delete: true}\n",
    ),
    "a leaf of an instance": Case(
        "v6.0",
        f'without = ["{DOOR_LEAF}"]',
        f"{DOOR_LEAF}: {{type: actuator, datatype: boolean, description: Is open., delete: true}}\n",
    ),
    "rows of seats": Case(
        "shipped",
        'instances = {"Vehicle.Cabin.Seat" = 3}',
        'Vehicle.Cabin.Seat: {instances: ["Row[1,3]", ["DriverSide", "Middle", "PassengerSide"]]}\n',
    ),
    "a list of instances": Case(
        "v5.0",
        'instances = {"Vehicle.Cabin.Door" = ["Row[1,1]", ["DriverSide", "PassengerSide"]]}',
        'Vehicle.Cabin.Door: {instances: ["Row[1,1]", ["DriverSide", "PassengerSide"]]}\n',
    ),
    "axles": Case(
        "v6.0",
        "instances = {Vehicle.Chassis.Axle = 4}",
        'Vehicle.Chassis.Axle: {instances: ["Row[1,4]"]}\n',
    ),
    "a value": Case(
        "shipped",
        'attributes = {steering = "left", "Vehicle.Cabin.DriverPosition" = "RIGHT"}',
        "Vehicle.Cabin.DriverPosition: {default: RIGHT}\n",
    ),
    "an overlay": Case("v5.0", 'with = ["extra.vspec"]', "", TRAILER),
    "everything": Case(
        "shipped",
        'with = ["extra.vspec"]\nwithout = ["Vehicle.Cabin.Seat.Row3.Middle", "Vehicle.ADAS.*"]\n'
        'instances = {"Vehicle.Cabin.Seat" = 3}',
        'Vehicle.Cabin.Seat: {instances: ["Row[1,3]", ["DriverSide", "Middle", "PassengerSide"]]}\n'
        "Vehicle.Cabin.Seat.Row3.Middle: {type: branch, description: Seats., delete: true}\n"
        + deleted("Vehicle.ADAS.*"),
        TRAILER,
    ),
}


def tree_of(case: Case) -> Path:
    return ROOT_FILE if case.tree == "shipped" else OFFICIAL / case.tree / "spec/VehicleSignalSpecification.vspec"


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    """Return the folder of each case: its project, and its overlays."""
    root = tmp_path_factory.mktemp("vehicles")
    for name, case in CASES.items():
        folder = root / name
        folder.mkdir()
        (folder / "extra.vspec").write_text(case.extra or TRAILER)
        (folder / "same.vspec").write_text(case.overlay or TRAILER)
        text = f'[[catalogue]]\nid = "base"\nspec = "{tree_of(case)}"\n[[vehicle]]\nid = "v"\n{case.vehicle}\n'
        (folder / "sigcat.toml").write_text(text)
    units = (OFFICIAL / "v6.0/spec/units.yaml").read_text()
    head, _, tail = units.partition("\nmpg:\n")  # vss-tools refuses the two units of one name
    tail = tail.replace("unit: miles per US gallon\n", "unit: miles per US gallon (deprecated)\n", 1)
    (root / "units.yaml").write_text(f"{head}\nmpg:\n{tail}")
    return root


def options(root: Path, name: str) -> list[str]:
    case = CASES[name]
    overlays = [file for file, text in (("extra.vspec", case.extra), ("same.vspec", case.overlay)) if text]
    units = ["-u", str(root / "units.yaml")] if case.tree == "v6.0" else []
    return ["-s", str(tree_of(case)), *(part for file in overlays for part in ("-l", str(root / name / file))), *units]


@official_releases
@checked_with("vss-tools", "Vehicles have the same meaning as their equivalent overlays")
@pytest.mark.parametrize("name", CASES)
def test_a_vehicle_is_exported_as_vss_tools_exports_its_equivalent_overlay(name, written, capsys, monkeypatch):
    monkeypatch.chdir(written / name)
    assert main(["export", "json", "-s", "vehicle:v"]) == 0
    output = outputs({name: Job("json", written / name, options(written, name))})[name]
    assert output is not None
    assert json.loads(capsys.readouterr().out) == json.loads(output)


@official_releases
@pytest.mark.parametrize("name", CASES)
@pytest.mark.parametrize("expand", ["--expand", "--no-expand"])
def test_a_vehicle_is_exported_byte_for_byte_as_its_equivalent_overlay(name, expand, written, capsys, monkeypatch):
    monkeypatch.chdir(written / name)
    assert main(["export", "json", "-s", "vehicle:v", expand]) == 0
    own = capsys.readouterr().out
    assert main(["export", "json", "--isolated", *options(written, name), expand]) == 0
    assert own == capsys.readouterr().out


@official_releases
@pytest.mark.parametrize("name", CASES)
def test_a_vehicle_that_shares_nodes_equals_one_that_is_composed_as_a_whole(name, written, monkeypatch):
    monkeypatch.chdir(written / name)
    project = read_project(Path("sigcat.toml"))
    source = source_of_vehicle(project, project.vehicles[0])
    vehicle = load(source)
    base = load(source._replace(vehicle=None))
    whole = with_overlays(base, vehicle.layers[len(base.layers) :])
    assert [(n.path, n.values) for n in vehicle.nodes.values()] == [(n.path, n.values) for n in whole.nodes.values()]
    assert (vehicle.digest, vehicle.findings) == (whole.digest, whole.findings)
    assert list(vehicle.definitions) == list(whole.definitions)
