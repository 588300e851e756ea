"""A message to a generated ROS 2 node and its answer, beside a node that one would write by hand: on our subset of rclcpp."""

import sys
from pathlib import Path
from statistics import median

from bench.measuring import command, interleaved
from bench.rows import Bench, Missing, Row
from scripts import ros2_environment, ros2_packages, run_ros2
from sigcat.players.ros2_domain import own_domain

TRIPS = 2000
"""At most 1,000 in a second, each after the answer to the one before."""
PROGRAMS = Path(__file__).with_name("programs") / "ros2"


def round_trip(bench: Bench) -> Row:
    """Time from publishing a speed to receiving the result of a call, which runs in a separate thread of the node.

    The quality of service of both nodes is the same.
    """
    if not ros2_environment.is_made():
        raise Missing("ROS 2: `make ros2`, which needs Python 3.11")
    built = _build(bench.folder)
    adapter: list[float] = []

    def generated() -> float:
        trip, told = _measured(built, bench.folder, "reflex/reflex_node")
        adapter.append(float(told))
        return trip

    def by_hand() -> float:
        return _measured(built, bench.folder, "by_hand/by_hand_node")[0]

    figure, reference = interleaved([generated, by_hand], bench.runs)
    work = "a message to a ROS 2 node and its answer, p50"
    measured = f"{figure:.1f} µs; {median(adapter):.1f} µs of it `SetInput` and `GetOutput`"
    return Row(
        work,
        measured,
        f"a node by hand: {reference:.1f} µs",
        f"{figure - reference:+.1f} µs",
        "at most 10 µs more",
        figure - reference <= 10,
    )


ROWS = {"ros2": round_trip}


def _build(folder: Path) -> run_ros2.Workspace:
    """The generated packages, and the one by hand beside them."""
    sigcat = (sys.executable, "-m", "sigcat.cli")
    integration, function = folder / "reflex.json", PROGRAMS / "reflex/function.yaml"
    command(*sigcat, "integrate", "ros2", str(function), "-o", str(integration))()
    command(*sigcat, "generate", "ros2", str(integration), "-o", str(folder / "src"))()
    subset = ros2_packages.build_subset(folder / "subset")
    code = {"REFLEX_CODE": PROGRAMS / "reflex"}
    built = run_ros2.build(folder, subset, flags="-O2", code=code)
    ros2_packages.build_cmake(PROGRAMS / "by_hand", folder, built.prefix, subset, flags="-O2", settings=code)
    return built


def _measured(built: run_ros2.Workspace, folder: Path, node: str) -> tuple[float, str]:
    """The median in µs, and what the node tells of its adapter."""
    programs = built.prefix / "lib"
    with own_domain() as number:
        variables = run_ros2.environment(built, number, folder)
        with run_ros2.started([(programs / node,)], variables, folder / "told.txt"):
            told = ros2_packages.run([programs / "by_hand/round_trip", TRIPS], variables)
    trip, adapter, _ = told.split()
    return float(trip), adapter
