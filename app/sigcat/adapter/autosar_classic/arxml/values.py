"""Values before the first one, as specifications of AUTOSAR."""

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from sigcat.adapter.arxml.paths import UNITS
from sigcat.adapter.arxml.tree import Tag, listed, reference, tag
from sigcat.adapter.autosar_classic.arxml.library import Library
from sigcat.integration.autosar_classic.model import ApplicationType


def init_value(value: Any, type_name: str, known: Library) -> Tag | None:
    """INIT-VALUE of an element of a type; None without a value."""
    return None if value is None else tag("INIT-VALUE", specification(value, type_name, known))


def specification(value: Any, type_name: str, known: Library) -> Tag:
    """A value as its type has it: of an application type what it means, of an implementation type the number."""
    found = known.application_types.get(type_name) or known.implementation_types.get(type_name)
    if found is not None and found.category == "ARRAY":
        inner = found.element or ""
        elements = (specification(each, inner, known) for each in _elements(value, found.length or 1))
        return tag("ARRAY-VALUE-SPECIFICATION", listed("ELEMENTS", elements))
    if found is not None and found.category == "STRUCTURE":
        fields = (
            specification(_member(value, member.name, index), member.type, known)
            for index, member in enumerate(found.members or ())
        )
        return tag("RECORD-VALUE-SPECIFICATION", listed("FIELDS", fields))
    if isinstance(found, ApplicationType):
        return _application(value, found, known)
    return tag("NUMERICAL-VALUE-SPECIFICATION", tag("VALUE", text=_number(value)))


def _elements(value: Any, length: int) -> Iterable[Any]:
    """As many values as the array has: a short list goes on with its last one, one number stands for all."""
    given = list(value) if isinstance(value, Sequence) and not isinstance(value, str) else [value]
    return (*given, *[given[-1] if given else 0] * length)[:length]


def _member(value: Any, name: str, index: int) -> Any:
    if isinstance(value, Mapping):
        return value.get(name, 0)
    if isinstance(value, Sequence) and not isinstance(value, str):
        return value[index] if index < len(value) else 0
    return value


def _application(value: Any, found: ApplicationType, known: Library) -> Tag:
    method = known.compu_methods.get(found.compu_method or "")
    texts = {each.value: each.symbol for each in (method.symbols or ())} if method else {}
    number = _number(value)
    text = texts.get(value)
    content = tag("VT", text=text) if text is not None else tag("V", text=number)
    unit = reference("UNIT-REF", known.paths.of(UNITS, found.unit), "UNIT") if found.unit else None
    return tag(
        "APPLICATION-VALUE-SPECIFICATION",
        tag("CATEGORY", text=found.category),
        tag("SW-VALUE-CONT", unit, tag("SW-VALUES-PHYS", content)),
    )


def _number(value: Any) -> str:
    if isinstance(value, bool):
        return str(int(value))
    return str(value)
