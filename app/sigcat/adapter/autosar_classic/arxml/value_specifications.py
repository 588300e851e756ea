"""Values before the first one, as specifications of AUTOSAR."""

from collections.abc import Mapping, Sequence
from typing import Any

from sigcat.adapter.arxml.numbers import references_of_number
from sigcat.adapter.arxml.tree import Tag, listed, tag
from sigcat.adapter.autosar_classic.arxml.library import Library
from sigcat.integration.autosar_classic.model import ApplicationType


def init_value(value: Any, type_name: str, known: Library) -> Tag | None:
    """INIT-VALUE of an element of a type; None without a value."""
    return None if value is None else tag("INIT-VALUE", specification(value, type_name, known))


def specification(value: Any, type_name: str, known: Library) -> Tag:
    """A value as its type has it: of an application type what it means, of an implementation type the number.

    One number applies to every element of an array and every member of a structure.
    """
    found = known.application_types.get(type_name) or known.implementation_types.get(type_name)
    if found is not None and found.category == "ARRAY":
        inner = found.element or ""
        values = value if isinstance(value, Sequence) else [value] * (found.length or 1)
        elements = (specification(each, inner, known) for each in values)
        return tag("ARRAY-VALUE-SPECIFICATION", listed("ELEMENTS", elements))
    if found is not None and found.category == "STRUCTURE":
        fields = (
            specification(value[member.name] if isinstance(value, Mapping) else value, member.type, known)
            for member in found.members or ()
        )
        return tag("RECORD-VALUE-SPECIFICATION", listed("FIELDS", fields))
    if isinstance(found, ApplicationType):
        return _application(value, found, known)
    return tag("NUMERICAL-VALUE-SPECIFICATION", {"VALUE": _number(value)})


def _application(value: Any, found: ApplicationType, known: Library) -> Tag:
    method = known.compu_methods.get(found.compu_method or "")
    texts = {each.value: each.symbol for each in (method.symbols or ())} if method else {}
    text = texts.get(value)
    content = {"V": _number(value)} if text is None else {"VT": text}
    unit = references_of_number(known.paths, unit=found.unit)
    physical = tag("SW-VALUE-CONT", *unit, tag("SW-VALUES-PHYS", content))
    return tag("APPLICATION-VALUE-SPECIFICATION", {"CATEGORY": found.category}, physical)


def _number(value: Any) -> str:
    return str(int(value)) if isinstance(value, bool) else str(value)
