"""The plan of the packages: every name resolved, so that the writers need nothing else."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

from sigcat.adapter.core.plan import Argument, CorePlan, Error, Method, Parameter, Port, WireStruct, WireType
from sigcat.adapter.host.host_plan import HostPlan
from sigcat.function.document.text import Text, composed
from sigcat.integration.ros2.model import Diagnostic, Package, QualityOfService
from sigcat.integration.ros2.settings import SchedulingPolicy
from sigcat.names import camel_case, snake_case


class InterfaceType(NamedTuple):
    """A message or a service of an interface package."""

    package: str
    kind: str
    """`msg` or `srv`."""
    name: str

    @property
    def path(self) -> str:
        """The name in ROS 2: `eco_control_interfaces/msg/Speed`."""
        return f"{self.package}/{self.kind}/{self.name}"

    @property
    def cpp(self) -> str:
        """The class in C++: `eco_control_interfaces::msg::Speed`."""
        return f"{self.package}::{self.kind}::{self.name}"


class Symbol(NamedTuple):
    """A value of an enumeration that a field has as text."""

    text: str
    number: int
    """In the core."""


class ReceivedField(NamedTuple):
    """A field of a message, and the place of the core that takes it."""

    place: str
    """`BrkCylP` of `CoreAcc_Adapter_Receive_BrkCylP`."""
    field: str
    """Field of the message; of an enumeration that with the number, if it has one."""
    wire: WireType
    comment: str
    symbols: tuple[Symbol, ...] = ()
    """Texts, where the field has nothing else."""
    nameless: int | None = None
    """A number without a text: the core takes it as one out of range. None if every number has a text."""
    numbers: tuple[tuple[int, int], ...] = ()
    """Numbers of the message and of the core, where they differ."""
    wakes: bool = False
    """Whether a value makes a call due."""


class SentField(NamedTuple):
    """A field of a message, and the place of the core's `out` that it is filled from."""

    place: str
    field: str
    wire: WireType
    comment: str
    is_queue: bool = False
    number_field: str | None = None
    """Field that has the number, beside the text."""
    symbols: tuple[Symbol, ...] = ()
    """Texts of the field, where it is text."""
    numbers: tuple[tuple[int, int], ...] = ()
    """Numbers of the core and of the message, where they differ."""
    own_ports: tuple[Port, ...] = ()
    """Ports of other calls of the function that receive it."""


@dataclass(frozen=True)
class Subscription:
    """A topic that a node takes."""

    topic: str
    message: InterfaceType
    member: str
    """Name of its member, without the underscore at the end: `vehicle_speed`."""
    quality: QualityOfService
    takes: tuple[ReceivedField, ...]

    @property
    def wakes(self) -> bool:
        """Whether a message may make a call due."""
        return any(each.wakes for each in self.takes)


class Fixed(NamedTuple):
    """A field of a message that always has one value."""

    field: str
    value: Any


@dataclass(frozen=True)
class Publisher:
    """A topic that a node gives."""

    topic: str
    message: InterfaceType
    member: str
    quality: QualityOfService
    gives: tuple[SentField, ...]
    is_status: bool = False
    """Whether it is an error, a safety reaction or a mode, and not data of a call."""
    stamp: str | None = "stamp"
    """Field that has the time; None if the message has none."""
    fixed: tuple[Fixed, ...] = ()

    @property
    def is_queue(self) -> bool:
        """Whether several messages may be sent at once."""
        return any(each.is_queue for each in self.gives)


class ArgumentField(NamedTuple):
    """An argument or result of a method, and its field."""

    field: str
    argument: Argument


class MethodService(NamedTuple):
    """A method that the function offers or uses, as a service."""

    topic: str
    """Name of the service."""
    service: InterfaceType
    member: str
    method: Method
    request: tuple[ArgumentField, ...]
    response: tuple[ArgumentField, ...]
    success: str | None
    """Field of the response that tells whether the function has answered."""


class NodeParameter(NamedTuple):
    """A parameter of the node, and that of the core."""

    name: str
    type: str
    """bool, integer, double or string, or an array of them, as `double_array`."""
    parameter: Parameter
    description: Text
    default: Any
    low: float | None
    high: float | None
    constraints: Text | None
    units: str | None
    is_read_only: bool
    symbols: tuple[Symbol, ...]
    """Texts, where it is text."""

    @property
    def described(self) -> Text:
        """The description with the unit, as the descriptor of the parameter has it in every language."""
        return composed(self.description, f" Unit: {self.units}.") if self.units else self.description

    @property
    def is_learned(self) -> bool:
        """Whether the function changes it, and its value is stored."""
        return self.parameter.learned is not None


class Monitor(NamedTuple):
    """An error, and how it is shown to people."""

    error: Error
    interface: str
    """Name of its interface."""
    diagnostic: Diagnostic


class StructPair(NamedTuple):
    """A struct of a message and the one of the core, whose members have the same order."""

    message: InterfaceType
    members: tuple[str, ...]
    struct: WireStruct

    @property
    def names(self) -> Sequence[tuple[str, str]]:
        """Names of each member in the message and in the core."""
        return [(name, field.name) for name, field in zip(self.members, self.struct.fields, strict=True)]


@dataclass(frozen=True)
class NodePlan:
    """A node, with the core of its function."""

    name: str
    """`core_acc`: default name of the node, and what its files begin with."""
    package: str
    """Namespace in C++ and folder of its header."""
    host: HostPlan
    executable: str
    priority: int | None
    """Priority of the thread that runs its calls."""
    policy: SchedulingPolicy
    """Default of the parameter `scheduling_policy`."""
    subscriptions: tuple[Subscription, ...]
    publishers: tuple[Publisher, ...]
    offered: tuple[MethodService, ...]
    used: tuple[MethodService, ...]
    parameters: tuple[NodeParameter, ...]
    monitors: tuple[Monitor, ...]
    structs: tuple[StructPair, ...]
    """Each after those that it holds."""
    step_service: InterfaceType
    """`Step` of the interface package, for lock-step."""
    error_status: InterfaceType
    safety_reaction: InterfaceType

    @property
    def stem(self) -> str:
        """Base name of its files: `core_acc_node`."""
        return f"{self.name}_node"

    @property
    def function_stem(self) -> str:
        """Its function: `core_acc`, what the folder of its code is called by default."""
        return snake_case(self.core.function)

    @property
    def type(self) -> str:
        """Its class."""
        return f"{camel_case(self.name)}Node"

    @property
    def core_library(self) -> str:
        """Library of its core. Packages that are installed into one prefix share a folder of libraries."""
        return f"{self.package}_{self.name}_core"

    @property
    def component_library(self) -> str:
        """Library of the component."""
        return f"{self.package}_{self.stem}_component"

    def cpp(self, interface: InterfaceType) -> str:
        """The class of a message in the namespace of the package: `msg::Speed`, or `geometry_msgs::msg::Twist`."""
        return f"{interface.kind}::{interface.name}" if self.is_own(interface) else interface.cpp

    def python(self, interface: InterfaceType) -> str:
        """The class of a message or service in a module of the set: `msg.Speed`, or `geometry_msgs.msg.Twist`."""
        own = f"{interface.kind}.{interface.name}"
        return own if self.is_own(interface) else f"{interface.package}.{own}"

    def private(self, topic: str) -> str:
        """A topic or service as the node creates it: below its own name, whatever it is started as, if it is the node's."""
        own = f"{self.name}/"
        return f"~/{topic.removeprefix(own)}" if topic.startswith(own) else topic

    @property
    def core(self) -> CorePlan:
        """The core of its function."""
        return self.host.core

    @property
    def settable(self) -> tuple[NodeParameter, ...]:
        """Parameters that may change while it runs, by the core's SetParameters."""
        return tuple(each for each in self.parameters if not each.is_learned)

    def is_own(self, interface: InterfaceType) -> bool:
        """Whether a message or service is of the interface package of the set."""
        return interface.package == self.step_service.package

    @property
    def messages(self) -> tuple[InterfaceType, ...]:
        """Messages and services that it exchanges, each once, by name."""
        ends: tuple[Subscription | Publisher, ...] = (*self.subscriptions, *self.publishers)
        found = {each.message for each in ends} | {each.service for each in (*self.offered, *self.used)}
        return tuple(sorted({*found, self.step_service, *(pair.message for pair in self.structs)}))


@dataclass(frozen=True)
class WorkspacePlan:
    """All nodes of a set, and the package that they are in."""

    application: str
    """As the integration calls it: `EcoControl`."""
    package: Package
    """In C++, as the document describes it: `eco_control`."""
    interfaces: str
    """Package of messages and services."""
    namespace: str
    release: str
    """`jazzy` or `humble`."""
    has_bond: bool
    """Whether nodes send heartbeats to their lifecycle manager."""
    nodes: tuple[NodePlan, ...]

    @property
    def message_packages(self) -> tuple[str, ...]:
        """Packages of messages that nodes exchange, by name, beside that of the set."""
        found = {each.package for node in self.nodes for each in node.messages}
        return tuple(sorted(found - {self.interfaces}))

    @property
    def name(self) -> str:
        """Name of the package."""
        return self.package.name
