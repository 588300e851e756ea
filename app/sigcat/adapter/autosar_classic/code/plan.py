"""The plan of a software component in C: every name resolved, so that the writers need nothing else."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple, Union

from sigcat.adapter.core.plan import CorePlan, Error, Method, Parameter, WireType
from sigcat.adapter.host.host_plan import HostPlan
from sigcat.integration.autosar_classic.model import Component, PerInstanceMemory, Port, Runnable


class RteType(NamedTuple):
    """A datatype of the RTE, with what is in it."""

    name: str
    """In C."""
    base: str = ""
    """Platform type of a number: `uint8`, `boolean`."""
    element: Union["RteType", None] = None
    length: int = 0
    members: tuple[tuple[str, "RteType"], ...] = ()

    @property
    def is_array(self) -> bool:
        return self.element is not None

    @property
    def is_struct(self) -> bool:
        return bool(self.members)

    @property
    def is_number(self) -> bool:
        return not self.is_array and not self.is_struct

    @property
    def pointed(self) -> str:
        """The type behind a pointer to it: of an array that of its elements."""
        return self.element.name if self.element else self.name

    def by_address(self, name: str) -> str:
        """Argument for a value to write: an array is an address already."""
        return name if self.is_array else f"&{name}"

    def by_value(self, name: str) -> str:
        """Argument for a value to read: structs by their address."""
        return f"&{name}" if self.is_struct else name

    def behind(self, pointer: str) -> str:
        """The value behind a pointer."""
        return pointer if self.is_array else f"(*{pointer})"


class DataEnd(NamedTuple):
    """A data element of a port, and what the core has for it."""

    port: str
    element: str
    type: RteType
    wire: WireType
    place: str
    """Name in the core: the end of its receiving function, or its member in `out` and `publish`."""
    comment: str
    columns: tuple[str, ...]
    """Names in traces: its path, its interface, or both."""
    is_queue: bool = False
    """Whether the RTE queues its values."""
    room: int = 1
    """Values that wait in the queue of the RTE."""
    has_count: bool = False
    """Whether the core sends several values at once: the providing function has its own queue."""
    has_update: bool = False
    has_transformer_errors: bool = False
    """Whether the RTE says what end-to-end protection found: a further argument of the function that reads."""
    tells_of_rejection: bool = False
    tells_of_loss: bool = False
    immediate_in: frozenset[str] = frozenset()
    """Calls that take it right before they run."""
    call: str = ""
    """The call that provides it; empty for what the core may say at any time."""

    @property
    def key(self) -> tuple[str, str]:
        return self.port, self.element

    @property
    def name(self) -> str:
        """End of the names of its RTE functions."""
        return f"{self.port}_{self.element}"


class ModeEnd(NamedTuple):
    """A mode of a port."""

    port: str
    prototype: str
    group: str
    place: str
    columns: tuple[str, ...] = ()

    @property
    def name(self) -> str:
        return f"{self.port}_{self.prototype}"

    @property
    def type(self) -> str:
        return f"Rte_ModeType_{self.group}"


class Told(NamedTuple):
    """An error whose status is reported to the diagnosis."""

    port: str
    operation: str
    error: Error


class Reported(NamedTuple):
    """A checkpoint of the watchdog manager."""

    function: str
    """`Rte_Call_<port>_<operation>`."""
    name: str


class ArgumentEnd(NamedTuple):
    """An argument of an operation, and its member in the core's struct."""

    name: str
    type: RteType
    wire: WireType
    place: str


class MethodEnd(NamedTuple):
    """A method that the function offers or uses, as an operation of a port."""

    port: str
    operation: str
    method: Method
    arguments: tuple[ArgumentEnd, ...]
    results: tuple[ArgumentEnd, ...]
    errors: Mapping[str, int]
    """Numbers of the application errors, by their names: `RTE_E_<interface>_<name>`."""
    interface: str
    columns: tuple[str, ...] = ()

    @property
    def name(self) -> str:
        return f"{self.port}_{self.operation}"


class ParameterEnd(NamedTuple):
    """A parameter that is calibrated: what gives its value, and where the core takes it."""

    function: str
    """`Rte_Prm_<port>_<element>` or `Rte_CData_<name>`."""
    type: RteType
    parameter: Parameter


@dataclass(frozen=True)
class SwcPlan:
    """A software component, with the core of its function."""

    component: Component
    host: HostPlan
    received: tuple[DataEnd, ...]
    sent: tuple[DataEnd, ...]
    mode_in: ModeEnd | None
    mode_out: ModeEnd | None
    told: tuple[Told, ...]
    reported: Mapping[tuple[str, str], tuple[Reported, ...]]
    """Checkpoints, by the call that reports them and the moment."""
    methods: tuple[MethodEnd, ...]
    parameters: tuple[ParameterEnd, ...]
    memory: PerInstanceMemory | None
    """Stored values."""
    time: str
    """Function that returns the time: `Rte_Call_<port>_<operation>`."""
    ignition: str
    """Function that returns the number of the ignition cycle; empty without one."""
    restored: str
    """Function that says whether stored values could be read; empty without one."""
    marked: str
    """Function that is notified of changed stored values; empty without one."""
    area: str
    """Exclusive area around the core."""
    calls_area: str
    """Exclusive area around the function's code; empty if it offers no method."""

    @property
    def name(self) -> str:
        """Name of the component type."""
        return self.component.name

    @property
    def core(self) -> CorePlan:
        """The core of its function."""
        return self.host.core

    @property
    def requests(self) -> tuple[MethodEnd, ...]:
        """Methods of others that the function uses."""
        return tuple(each for each in self.methods if not each.method.is_offered)

    @property
    def required_modes(self) -> tuple[Port, ...]:
        """Ports over which modes come, that of the ECU too."""
        ports = self.component.ports
        return tuple(port for port in ports if port.kind == "ModeSwitch" and port.direction == "Required")

    def outputs(self, call: str) -> tuple[DataEnd, ...]:
        """Elements that a call provides."""
        return tuple(end for end in self.sent if end.call == call)

    @property
    def kept(self) -> tuple[DataEnd, ...]:
        """Elements that are sent again until the RTE takes them: others would have an old value until they change.

        Each step of a cycle sends its values again.
        """
        cyclic = {step.name for step in self.core.steps if step.cycle}
        return tuple(end for end in self.sent if not end.is_queue and end.call not in cyclic)

    def runnable(self, role: str, of: str | None = None) -> Runnable | None:
        """The runnable of a role, of a call or a method."""
        return next(
            (each for each in self.component.runnables
             if each.role == role and (of is None or of in (each.call, each.method))), None
        )  # fmt: skip

    def ends(self, runnable: Runnable, kind: str) -> tuple[DataEnd, ...]:
        """Elements that a runnable receives in one way."""
        known = {each.key: each for each in self.received}
        keys = ((each.port or "", each.element) for each in runnable.accesses if each.kind == kind)
        return tuple(known[key] for key in keys if key in known)


class ClassicPlan(NamedTuple):
    """All components."""

    name: str
    swcs: tuple[SwcPlan, ...]
    types: Mapping[str, RteType]
    """Datatypes of the RTE, by name, in the order of the document."""
