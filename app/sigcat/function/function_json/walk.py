"""The parts of a Function JSON, each with its pointer."""

from collections.abc import Iterator
from typing import Any, NamedTuple

from sigcat.function.document.document import Pointer
from sigcat.function.function_json.model import (
    Component,
    Contract,
    DataQueue,
    Error,
    FunctionJson,
    Method,
    Parameter,
    Runnable,
    Signal,
)


class Placed(NamedTuple):
    """A call and its place."""

    pointer: Pointer
    component: Component
    runnable: Runnable


def runnables(function: FunctionJson) -> Iterator[Placed]:
    """Every call."""
    for i, component in enumerate(function.components):
        for j, runnable in enumerate(component.runnables):
            yield Placed(("ComponentList", i, "functionList", j), component, runnable)


def contracts(function: FunctionJson) -> Iterator[tuple[Pointer, Placed, Contract]]:
    """Every contract, with the call that it belongs to."""
    for placed in runnables(function):
        for index, contract in enumerate(placed.runnable.contracts or ()):
            yield (*placed.pointer, "funcContractList", index), placed, contract


def data(function: FunctionJson) -> Iterator[tuple[Pointer, Placed, Signal | DataQueue]]:
    """Every signal and every queue."""
    for pointer, placed, contract in contracts(function):
        for index, signal in enumerate(contract.signals or ()):
            yield (*pointer, "SignalList", index), placed, signal
        for index, queue in enumerate(contract.queues or ()):
            yield (*pointer, "DataQList", index), placed, queue


def parameters(function: FunctionJson) -> Iterator[tuple[Pointer, Placed, Parameter]]:
    """Every parameter."""
    for pointer, placed, contract in contracts(function):
        for index, item in enumerate(contract.parameters or ()):
            yield (*pointer, "ParameterList", index), placed, item


def methods(function: FunctionJson) -> Iterator[tuple[Pointer, Placed, Method]]:
    """Every method."""
    for pointer, placed, contract in contracts(function):
        for index, item in enumerate(contract.methods or ()):
            yield (*pointer, "MethodList", index), placed, item


def errors(function: FunctionJson) -> Iterator[tuple[Pointer, Placed, Error]]:
    """Every error."""
    for pointer, placed, contract in contracts(function):
        for index, item in enumerate(contract.errors or ()):
            yield (*pointer, "ErrorList", index), placed, item


def references(function: FunctionJson) -> Iterator[tuple[Pointer, str]]:
    """Every reference to a datatype."""
    for pointer, _, contract in contracts(function):
        for key, items in _lists(contract):
            for index, item in enumerate(items or ()):
                place = (*pointer, key, index)
                if key == "MethodList":
                    yield from _arguments(place, item)
                else:
                    yield (*place, "Datatype"), item.datatype
    for index, interface in enumerate(function.mode_interfaces or ()):
        yield ("ModeInterfaceList", index, "Datatype"), interface.datatype
    for index, datatype in enumerate(function.datatypes):
        if datatype.element is not None:
            yield ("Datatypes", index, "ElementType"), datatype.element
        for number, field in enumerate(datatype.fields or ()):
            yield ("Datatypes", index, "Fields", number, "Datatype"), field.datatype


def _lists(contract: Contract) -> tuple[tuple[str, tuple[Any, ...] | None], ...]:
    return (
        ("SignalList", contract.signals),
        ("DataQList", contract.queues),
        ("MethodList", contract.methods),
        ("ParameterList", contract.parameters),
        ("ErrorList", contract.errors),
        ("SafetyReactionList", contract.safety_reactions),
    )


def _arguments(place: Pointer, method: Any) -> Iterator[tuple[Pointer, str]]:
    for key, items in (("InDataTypeList", method.inputs), ("OutDataTypeList", method.outputs)):
        for index, item in enumerate(items):
            yield (*place, key, index, "Datatype"), item.datatype
