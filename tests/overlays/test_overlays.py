"""The shipped overlays load in sigcat and in vss-tools, alone and together, and state the facts of their sources."""

import json
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import pytest
import yaml

from sigcat.catalogue.composing.compose import read_catalogue
from sigcat.catalogue.model.interfaces import category_of
from sigcat.data import OVERLAYS, ROOT_FILE, VSPEC
from tests.catalogue.vss_tools_output import Job, outputs
from tests.function.shipped import interfaces
from tests.needs import published, published_files, slow
from tests.reference_tools import checked_with

NAMES = ("ecocontrol", "error", "safety_reaction", "mode", "scheduling")
UNITS = (VSPEC / "units.yaml", OVERLAYS / "units.yaml")
EXTENDED = (
    "ASILlevel", "resolution", "maturationTime", "severity", "resetTime", "resetCondition", "dependency", "errorList",
    "runType", "cycleTime", "executionOffset", "priority", "scheduling", "debounceTime", "previousRunnable",
    "supervisionType", "aliveSupervision", "deadlineSupervision", "logicalSupervision", "stackSize",
)  # fmt: skip

ECOCONTROL = [
    ("Vehicle.Chassis.Brake.CylP", {"datatype": "double", "unit": "bar", "min": -30, "max": 276.9, "resolution": 0.3}),
    (
        "Vehicle.Chassis.Steering.WhlAg",
        {"datatype": "double", "unit": "radians", "min": -16, "max": 16.766, "resolution": 0.002},
    ),
    ("Vehicle.ADAS.Map.DFS.MapDataSpdUnitTyp", {"datatype": "string"}),
    ("Vehicle.ADAS.EcoControl.Status", {"datatype": "uint8", "resolution": 1, "min": 0, "max": 15, "default": 0}),
    ("Vehicle.ADAS.EcoControl.IsEnabled", {"datatype": "boolean", "default": False}),
    ("Vehicle.Acceleration.Longitudinal", {"datatype": "float", "unit": "m/s^2"}),
    ("Vehicle.Mass", {"type": "attribute", "datatype": "float", "unit": "kg", "default": 2495}),
]


def overlay(name: str) -> Path:
    return OVERLAYS / f"{name}.vspec"


def strict_export(overlays: Sequence[str]) -> Job:
    """`vspec export json --strict` of the tree with overlays, with `-e` for every extended attribute."""
    options = (("-l", map(overlay, overlays)), ("-u", UNITS), ("-e", EXTENDED))
    given = [part for option, values in options for value in values for part in (option, str(value))]
    return Job("json", OVERLAYS, ["-s", str(ROOT_FILE), "--strict", *given])


def paths_of(prefix: str, nodes: Any) -> Iterator[str]:
    for name, node in nodes.items():
        yield prefix + name
        yield from paths_of(f"{prefix}{name}.", node.get("children", {}))


def test_all_of_them_compose_without_a_finding():
    assert interfaces().findings == ()


@pytest.mark.parametrize("name", NAMES)
def test_each_of_them_composes_alone(name):
    assert read_catalogue(ROOT_FILE, [overlay(name)], units=UNITS).findings == ()


@checked_with("vss-tools", "The shipped tree and overlays are accepted with `--strict`")
def test_vss_tools_takes_all_of_them_strictly_and_sees_the_same_nodes():
    output = outputs({"all": strict_export(NAMES)})["all"]
    assert output is not None
    assert set(paths_of("", json.loads(output))) == set(interfaces().nodes)


@checked_with("vss-tools", "The shipped tree and overlays are accepted with `--strict`")
@slow
@pytest.mark.parametrize("name", NAMES)
def test_vss_tools_takes_each_of_them_alone(name):
    output = outputs({name: strict_export([name])})[name]
    assert output is not None
    assert "Vehicle" in json.loads(output)


def test_every_extended_attribute_is_one_that_is_documented():
    used = {name for node in interfaces().nodes.values() for name in node.definition.extended}
    assert used == set(EXTENDED)


@pytest.mark.parametrize(("path", "facts"), ECOCONTROL)
def test_ecocontrol_states_the_facts_of_the_application(path, facts):
    values = interfaces().nodes[path].values
    assert {name: values.get(name) for name in facts} == facts
    assert values["ASILlevel"] == "QM"


def test_the_standard_node_keeps_its_own_description():
    node = interfaces().nodes["Vehicle.Acceleration.Longitudinal"]
    assert node.definition.origin("description").overlay == ""
    assert node.definition.origin("ASILlevel").overlay.endswith("ecocontrol.vspec")


@published_files
def test_ecocontrol_agrees_with_the_published_example_where_that_is_right():
    """It bounds a boolean, and allows `unknown` and lower-case values: these are fixed."""
    theirs = yaml.safe_load(published("example_adas_application.vspec"))
    mended = {
        "Vehicle.ADAS.EcoControl.IsEnabled": {"min", "max"},
        "Vehicle.ADAS.Map.DFS.MapDataSpdUnitTyp": {"allowed"},
    }
    assert len(theirs) > 7
    for path, facts in theirs.items():
        values = interfaces().nodes[path].values
        for name in set(facts) - {"description"} - mended.get(path, set()):
            assert values.get(name) == facts[name], (path, name)
        if path not in ("Vehicle", "Vehicle.Chassis", "Vehicle.ADAS"):
            assert values["description"] != facts["description"]


@pytest.mark.parametrize(("key", "quantity"), [("bar", "pressure"), ("radians", "angle")])
def test_the_units_that_the_example_lacks_are_defined(key, quantity):
    unit = interfaces().vocabulary.unit(key)
    assert unit is not None
    assert unit.quantity == quantity
    assert unit.allowed_datatypes == ("numeric",)


@pytest.mark.parametrize("function", ["WheelSpeedCalculation", "CoreAcc", "EcoControlMpc"])
@pytest.mark.parametrize("category", ["error", "safety_reaction", "mode", "scheduling"])
def test_each_function_has_interfaces_of_every_category(function, category):
    paths = [path for path in interfaces().nodes if path.startswith(f"Vehicle.Function.{function}.")]
    assert any(category_of(path) == category for path in paths)


@pytest.mark.parametrize(
    ("function", "cycle"), [("WheelSpeedCalculation", 10), ("CoreAcc", 50), ("EcoControlMpc", 500)]
)
def test_steps_have_the_cycle_times_of_the_paper(function, cycle):
    assert interfaces().nodes[f"Vehicle.Function.{function}.Scheduling.Step"].values["cycleTime"] == cycle
