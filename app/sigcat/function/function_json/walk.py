"""The parts of a Function JSON, each with its pointer."""

from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

from pydantic import BaseModel

from sigcat.function.document.document import Pointer
from sigcat.function.document.problem import Kind, Subject
from sigcat.function.function_json.interfaces.data_interfaces import DataQueue, ParameterInterface, Signal
from sigcat.function.function_json.interfaces.methods import Argument, MethodInterface
from sigcat.function.function_json.interfaces.status_interfaces import ErrorInterface, ModeInterface, SafetyReaction
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


_LISTS = {
    "SignalList": "signals",
    "DataQList": "queues",
    "MethodList": "methods",
    "ParameterList": "parameters",
    "ErrorList": "errors",
    "SafetyReactionList": "safety_reactions",
    "AbsentSignalList": "absent_signals",
    "AbsentDataQList": "absent_queues",
}
"""Fields of the lists of a contract, by their keys."""
_DATA, _ABSENT = ("SignalList", "DataQList"), ("AbsentSignalList", "AbsentDataQList")
_PRESENT = tuple(key for key in _LISTS if key not in _ABSENT)
_KINDS: Mapping[type, Kind] = {
    Signal: "data",
    DataQueue: "data",
    ParameterInterface: "data",
    MethodInterface: "method",
    ErrorInterface: "error",
    SafetyReaction: "safety_reaction",
    ModeInterface: "mode",
}
Interface = Signal | DataQueue | ParameterInterface | MethodInterface | ErrorInterface | SafetyReaction | ModeInterface


def subject_of(item: Interface) -> Subject:
    """An interface under its name, as the subject of a problem."""
    return Subject(_KINDS[type(item)], item.name)


def contracts(function: FunctionJson) -> Iterator[tuple[Pointer, Located, Contract]]:
    """Every contract, with the call that it belongs to."""
    for located in runnables(function):
        for index, contract in enumerate(located.runnable.contracts or ()):
            yield (*located.pointer, "funcContractList", index), located, contract


def interface_lists(contract: Contract) -> tuple[tuple[str, tuple[Any, ...] | None], ...]:
    """Lists of interfaces of a contract, each with its key."""
    return tuple((key, getattr(contract, _LISTS[key])) for key in _PRESENT)


def _items(contract: Contract, pointer: Pointer, keys: tuple[str, ...]) -> list[tuple[Pointer, Any]]:
    """Interfaces in lists of a contract, with their pointers."""
    lists = [(key, getattr(contract, _LISTS[key]) or ()) for key in keys]
    return [((*pointer, key, index), item) for key, items in lists for index, item in enumerate(items)]


def _all(function: FunctionJson, *keys: str) -> Iterator[tuple[Pointer, Located, Any]]:
    """Interfaces in lists of every contract."""
    for pointer, located, contract in contracts(function):
        for at, item in _items(contract, pointer, keys):
            yield at, located, item


def data_of(contract: Contract) -> tuple[Signal | DataQueue, ...]:
    """Signals and queues of a contract."""
    return (*(contract.signals or ()), *(contract.queues or ()))


def located_data(contract: Contract, pointer: Pointer) -> list[tuple[Pointer, Signal | DataQueue]]:
    """Signals and queues of a contract, with their pointers."""
    return _items(contract, pointer, _DATA)


def data(function: FunctionJson) -> Iterator[tuple[Pointer, Located, Signal | DataQueue]]:
    """Every signal and every queue."""
    return _all(function, *_DATA)


def absent_of(contract: Contract) -> tuple[Signal | DataQueue, ...]:
    """Optional signals and queues of a contract that the vehicle does not have."""
    return (*(contract.absent_signals or ()), *(contract.absent_queues or ()))


def located_absent(contract: Contract, pointer: Pointer) -> list[tuple[Pointer, Signal | DataQueue]]:
    """The same of optional ones that the vehicle does not have."""
    return _items(contract, pointer, _ABSENT)


def absent(function: FunctionJson) -> Iterator[tuple[Pointer, Located, Signal | DataQueue]]:
    """Every optional signal and queue that the vehicle does not have."""
    return _all(function, *_ABSENT)


def declared_data(function: FunctionJson) -> Iterator[tuple[Pointer, Located, Signal | DataQueue]]:
    """Every signal and queue that is declared, also those that the vehicle does not have."""
    yield from data(function)
    yield from absent(function)


def parameters(function: FunctionJson) -> Iterator[tuple[Pointer, Located, ParameterInterface]]:
    """Every parameter."""
    return _all(function, "ParameterList")


def methods(function: FunctionJson) -> Iterator[tuple[Pointer, Located, MethodInterface]]:
    """Every method."""
    return _all(function, "MethodList")


def errors(function: FunctionJson) -> Iterator[tuple[Pointer, Located, ErrorInterface]]:
    """Every error."""
    return _all(function, "ErrorList")


def modes(function: FunctionJson) -> Iterator[tuple[Pointer, ModeInterface]]:
    """Every mode interface."""
    for index, item in enumerate(function.mode_interfaces or ()):
        yield ("ModeInterfaceList", index), item


def safety_reactions(function: FunctionJson) -> Iterator[tuple[Pointer, Located, SafetyReaction]]:
    """Every safety reaction."""
    return _all(function, "SafetyReactionList")


def statuses(function: FunctionJson) -> Iterator[tuple[Pointer, Located, ErrorInterface | SafetyReaction]]:
    """Every error, then every safety reaction."""
    yield from errors(function)
    yield from safety_reactions(function)


def timed(function: FunctionJson) -> Iterator[tuple[Pointer, Signal | DataQueue | SafetyReaction | MethodInterface]]:
    """Every interface that has a time-out."""
    yield from ((pointer, item) for pointer, _, item in data(function))
    yield from ((pointer, item) for pointer, _, item in _all(function, "SafetyReactionList", "MethodList"))


def arguments(method: MethodInterface) -> Iterator[tuple[Pointer, Argument]]:
    """Arguments and return values of a method, with their pointers in it."""
    for key, items in (("InDataTypeList", method.inputs), ("OutDataTypeList", method.outputs)):
        yield from (((key, index), item) for index, item in enumerate(items))


def references(function: FunctionJson) -> Iterator[tuple[Pointer, str]]:
    """Every reference to a datatype."""
    for at, _, item in (*_all(function, *_PRESENT), *absent(function)):
        inner = arguments(item) if isinstance(item, MethodInterface) else (((), item),)
        yield from (((*at, *below, "Datatype"), each.datatype) for below, each in inner)
    yield from (((*at, "Datatype"), interface.datatype) for at, interface in modes(function))
    for index, datatype in enumerate(function.datatypes):
        if datatype.element is not None:
            yield ("Datatypes", index, "ElementType"), datatype.element
        for number, field in enumerate(datatype.fields or ()):
            yield ("Datatypes", index, "Fields", number, "Datatype"), field.datatype


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
