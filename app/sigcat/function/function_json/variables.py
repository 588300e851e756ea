"""The variables of the C code that a function names: what each holds, and where it is named."""

from collections.abc import Iterator
from fractions import Fraction
from typing import NamedTuple

from pydantic import BaseModel

from sigcat.function.document.document import Pointer
from sigcat.function.document.problem import Subject
from sigcat.function.function_json.conversion import of_text
from sigcat.function.function_json.interfaces.data_interfaces import DataQueue, ParameterInterface, Signal
from sigcat.function.function_json.interfaces.role import PROVIDER
from sigcat.function.function_json.interfaces.status_interfaces import ErrorInterface, ModeInterface, SafetyReaction
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.walk import (
    arguments,
    declared_data,
    methods,
    modes,
    parameters,
    statuses,
    subject_of,
)


class Place(NamedTuple):
    """Place of a variable: its component, call and interface."""

    component: str
    """Name of the component; empty where it is one of the whole function."""
    call: Pointer
    subject: Subject


class CodeVariable(NamedTuple):
    """An expression of the C code."""

    pointer: Pointer
    expression: str
    place: Place
    holds: str
    """Content of the variable: two variables of the same interface differ in it."""
    datatype: str | None = None
    """Reference to the datatype; None where it is a number that the adapter and the function agree on."""
    defined_by: str | None = None
    c_type: str | None = None
    """Type in C, as declared or as agreed on."""
    elements: int | None = None
    """Values of the datatype that it holds; None if it holds one."""
    members: tuple[tuple[str, str], ...] = ()
    """Members of a struct, as the catalogue and the code name them."""
    limits: tuple[Fraction | None, Fraction | None] = (None, None)
    """Declared smallest and largest number of the variable, before scaling; None where there is none."""
    is_replaced: bool = False
    """Whether a value outside the limits is replaced: without an action it passes (adapter.md, section 5)."""


def variables(function: FunctionJson) -> Iterator[CodeVariable]:
    """Every variable that is named, in the order of the document."""
    yield from _of_data(function)
    yield from _of_statuses(function)
    yield from _of_methods(function)
    for pointer, mode in modes(function):
        yield from _own(mode, pointer, Place("", (), subject_of(mode)))


def _of_data(function: FunctionJson) -> Iterator[CodeVariable]:
    for pointer, located, item in (*declared_data(function), *parameters(function)):
        name = item.vss_path or item.name
        place = Place(located.component.name, located.pointer, Subject("data", name))
        if item.variable:
            at = (*pointer, "Variable")
            c_type, count = item.c_type, _count(item)
            members = tuple((each.name, each.member) for each in item.members or ())
            yield CodeVariable(
                *(at, item.variable, place, name, item.datatype, item.defined_by, c_type, count, members),
                limits=_limits(item),
                is_replaced=item.range_error_action in ("Default", "Init"),
            )
        if isinstance(item, DataQueue) and item.count_variable:
            at = (*pointer, "CountVariable")
            yield CodeVariable(at, item.count_variable, place, f"{name} count", None, item.defined_by, "uint32_t")


def _limits(item: Signal | DataQueue | ParameterInterface) -> tuple[Fraction | None, Fraction | None]:
    """Limits of the stored number: those of the physical value without its scaling."""
    factor, offset = of_text(str(item.factor or 1)), of_text(str(item.offset or 0))
    if not factor or offset is None:
        return (None, None)
    stored = [None if each is None else (Fraction(each) - offset) / factor for each in (item.min, item.max)]
    least, most = stored if factor > 0 else reversed(stored)
    return (least, most)


def _count(item: BaseModel) -> int | None:
    """Values of a queue that one call takes or gives, if these are several."""
    if not isinstance(item, DataQueue):
        return None
    if item.role == PROVIDER:
        return item.queue_length if item.count_variable is not None else None
    return item.values_per_step if item.values_per_step and item.values_per_step > 1 else None


def _of_statuses(function: FunctionJson) -> Iterator[CodeVariable]:
    for pointer, located, item in statuses(function):
        place = Place(located.component.name, located.pointer, subject_of(item))
        yield from _own(item, pointer, place)
        if isinstance(item, ErrorInterface) and item.status_variable:
            at, holds = (*pointer, "StatusVariable"), f"{item.name} status"
            yield CodeVariable(at, item.status_variable, place, holds, item.datatype, item.defined_by)


def _own(item: ErrorInterface | SafetyReaction | ModeInterface, at: Pointer, place: Place) -> Iterator[CodeVariable]:
    """The variable of the interface itself."""
    if item.variable:
        pointer, datatype = (*at, "Variable"), item.datatype
        yield CodeVariable(pointer, item.variable, place, item.name, datatype, item.defined_by, item.c_type)


def _of_methods(function: FunctionJson) -> Iterator[CodeVariable]:
    for pointer, located, method in methods(function):
        place = Place(located.component.name, located.pointer, subject_of(method))
        for below, argument in arguments(method):
            if argument.variable:
                at, holds = (*pointer, *below, "Variable"), f"{method.name} {below[0]} {argument.name}"
                yield CodeVariable(at, argument.variable, place, holds, argument.datatype)
        for key, expression in (("Request", method.request_variable), ("Status", method.status_variable)):
            if expression:
                at, holds = (*pointer, f"{key}Variable"), f"{method.name} {key}"
                yield CodeVariable(at, expression, place, holds, c_type="uint8_t")
