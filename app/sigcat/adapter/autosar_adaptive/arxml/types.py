"""Implementation datatypes, units, compu methods and data constraints."""

import re
from collections.abc import Iterable, Mapping
from typing import NamedTuple, TypeVar

from sigcat.adapter.arxml import units
from sigcat.adapter.arxml.paths import COMPU_METHODS, CONSTRAINTS, UNITS, Paths
from sigcat.adapter.arxml.tree import (
    Package,
    Tag,
    definition_properties,
    description,
    listed,
    namespaces,
    reference,
    tag,
    trace,
)
from sigcat.adapter.autosar_adaptive.arxml.paths import DATATYPES, TYPE
from sigcat.integration.autosar_adaptive.deployment.namespaces import parts
from sigcat.integration.autosar_adaptive.model import Event, IntegrationModel, StructField, TypeEntry
from sigcat.integration.autosar_adaptive.units import units_of
from sigcat.integration.autosar_names import distinct, short_name
from sigcat.integration.autosar_si_units import UnitSettings
from sigcat.integration.datatypes import BY_ADAPTIVE

K = TypeVar("K")
IDENTICAL = ("1", "0")
"""Factor and offset of a value that is sent as it is."""


class Presentation(NamedTuple):
    """Meaning of the number that is sent: unit, scaling, limits."""

    unit: str | None
    factor: str | None
    offset: str | None
    min: float | None
    max: float | None


class Library(NamedTuple):
    """Names that several elements refer to."""

    paths: Paths
    units: dict[str, str]
    methods: dict[tuple[str | None, str, str], str]
    limits: dict[tuple[float | None, float | None], str]
    types: dict[str, TypeEntry]
    namespace: tuple[str, ...]
    """Namespaces of datatypes, the outermost first."""

    def type_path(self, word: str) -> str:
        """Path of the implementation datatype of a word or a name."""
        row = BY_ADAPTIVE.get(word)
        return self.paths.of(DATATYPES, row.autosar if row else word)

    def properties(self, shown: Presentation) -> Tag | None:
        """SW-DATA-DEF-PROPS of an element that is presented so."""
        method = self.methods.get(_method_key(shown))
        limits = self.limits.get((shown.min, shown.max))
        unit = self.units.get(shown.unit or "")
        return definition_properties(
            reference("COMPU-METHOD-REF", self.paths.of(COMPU_METHODS, method), "COMPU-METHOD") if method else None,
            reference("DATA-CONSTR-REF", self.paths.of(CONSTRAINTS, limits), "DATA-CONSTR") if limits else None,
            reference("UNIT-REF", self.paths.of(UNITS, unit), "UNIT") if unit else None,
        )


def presentation(event: Event) -> Presentation:
    """Meaning of the value of an event."""
    return Presentation(event.unit, event.scaling, event.offset, event.min, event.max)


def library(model: IntegrationModel, paths: Paths) -> Library:
    """Everything that elements of the model refer to, by name."""
    shown = list(dict.fromkeys(_presentations(model)))
    types = {entry.name: entry for entry in model.datatypes or ()}
    names = distinct({unit: short_name(unit) for unit in units_of(model)})
    methods = {
        _method_key(item): _method_name(item, names) for item in shown if item.unit or _coefficients(item) != IDENTICAL
    }
    limits = {
        (item.min, item.max): _limits_name(item) for item in shown if item.min is not None or item.max is not None
    }
    return Library(
        paths, names, _unlike(methods, map(text_table_name, types.values())), _unlike(limits), types, _namespace(model)
    )


def _namespace(model: IntegrationModel) -> tuple[str, ...]:
    assert model.deployment is not None
    chosen = model.deployment.type_namespace or model.deployment.namespace
    return tuple(parts(chosen)) if chosen else ()


def _presentations(model: IntegrationModel) -> Iterable[Presentation]:
    for component in model.components:
        for interface in component.services:
            for services in interface.services:
                yield from map(presentation, services.events)
        for parameter in component.parameters or ():
            kind = parameter.datatype
            yield Presentation(kind.unit or None, None, None, kind.min, kind.max)


def _unlike(names: dict[K, str], taken: Iterable[str] = ()) -> dict[K, str]:
    keys = {repr(key): key for key in names}
    return {keys[text]: name for text, name in distinct({repr(key): names[key] for key in names}, taken).items()}


_COEFFICIENT = re.compile(r"[+-]?(?:[1-9][0-9]+|[0-9])(?:\.[0-9]+)?(?:[eE][+-]?[0-9]{1,3})?")
"""A number as the metamodel writes it."""


def _coefficients(shown: Presentation) -> tuple[str, str]:
    """Factor and offset; a text that is not a number counts as none."""
    factor, offset = shown.factor or "1", shown.offset or "0"
    kept = (factor if _COEFFICIENT.fullmatch(factor) else "1", offset if _COEFFICIENT.fullmatch(offset) else "0")
    return kept if (float(kept[0]), float(kept[1])) != (1.0, 0.0) else IDENTICAL


def _method_key(shown: Presentation) -> tuple[str | None, str, str]:
    return shown.unit, *_coefficients(shown)


def _method_name(shown: Presentation, names: dict[str, str]) -> str:
    unit, coefficients = names.get(shown.unit or "", "NoUnit"), _coefficients(shown)
    return short_name(f"CM_{unit}" if coefficients == IDENTICAL else "_".join(("CM", unit, *coefficients)))


def _limits_name(shown: Presentation) -> str:
    ends = "_to_".join("open" if end is None else str(end).replace("-", "m") for end in (shown.min, shown.max))
    return short_name(f"DC_{ends}")


def packages(known: Library, used: Iterable[str], described: Mapping[str, UnitSettings]) -> list[Package]:
    """The packages of the file of types. `used` are the words and names that elements refer to."""
    words = sorted({*_words(known.types.values()), *used} & set(BY_ADAPTIVE))
    types = [_primitive(word, known) for word in words] + [_type(entry, known) for entry in known.types.values()]
    texts = [_text_table(entry) for entry in known.types.values() if entry.symbols]
    methods = [_compu_method(key, name, known) for key, name in known.methods.items()]
    return [
        Package(DATATYPES, tuple(types)),
        Package(COMPU_METHODS, (*methods, *texts)),
        *units.packages(known.units, described, known.paths),
        Package(CONSTRAINTS, tuple(_limits(ends, name) for ends, name in known.limits.items())),
    ]  # fmt: skip


def _words(entries: Iterable[TypeEntry]) -> Iterable[str]:
    for entry in entries:
        yield from (field.type for field in entry.fields or ())
        yield from (word for word in (entry.type, entry.storage, entry.c_definition) if word)


def _primitive(word: str, known: Library) -> Tag:
    """A primitive. Numbers are those of the standard library, without a namespace of the application."""
    name = BY_ADAPTIVE[word].autosar
    if word != "string":
        return tag(TYPE, tag("CATEGORY", text="VALUE"), name=name)
    return tag(TYPE, tag("CATEGORY", text="STRING"), namespaces(known.namespace), name=name)


def _type(entry: TypeEntry, known: Library) -> Tag:
    admin = trace([("TypeRef", entry.reference or entry.name), ("VssDatatype", entry.vss_datatype)])
    if entry.symbols is not None or entry.kind == "type_reference":
        return _alias(entry, admin, known)
    if entry.kind == "array":
        return _array(entry, admin, known)
    members = listed("SUB-ELEMENTS", (_member(field, known) for field in entry.fields or ()))
    text = description(entry.description)
    inside = namespaces(known.namespace, (field.name for field in entry.fields or ()))
    return tag(TYPE, text, tag("CATEGORY", text="STRUCTURE"), admin, inside, members, name=entry.name)


def _alias(entry: TypeEntry, admin: Tag | None, known: Library) -> Tag:
    """An enumeration, or another name for a primitive."""
    target = known.type_path(entry.storage or entry.c_definition or "uint8_t")
    properties = None
    if entry.symbols:
        path = known.paths.of(COMPU_METHODS, text_table_name(entry))
        properties = definition_properties(reference("COMPU-METHOD-REF", path, "COMPU-METHOD"))
    return tag(
        TYPE,
        tag("CATEGORY", text="TYPE_REFERENCE"),
        admin,
        properties,
        namespaces(known.namespace),
        reference("TYPE-REFERENCE-REF", target, TYPE),
        name=entry.name,
    )


def _array(entry: TypeEntry, admin: Tag | None, known: Library) -> Tag:
    size = None if entry.is_open else entry.dimension
    element = reference("TEMPLATE-TYPE-REF", known.type_path(entry.element), TYPE)
    return tag(
        TYPE,
        tag("CATEGORY", text="VECTOR" if size is None else "ARRAY"),
        admin,
        tag("ARRAY-SIZE", text=size) if size is not None else None,
        namespaces(known.namespace),
        tag("TEMPLATE-ARGUMENTS", tag("CPP-TEMPLATE-ARGUMENT", element)),
        name=entry.name,
    )


def _member(field: StructField, known: Library) -> Tag:
    """A member of a structure. It has a type and no properties: unit and limits are in admin data."""
    target = reference("TYPE-REFERENCE-REF", known.type_path(field.type), TYPE)
    return tag(
        "CPP-IMPLEMENTATION-DATA-TYPE-ELEMENT",
        description(field.description),
        trace([("Unit", field.unit), ("Min", field.min), ("Max", field.max)]),
        tag("TYPE-REFERENCE", target),
        name=field.name,
    )


def text_table_name(entry: TypeEntry) -> str:
    """Name of the compu method of an enumeration."""
    return short_name(f"CM_{entry.name}")


def _text_table(entry: TypeEntry) -> Tag:
    scales = (
        tag(
            "COMPU-SCALE",
            tag("SYMBOL", text=item.symbol),
            tag("LOWER-LIMIT", text=item.value),
            tag("UPPER-LIMIT", text=item.value),
            tag("COMPU-CONST", tag("VT", text=item.symbol)),
        )
        for item in entry.symbols or ()
    )
    content = tag("COMPU-INTERNAL-TO-PHYS", listed("COMPU-SCALES", scales))
    return tag("COMPU-METHOD", tag("CATEGORY", text="TEXTTABLE"), content, name=text_table_name(entry))


def _compu_method(key: tuple[str | None, str, str], name: str, known: Library) -> Tag:
    unit, factor, offset = key
    identical = (factor, offset) == IDENTICAL
    scale = tag(
        "COMPU-SCALE",
        tag(
            "COMPU-RATIONAL-COEFFS",
            tag("COMPU-NUMERATOR", tag("V", text=offset), tag("V", text=factor)),
            tag("COMPU-DENOMINATOR", tag("V", text="1")),
        ),
    )
    return tag(
        "COMPU-METHOD",
        tag("CATEGORY", text="IDENTICAL" if identical else "LINEAR"),
        reference("UNIT-REF", known.paths.of(UNITS, known.units[unit]), "UNIT") if unit else None,
        None if identical else tag("COMPU-INTERNAL-TO-PHYS", tag("COMPU-SCALES", scale)),
        name=name,
    )


def _limits(ends: tuple[float | None, float | None], name: str) -> Tag:
    low, high = ends
    rule = tag(
        "PHYS-CONSTRS",
        Tag("LOWER-LIMIT", (), str(low), None, (("INTERVAL-TYPE", "CLOSED"),)) if low is not None else None,
        Tag("UPPER-LIMIT", (), str(high), None, (("INTERVAL-TYPE", "CLOSED"),)) if high is not None else None,
    )
    return tag("DATA-CONSTR", tag("DATA-CONSTR-RULES", tag("DATA-CONSTR-RULE", rule)), name=name)
