"""Static ids are those of `vspec export id`."""

from pathlib import Path
from subprocess import run

import pytest
import yaml
from hypothesis import given
from hypothesis import strategies as st
from vss_tools.utils.idgen_utils import fnv1_32_hash

from sigcat.catalogue.composing.compose import read_catalogue
from sigcat.catalogue.exporting.static_id import fnv1, static_id

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


@given(st.binary(max_size=200))
def test_the_hash_is_that_of_vss_tools(data: bytes) -> None:
    assert fnv1(data) == fnv1_32_hash(data)


@pytest.mark.parametrize("options", [[], ["--case-sensitive"]])
def test_ids_are_those_that_vss_tools_exports(tmp_path: Path, options: list[str]) -> None:
    for name, text in {"tree.vspec": TREE, "units.yaml": UNITS, "quantities.yaml": QUANTITIES}.items():
        (tmp_path / name).write_text(text)
    command = [
        "vspec",
        "export",
        "id",
        "-s",
        "tree.vspec",
        "-u",
        "units.yaml",
        "-q",
        "quantities.yaml",
        "-o",
        "out.yaml",
    ]
    vspec = Path(__file__).parents[3] / ".venv" / "bin" / "vspec"
    command[0] = str(vspec) if vspec.exists() else "vspec"
    done = run([*command, *options], cwd=tmp_path, check=False, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    exported = yaml.safe_load((tmp_path / "out.yaml").read_text())
    catalogue = read_catalogue(tmp_path / "tree.vspec")
    ids = {path: static_id(node, case_sensitive=bool(options)) for path, node in catalogue.nodes.items()}
    assert ids == {path: values["staticUID"] for path, values in exported.items()}
