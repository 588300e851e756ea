"""Constants that the contract phase gives a component: numbers as C, names of enumerations, limits, initial values."""

import math
from collections.abc import Iterable, Iterator, Mapping
from typing import NamedTuple

from sigcat.adapter.autosar_classic.code.plan import RteType, SwcPlan
from sigcat.adapter.autosar_classic.code.rte_types import rte_types
from sigcat.integration.autosar_classic.datatypes.used_types import (
    element_types,
    enumerations_of,
    exchanged_types,
    with_inner,
)
from sigcat.integration.autosar_classic.model import ApplicationType, ClassicIntegration, DataConstraint

_SMALLEST = {-(2**31): "(-2147483647 - 1)", -(2**63): "(-9223372036854775807LL - 1LL)"}


def number(value: float, base: str) -> str:
    """A number as a constant of a platform type: C99 has none for the smallest ones, and no suffix for small ones."""
    if base == "boolean":
        return "TRUE" if value else "FALSE"
    if base.startswith("float"):
        return f"{float(value)!r}{'F' if base == 'float32' else ''}"
    suffix = f"{'U' if base.startswith('u') else ''}{'LL' if base.endswith('64') else ''}"
    return _SMALLEST.get(int(value)) or f"{int(value)}{suffix}"


class Constant(NamedTuple):
    """A constant, its literal in brackets."""

    name: str
    literal: str


def _constant(name: str, text: str) -> Constant:
    return Constant(name, text if text.startswith("(") else f"({text})")


def enumerations(swc: SwcPlan, model: ClassicIntegration) -> Iterator[tuple[str, list[Constant]]]:
    """Names of values by their types, of everything that goes through a port: elements, arguments, parameters."""
    types = {each.name: each for each in model.implementation_types}
    meant = {each.name: each for each in model.application_types}
    methods = {each.name: each for each in model.compu_methods}
    for each in enumerations_of(swc.component, exchanged_types(model), meant, types):
        method = methods.get(each.compu_method or "")
        symbols = {f"{each.literal_prefix or ''}{one.symbol}": one.value for one in (method and method.symbols) or ()}
        if symbols:
            literals = [_constant(name, f"{value}{'U' if value >= 0 else ''}") for name, value in symbols.items()]
            yield each.name, literals


def limits(swc: SwcPlan, model: ClassicIntegration) -> Iterator[list[Constant]]:
    """`<type>_LowerLimit` and `<type>_UpperLimit` of the types that have a range."""
    types = rte_types(model)
    constraints = {each.name: each for each in model.constraints}
    scaled = {each.name for each in model.compu_methods if each.category == "LINEAR"}
    for each in _meant(swc, model):
        constraint, type_ = constraints.get(each.constraint or ""), types[each.implementation]
        if constraint is not None and type_.is_number and each.compu_method not in scaled:
            yield [_constant(f"{each.name}_{side}Limit", text) for side, text in _sides(constraint, type_)]


def _sides(constraint: DataConstraint, type_: RteType) -> Iterator[tuple[str, str]]:
    """The outermost whole numbers in the range."""
    is_float = type_.base.startswith("float")
    if constraint.min is not None:
        yield "Lower", number(constraint.min if is_float else math.ceil(constraint.min), type_.base)
    if constraint.max is not None:
        yield "Upper", number(constraint.max if is_float else math.floor(constraint.max), type_.base)


def _meant(swc: SwcPlan, model: ClassicIntegration) -> Iterable[ApplicationType]:
    """Application types of the values at the component's ports, and the types within them, by name."""
    known = {each.name: each for each in model.application_types}
    exchanged = exchanged_types(model)
    names = [name for port in swc.component.ports for name in exchanged.get(port.interface, ())]
    return with_inner([*names, *(parameter.type for parameter in swc.component.parameters)], known)


def initial_values(swc: SwcPlan, model: ClassicIntegration, types: Mapping[str, RteType]) -> Iterator[Constant]:
    """`Rte_InitValue_<port>_<element>` of each number that a port has before anything was sent."""
    meant = {each.name: each.implementation for each in model.application_types}
    elements = element_types(model)
    for port in swc.component.ports:
        for element in port.elements if port.kind == "SenderReceiver" else ():
            name = elements[port.interface, element.name]
            type_ = types[meant.get(name, name)]
            if type_.is_number and isinstance(element.init, int | float):
                yield Constant(f"{port.name}_{element.name}", f"({number(element.init, type_.base)})")
