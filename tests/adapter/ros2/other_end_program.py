"""A node that follows commands: each line is a command, and is answered by a line; both are JSON.

A program for the interpreter that has rclpy.
"""

import importlib
import json
import sys
import threading
from collections import defaultdict
from typing import Any

import rclpy
from diagnostic_msgs.msg import DiagnosticArray
from lifecycle_msgs.msg import Transition
from lifecycle_msgs.srv import ChangeState, GetState
from rcl_interfaces.srv import DescribeParameters, GetParameters, SetParameters, SetParametersAtomically
from rclpy.duration import Duration
from rclpy.executors import SingleThreadedExecutor
from rclpy.parameter import Parameter, parameter_value_to_python
from rclpy.qos import DurabilityPolicy, LivelinessPolicy, QoSProfile, ReliabilityPolicy

PATIENCE = 60.0
"""Seconds after which what does not come will not come; on a machine that has other work too."""


class Peer:
    """Its methods are the commands."""

    def __init__(self) -> None:
        self._node = rclpy.create_node("peer")
        self._executor = SingleThreadedExecutor()
        self._executor.add_node(self._node)
        self._clients: dict[str, Any] = {}
        self._publishers: dict[str, Any] = {}
        self._heard: defaultdict[str, list[dict[str, Any]]] = defaultdict(list)
        self._diagnostics: dict[str, dict[str, Any]] = {}
        self._subscriptions = [self._node.create_subscription(DiagnosticArray, "/diagnostics", self._diagnosed, 100)]
        threading.Thread(target=self._executor.spin, daemon=True).start()

    def change(self, node: str, transition: int) -> Any:
        """Whether the transition was made."""
        request = ChangeState.Request(transition=Transition(id=transition))
        return self._ask(ChangeState, f"{node}/change_state", request).success

    def state(self, node: str) -> Any:
        """The state of a node, by its label."""
        return self._ask(GetState, f"{node}/get_state", GetState.Request()).current_state.label

    def set_parameters(self, node: str, values: dict[str, Any]) -> list[tuple[bool, str]]:
        """Return the result of each."""
        request = SetParameters.Request(parameters=_parameters(values))
        results = self._ask(SetParameters, f"{node}/set_parameters", request).results
        return [(result.successful, result.reason) for result in results]

    def set_all_parameters(self, node: str, values: dict[str, Any]) -> tuple[bool, str]:
        """Return the result of all of them together."""
        request = SetParametersAtomically.Request(parameters=_parameters(values))
        result = self._ask(SetParametersAtomically, f"{node}/set_parameters_atomically", request).result
        return result.successful, result.reason

    def parameters(self, node: str, names: list[str]) -> list[Any]:
        """Their values."""
        request = GetParameters.Request(names=names)
        values = self._ask(GetParameters, f"{node}/get_parameters", request).values
        return [parameter_value_to_python(value) for value in values]

    def described(self, node: str, name: str) -> dict[str, Any]:
        """Return the description of a parameter."""
        request = DescribeParameters.Request(names=[name])
        (found,) = self._ask(DescribeParameters, f"{node}/describe_parameters", request).descriptors
        ranges = [(each.from_value, each.to_value) for each in found.floating_point_range]
        return {"description": found.description, "ranges": ranges, "read_only": found.read_only}

    def step(self, node: str, received: int, time: int, package: str) -> dict[str, Any]:
        """A step of a node whose time is given."""
        service = importlib.import_module(f"{package}.srv").Step
        return _fields(self._ask(service, f"{node}/step", service.Request(received=received, time=time)))

    def advertise(self, topic: str, message: str, quality: dict[str, Any]) -> None:
        """Publish on a topic from now on."""
        self._publishers[topic] = self._node.create_publisher(_type(message), topic, _quality(quality))

    def withdraw(self, topic: str) -> None:
        """Publish there no more."""
        self._node.destroy_publisher(self._publishers.pop(topic))

    def publish(self, topic: str, fields: dict[str, Any]) -> None:
        """Send a message."""
        publisher = self._publishers[topic]
        message = publisher.msg_type()
        _fill(message, fields)
        publisher.publish(message)

    def takers(self, topic: str) -> Any:
        """Return the number of subscriptions that match the publisher."""
        return self._publishers[topic].get_subscription_count()

    def listen(self, topic: str, message: str, quality: dict[str, Any]) -> None:
        """Store messages of a topic from now on."""
        self._subscriptions.append(
            self._node.create_subscription(
                _type(message), topic, lambda each: self._heard[topic].append(_fields(each)), _quality(quality)
            )
        )

    def heard(self, topic: str) -> list[dict[str, Any]]:
        """Return the received messages."""
        return self._heard[topic]

    def diagnostics(self) -> dict[str, dict[str, Any]]:
        """The latest status of everything, by its name."""
        return self._diagnostics

    def _diagnosed(self, array: DiagnosticArray) -> None:
        for status in array.status:
            values = {each.key: each.value for each in status.values}
            level = int.from_bytes(status.level, "little")
            worst = max(level, self._diagnostics.get(status.name, {}).get("worst", 0))
            received = self._diagnostics.get(status.name, {}).get("received", 0) + 1
            told = {"level": level, "worst": worst, "received": received, "message": status.message, "values": values}
            self._diagnostics[status.name] = told

    def _ask(self, service: Any, name: str, request: Any) -> Any:
        if name not in self._clients:
            self._clients[name] = self._node.create_client(service, name)
        client = self._clients[name]
        if not client.wait_for_service(PATIENCE):
            raise TimeoutError(f"there is no {name}")
        done = threading.Event()
        future = client.call_async(request)
        future.add_done_callback(lambda _: done.set())
        if not done.wait(PATIENCE):
            raise TimeoutError(f"{name} does not answer")
        return future.result()


def _type(name: str) -> Any:
    package, kind, message = name.split("/")
    return getattr(importlib.import_module(f"{package}.{kind}"), message)


def _fill(message: Any, fields: dict[str, Any]) -> None:
    for name, value in fields.items():
        if isinstance(value, dict):
            _fill(getattr(message, name), value)
        else:
            setattr(message, name, value)


def _fields(message: Any) -> dict[str, Any]:
    values = {name: getattr(message, name) for name in message.get_fields_and_field_types()}
    return {
        name: _fields(value) if hasattr(value, "get_fields_and_field_types") else value
        for name, value in values.items()
    }


def _parameters(values: dict[str, Any]) -> list[Any]:
    return [Parameter(name, value=value).to_parameter_msg() for name, value in values.items()]


def _quality(given: dict[str, Any]) -> QoSProfile:
    times = {"deadline": "deadline", "lease": "liveliness_lease_duration"}
    more = {times[name]: Duration(seconds=given[name]) for name in times if name in given}
    return QoSProfile(
        depth=given.get("depth", 10),
        reliability=ReliabilityPolicy[given.get("reliability", "RELIABLE")],
        durability=DurabilityPolicy[given.get("durability", "VOLATILE")],
        liveliness=LivelinessPolicy[given.get("liveliness", "AUTOMATIC")],
        **more,
    )


def main() -> None:
    """Until there are no more commands."""
    rclpy.init()
    peer = Peer()
    for line in sys.stdin:
        command, arguments = json.loads(line)
        try:
            answer = {"answer": getattr(peer, command)(*arguments)}
        except TimeoutError as error:
            answer = {"error": str(error)}
        print(json.dumps(answer, default=list), flush=True)
    rclpy.shutdown()


if __name__ == "__main__":
    main()
