"""Quality of service, in the words of the integration."""

from typing import Optional

from rclpy.duration import Duration
from rclpy.qos import DurabilityPolicy, HistoryPolicy, LivelinessPolicy, QoSProfile
from rclpy.qos import ReliabilityPolicy


def quality(
    reliability: str, durability: str, depth: int, *,
    deadline: Optional[float] = None, liveliness: str = 'automatic', lease: Optional[float] = None,
) -> QoSProfile:
    """Answer a profile; times are in milliseconds."""
    profile = QoSProfile(
        history=HistoryPolicy.KEEP_LAST,
        depth=depth,
        reliability=ReliabilityPolicy[reliability.upper()],
        durability=DurabilityPolicy[durability.upper()],
        liveliness=LivelinessPolicy[liveliness.upper()],
    )
    if deadline is not None:
        profile.deadline = Duration(nanoseconds=round(deadline * 1e6))
    if lease is not None:
        profile.liveliness_lease_duration = Duration(nanoseconds=round(lease * 1e6))
    return profile
