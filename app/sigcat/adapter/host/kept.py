"""Values that functions keep from one ignition cycle to the next: counts of errors, and parameters."""

from collections.abc import Iterator, Sequence
from typing import Literal, NamedTuple

from sigcat.adapter.host.connections import Member, shape_of, sides_of, structs_of
from sigcat.adapter.host.host_plan import stored_keys
from sigcat.adapter.host.shapes import Number, Record, Shape

COUNTS = Record((
    ("occurrences", Number("uint16")), ("ignitionCycles", Number("uint16")),
    ("hasFailed", Number("boolean")), ("isTested", Number("boolean")),
))  # fmt: skip
"""Counts of an error."""
Section = Literal["ignitionCycle", "errors", "parameters"]


class Kept(NamedTuple):
    """A part of the values that a function keeps."""

    member: int
    section: Section
    name: str
    """Interface name of the error, or key of the parameter: `Gain`, or `Calibration.Gain` if another storage has one too."""
    field: str
    """Its name in the struct in C."""
    shape: Shape


def kept_of(members: Sequence[Member]) -> tuple[Kept, ...]:
    """All parts of the values that the functions keep, function by function."""
    return tuple(each for index, member in enumerate(members) for each in _kept(index, member))


def _kept(index: int, member: Member) -> Iterator[Kept]:
    plan, sides, structs = member.plan, sides_of(member.function.function), structs_of(member)
    yield Kept(index, "ignitionCycle", "", "ignition_cycle", Number("uint32"))
    for error in plan.errors:
        yield Kept(index, "errors", sides[error.named.pointer].identity, error.named.name, COUNTS)
    keys = stored_keys(member.function.function, plan)
    for parameter in plan.parameters:
        shape = shape_of(parameter.value.wire, structs)
        yield Kept(index, "parameters", keys[parameter.variable], parameter.named.name, shape)
