"""The platforms that functions are integrated with. Whatever lists platforms, or what they generate, reads this table."""

from collections.abc import Mapping

from sigcat.platforms.autosar_adaptive import AUTOSAR_ADAPTIVE
from sigcat.platforms.autosar_classic import AUTOSAR_CLASSIC
from sigcat.platforms.fmi import FMI
from sigcat.platforms.platform import Platform
from sigcat.platforms.ros2 import ROS2

PLATFORMS: Mapping[str, Platform] = {
    platform.name: platform for platform in (AUTOSAR_ADAPTIVE, AUTOSAR_CLASSIC, ROS2, FMI)
}
"""The platforms by name, in the order in which they are listed."""
