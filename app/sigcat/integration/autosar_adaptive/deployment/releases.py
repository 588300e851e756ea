"""Releases of AUTOSAR adaptive that ARXML is written for."""

from typing import Literal, get_args

ReleaseName = Literal["R20-11", "R21-11", "R22-11", "R23-11", "R24-11"]
RELEASES: tuple[ReleaseName, ...] = get_args(ReleaseName)
"""From the oldest to the newest, which is also the order of their names."""
DEFAULT_RELEASE: ReleaseName = "R23-11"
SOURCE_RELEASES: tuple[ReleaseName, ...] = ("R23-11", "R24-11")
"""Releases whose API the sources of applications use."""
