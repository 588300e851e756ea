"""Static ids are those of `vspec export id`."""

from pathlib import Path

import pytest
import yaml
from hypothesis import given
from hypothesis import strategies as st
from vss_tools.utils.idgen_utils import fnv1_32_hash

from sigcat.catalogue.composing.compose import read_catalogue
from sigcat.catalogue.exporting.static_id import fnv1, static_id
from tests.catalogue.vss_tools_output import Job, outputs
from tests.reference_tools import checked_with

TREE = """\
Vehicle: {type: branch, description: A vehicle.}
Vehicle.Door: {type: branch, description: A door., instances: [Left, Right]}
Vehicle.Door.IsOpen: {type: actuator, datatype: boolean, description: Open or not.}
Vehicle.Speed: {type: sensor, datatype: float, unit: km/h, min: -10, max: 250.5, description: Speed.}
Vehicle.Zero: {type: sensor, datatype: uint8, min: 0, description: From zero on.}
Vehicle.Mode: {type: actuator, datatype: string, allowed: ['OFF', SPORT], description: Mode.}
Vehicle.Named: {type: sensor, datatype: float, fka: [Vehicle.Formerly], description: Renamed.}
Vehicle.NamedTwice: {type: sensor, datatype: float, fka: [Vehicle.First, Vehicle.Second], description: Renamed.}
Vehicle.Fixed: {type: sensor, datatype: float, constUID: '0x12345678', description: Fixed.}
"""
UNITS = "km/h: {definition: Speed, unit: kilometer per hour, quantity: velocity, allowed-datatypes: [numeric]}\n"
QUANTITIES = "velocity: {definition: Rate of change of position}\n"


@checked_with("vss-tools", "Static identifiers are the same")
@given(st.binary(max_size=200))
def test_the_hash_is_that_of_vss_tools(data: bytes) -> None:
    assert fnv1(data) == fnv1_32_hash(data)


@pytest.fixture(scope="module")
def tree(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("tree")
    for name, text in {"tree.vspec": TREE, "units.yaml": UNITS, "quantities.yaml": QUANTITIES}.items():
        (folder / name).write_text(text)
    return folder / "tree.vspec"


@pytest.fixture(scope="module")
def expected_outputs(tree: Path) -> dict[str, str | None]:
    usual = ["-s", tree.name, "-u", "units.yaml", "-q", "quantities.yaml"]
    options = {"usual": usual, "case-sensitive": [*usual, "--case-sensitive"]}
    return outputs({name: Job("id", tree.parent, given) for name, given in options.items()})


@checked_with("vss-tools", "Static identifiers are the same")
@pytest.mark.parametrize("name", ["usual", "case-sensitive"])
def test_ids_are_those_that_vss_tools_exports(tree: Path, expected_outputs: dict[str, str | None], name: str) -> None:
    output = expected_outputs[name]
    assert output is not None
    nodes = read_catalogue(tree).nodes
    ids = {path: static_id(node, case_sensitive=name == "case-sensitive") for path, node in nodes.items()}
    assert ids == {path: values["staticUID"] for path, values in yaml.safe_load(output).items()}
