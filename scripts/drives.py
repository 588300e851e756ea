"""The recorded drives of the examples, as scripts/drive makes them."""

from collections.abc import Mapping

from scripts.drive import ecocontrol, wheel_speeds


def files() -> Mapping[str, str]:
    """Each drive as CSV."""
    return {
        "examples/ecocontrol/drive.csv": ecocontrol.recording(),
        "examples/wheel_speed_calculation/drive.csv": wheel_speeds.recording(),
    }
