"""Plays a recorded drive to lifecycle nodes in lock-step, and records what they send.

A program for the interpreter that has rclpy: PYTHON player.py INTEGRATION DRIVE RECORDED SECONDS. The nodes are running, with
`lock_step` set; it brings them through their life by their services. Rows of the record: time in ns, name, value.
"""

import csv
import importlib
import json
import sys
import time
from collections import Counter, defaultdict
from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

import rclpy
from lifecycle_msgs.msg import Transition
from lifecycle_msgs.srv import ChangeState
from rclpy.executors import SingleThreadedExecutor
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy

PATIENCE = 60.0
"""Seconds after which what does not come will not come."""


class Field(NamedTuple):
    """A field of a message, and what it is called in a recording."""

    name: str
    field: str
    number_field: str | None


class Topic(NamedTuple):
    """One end of a topic."""

    name: str
    message: str
    node: str
    fields: tuple[Field, ...]
    quality: Mapping[str, Any]


def data_topics(document: Mapping[str, Any], role: str) -> Iterator[Topic]:
    """Signals."""
    for communication in document["CommunicationList"]:
        for topic in communication["ROSTopicList"]:
            if topic["Role"] == role:
                mappings = [each for data in topic["DataMappingList"] for each in data["FieldList"]]
                fields = tuple(Field(each["VssPath"], each["Field"], each.get("NumberField")) for each in mappings)
                yield Topic(
                    topic["TopicName"], topic["MessageType"], topic["NodeName"], fields, topic["QualityOfService"]
                )


def status_topics(document: Mapping[str, Any], role: str) -> Iterator[Topic]:
    """Errors, safety reactions and modes."""
    for package in document["NodePackageList"]:
        for node in package["Nodes"]:
            for key in ("ErrorTopics", "SafetyReactionTopics", "ModeTopics"):
                for topic in node[key]:
                    if topic["Role"] == role:
                        fields = (Field(topic["InterfaceName"], topic["Field"], None),)
                        quality = topic["QualityOfService"]
                        yield Topic(topic["TopicName"], topic["MessageType"], node["NodeName"], fields, quality)


def releases(document: Mapping[str, Any], end: int) -> set[int]:
    """Times at which calls are due."""
    schedules = [
        each for package in document["NodePackageList"] for node in package["Nodes"] for each in node["Schedules"]
    ]
    found: set[int] = set()
    for schedule in schedules:
        if schedule.get("Period"):
            found.update(range(round(schedule["Offset"] * 1e6), end + 1, round(schedule["Period"] * 1e6)))
    return found


def drive(path: Path, end: int) -> Iterator[tuple[int, Mapping[str, str]]]:
    """Times and the values received then."""
    with path.open(newline="", encoding="utf-8") as file:
        for row in csv.DictReader(file):
            seconds, _, fraction = row.pop("time").partition(".")
            at = int(seconds) * 10**9 + int(fraction.ljust(9, "0"))
            if at <= end:
                yield at, {name: value for name, value in row.items() if value}


def message_type(name: str) -> Any:
    """The class of a message: `eco_control_interfaces/msg/Speed`."""
    package, kind, message = name.split("/")
    return getattr(importlib.import_module(f"{package}.{kind}"), message)


def constants(message: Any) -> Mapping[str, int]:
    """Numbers of a message's constants, by name."""
    names = (name for name in dir(type(message)) if name.isupper())
    return {name: value for name in names if isinstance(value := getattr(message, name), int)}


def profile(quality: Mapping[str, Any], *, is_publisher: bool) -> QoSProfile:
    """Quality of service that fits the other end, and keeps everything."""
    is_reliable = is_publisher or quality["Reliability"] == "reliable"
    keeps = quality["Durability"] == "transient_local"
    return QoSProfile(
        depth=1000,
        reliability=ReliabilityPolicy.RELIABLE if is_reliable else ReliabilityPolicy.BEST_EFFORT,
        durability=DurabilityPolicy.TRANSIENT_LOCAL if keeps else DurabilityPolicy.VOLATILE,
    )


class Player:
    """The nodes, with the messages to and from them."""

    def __init__(self, document: Mapping[str, Any]) -> None:
        self.document = document
        self.nodes = [node["NodeName"] for package in document["NodePackageList"] for node in package["Nodes"]]
        self.interfaces = document["InterfacePackageList"][0]["Name"]
        self.recorded: list[tuple[int, str, str]] = []
        self.sent: Counter[str] = Counter()
        """Messages of each node that have come here."""
        self.given: Counter[str] = Counter()
        """Messages that each node has to take."""
        self.node = rclpy.create_node("player")
        self.executor = SingleThreadedExecutor()
        self.executor.add_node(self.node)
        self._listen()
        self._advertise()
        self.steps = {
            name: self._client(name, "step", message_type(f"{self.interfaces}/srv/Step")) for name in self.nodes
        }
        self.changes = {name: self._client(name, "change_state", ChangeState) for name in self.nodes}

    def _client(self, node: str, name: str, service: Any) -> Any:
        return self.node.create_client(service, f"{node}/{name}")

    def _ends(self, role: str) -> list[Topic]:
        return [*data_topics(self.document, role), *status_topics(self.document, role)]

    def _listen(self) -> None:
        self.takers: defaultdict[str, set[str]] = defaultdict(set)
        for topic in self._ends("Subscription"):
            self.takers[topic.name].add(topic.node)
        self.listened = {topic.name: topic for topic in self._ends("Publisher")}
        self.subscriptions = [
            self.node.create_subscription(
                message_type(topic.message), topic.name, partial(self._heard, topic),
                profile(topic.quality, is_publisher=False),
            )
            for topic in self.listened.values()
        ]  # fmt: skip

    def _heard(self, topic: Topic, message: Any) -> None:
        self.sent[topic.node] += 1
        for taker in self.takers[topic.name] - {topic.node}:
            self.given[taker] += 1
        at = message.stamp.sec * 10**9 + message.stamp.nanosec
        names = {number: name for name, number in constants(message).items()}
        for field in topic.fields:
            value = getattr(message, field.field)
            is_status = not field.name.startswith("Vehicle.")
            self.recorded.append((at, field.name, names[value] if is_status else json.dumps(value)))

    def _advertise(self) -> None:
        self.publishers: dict[str, Any] = {}
        self.columns: dict[str, tuple[Topic, Field]] = {}
        for topic in self._ends("Subscription"):
            if topic.name not in self.listened and topic.name not in self.publishers:
                quality = profile(topic.quality, is_publisher=True)
                self.publishers[topic.name] = self.node.create_publisher(
                    message_type(topic.message), topic.name, quality
                )
            if topic.name in self.publishers:
                self.columns.update({field.name: (topic, field) for field in topic.fields})

    # -- life ------------------------------------------------------------------------------------------------------

    def answers(self, asked: Mapping[str, Any]) -> Mapping[str, Any]:
        """Responses, by node."""
        end = time.monotonic() + PATIENCE
        while not all(future.done() for future in asked.values()):
            self.executor.spin_once(0.1)
            assert time.monotonic() < end, f"There is no answer from {[n for n, f in asked.items() if not f.done()]}"
        return {name: future.result() for name, future in asked.items()}

    def change(self, transition: int) -> None:
        """Bring all nodes through a transition."""
        for name, client in self.changes.items():
            assert client.wait_for_service(PATIENCE), name
            request = ChangeState.Request(transition=Transition(id=transition))
            answer = self.answers({name: client.call_async(request)})[name]
            assert answer.success, f"{name} refuses transition {transition}"

    def wait_for_ends(self) -> None:
        """Wait until everybody has found everybody, and what was sent at once has come."""
        end = time.monotonic() + PATIENCE
        while not all(
            publisher.get_subscription_count() >= len(self.takers[name]) for name, publisher in self.publishers.items()
        ):
            self.executor.spin_once(0.05)
            assert time.monotonic() < end, "Not every subscription has been found"
        until = time.monotonic() + 1.0
        while time.monotonic() < until:
            self.executor.spin_once(0.05)

    # -- steps -----------------------------------------------------------------------------------------------------

    def publish(self, row: Mapping[str, str]) -> None:
        """Send the values of one time."""
        messages: dict[str, Any] = {}
        for name, value in row.items():
            if name in self.columns:
                topic, field = self.columns[name]
                message = messages.setdefault(topic.name, message_type(topic.message)())
                fill(message, field, value)
        for name, message in messages.items():
            self.publishers[name].publish(message)
            for taker in self.takers[name]:
                self.given[taker] += 1

    def step(self, at: int) -> bool:
        """One step of each node in turn; whether any of them has sent something to another one."""
        before = sum(self.given.values())
        for name in self.nodes:
            self._step_alone(name, at)
        return sum(self.given.values()) > before

    def _step_alone(self, name: str, at: int) -> None:
        """One step of a node, until all that it sent has come here: the next node takes it before its own step."""
        request = message_type(f"{self.interfaces}/srv/Step").Request(received=self.given[name], time=at)
        answer = self.answers({name: self.steps[name].call_async(request)})[name]
        assert answer.success, f"{name}: {answer.message}"
        assert answer.received <= self.given[name], (
            f"{name} has taken {answer.received} messages, not {self.given[name]}"
        )
        end = time.monotonic() + PATIENCE
        while self.sent[name] < answer.sent:
            self.executor.spin_once(0.1)
            assert time.monotonic() < end, f"{name} has sent {answer.sent} messages, and {self.sent[name]} have come"

    def play(self, rows: Sequence[tuple[int, Mapping[str, str]]], end: int) -> None:
        """Everything up to a time."""
        by_time: defaultdict[int, list[Mapping[str, str]]] = defaultdict(list)
        for at, row in rows:
            by_time[at].append(row)
        times = sorted({*by_time, *releases(self.document, end)})
        for at, after in zip(times, [*times[1:], end], strict=True):
            for row in by_time[at]:
                self.publish(row)
            while self.step(at):
                pass
            self.step(after)


def fill(message: Any, field: Field, value: str) -> None:
    """Put a value of a recording into a field; an enumeration as text and number, where both are there."""
    known = constants(message)
    current = getattr(message, field.field)
    if value in known:
        number = known[value]
        setattr(message, field.field, value if isinstance(current, str) else number)
        if field.number_field:
            setattr(message, field.number_field, number)
        return
    read = json.loads({"nan": "NaN", "inf": "Infinity", "-inf": "-Infinity"}.get(value, value))
    is_float = isinstance(current, float) and not isinstance(read, bool)
    setattr(
        message,
        field.field,
        [float(each) for each in read] if isinstance(read, list) else float(read) if is_float else read,
    )


def main() -> int:
    """Play, and write the record."""
    integration, recording, recorded, seconds = (
        Path(sys.argv[1]),
        Path(sys.argv[2]),
        Path(sys.argv[3]),
        float(sys.argv[4]),
    )
    end = round(seconds * 1e9)
    rclpy.init()
    player = Player(json.loads(integration.read_bytes()))
    player.change(Transition.TRANSITION_CONFIGURE)
    player.wait_for_ends()
    player.change(Transition.TRANSITION_ACTIVATE)
    player.play(list(drive(recording, end)), end)
    player.change(Transition.TRANSITION_DEACTIVATE)
    player.change(Transition.TRANSITION_CLEANUP)
    with recorded.open("w", newline="", encoding="utf-8") as file:
        csv.writer(file).writerows([("time", "name", "value"), *player.recorded])
    rclpy.shutdown()
    return 0


if __name__ == "__main__":
    sys.exit(main())
