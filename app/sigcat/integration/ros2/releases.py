"""Releases of ROS 2 that packages are generated for."""

RELEASES = ("jazzy", "humble")
DEFAULT_RELEASE = RELEASES[0]
