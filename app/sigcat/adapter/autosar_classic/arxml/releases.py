"""Differences between the releases of AUTOSAR in the written elements."""

from collections.abc import Mapping
from typing import NamedTuple

from sigcat.integration.autosar_classic.deployment.releases import ReleaseName


class Release(NamedTuple):
    """A release, and its choice among elements that mean the same."""

    schema: str
    """Name of its XML schema, which every file states."""
    has_conditional_areas: bool
    """Exclusive areas of a runnable are in elements that may be conditional."""
    has_confirmation_threshold: bool
    """A diagnostic event has a threshold of confirmation, and not one of failure cycles."""
    has_windows_by_state: bool
    """Each state of end-to-end protection has a window; otherwise all states have one."""


BY_NAME: Mapping[ReleaseName, Release] = {
    "4.4.0": Release(
        "AUTOSAR_00046", has_conditional_areas=False, has_confirmation_threshold=False, has_windows_by_state=False
    ),
    "R23-11": Release(
        "AUTOSAR_00052", has_conditional_areas=True, has_confirmation_threshold=True, has_windows_by_state=True
    ),
}
