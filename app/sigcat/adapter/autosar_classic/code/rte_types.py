"""Datatypes of the RTE, resolved."""

from collections.abc import Mapping

from sigcat.adapter.autosar_classic.code.plan import RteType
from sigcat.integration.autosar_classic.model import ClassicIntegration, ImplementationType


def rte_types(model: ClassicIntegration) -> Mapping[str, RteType]:
    """By their names in C; those that others have in them first, as the document has them."""
    found: dict[str, RteType] = {}
    for each in model.implementation_types:
        found[each.name] = _type(each, found)
    return found


def _type(each: ImplementationType, known: Mapping[str, RteType]) -> RteType:
    if each.element is not None:
        return RteType(each.name, element=known[each.element], length=each.length or 0)
    if each.members:
        return RteType(each.name, members=tuple((member.name, known[member.type]) for member in each.members))
    base = each.base or each.name
    return RteType(each.name, base=known[base].base if base in known else base)


def type_of(name: str, model: ClassicIntegration, types: Mapping[str, RteType]) -> RteType:
    """The datatype of a data element, which names an application type or one of the code."""
    if name in types:
        return types[name]
    return types[next(each.implementation for each in model.application_types if each.name == name)]
