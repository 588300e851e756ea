"""The whole plan of a core."""

from collections.abc import Iterable, Mapping
from typing import NamedTuple

from sigcat.adapter.core.numbers import DOUBLE, FLOAT, NumberType
from sigcat.adapter.core.plan.call import Call
from sigcat.adapter.core.plan.clock import NANOSECONDS, Clock
from sigcat.adapter.core.plan.interface import Method, Output, Parameter, Port
from sigcat.adapter.core.plan.status import Error, ForeignError, ModeIn, ModeOut, Reaction
from sigcat.adapter.core.plan.value import WireStruct
from sigcat.function.document.document import Pointer
from sigcat.function.document.text import Text, composed
from sigcat.function.function_json.code import CLASS, GLOBALS
from sigcat.names import screaming_snake_case


class CodeObject(NamedTuple):
    """An object of the code that the adapter holds or defines."""

    name: str
    type: str
    member: str | None
    length: int | None = None
    """Elements of an array; None if it is not an array."""


class Extern(NamedTuple):
    """A variable that no header declares, or that the adapter defines."""

    name: str
    c: str
    """Type in C; of an array that of its elements."""
    length: int | None
    is_defined_here: bool


class Code(NamedTuple):
    """Sources, headers and calls of the function's code."""

    signature: str
    headers: tuple[str, ...] = ()
    objects: tuple[CodeObject, ...] = ()
    class_name: str | None = None
    externs: tuple[Extern, ...] = ()
    sources: tuple[str, ...] = ()
    include_folders: tuple[str, ...] = ()
    definitions: tuple[str, ...] = ()
    """`NAME` or `NAME=VALUE`."""

    @property
    def is_cpp(self) -> bool:
        """Whether what calls it is C++."""
        return self.signature == CLASS

    @property
    def ending(self) -> str:
        """Extension of the names of files that call it."""
        return "cpp" if self.is_cpp else "c"


class Provenance(NamedTuple):
    """The file that declares a function, and the lines of its interfaces, for readers."""

    declaration: Text = Text("")
    """Name of the file."""
    digest: str = ""
    """SHA-256 of the file."""
    document: str = ""
    """Name of the file whose lines `lines` names: the same, or a document that was made from it."""
    lines: Mapping[Pointer, str] = {}
    """Line and ASIL of each interface, by pointers into Function JSON."""

    @property
    def text(self) -> Text:
        """The file: `function.yaml (SHA-256 f4cb…)`."""
        return composed(self.declaration, f" (SHA-256 {self.digest})")

    def of(self, pointers: Iterable[Pointer]) -> str:
        """Return the lines of some interfaces, as the beginning of a list: `line 57, ASIL B, `."""
        found = dict.fromkeys(self.lines[each] for each in pointers if each in self.lines)
        return " and ".join(found) + ", " if found else ""


class CorePlan(NamedTuple):
    """The core of one function."""

    function: str
    version: str | None
    description: Text
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
    arithmetic: NumberType = DOUBLE
    """Type in which values are converted."""
    clock: Clock = NANOSECONDS
    """Its clock."""
    provenance: Provenance = Provenance()

    @property
    def is_in_float(self) -> bool:
        """Whether values are converted in float."""
        return self.arithmetic == FLOAT

    @property
    def calls(self) -> tuple[Call, ...]:
        """Init, steps and terminate."""
        return (*self.inits, *self.steps, *self.terminates)

    @property
    def outputs(self) -> tuple[Output, ...]:
        """Data that is sent."""
        return tuple(output for step in self.steps for output in step.outputs)

    @property
    def statuses(self) -> tuple[Error | Reaction | ModeOut, ...]:
        """Sent status of the function: errors, safety reactions and its mode."""
        return (*self.errors, *self.reactions, *((self.mode_out,) if self.mode_out else ()))

    @property
    def requests(self) -> tuple[Method, ...]:
        """Methods of others that the function uses."""
        return tuple(method for method in self.methods if not method.is_offered)

    @property
    def offered(self) -> tuple[Method, ...]:
        """Methods that others use."""
        return tuple(method for method in self.methods if method.is_offered)

    @property
    def published(self) -> tuple[Output | Error | Reaction | ModeOut | Method, ...]:
        """Everything that the platform sends when the core says so."""
        return (*self.outputs, *self.statuses, *self.requests)

    @property
    def hooks(self) -> tuple[str, ...]:
        """Functions of the project, which run before and after calls."""
        return tuple(dict.fromkeys(hook for call in self.calls for hook in (*call.before, *call.after)))

    @property
    def judged_checkpoints(self) -> tuple[Call, ...]:
        """Checkpoints that an error reports."""
        return tuple(call for call in self.calls if call.logical and call.logical.error)

    @property
    def settable(self) -> tuple[Parameter, ...]:
        """Parameters that are set from outside: all but those that the function learns."""
        return tuple(each for each in self.parameters if each.learned is None)

    @property
    def learned(self) -> tuple[Parameter, ...]:
        """Parameters that the function learns."""
        return tuple(each for each in self.parameters if each.learned is not None)

    @property
    def is_stored(self) -> bool:
        """Whether the host has anything to store from one run to the next."""
        return bool(self.errors or self.learned)

    @property
    def has_deadline(self) -> bool:
        """Whether a call may be late while it runs."""
        return any(step.deadline for step in self.steps)

    @property
    def received_statuses(self) -> tuple[ForeignError, ...]:
        """Errors of others, and the mode."""
        mode = self.mode_in
        modes = (ForeignError(mode.named.name, mode.named.comment, mode.wire),) if mode else ()
        return (*self.foreign_errors, *modes)

    @property
    def is_received(self) -> bool:
        """Whether anything is received."""
        return bool(self.ports or self.received_statuses)

    @property
    def is_sent(self) -> bool:
        """Whether anything is sent."""
        return bool(self.outputs or self.statuses)

    @property
    def has_checkpoints(self) -> bool:
        """Whether calls are checkpoints."""
        return any(call.logical for call in self.calls)

    @property
    def has_windows(self) -> bool:
        """Whether the ends of any call are counted (section 10)."""
        return any(call.alive for call in self.steps)

    @property
    def has_globals(self) -> bool:
        """Whether the code keeps its data in global variables."""
        return self.code.signature == GLOBALS

    @property
    def type_name(self) -> str:
        """Name of the context struct, with which all names begin."""
        return f"{self.function}_Adapter"

    @property
    def header_file(self) -> str:
        """Name of its header."""
        return f"{self.function}_adapter.h"

    @property
    def source_file(self) -> str:
        """Name of its source."""
        return f"{self.function}_adapter.{self.code.ending}"

    @property
    def code_setting(self) -> str:
        """The setting of CMake that names the folder of the function's code: `CORE_ACC_CODE`."""
        return f"{screaming_snake_case(self.function)}_CODE"

    def is_moded(self, call: Call) -> bool:
        """Whether a mode excludes a call."""
        return self.mode_in is not None and any(each.name in (call.modes or ()) for each in self.mode_in.modes)

    def is_followed(self, call: Call) -> bool:
        """Whether a call waits for this one."""
        return any(call.name in other.previous for other in self.steps)

    def timed_reactions(self, call: Call) -> tuple[Reaction, ...]:
        """Reactions of a call with a time-out: each call has a clock for each of them."""
        return tuple(each for each in self.reactions if call.name in each.calls and each.time_out is not None)

    def errors_of(self, call: str, *, late: bool) -> tuple[Error, ...]:
        """Errors that are evaluated when a call has ended (late), or before it."""
        return tuple(error for error in self.errors if error.call == call and error.is_late == late)
