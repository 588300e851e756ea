"""Topics of a node: publishers and subscriptions whose messages and events are counted."""

from threading import Condition
from time import monotonic, sleep
from typing import Any, Callable, List, Optional

from diagnostic_msgs.msg import DiagnosticStatus
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.lifecycle import LifecycleNode
from rclpy.qos import QoSProfile

from .diagnostics import TopicCounts
from .events import has_deadline, publisher_events, subscription_events
from .executor import has_threads
from .message_info import with_sequence_number

ALL_OF_A_STEP = 1000
"""Messages of a topic that are kept in lock step until they are taken."""


class Topics:
    """All topics of a node."""

    def __init__(self, node: LifecycleNode) -> None:
        """Begin with none."""
        self.received = 0
        """Messages that have been taken in all, and whose values are stored."""
        self.sent = 0
        self.keeps_all = False
        """Whether nothing may be lost, as in lock step, however many messages a step sends.

        Deadlines are those of the clock, not of the steps: they are not watched then.
        """
        self._node = node
        self._group = MutuallyExclusiveCallbackGroup()
        self._counts: List[TopicCounts] = []
        self._subscriptions: List[Any] = []
        self._destroyers: List[Callable[[], Any]] = []
        self._has_received = Condition()

    def subscribe(
        self, message: Any, topic: str, quality: QoSProfile, take: Callable[[Any], None],
    ) -> None:
        """Subscribe to a topic whose messages `take` stores."""
        counts = TopicCounts(f'subscription {self._shown(topic)}', self._deadline(quality))

        def taken(value: Any, sequence_number: Optional[int]) -> None:
            take(value)
            counts.add_message()
            skipped = counts.skipped_before(sequence_number)
            if skipped and subscription.get_publisher_count() == 1:  # others count for themselves
                counts.events['skipped'] += skipped
            with self._has_received:
                self.received += 1
                self._has_received.notify_all()

        subscription = self._node.create_subscription(
            message, topic, with_sequence_number(taken), self._kept(quality),
            callback_group=self._group,
            event_callbacks=subscription_events(quality, counts),
        )
        counts.has_stranger = lambda: (
            self._node.count_publishers(subscription.topic_name)
            > subscription.get_publisher_count())
        self._counts.append(counts)
        self._subscriptions.append(subscription)
        self._destroyers.append(lambda: self._node.destroy_subscription(subscription))

    def advertise(self, message: Any, topic: str, quality: QoSProfile) -> Callable[[Any], None]:
        """Advertise a topic, and answer what sends a message on it while the node is active."""
        counts = TopicCounts(f'publisher {self._shown(topic)}', self._deadline(quality))
        publisher = self._node.create_lifecycle_publisher(
            message, topic, self._kept(quality), callback_group=self._group,
            event_callbacks=publisher_events(quality, counts),
        )
        counts.has_stranger = lambda: (
            self._node.count_subscribers(publisher.topic_name)
            > publisher.get_subscription_count())
        self._counts.append(counts)
        self._destroyers.append(lambda: self._node.destroy_lifecycle_publisher(publisher))

        def send(value: Any) -> None:
            if publisher.is_activated:
                publisher.publish(value)
                counts.add_message()
                self.sent += 1

        return send

    def _shown(self, topic: str) -> str:
        return self._node.get_name() + topic[1:] if topic.startswith('~/') else topic

    def _deadline(self, quality: QoSProfile) -> int:
        return 0 if self.keeps_all or not has_deadline(quality) else quality.deadline.nanoseconds

    def _kept(self, quality: QoSProfile) -> QoSProfile:
        if self.keeps_all:
            quality.depth = ALL_OF_A_STEP
        return quality

    def wait_for_received(self, count: int, longest: float) -> bool:
        """Answer whether so many messages have been taken in all, `longest` seconds from now."""
        if not has_threads(self._node):
            return self._take_until_received(count, longest)
        with self._has_received:
            return self._has_received.wait_for(lambda: self.received >= count, longest)

    def _take_until_received(self, count: int, longest: float) -> bool:
        """Take messages in the thread that would take them otherwise."""
        end = monotonic() + longest
        while self.received < count:
            before = self.received
            for subscription in self._subscriptions:
                self._take_from(subscription)
            if self.received == before:
                if monotonic() > end:
                    return False
                sleep(0.0002)
        return True

    def _take_from(self, subscription: Any) -> None:
        taken = subscription.handle.take_message(subscription.msg_type, subscription.raw)
        while taken is not None:
            subscription.callback(*taken)
            taken = subscription.handle.take_message(subscription.msg_type, subscription.raw)

    def tick(self, seconds: float) -> None:
        """Note that so much time has passed."""
        for counts in self._counts:
            counts.tick(seconds)

    def statuses(self, node: str, *, has_calls: bool) -> List[DiagnosticStatus]:
        """Answer a status of each topic."""
        return [counts.status(node, has_calls=has_calls) for counts in list(self._counts)]

    def clear(self) -> None:
        """Destroy all of them, and begin again."""
        for destroy in self._destroyers:
            destroy()
        self._destroyers.clear()
        self._subscriptions.clear()
        self._counts.clear()
        self.received = self.sent = 0
