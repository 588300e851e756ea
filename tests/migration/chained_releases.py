"""Releases in which a signal is added, changed, moved and removed."""

from collections.abc import Mapping
from pathlib import Path

from sigcat.catalogue.hosting.source import Source

_VERSION = """
Vehicle: {{type: branch, description: A vehicle.}}
Vehicle.VersionVSS: {{type: branch, description: Version.}}
Vehicle.VersionVSS.Major: {{type: attribute, datatype: uint32, default: {0}, description: Major.}}
Vehicle.VersionVSS.Minor: {{type: attribute, datatype: uint32, default: {1}, description: Minor.}}
"""
SPEED = "Vehicle.{}: {{type: sensor, datatype: {}, unit: {}, description: Speed of the vehicle.}}\n"
CHAIN: Mapping[str, str] = {
    "3.1": SPEED.format("Velocity", "float", "km/h"),
    "4.0": SPEED.format("Velocity", "float", "m/s"),
    "5.0": SPEED.format("Speed", "float", "m/s").replace("description", "fka: [Vehicle.Velocity], description"),
    "6.0": "Vehicle.Other: {type: actuator, datatype: string, description: Other.}\n",
}


def source_of(folder: Path, name: str, text: str) -> Source:
    """The source of a release with this tree, which it writes."""
    file = folder / f"{name}.vspec"
    file.write_text(_VERSION.format(*name.split(".")) + text)
    return Source(f"v{name}", f"VSS {name}", file, release=f"v{name}")


def chained_sources(folder: Path) -> tuple[Source, ...]:
    """All of them, the newest first, as a service hosts them."""
    return tuple(source_of(folder, name, text) for name, text in reversed([*CHAIN.items()]))
