"""The parts of a Function JSON, each with its pointer."""

from collections.abc import Iterator
from typing import Any, NamedTuple

from pydantic import BaseModel

from sigcat.function.document.document import Pointer
from sigcat.function.function_json.interfaces.data_interfaces import DataQueue, ParameterInterface, Signal
from sigcat.function.function_json.interfaces.methods import MethodInterface
from sigcat.function.function_json.interfaces.status_interfaces import ErrorInterface, SafetyReaction
from sigcat.function.function_json.model import Component, FunctionJson
from sigcat.function.function_json.runnable import Contract, Runnable


class Located(NamedTuple):
    """A call, and where it stands."""

    pointer: Pointer
    component: Component
    runnable: Runnable


def runnables(function: FunctionJson) -> Iterator[Located]:
    """Every call."""
    for i, component in enumerate(function.components):
        for j, runnable in enumerate(component.runnables):
            yield Located(("ComponentList", i, "functionList", j), component, runnable)


def calls_of(function: FunctionJson) -> Iterator[Runnable]:
    """Every call, without its place."""
    return (each.runnable for each in runnables(function))


def data_of(contract: Contract) -> tuple[Signal | DataQueue, ...]:
    """Signals and queues of a contract."""
    return (*(contract.signals or ()), *(contract.queues or ()))


def contracts(function: FunctionJson) -> Iterator[tuple[Pointer, Located, Contract]]:
    """Every contract, with the call that it belongs to."""
    for located in runnables(function):
        for index, contract in enumerate(located.runnable.contracts or ()):
            yield (*located.pointer, "funcContractList", index), located, contract


def located_data(contract: Contract, pointer: Pointer) -> Iterator[tuple[Pointer, Signal | DataQueue]]:
    """Signals and queues of a contract, with their pointers."""
    for index, signal in enumerate(contract.signals or ()):
        yield (*pointer, "SignalList", index), signal
    for index, queue in enumerate(contract.queues or ()):
        yield (*pointer, "DataQList", index), queue


def data(function: FunctionJson) -> Iterator[tuple[Pointer, Located, Signal | DataQueue]]:
    """Every signal and every queue."""
    for pointer, located, contract in contracts(function):
        yield from ((at, located, item) for at, item in located_data(contract, pointer))


def absent_of(contract: Contract) -> tuple[Signal | DataQueue, ...]:
    """Optional signals and queues of a contract that the vehicle does not have."""
    return (*(contract.absent_signals or ()), *(contract.absent_queues or ()))


def located_absent(contract: Contract, pointer: Pointer) -> Iterator[tuple[Pointer, Signal | DataQueue]]:
    """The same of optional ones that the vehicle does not have."""
    for index, signal in enumerate(contract.absent_signals or ()):
        yield (*pointer, "AbsentSignalList", index), signal
    for index, queue in enumerate(contract.absent_queues or ()):
        yield (*pointer, "AbsentDataQList", index), queue


def absent(function: FunctionJson) -> Iterator[tuple[Pointer, Located, Signal | DataQueue]]:
    """Every optional signal and queue that the vehicle does not have."""
    for pointer, located, contract in contracts(function):
        yield from ((at, located, item) for at, item in located_absent(contract, pointer))


def declared_data(function: FunctionJson) -> Iterator[tuple[Pointer, Located, Signal | DataQueue]]:
    """Every signal and queue that is declared, also those that the vehicle does not have."""
    yield from data(function)
    yield from absent(function)


def parameters(function: FunctionJson) -> Iterator[tuple[Pointer, Located, ParameterInterface]]:
    """Every parameter."""
    for pointer, located, contract in contracts(function):
        for index, item in enumerate(contract.parameters or ()):
            yield (*pointer, "ParameterList", index), located, item


def methods(function: FunctionJson) -> Iterator[tuple[Pointer, Located, MethodInterface]]:
    """Every method."""
    for pointer, located, contract in contracts(function):
        for index, item in enumerate(contract.methods or ()):
            yield (*pointer, "MethodList", index), located, item


def errors(function: FunctionJson) -> Iterator[tuple[Pointer, Located, ErrorInterface]]:
    """Every error."""
    for pointer, located, contract in contracts(function):
        for index, item in enumerate(contract.errors or ()):
            yield (*pointer, "ErrorList", index), located, item


def safety_reactions(function: FunctionJson) -> Iterator[tuple[Pointer, Located, SafetyReaction]]:
    """Every safety reaction."""
    for pointer, located, contract in contracts(function):
        for index, item in enumerate(contract.safety_reactions or ()):
            yield (*pointer, "SafetyReactionList", index), located, item


def references(function: FunctionJson) -> Iterator[tuple[Pointer, str]]:
    """Every reference to a datatype."""
    for pointer, _, contract in contracts(function):
        for key, items in interface_lists(contract):
            for index, item in enumerate(items or ()):
                at = (*pointer, key, index)
                if key == "MethodList":
                    yield from _arguments(at, item)
                else:
                    yield (*at, "Datatype"), item.datatype
    yield from (((*at, "Datatype"), item.datatype) for at, _, item in absent(function))
    for index, interface in enumerate(function.mode_interfaces or ()):
        yield ("ModeInterfaceList", index, "Datatype"), interface.datatype
    for index, datatype in enumerate(function.datatypes):
        if datatype.element is not None:
            yield ("Datatypes", index, "ElementType"), datatype.element
        for number, field in enumerate(datatype.fields or ()):
            yield ("Datatypes", index, "Fields", number, "Datatype"), field.datatype


def interface_lists(contract: Contract) -> tuple[tuple[str, tuple[Any, ...] | None], ...]:
    """Lists of interfaces of a contract, each with its key."""
    return (
        ("SignalList", contract.signals),
        ("DataQList", contract.queues),
        ("MethodList", contract.methods),
        ("ParameterList", contract.parameters),
        ("ErrorList", contract.errors),
        ("SafetyReactionList", contract.safety_reactions),
    )


def _arguments(at: Pointer, method: Any) -> Iterator[tuple[Pointer, str]]:
    for key, items in (("InDataTypeList", method.inputs), ("OutDataTypeList", method.outputs)):
        for index, item in enumerate(items):
            yield (*at, key, index, "Datatype"), item.datatype


def parts(part: BaseModel, pointer: Pointer = ()) -> Iterator[tuple[Pointer, BaseModel]]:
    """A model and all models in it, by their keys and indexes in the document."""
    yield pointer, part
    for name, info in type(part).model_fields.items():
        value, at = getattr(part, name), (*pointer, info.alias or name)
        if isinstance(value, BaseModel):
            yield from parts(value, at)
        elif isinstance(value, tuple | list):
            for index, item in enumerate(value):
                if isinstance(item, BaseModel):
                    yield from parts(item, (*at, index))
