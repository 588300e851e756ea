"""A project of C code, from its folder to its description."""

import re
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, Literal, NamedTuple

from sigcat.findings import Finding
from sigcat.function.c_project.code_values import Value
from sigcat.function.c_project.declarations import CFunction, Place
from sigcat.function.c_project.found_calls import CallKind, Use
from sigcat.function.c_project.roles import Role

Signature = Literal["globals", "pointers", "class"]


class Call(NamedTuple):
    """A function that is called: at the start, in every cycle, or at the end."""

    kind: CallKind
    symbol: str
    place: Place
    arguments: tuple[str, ...] = ()
    """Objects that it takes pointers to."""
    cycle_time: float | int | None = None
    """In ms."""
    returns: bool = False
    """Whether it returns an integer."""
    use: Use = Use(is_known=False)


class CodeObject(NamedTuple):
    """An object that calls take a pointer to, or that another object points to."""

    name: str
    type: str
    place: Place
    member: str = ""
    """Member of the first object that points to it."""
    defined_by: str = "adapter"
    length: int = 0
    """Elements of an array; 0 if it is not an array."""


class Interface(NamedTuple):
    """Variables that calls read and write, and the objects that they are given."""

    inputs: tuple[Value, ...] = ()
    outputs: tuple[Value, ...] = ()
    parameters: tuple[Value, ...] = ()
    objects: tuple[CodeObject, ...] = ()
    arguments: Mapping[str, tuple[str, ...]] = {}
    """Names of objects by the name of the call."""
    findings: tuple[Finding, ...] = ()
    others: tuple[Value, ...] = ()
    """Further values of the objects or the class, of which nothing tells what they are for."""

    @property
    def values(self) -> tuple[Value, ...]:
        """Inputs, outputs and parameters."""
        return (*self.inputs, *self.outputs, *self.parameters)


def with_owners(expression: str) -> Iterator[str]:
    """An expression such as `in.middle[0].flow`, and the structs and arrays that it is in: `in.middle[0]`, `in.middle`, `in`."""
    yield expression
    yield from (expression[: mark.start()] for mark in re.finditer(r"[.\[]", expression))


ROLES: tuple[Role, ...] = ("input", "output", "parameter")
"""Roles of the values of an interface, in their order."""


def interface_of(values: Sequence[tuple[Role, Value]], **others: Any) -> Interface:
    """The interface of values with their roles; `others` are its other fields."""
    inputs, outputs, parameters = (tuple(value for role, value in values if role == each) for each in ROLES)
    return Interface(inputs, outputs, parameters, **others)


class CodeProject(NamedTuple):
    """Interface of the code of one model, with all that is needed to call it."""

    model: str
    signature: Signature
    calls: tuple[Call, ...]
    interface: Interface
    class_name: str = ""
    sources: tuple[str, ...] = ()
    headers: tuple[str, ...] = ()
    include_folders: tuple[str, ...] = ()
    definitions: tuple[str, ...] = ()
    machine: str = ""
    """In words, where the code refuses one of 64 bit with a long of 64 bit."""
    title: Mapping[str, str] = {}
    """Words in the head of the generated header: `model`, `version`, `tool`."""
    findings: tuple[Finding, ...] = ()
    folder: Path = Path()
    expressions: frozenset[str] = frozenset()
    """Variables and members that the code has, whatever they are for: of `u.bus.speed` also `u.bus` and `u`."""
    undivided: frozenset[str] = frozenset()
    """Those whose parts are not among `expressions`: arrays, unions, pointers."""
    others: tuple[Value, ...] = ()
    """Values of other variables and members, whether or not the calls use them."""
    is_broken: bool = False
    """Whether a text of it is not C, so that what was read may be wrong."""
    left_out: tuple[CFunction, ...] = ()
    """Functions that the header of the calls declares, and nothing calls."""

    @property
    def steps(self) -> tuple[Call, ...]:
        """The calls that are made in every cycle."""
        return tuple(call for call in self.calls if call.kind == "step")
