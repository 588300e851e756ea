"""Events of the quality of service, which are counted and told in the diagnostics."""

from typing import Any

from rclpy.duration import Infinite
from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
from rclpy.qos import QoSProfile

from .diagnostics import TopicCounts


def subscription_events(
    quality: QoSProfile, counts: TopicCounts,
) -> SubscriptionEventCallbacks:
    """Count what becomes of a subscription."""
    def lost(event: Any) -> None:
        counts.events['lost'] = event.total_count

    def incompatible(event: Any) -> None:
        counts.events['incompatible QoS'] = event.total_count

    def liveliness(event: Any) -> None:
        counts.events['liveliness lost'] += max(event.not_alive_count_change, 0)

    return SubscriptionEventCallbacks(
        message_lost=lost,
        incompatible_qos=incompatible,
        liveliness=liveliness if has_lease(quality) else None,
    )


def publisher_events(
    quality: QoSProfile, counts: TopicCounts,
) -> PublisherEventCallbacks:
    """Count what becomes of a publisher."""
    def incompatible(event: Any) -> None:
        counts.events['incompatible QoS'] = event.total_count

    def liveliness(event: Any) -> None:
        counts.events['liveliness lost'] = event.total_count

    return PublisherEventCallbacks(
        incompatible_qos=incompatible,
        liveliness=liveliness if has_lease(quality) else None,
    )


def has_deadline(quality: QoSProfile) -> bool:
    """Answer whether values have to come in time."""
    return bool(0 < quality.deadline.nanoseconds < Infinite.nanoseconds)


def has_lease(quality: QoSProfile) -> bool:
    """Answer whether a silent publisher is taken for dead."""
    lease = quality.liveliness_lease_duration
    return bool(0 < lease.nanoseconds < Infinite.nanoseconds)
