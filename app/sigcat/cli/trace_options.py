"""The trace that a command reads: CSV, MCAP, or a bag of ROS 2, whose existing messages a deployment file maps."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from sigcat.cli.function_options import deployment_of

if TYPE_CHECKING:
    from sigcat.runs.prepare import Prepared
    from sigcat.runs.recording.ros2_bag import BagColumns
    from sigcat.runs.recording.trace_file import Known, Trace


def add_trace(parser: argparse.ArgumentParser, *, is_required: bool = False) -> None:
    """Add the options."""
    parser.add_argument(
        "--trace", type=Path, required=is_required, metavar="TRACE",
        help="what the functions receive: CSV, MCAP, or a bag of ROS 2",
    )  # fmt: skip
    parser.add_argument(
        "--deployment", type=Path, metavar="FILE",
        help="deployment file that maps existing messages of a bag (default: that of the project)",
    )  # fmt: skip


def trace_of(arguments: argparse.Namespace, known: "Known", prepared: "Prepared") -> "Trace":
    """Open the trace. Raises InputRefused, or UsageError."""
    from sigcat.runs.recording.traces import open_trace

    return open_trace(arguments.trace, known, _mapped(arguments, prepared))


def _mapped(arguments: argparse.Namespace, prepared: "Prepared") -> "BagColumns":
    """Return the columns of existing messages of a bag of ROS 2, as the deployment file maps them."""
    from sigcat.platforms.deployment_file import read_deployment
    from sigcat.runs.bag_columns import bag_columns
    from sigcat.runs.recording.ros2_bag import is_bag

    path = deployment_of(arguments) if is_bag(arguments.trace) else None
    if path is None:
        return {}
    return bag_columns(read_deployment(path.read_bytes(), str(path)), prepared.connections)
