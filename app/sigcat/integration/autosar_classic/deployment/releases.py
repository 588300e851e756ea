"""Releases of AUTOSAR that the ARXML can be of."""

from typing import Literal

ReleaseName = Literal["4.4.0", "R23-11"]
RELEASES: tuple[ReleaseName, ...] = ("4.4.0", "R23-11")
DEFAULT_RELEASE: ReleaseName = "R23-11"
RELEASES_WITH_ONE_WINDOW = frozenset({"4.4.0"})
"""Releases in which all states of the end-to-end state machine have the same window."""
