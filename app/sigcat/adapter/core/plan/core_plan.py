"""The whole plan of a core."""

from collections.abc import Mapping
from typing import NamedTuple

from sigcat.adapter.core.plan.call import Call
from sigcat.adapter.core.plan.interface import Method, Output, Parameter, Port
from sigcat.adapter.core.plan.status import Error, ForeignError, ModeIn, ModeOut, Reaction
from sigcat.adapter.core.plan.value import WireStruct
from sigcat.function.document.text import Text
from sigcat.function.function_json.code import CLASS
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
    """How the code of the function is compiled, included and called."""

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
        """Of names of files that call it."""
        return "cpp" if self.is_cpp else "c"


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
    sources: Mapping[str, str] = {}
    """What the plan was made from, by name and digest."""

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
        """What is sent of how the function is: errors, safety reactions and the mode that it is in."""
        return (*self.errors, *self.reactions, *((self.mode_out,) if self.mode_out else ()))

    @property
    def requests(self) -> tuple[Method, ...]:
        """Methods of others that the function uses."""
        return tuple(method for method in self.methods if not method.is_offered)

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

    def errors_of(self, call: str, *, late: bool) -> tuple[Error, ...]:
        """Errors that are evaluated when a call has ended (late), or before it."""
        return tuple(error for error in self.errors if error.call == call and error.is_late == late)
