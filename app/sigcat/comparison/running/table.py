"""The platforms that a drive can be played to. Whatever lists them reads this table."""

from collections.abc import Mapping

from sigcat.comparison.running.autosar import AUTOSAR_ADAPTIVE
from sigcat.comparison.running.autosar_classic import AUTOSAR_CLASSIC
from sigcat.comparison.running.fmi import FMI
from sigcat.comparison.running.ros2 import ROS2_CPP, ROS2_PY
from sigcat.comparison.running.runner import Runner
from sigcat.comparison.running.simulation import SIMULATION

RUNNERS: Mapping[str, Runner] = {
    runner.name: runner for runner in (SIMULATION, AUTOSAR_ADAPTIVE, AUTOSAR_CLASSIC, ROS2_CPP, ROS2_PY, FMI)
}
"""By name, in the order in which they are listed; the first one is the reference."""
