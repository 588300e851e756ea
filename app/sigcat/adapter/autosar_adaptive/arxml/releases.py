"""Differences between the releases of AUTOSAR in the written elements. A later one has all of an earlier one."""

from collections.abc import Mapping
from typing import NamedTuple

from sigcat.integration.autosar_adaptive.deployment.releases import RELEASES, ReleaseName


class Release(NamedTuple):
    """A release, and its choice among elements that mean the same."""

    name: ReleaseName
    schema: str
    """Name of its XML schema, which every file states."""
    has_sets: bool
    """Start-up configurations are in a set, as are the mappings of transformation properties."""
    has_one_executable: bool
    """A process refers to its executable, not to a list of them."""
    has_local_supervisions: bool
    """Supervisions are in local ones, and not in states of function groups."""
    has_root_of_port: bool
    """The mapping of a service instance names the root component of the executable, above the port."""


def _release(name: ReleaseName, number: int) -> Release:
    return Release(
        name,
        f"AUTOSAR_{number:05d}",
        has_sets=name < "R21-11",
        has_local_supervisions=name < "R21-11",
        has_one_executable=name < "R22-11",
        has_root_of_port=name != "R22-11",
    )


_R20_11 = 49
"""Number of the schema of the first of them; each release has the next one."""
BY_NAME: Mapping[str, Release] = {name: _release(name, number) for number, name in enumerate(RELEASES, _R20_11)}
