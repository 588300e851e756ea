"""The plan of the applications: every name resolved, so that the writers of C++ need nothing else."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

from sigcat.adapter.autosar_adaptive.cpp_names import ServiceNames
from sigcat.adapter.core.plan import Call, CorePlan, Error, Parameter, Port, WireStruct, WireType
from sigcat.adapter.host.host_plan import HostPlan
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
    wakes: bool = False
    """Whether it may make a call due."""
    tells_of_rejection: bool = False
    """Whether the core wants to know of messages that end-to-end protection rejects."""
    is_protected: bool = False
    """Whether the model protects the event end to end: what the platform does not check is rejected."""

    @property
    def argument(self) -> str:
        """The received `value` for the core, or the copy `taken` of a value other than a number."""
        if not self.wire.is_plain:
            return "&taken" if self.wire.is_one_struct else "taken"
        return f"static_cast<{self.wire.c}>(value)" if self.type.startswith("::") else "value"


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


class Passed(NamedTuple):
    """An argument or a result: its names in the service interface and in the core, and its type in C++."""

    name: str
    core: str
    type: str

    @property
    def local(self) -> str:
        """Its name in a function: unlike every local variable and member, whatever its own name is."""
        return f"argument_{self.name}"


class CalledMethod(NamedTuple):
    """A method that the function uses, or offers."""

    member: str
    name: str
    """In the core."""
    output: str
    """Type of its results in C++, or void."""
    arguments: tuple[Passed, ...]
    results: tuple[Passed, ...]

    @property
    def pending(self) -> str:
        """The member that waits for an answer."""
        return f"pending_{self.member}_"

    @property
    def future(self) -> str:
        """Return type of the function that calls it."""
        return f"ara::core::Future<{self.output}>"

    @property
    def parameters(self) -> str:
        """Parameters of the function in C++ that answers it."""
        return ", ".join(f"const {each.type}& {each.local}" for each in self.arguments)


_OWN_MEMBERS = {
    f"{name}_"
    for name in (
        "call_mutex", "clock", "core", "core_mutex", "logger", "publishing_mutex", "supervision", "thread", "watch",
    )
}  # fmt: skip
_OWN_PREFIXES = ("calls_", "missed_", "monitor_", "pending_", "sent_", "service_", "storage_")


@dataclass(frozen=True)
class _Service:
    """A service of a component."""

    name: str
    names: ServiceNames
    port: str
    """Its instance specifier."""
    methods: tuple[CalledMethod, ...]

    @property
    def variable(self) -> str:
        """The member of the adapter: unlike those that every adapter has, whatever the service is called."""
        name = f"{self.names.variable}_"
        return f"service_{name}" if name in _OWN_MEMBERS or name.startswith(_OWN_PREFIXES) else name


@dataclass(frozen=True)
class Required(_Service):
    """A service that a component uses."""

    receivers: tuple[Receiver, ...]


@dataclass(frozen=True)
class Provided(_Service):
    """A service that a component offers."""

    events: tuple[SentEvent, ...]
    fields: tuple[SentField, ...]

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

    number: int
    priority: int
    """The highest of its calls."""
    calls: tuple[Call, ...]
    """In the order in which they run if several are due."""

    @property
    def variable(self) -> str:
        """The member of the adapter."""
        return f"calls_{self.number}_"

    @property
    def about(self) -> str:
        """Words for readers."""
        return f"Priority {self.priority}: {', '.join(call.interface for call in self.calls)}"


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

    @property
    def names(self) -> Sequence[tuple[str, str]]:
        """Names of each member on the platform and in the core."""
        return [(name, field.name) for name, field in zip(self.members, self.struct.fields, strict=True)]


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

    def thread_of(self, call: Call) -> CallThread:
        """The thread of a call."""
        return next(thread for thread in self.threads if call in thread.calls)

    def watch_of(self, call: Call) -> str:
        """The member that watches the deadline of a call: that of one call at a time."""
        return f"watch_{self.thread_of(call).number}_" if self.is_threaded else "watch_"

    @property
    def watches(self) -> tuple[str, ...]:
        """Members that watch deadlines."""
        return tuple(dict.fromkeys(self.watch_of(step) for step in self.core.steps if step.deadline))

    @property
    def used(self) -> tuple[CalledMethod, ...]:
        """Methods of other functions."""
        return tuple(method for service in self.required for method in service.methods)

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
