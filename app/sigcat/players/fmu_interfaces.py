"""Interfaces of functions as variables of the FMU that sigcat makes of them. A struct has a variable for each member."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import chain
from typing import NamedTuple

from sigcat.adapter.fmi.variables import Variable, layout_of
from sigcat.adapter.host.connections import Connections
from sigcat.adapter.host.shapes import Shape, Value, built, numbers


class Interface(NamedTuple):
    """A value that a function receives or sends, and its variables in order."""

    shape: Shape
    variables: tuple[Variable, ...]


class Interfaces(NamedTuple):
    """Interfaces of a set by name."""

    inputs: Mapping[str, Interface]
    """By every name that a trace may have."""
    outputs: Mapping[str, Interface]

    def as_variables(self, values: Iterable[tuple[str, Value]]) -> dict[str, Value]:
        """Values of variables by name, from those of inputs. Other values are skipped."""
        known = ((self.inputs[name], value) for name, value in values if name in self.inputs)
        return dict(chain.from_iterable(_split(interface, value) for interface, value in known))

    def of_variables(self, values: Mapping[str, Value], changed: Iterable[str]) -> Iterator[tuple[str, Value, Shape]]:
        """The outputs that have a changed variable."""
        names = set(changed)
        for name, each in self.outputs.items():
            if not names.isdisjoint(variable.name for variable in each.variables):
                yield name, built(chain.from_iterable(_numbers(each, values)), each.shape), each.shape


def interfaces_of(connections: Connections) -> Interfaces:
    """The interfaces of connected functions."""
    variables = layout_of(connections).variables
    received = {name: entry.names[-1] for entry in connections.entries for name in entry.names}
    first = {entry.names[-1]: index for index, entry in reversed([*enumerate(connections.entries)])}
    inputs = {name: _owned(variables, "input", first[received[name]]) for name in connections.received}
    return Interfaces(
        {name: Interface(connections.received[name], each) for name, each in inputs.items()},
        {
            each.name: Interface(each.shape, _owned(variables, "output", index))
            for index, each in enumerate(connections.exits)
        },
    )


def _owned(variables: Sequence[Variable], causality: str, owner: int) -> tuple[Variable, ...]:
    return tuple(each for each in variables if (each.causality, each.owner) == (causality, owner))


def _split(interface: Interface, value: Value) -> Iterator[tuple[str, Value]]:
    rest = numbers(value, interface.shape)
    for each in interface.variables:
        yield each.name, next(rest) if each.length is None else [next(rest) for _ in range(each.length)]


def _numbers(interface: Interface, values: Mapping[str, Value]) -> Iterator[Sequence[Value]]:
    for each in interface.variables:
        value = values[each.name]
        yield [value] if each.length is None else value
