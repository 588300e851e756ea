"""Initial values that their datatype cannot hold: an initializer in C that does not compile, or that another value results from."""

from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple, Union

from sigcat.function.document.document import Pointer
from sigcat.function.document.text import Text
from sigcat.integration.autosar_classic.datatypes.platform_types import FLOATS, WHOLE_NUMBERS
from sigcat.integration.autosar_classic.datatypes.used_types import element_types
from sigcat.integration.autosar_classic.model import ClassicIntegration, ImplementationType
from sigcat.integration.problem import Problem
from sigcat.integration.references import places


class _Shape(NamedTuple):
    """Form of a datatype."""

    base: str = ""
    """Platform type of a number."""
    element: Union["_Shape", None] = None
    length: int = 0
    members: Mapping[str, "_Shape"] = {}


def value_problems(model: ClassicIntegration) -> Iterator[Problem]:
    """Values of ports of components and of the composition, and of parameters."""
    shapes = _shapes(model)
    elements = _elements(model, shapes)
    for at, parameter in places(model, "Components/*/InternalParameters/*"):
        yield from _value(parameter.init, shapes.get(parameter.type), (*at, "InitValue"))
    for path in ("Components/*/Ports/*", "ParameterComponents/*/Ports/*"):
        for at, port in places(model, path):
            for number, element in enumerate(port.elements):
                shape = elements.get((port.interface, element.name))
                yield from _value(element.init, shape, (*at, "Elements", number, "InitValue"))
    for at, port in places(model, "Composition/Ports/*"):
        of_interface = [shape for (interface, _), shape in elements.items() if interface == port.interface]
        yield from _value(port.init, next(iter(of_interface), None), (*at, "InitValue"))


def _shapes(model: ClassicIntegration) -> dict[str, _Shape]:
    """Shapes of all datatypes by name. What refers to something that does not stand before it has none."""
    found: dict[str, _Shape] = {}
    for each in model.implementation_types:
        if (shape := _shape(each, found)) is not None:
            found[each.name] = shape
    meant = {each.name: found[each.implementation] for each in model.application_types if each.implementation in found}
    return {**found, **meant}


def _shape(each: ImplementationType, known: Mapping[str, _Shape]) -> _Shape | None:
    if each.category == "ARRAY":
        element = known.get(each.element or "")
        return _Shape(element=element, length=each.length or 0) if element else None
    if each.category == "STRUCTURE":
        members = {member.name: known[member.type] for member in each.members or () if member.type in known}
        return _Shape(members=members) if members else None
    return known.get(each.base or "") or _Shape(base=each.base or "")


def _elements(model: ClassicIntegration, shapes: Mapping[str, _Shape]) -> dict[tuple[str, str], _Shape]:
    """Shapes of data elements and parameters, by interface and name."""
    return {key: shapes[name] for key, name in element_types(model).items() if name in shapes}


def _value(value: Any, shape: _Shape | None, at: Pointer) -> Iterator[Problem]:
    """One number may apply to every element and every member."""
    if value is None or shape is None:
        return
    if shape.element is not None and isinstance(value, list):
        yield from _listed(value, shape, shape.element, at)
    elif shape.members and isinstance(value, dict):
        yield from _struct(value, shape, at)
    elif shape.element is not None:
        yield from _value(value, shape.element, at)
    elif shape.members:
        for member in shape.members.values():
            yield from _value(value, member, at)
    else:
        yield from _number(value, shape.base, at)


def _listed(value: list[Any], shape: _Shape, element: _Shape, at: Pointer) -> Iterator[Problem]:
    if len(value) != shape.length:
        message = f"The initial value must have {shape.length} elements, as its datatype has, not {len(value)}."
        yield Problem(at, message, "Give one for each.")
        return
    for index, each in enumerate(value):
        yield from _inner(each, element, (*at, index))


def _struct(value: dict[str, Any], shape: _Shape, at: Pointer) -> Iterator[Problem]:
    for name in value.keys() ^ shape.members.keys():
        what = "is not one" if name in value else "is missing"
        message = (
            f"The initial value must have the members of its datatype, {', '.join(shape.members)}: {name[:60]} {what}."
        )
        yield Problem(at, message, "Give one value for each.")
    for name, member in shape.members.items():
        if name in value:
            yield from _inner(value[name], member, (*at, name))


def _inner(value: Any, shape: _Shape, at: Pointer) -> Iterator[Problem]:
    """An element or a member: a whole value may be absent, but no part of it."""
    if value is None:
        yield Problem(at, "The initial value must have each element and member, not null.", "Give a value.")
    yield from _value(value, shape, at)


def _number(value: Any, base: str, at: Pointer) -> Iterator[Problem]:
    if base not in WHOLE_NUMBERS and base not in FLOATS:
        return  # `type_problems` reports it
    if isinstance(value, Text | list | dict) or (isinstance(value, bool) and base != "boolean"):
        yield Problem(at, f"The initial value must be a number for {base}, not {_shown(value)}.", "Correct it.")
        return
    low, high = WHOLE_NUMBERS.get(base) or (-FLOATS[base], FLOATS[base])
    if not low <= value <= high:
        yield Problem(at, f"The initial value must be from {low} to {high} for {base}, not {value}.", "Correct it.")
    elif base in WHOLE_NUMBERS and int(value) != value:
        yield Problem(at, f"The initial value must be a whole number for {base}, not {value}.", "Correct it.")


def _shown(value: Any) -> str:
    if isinstance(value, list | dict):
        return "a list" if isinstance(value, list) else "an object"
    return repr(value.raw if isinstance(value, Text) else value)[:60]
