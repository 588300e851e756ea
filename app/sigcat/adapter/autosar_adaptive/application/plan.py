"""The plan of the applications: every name resolved, so that the writers of C++ need nothing else."""

from dataclasses import dataclass
from typing import NamedTuple

from sigcat.adapter.autosar_adaptive.cpp_names import ServiceNames
from sigcat.adapter.core.plan import Call, CorePlan, Error, Method, Parameter, Port, WireStruct, WireType
from sigcat.adapter.host.plan import HostPlan
from sigcat.integration.autosar_adaptive.storages import ADAPTER_STORAGE


class Receiver(NamedTuple):
    """An event, or the notifier of a field, whose values the core takes."""

    member: str
    """Member of the proxy."""
    function: str
    """End of the core's function that receives it: `BrkCylP` of `CoreAcc_Adapter_Receive_BrkCylP`."""
    type: str
    """In C++."""
    wire: WireType
    capacity: int
    comment: str
    tells_of_rejection: bool = False
    """Whether the core wants to know of messages that end-to-end protection rejects."""
    is_protected: bool = False
    """Whether the model protects the event end to end: what the platform does not check is rejected."""


class SentEvent(NamedTuple):
    """An event that the core gives."""

    member: str
    """Member of the skeleton."""
    place: str
    """Member of the core in `out` and `publish`."""
    is_queue: bool
    comment: str
    own_ports: tuple[Port, ...] = ()
    """Ports of other calls of the function that receive it."""


class SentField(NamedTuple):
    """A field that the core gives: an error, or the mode that it is in."""

    member: str
    place: str
    type: str
    initial: int | None
    """Value until the core provides one; None: the start value of the core."""
    error: Error | None
    comment: str
    wire: str
    """Its type in the core."""
    repeated_by: str | None
    """The call that sends it again whenever it ends, of a field that is protected end to end."""

    @property
    def sent(self) -> str:
        """The member that has what was sent last, if that is sent again."""
        return f"sent_{self.place}_"


class CalledMethod(NamedTuple):
    """A method that the function uses, or offers."""

    member: str
    method: Method
    arguments: tuple[tuple[str, str], ...]
    """Names in the service interface and types in C++, in the order of those of the core."""
    results: tuple[tuple[str, str], ...]


_OWN_MEMBERS = {
    f"{name}_"
    for name in (
        "call_mutex", "clock", "core", "core_mutex", "logger", "publishing_mutex", "supervision", "thread", "watch",
    )
}  # fmt: skip
_OWN_PREFIXES = ("calls_", "missed_", "monitor_", "pending_", "sent_", "service_", "storage_")


def _member(names: ServiceNames) -> str:
    """The member for a service: unlike those that every adapter has, whatever the service is called."""
    name = f"{names.variable}_"
    return f"service_{name}" if name in _OWN_MEMBERS or name.startswith(_OWN_PREFIXES) else name


@dataclass(frozen=True)
class Required:
    """A service that a component uses."""

    name: str
    names: ServiceNames
    port: str
    """Its instance specifier."""
    receivers: tuple[Receiver, ...]
    methods: tuple[CalledMethod, ...]

    @property
    def variable(self) -> str:
        """The member of the adapter."""
        return _member(self.names)


@dataclass(frozen=True)
class Provided:
    """A service that a component offers."""

    name: str
    names: ServiceNames
    port: str
    events: tuple[SentEvent, ...]
    fields: tuple[SentField, ...]
    methods: tuple[CalledMethod, ...]

    @property
    def variable(self) -> str:
        """The member of the adapter."""
        return _member(self.names)

    @property
    def type(self) -> str:
        """The class of the member: the skeleton, or what implements its methods."""
        return f"Offered{self.names.stem}" if self.methods else f"::{self.names.skeleton}"


class Monitor(NamedTuple):
    """An error, told to the diagnosis."""

    error: Error
    name: str
    """Name of its interface."""
    port: str
    """Its instance specifier."""

    @property
    def variable(self) -> str:
        """The member of the adapter."""
        return f"monitor_{self.error.named.name}_"


class Storage(NamedTuple):
    """A key-value storage."""

    name: str
    port: str
    """Its instance specifier."""

    @property
    def variable(self) -> str:
        """The member of the adapter."""
        return f"storage_{self.name}_"


class Stored(NamedTuple):
    """A parameter, and where it is stored."""

    parameter: Parameter
    storage: Storage
    key: str

    @property
    def place(self) -> str:
        """Its place in the stored values of the core."""
        return f"stored.{self.parameter.named.name}"


class CallThread(NamedTuple):
    """Calls that run one after the other."""

    priority: int
    """The highest of its calls."""
    calls: tuple[Call, ...]
    """In the order in which they run if several are due."""


class Joined(NamedTuple):
    """Two calls of different priorities that must not run at the same time."""

    first: str
    second: str
    reason: str


class StructPair(NamedTuple):
    """A struct of the platform and the one of the core, whose members have the same order."""

    type: str
    members: tuple[str, ...]
    struct: WireStruct


@dataclass(frozen=True)
class ComponentPlan:
    """A component, with the core of its function."""

    name: str
    stem: str
    """Base name of its files."""
    host: HostPlan
    required: tuple[Required, ...]
    provided: tuple[Provided, ...]
    structs: tuple[StructPair, ...]
    type_headers: tuple[str, ...]
    monitors: tuple[Monitor, ...]
    """Monitors of its errors, which are stored too."""
    storages: tuple[Storage, ...]
    """Key-value storages, that of the adapter itself included."""
    stored: tuple[Stored, ...]
    """Its parameters."""
    supervision: str
    """Instance specifier of its supervised entity."""
    checkpoints: tuple[str, ...]
    """Calls whose ends are reported to it, in the order of their numbers."""
    threads: tuple[CallThread, ...]
    """Threads of its calls, the most urgent one first."""
    error_namespace: tuple[str, ...]
    """Namespace of the errors of methods."""
    joined: tuple[Joined, ...]
    """Calls that are in one thread in spite of their priorities."""

    @property
    def type(self) -> str:
        """The class of its adapter."""
        return f"{self.name}Adapter"

    @property
    def core(self) -> CorePlan:
        """The core of its function."""
        return self.host.core

    @property
    def learned(self) -> tuple[Stored, ...]:
        """Parameters that the function changes."""
        return tuple(each for each in self.stored if each.parameter.learned is not None)

    @property
    def written(self) -> tuple[Storage, ...]:
        """Storages that are written at the end."""
        storages = {each.storage for each in self.learned}
        return tuple(each for each in self.storages if each in storages or each.name == ADAPTER_STORAGE)

    @property
    def is_threaded(self) -> bool:
        """Whether calls may run at the same time: else the thread that finds them due runs them."""
        return len(self.threads) > 1

    @property
    def has_offered(self) -> bool:
        """Whether the function offers a method."""
        return any(each.methods for each in self.provided)

    @property
    def call_mutex(self) -> str:
        """The type of the mutex that separates methods and calls."""
        return "application::CallMutex" if self.is_threaded else "std::mutex"


class ExecutablePlan(NamedTuple):
    """An executable and its components."""

    name: str
    components: tuple[ComponentPlan, ...]


class ApplicationPlan(NamedTuple):
    """All executables."""

    name: str
    namespace: tuple[str, ...]
    executables: tuple[ExecutablePlan, ...]

    @property
    def components(self) -> tuple[ComponentPlan, ...]:
        """Components of all executables."""
        return tuple(component for each in self.executables for component in each.components)
