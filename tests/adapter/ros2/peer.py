"""Another process of ROS 2, which asks nodes and says what they answer: one JSON value for each line that comes.

A program for the interpreter that has rclpy. It does not know the generated code.
"""

import importlib
import json
import sys
import time
from collections.abc import Callable, Mapping
from typing import Any

import rclpy
from diagnostic_msgs.msg import DiagnosticArray
from lifecycle_msgs.msg import Transition
from lifecycle_msgs.srv import ChangeState, GetState
from rcl_interfaces.msg import Parameter
from rcl_interfaces.srv import DescribeParameters, GetParameters, SetParametersAtomically
from rclpy.executors import SingleThreadedExecutor
from rclpy.parameter import Parameter as Value
from rclpy.parameter import parameter_value_to_python
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy

PATIENCE = 60.0
"""Seconds after which what does not come will not come."""


class Peer:
    """Requests and received messages."""

    def __init__(self) -> None:
        self.node = rclpy.create_node("peer")
        self.executor = SingleThreadedExecutor()
        self.executor.add_node(self.node)
        self.clients: dict[tuple[str, str], Any] = {}
        self.publishers: dict[tuple[str, str], Any] = {}
        self.heard: dict[str, list[Any]] = {}
        self.told: dict[str, dict[str, Any]] = {}
        self.node.create_subscription(DiagnosticArray, "/diagnostics", self._diagnosed, 10)

    def _diagnosed(self, message: Any) -> None:
        for status in message.status:
            values = {pair.key: pair.value for pair in status.values}
            level = int.from_bytes(status.level, "big")
            told = self.told.setdefault(status.hardware_id, {})
            told[status.name] = {"level": level, "message": status.message, **values}

    def until(self, is_so: Callable[[], bool]) -> bool:
        """Wait for something."""
        end = time.monotonic() + PATIENCE
        self.executor.spin_once(0.05)
        while not is_so() and time.monotonic() < end:
            self.executor.spin_once(0.05)
        return is_so()

    def ask(self, name: str, service: Any, request: Any) -> Any:
        """The response of a service."""
        client = self.clients.setdefault((name, service.__name__), self.node.create_client(service, name))
        assert self.until(client.service_is_ready), f"Nobody offers {name}"
        future = client.call_async(request)
        assert self.until(future.done), f"{name} does not answer"
        return future.result()

    # -- what can be asked -----------------------------------------------------------------------------------------

    def change(self, node: str, transition: int | str) -> bool:
        """Ask for a transition, by number or name."""
        asked = Transition(id=transition) if isinstance(transition, int) else Transition(label=transition)
        return bool(self.ask(f"{node}/change_state", ChangeState, ChangeState.Request(transition=asked)).success)

    def state(self, node: str) -> str:
        """The state of a node."""
        return str(self.ask(f"{node}/get_state", GetState, GetState.Request()).current_state.label)

    def set(self, node: str, values: Mapping[str, Any]) -> tuple[bool, str]:
        """Set parameters together."""
        messages = [
            Parameter(name=name, value=Value(name, value=value).get_parameter_value()) for name, value in values.items()
        ]
        request = SetParametersAtomically.Request(parameters=messages)
        result = self.ask(f"{node}/set_parameters_atomically", SetParametersAtomically, request).result
        return bool(result.successful), str(result.reason)

    def get(self, node: str, names: list[str]) -> list[Any]:
        """Values of parameters."""
        values = self.ask(f"{node}/get_parameters", GetParameters, GetParameters.Request(names=names)).values
        return [parameter_value_to_python(value) for value in values]

    def describe(self, node: str, name: str) -> Mapping[str, Any]:
        """Return the description of a parameter."""
        request = DescribeParameters.Request(names=[name])
        (found,) = self.ask(f"{node}/describe_parameters", DescribeParameters, request).descriptors
        ranges = [(each.from_value, each.to_value) for each in found.floating_point_range]
        return {"description": found.description, "ranges": ranges, "read_only": found.read_only}

    def step(self, node: str, service: str, received: int, at: int) -> Mapping[str, Any]:
        """A step in lock-step."""
        kind = _type(service)
        answer = self.ask(f"{node}/step", kind, kind.Request(received=received, time=at))
        return {"success": answer.success, "message": answer.message, "received": answer.received, "sent": answer.sent}

    def publish(self, topic: str, message: str, fields: Mapping[str, Any], reliability: str) -> None:
        """Send a message, once a subscriber has matched or refused."""
        kind, key = _type(message), (topic, reliability)
        if key not in self.publishers:
            quality = QoSProfile(depth=10, reliability=ReliabilityPolicy[reliability.upper()],
                                 durability=DurabilityPolicy.TRANSIENT_LOCAL)  # fmt: skip
            self.publishers[key] = self.node.create_publisher(kind, topic, quality)
            self.until(lambda: self.node.count_subscribers(topic) > 0)
            time.sleep(0.3)
        made = kind()
        for name, value in fields.items():
            setattr(made, name, value)
        self.publishers[key].publish(made)

    def tick(self, seconds: float) -> None:
        """Say on /clock that it is so late."""
        whole, part = divmod(round(seconds * 1e9), 10**9)
        self.publish("/clock", "rosgraph_msgs/msg/Clock", {}, "reliable")
        clock = _type("rosgraph_msgs/msg/Clock")()
        clock.clock.sec, clock.clock.nanosec = whole, part
        self.publishers["/clock", "reliable"].publish(clock)

    def listen(self, topic: str, message: str) -> None:
        """Note messages of a topic from now on."""
        quality = QoSProfile(depth=100, reliability=ReliabilityPolicy.BEST_EFFORT)
        self.heard[topic] = []
        self.node.create_subscription(_type(message), topic, self.heard[topic].append, quality)
        self.until(lambda: self.node.count_publishers(topic) > 0)

    def stamps(self, topic: str, count: int) -> list[int]:
        """Return the stamps of received messages, once there are so many."""
        self.until(lambda: len(self.heard[topic]) >= count)
        return [each.stamp.sec * 10**9 + each.stamp.nanosec for each in self.heard[topic]]

    def diagnostics(self, node: str, name: str, key: str, value: Any) -> Mapping[str, Any]:
        """Return the status of a node under a name, once it matches; else its last status."""
        self.until(lambda: self.told.get(node, {}).get(name, {}).get(key) == value)
        found: Mapping[str, Any] = self.told.get(node, {}).get(name, {})
        return found


def _type(name: str) -> Any:
    package, kind, message = name.split("/")
    return getattr(importlib.import_module(f"{package}.{kind}"), message)


def main() -> None:
    """Answer until the input ends."""
    rclpy.init()
    peer = Peer()
    print(json.dumps("ready"), flush=True)
    for line in sys.stdin:
        name, *arguments = json.loads(line)
        print(json.dumps(getattr(peer, name)(*arguments)), flush=True)
    rclpy.shutdown()


if __name__ == "__main__":
    main()
