"""Implementation datatypes, units, compu methods and data constraints."""

import re
from collections.abc import Iterable, Mapping
from typing import NamedTuple, TypeVar

from sigcat.adapter.arxml import numbers, units
from sigcat.adapter.arxml.paths import COMPU_METHODS, CONSTRAINTS, Paths
from sigcat.adapter.arxml.tree import (
    Child,
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
from sigcat.adapter.autosar_adaptive.arxml.releases import Release
from sigcat.integration.autosar_adaptive.deployment.namespaces import parts
from sigcat.integration.autosar_adaptive.model import Event, IntegrationModel, ParameterEntry, StructField, TypeEntry
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
    factor: str | None = None
    offset: str | None = None
    min: float | None = None
    max: float | None = None


class Library(NamedTuple):
    """Names that several elements refer to."""

    paths: Paths
    release: Release
    units: dict[str, str]
    methods: dict[tuple[str | None, str, str], str]
    limits: dict[tuple[float | None, float | None], str]
    types: dict[str, TypeEntry]
    namespace: tuple[str, ...]
    """Namespaces of datatypes, the outermost first."""

    def path(self, package: str, *names: str) -> str:
        """Path of an element in a package, or of one inside it."""
        return self.paths.of(package, *names)

    def type_path(self, word: str) -> str:
        """Path of the implementation datatype of a word or a name."""
        row = BY_ADAPTIVE.get(word)
        return self.path(DATATYPES, row.autosar if row else word)

    def typed(self, word: str) -> Tag:
        """TYPE-TREF to the implementation datatype of a word or a name."""
        return reference("TYPE-TREF", self.type_path(word), TYPE)

    def properties(self, shown: Presentation) -> Tag | None:
        """SW-DATA-DEF-PROPS of an element that is presented so."""
        method = self.methods.get(_method_key(shown))
        limits = self.limits.get((shown.min, shown.max))
        unit = self.units.get(shown.unit or "")
        return definition_properties(*numbers.references_of_number(self.paths, method, limits, unit))


def presentation(event: Event) -> Presentation:
    """Meaning of the value of an event."""
    return Presentation(event.unit, event.scaling, event.offset, event.min, event.max)


def parameter_presentation(parameter: ParameterEntry) -> Presentation:
    """Meaning of the value of a parameter."""
    kind = parameter.datatype
    return Presentation(kind.unit or None, min=kind.min, max=kind.max)


def library(model: IntegrationModel, release: Release) -> Library:
    """Everything that elements of the model refer to, by name."""
    assert model.deployment is not None
    shown = list(dict.fromkeys(_presentations(model)))
    types = {entry.name: entry for entry in model.datatypes or ()}
    names = distinct({unit: short_name(unit) for unit in units_of(model)})
    methods = {
        _method_key(item): _method_name(item, names) for item in shown if item.unit or _coefficients(item) != IDENTICAL
    }
    limits = {
        (item.min, item.max): _limits_name(item) for item in shown if item.min is not None or item.max is not None
    }
    methods, limits = _unlike(methods, map(_text_table_name, types.values())), _unlike(limits)
    namespace = model.deployment.type_namespace or model.deployment.namespace
    inside = tuple(parts(namespace)) if namespace else ()
    return Library(Paths(model.deployment.package), release, names, methods, limits, types, inside)


def _presentations(model: IntegrationModel) -> Iterable[Presentation]:
    for component in model.components:
        for interface in component.services:
            for services in interface.services:
                yield from map(presentation, services.events)
        for parameter in component.parameters or ():
            yield parameter_presentation(parameter)


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
    constraints = tuple(numbers.constraint(name, *ends) for ends, name in known.limits.items())
    described_units = units.packages(known.units, described, known.paths)
    content = [Package(DATATYPES, tuple(types)), Package(COMPU_METHODS, (*methods, *texts)), *described_units]
    return [*content, Package(CONSTRAINTS, constraints)]


def _words(entries: Iterable[TypeEntry]) -> Iterable[str]:
    for entry in entries:
        yield from (field.type for field in entry.fields or ())
        yield from (word for word in (entry.type, entry.storage, entry.c_definition) if word)


def _primitive(word: str, known: Library) -> Tag:
    """A primitive. Numbers are those of the standard library, without a namespace of the application."""
    is_text = word == "string"
    inside = namespaces(known.namespace) if is_text else None
    return tag(TYPE, {"CATEGORY": "STRING" if is_text else "VALUE"}, inside, name=BY_ADAPTIVE[word].autosar)


def _type(entry: TypeEntry, known: Library) -> Tag:
    admin = trace([("TypeRef", entry.reference or entry.name), ("VssDatatype", entry.vss_datatype)])
    members = entry.fields or ()
    content: list[Child]
    if entry.symbols is not None or entry.kind == "type_reference":
        category, target = "TYPE_REFERENCE", known.type_path(entry.storage or entry.c_definition or "uint8_t")
        table = _text_table_name(entry) if entry.symbols else None
        properties = definition_properties(*numbers.references_of_number(known.paths, table))
        content = [properties, reference("TYPE-REFERENCE-REF", target, TYPE)]
    elif entry.kind == "array":
        is_open = entry.is_open or entry.dimension is None
        element = reference("TEMPLATE-TYPE-REF", known.type_path(entry.element), TYPE)
        arguments = tag("TEMPLATE-ARGUMENTS", tag("CPP-TEMPLATE-ARGUMENT", element))
        category = "VECTOR" if is_open else "ARRAY"
        content = [{"ARRAY-SIZE": None if is_open else entry.dimension}, arguments]
    else:
        category = "STRUCTURE"
        content = [description(entry.description), listed("SUB-ELEMENTS", (_member(each, known) for each in members))]
    inside = namespaces(known.namespace, (field.name for field in members) if category == "STRUCTURE" else ())
    return tag(TYPE, {"CATEGORY": category}, admin, inside, *content, name=entry.name)


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


def _text_table_name(entry: TypeEntry) -> str:
    return short_name(f"CM_{entry.name}")


def _text_table(entry: TypeEntry) -> Tag:
    values = ((each.symbol, {"LOWER-LIMIT": each.value, "UPPER-LIMIT": each.value}) for each in entry.symbols or ())
    scales = (numbers.text_scale(symbol, limits) for symbol, limits in values)
    return numbers.compu_method(_text_table_name(entry), "TEXTTABLE", scales)


def _compu_method(key: tuple[str | None, str, str], name: str, known: Library) -> Tag:
    unit, factor, offset = key
    is_identical = (factor, offset) == IDENTICAL
    scales = () if is_identical else (numbers.linear_scale(offset, factor, "1"),)
    category = "IDENTICAL" if is_identical else "LINEAR"
    target = numbers.references_of_number(known.paths, unit=known.units[unit] if unit else None)
    return numbers.compu_method(name, category, scales, target)
