"""The variables of the C code that a function names: what each holds, and where it is named."""

from collections.abc import Iterator
from fractions import Fraction
from typing import NamedTuple

from pydantic import BaseModel

from sigcat.function.document.document import Pointer
from sigcat.function.document.problem import Subject
from sigcat.function.function_json.conversion import of_text
from sigcat.function.function_json.interfaces.data_interfaces import DataQueue, ParameterInterface, Signal
from sigcat.function.function_json.interfaces.methods import MethodInterface
from sigcat.function.function_json.interfaces.role import PROVIDER
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.walk import declared_data, errors, methods, parameters, safety_reactions


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
    yield from _of_modes(function)


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
    for pointer, located, error in errors(function):
        place = Place(located.component.name, located.pointer, Subject("error", error.name))
        if error.variable:
            at, datatype = (*pointer, "Variable"), error.datatype
            yield CodeVariable(at, error.variable, place, error.name, datatype, error.defined_by, error.c_type)
        if error.status_variable:
            at, holds = (*pointer, "StatusVariable"), f"{error.name} status"
            yield CodeVariable(at, error.status_variable, place, holds, error.datatype, error.defined_by)
    for pointer, located, reaction in safety_reactions(function):
        if reaction.variable:
            place = Place(located.component.name, located.pointer, Subject("safety_reaction", reaction.name))
            at = (*pointer, "Variable")
            datatype, defined_by, c_type = reaction.datatype, reaction.defined_by, reaction.c_type
            yield CodeVariable(at, reaction.variable, place, reaction.name, datatype, defined_by, c_type)


def _of_methods(function: FunctionJson) -> Iterator[CodeVariable]:
    for pointer, located, method in methods(function):
        place = Place(located.component.name, located.pointer, Subject("method", method.name))
        yield from _of_arguments(pointer, place, method)
        for key, expression in (("Request", method.request_variable), ("Status", method.status_variable)):
            if expression:
                yield CodeVariable(
                    (*pointer, f"{key}Variable"), expression, place, f"{method.name} {key}", c_type="uint8_t"
                )


def _of_arguments(pointer: Pointer, place: Place, method: MethodInterface) -> Iterator[CodeVariable]:
    for key, arguments in (("InDataTypeList", method.inputs), ("OutDataTypeList", method.outputs)):
        for index, argument in enumerate(arguments):
            if argument.variable:
                at, holds = (*pointer, key, index, "Variable"), f"{method.name} {key} {argument.name}"
                yield CodeVariable(at, argument.variable, place, holds, argument.datatype)


def _of_modes(function: FunctionJson) -> Iterator[CodeVariable]:
    for index, mode in enumerate(function.mode_interfaces or ()):
        if mode.variable:
            place = Place("", (), Subject("mode", mode.name))
            at = ("ModeInterfaceList", index, "Variable")
            yield CodeVariable(at, mode.variable, place, mode.name, mode.datatype, mode.defined_by, mode.c_type)
