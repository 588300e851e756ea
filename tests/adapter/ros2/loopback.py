"""Processes of ROS 2 that find each other on this machine alone, and share no memory.

Fast DDS reopens a port of shared memory whose reader seems to be dead, such as that of a process that got no processor for a second. A process
that ends in that moment crashes, since the thread that closes the port does not know of the one that reopens it (up to Fast DDS 3.6).
Where tests run side by side, that happens.

With a separate discovery range, ROS always uses shared memory. With that of the system, the profile decides.
"""

from pathlib import Path

LOOPBACK = {
    "ROS_AUTOMATIC_DISCOVERY_RANGE": "SYSTEM_DEFAULT",
    "FASTRTPS_DEFAULT_PROFILES_FILE": str(Path(__file__).with_suffix(".xml")),
}
"""Environment of such a process."""
