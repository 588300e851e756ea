"""The platforms that functions are integrated with. Whatever lists platforms reads this table."""

from collections.abc import Mapping

from sigcat.integration.autosar_adaptive.platform import AUTOSAR_ADAPTIVE
from sigcat.integration.platform import Platform
from sigcat.integration.ros2.platform import ROS2

PLATFORMS: Mapping[str, Platform] = {platform.name: platform for platform in (AUTOSAR_ADAPTIVE, ROS2)}
"""The platforms by name, in the order in which they are listed."""
