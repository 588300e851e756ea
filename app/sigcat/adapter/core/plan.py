"""What the core of an adapter has to do, with every name, number and conversion resolved. The writer of C asks nothing
but this."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import NamedTuple

from sigcat.adapter.core.numbers import Number, NumberType
from sigcat.function.document.document import Pointer
from sigcat.function.function_json.code import CLASS, GLOBALS, POINTERS
from sigcat.function.function_json.conversion import IDENTITY, Linear

__all__ = ["CLASS", "GLOBALS", "POINTERS"]


# -- values -------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Element:
    """One number on its way from a source to a target: from what is received to a variable, or from a variable to what
    is sent."""

    source: NumberType
    target: NumberType
    conversion: Linear = IDENTITY
    """From the number in the source to that in the target."""
    names: Mapping[int, int] | None = None
    """Of an enumeration: numbers of the source, and what they are in the target."""
    least: Number | None = None
    """Smallest number of the source within the range; None if there is none below it."""
    greatest: Number | None = None
    is_checked: bool = False
    """Whether there is a check of the range, so that NaN and infinities are outside of it."""


@dataclass(frozen=True)
class Leaf:
    """A number, or an array of numbers, within a value. A struct has one for each member."""

    source: str
    """Where in the source, after its name: ``, `.x`, `[i]`, `[i].x`, `.x[i]`."""
    target: str
    length: int | None
    """Elements, where there is an `[i]`."""
    element: Element
    init: tuple[Number, ...]
    """Start value in the target, for each element."""
    default: tuple[Number, ...]
    """What stands in for NaN, and for a value after a time-out."""
    replacement: tuple[Number, ...] | None = None
    """What stands in for a value out of range; None: the value passes."""


@dataclass(frozen=True)
class WireField:
    """A member of a struct, as it is received or sent."""

    name: str
    c: str
    length: int | None
    comment: str


@dataclass(frozen=True)
class WireStruct:
    """A struct, as it is received or sent."""

    name: str
    comment: str
    fields: tuple[WireField, ...]


@dataclass(frozen=True)
class WireType:
    """How a value is received or sent: in the catalogue's datatype."""

    c: str
    """Type in C: of an array that of its elements."""
    length: int | None = None
    is_struct: bool = False
    symbols: tuple[tuple[str, int], ...] = ()
    """Names and numbers of an enumeration."""


@dataclass(frozen=True)
class Value:
    """A value between the catalogue and the code."""

    wire: WireType
    leaves: tuple[Leaf, ...]
    is_bare: bool
    """Whether the variable is one number and not an array or a struct."""

    @property
    def is_checked(self) -> bool:
        """Whether any part of it can be out of range."""
        return any(leaf.element.is_checked or leaf.element.names is not None for leaf in self.leaves)

    @property
    def is_replaced(self) -> bool:
        """Whether a value out of range is replaced."""
        return any(leaf.replacement is not None for leaf in self.leaves)


# -- interfaces ---------------------------------------------------------------------------------------------------


class Named(NamedTuple):
    """How an interface is called in the code, and what a reader should know of it."""

    name: str
    """Identifier, unique in the function."""
    comment: str
    """Path in the catalogue and unit: `Vehicle.Speed [km/h]`."""
    pointer: Pointer
    """Where it stands in Function JSON."""


class TimeOut(NamedTuple):
    """When a value is late (section 3)."""

    nanoseconds: int
    starts_with_first: bool
    substitute: str
    """`Last`, `Default` or `Init`."""
    recovery: int
    """Values that end it."""


class Queue(NamedTuple):
    """Values that wait (section 2)."""

    length: int
    drops_newest: bool
    values_per_step: int
    count_variable: str | None
    overflow_error: str | None


@dataclass(frozen=True)
class Input:
    """A signal that a call consumes."""

    named: Named
    port: str
    """What its receive function and its place among the received values are called: one for all calls."""
    variable: str
    value: Value
    is_immediate: bool = False
    time_out: TimeOut | None = None
    time_out_error: str | None = None
    range_error: str | None = None
    queue: Queue | None = None
    names: tuple[str, ...] = ()
    """How the declaration may call it."""
    is_reset: bool = False
    """Whether an error is reset by it."""


@dataclass(frozen=True)
class Output:
    """A signal that a call provides."""

    named: Named
    variable: str
    value: Value
    range_error: str | None = None
    queue: Queue | None = None


@dataclass(frozen=True)
class Port:
    """A signal that is received, for all calls that consume it."""

    name: str
    comment: str
    wire: WireType
    triggers: tuple[str, ...]
    """Calls that it triggers."""
    consumers: tuple[tuple[str, Input], ...] = ()
    """Calls and their inputs."""


@dataclass(frozen=True)
class Parameter:
    """A parameter of one or more calls (section 11)."""

    named: Named
    key: str
    variable: str
    value: Value
    """From the catalogue to the code."""
    learned: Value | None
    """From the code to the catalogue, if the function learns it."""
    calls: tuple[str, ...]
    range_error: str | None = None


# -- causes and errors --------------------------------------------------------------------------------------------


class Cause(NamedTuple):
    """One of the conditions that make an error present."""

    place: str
    """Member of the context that holds its verdict: `Step.in.BrkCylP.time_out`."""
    call: str | None
    """Call that judges it; None where none does."""
    is_late: bool
    """Whether it is known only when the call has ended."""
    is_supervised: bool = False


@dataclass(frozen=True)
class Error:
    """An error of the function (section 6)."""

    named: Named
    wire: WireType
    passed: int
    failed: int
    """Numbers of the two states that are sent."""
    call: str | None
    """The first step that lists it; None: it is never evaluated."""
    calls: tuple[str, ...]
    """Calls that list it."""
    causes: tuple[Cause, ...]
    variable: str | None
    status_variable: str | None
    maturation: int
    """Time in ns."""
    reset: int
    """Time in ns."""
    waits_for_restart: bool
    reset_input: str | None
    """Place of what tells whether its reset condition holds."""
    dependencies: tuple[str, ...]
    """Own errors that it depends on, by their names here."""
    foreign: tuple[str, ...]
    """Errors of others that it depends on, by the names of their ports."""
    occurrence_limit: int
    ignition_limit: int

    @property
    def is_late(self) -> bool:
        """Whether it is evaluated when its call has ended, and not before."""
        return any(cause.is_late and cause.call == self.call for cause in self.causes)

    @property
    def is_supervised(self) -> bool:
        """Whether a supervision is one of its causes."""
        return any(cause.is_supervised for cause in self.causes)


@dataclass(frozen=True)
class ForeignError:
    """An error of another function, which is received."""

    name: str
    comment: str
    wire: WireType


@dataclass(frozen=True)
class Reaction:
    """A safety reaction (section 7)."""

    named: Named
    wire: WireType
    inactive: int
    active: int
    initial: int
    calls: tuple[str, ...]
    errors: tuple[str, ...]
    foreign: tuple[str, ...]
    variable: str | None
    time_out: int | None
    """In ns."""


# -- modes and calls ----------------------------------------------------------------------------------------------


class ModeValue(NamedTuple):
    """A mode, by the number that is received or sent and that of the code."""

    name: str
    number: int
    code: int


@dataclass(frozen=True)
class ModeIn:
    """The mode that the function has to take (section 8)."""

    named: Named
    wire: WireType
    modes: tuple[ModeValue, ...]
    initial: ModeValue
    variable: str | None
    goes_to_initial: bool
    unknown_error: str | None


@dataclass(frozen=True)
class ModeOut:
    """The mode that the function is in."""

    named: Named
    wire: WireType
    modes: tuple[ModeValue, ...]
    variable: str


class Alive(NamedTuple):
    """Limits of the alive supervision (section 10)."""

    least: int
    most: int
    window: int
    """In ns."""
    error: str


class Deadline(NamedTuple):
    """Limits of the deadline supervision, in ns."""

    least: int
    most: int
    error: str


class Logical(NamedTuple):
    """A call in the graph of the logical supervision."""

    number: int
    """Number of its checkpoint, from 1."""
    is_initial: bool
    is_final: bool
    previous: tuple[int, ...]
    """Checkpoints that it may follow."""
    error: str | None


@dataclass(frozen=True)
class Method:
    """A method that the function offers or uses (section 12)."""

    named: Named
    call: str
    is_offered: bool
    symbol: str | None
    arguments: tuple["Argument", ...]
    results: tuple["Argument", ...]
    time_out: int | None
    request_variable: str | None
    status_variable: str | None


@dataclass(frozen=True)
class Argument:
    """An argument or result of a method, in the code's datatype."""

    name: str
    variable: str
    value: Value


@dataclass(frozen=True)
class Call:
    """A step of the function, or its init or terminate (sections 1 and 9)."""

    name: str
    """Last part of its name: `Step`."""
    interface: str
    pointer: Pointer
    symbol: str
    arguments: tuple[str, ...] = ()
    success: int | None = None
    before: tuple[str, ...] = ()
    after: tuple[str, ...] = ()
    description: str = ""
    cycle: int | None = None
    """In ns; None if events trigger it."""
    offset: int = 0
    debounce: int = 0
    priority: int = 0
    previous: tuple[str, ...] = ()
    most_events: int = 1
    """Events that wait: each is a call of its own if one of its triggers is a queue."""
    triggers: frozenset[str] = frozenset()
    """Names of the ports whose values are its events."""
    modes: frozenset[str] | None = None
    """Modes in which it does not run."""
    inputs: tuple[Input, ...] = ()
    outputs: tuple[Output, ...] = ()
    overrun_error: str | None = None
    alive: Alive | None = None
    deadline: Deadline | None = None
    logical: Logical | None = None


class CodeObject(NamedTuple):
    """An object of the code that the adapter holds or defines."""

    name: str
    type: str
    member: str | None


class Extern(NamedTuple):
    """A variable that no header declares, or that the adapter defines."""

    name: str
    c: str
    """Type in C; of an array that of its elements."""
    length: int | None
    is_defined_here: bool


@dataclass(frozen=True)
class Code:
    """How the code of the function is included and called."""

    signature: str
    headers: tuple[str, ...] = ()
    objects: tuple[CodeObject, ...] = ()
    class_name: str | None = None
    externs: tuple[Extern, ...] = ()


@dataclass(frozen=True)
class CorePlan:
    """The core of one function."""

    function: str
    version: str | None
    description: str
    code: Code
    structs: tuple[WireStruct, ...]
    ports: tuple[Port, ...]
    parameters: tuple[Parameter, ...]
    errors: tuple[Error, ...]
    """Each after those that it depends on."""
    foreign_errors: tuple[ForeignError, ...]
    reactions: tuple[Reaction, ...]
    mode_in: ModeIn | None
    mode_out: ModeOut | None
    methods: tuple[Method, ...]
    inits: tuple[Call, ...]
    steps: tuple[Call, ...]
    """In the order of the file."""
    due: tuple[Call, ...]
    """The steps in the order in which they run when they are due at the same time."""
    terminates: tuple[Call, ...]
    sources: Mapping[str, str] = field(default_factory=dict)
    """What the plan was made from, by name and digest."""

    @property
    def calls(self) -> tuple[Call, ...]:
        """Init, steps and terminate."""
        return (*self.inits, *self.steps, *self.terminates)

    @property
    def type_name(self) -> str:
        """Name of the context struct, with which all names begin."""
        return f"{self.function}_Adapter"

    def errors_of(self, call: str, *, late: bool) -> tuple[Error, ...]:
        """Errors that are evaluated when a call has ended (late), or before it."""
        return tuple(error for error in self.errors if error.call == call and error.is_late == late)
