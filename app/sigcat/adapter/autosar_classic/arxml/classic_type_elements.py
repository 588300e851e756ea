"""Platform types, implementation and application types, what their numbers mean, and how one becomes the other."""

from collections.abc import Iterable
from fractions import Fraction

from sigcat.adapter.arxml import units
from sigcat.adapter.arxml.numbers import compu_method, constraint, limit, linear_scale, references_of_number, text_scale
from sigcat.adapter.arxml.paths import COMPU_METHODS, CONSTRAINTS
from sigcat.adapter.arxml.tree import (
    Child,
    Package,
    Tag,
    definition_properties,
    description,
    listed,
    reference,
    tag,
    trace,
)
from sigcat.adapter.autosar_classic.arxml import paths
from sigcat.adapter.autosar_classic.arxml.library import APPLICATION_TYPE, Library
from sigcat.integration.autosar_classic import model

_PLATFORM_TYPES = {
    "boolean": (8, "BOOLEAN"),
    **{f"uint{size}": (size, "NONE") for size in (8, 16, 32, 64)},
    **{f"sint{size}": (size, "2C") for size in (8, 16, 32, 64)},
    **{f"float{size}": (size, "IEEE754") for size in (32, 64)},
}
"""Size in bits and encoding of each platform type (AUTOSAR_SWS_PlatformTypes)."""


def platform_packages(document: model.ClassicIntegration) -> list[Package]:
    """The platform types that the document uses, where every vendor has them."""
    used = {each.base or each.name for each in document.implementation_types if each.category != "ARRAY"}
    names = [name for name in _PLATFORM_TYPES if name in used | {group.type for group in document.mode_groups}]
    return [
        Package(paths.BASE_TYPES, tuple(map(_base_type, names))),
        Package(paths.IMPLEMENTATION_TYPES, tuple(map(_platform_type, names))),
    ]


def _base_type(name: str) -> Tag:
    size, encoding = _PLATFORM_TYPES[name]
    content: Child = {"CATEGORY": "FIXED_LENGTH", "BASE-TYPE-SIZE": size, "BASE-TYPE-ENCODING": encoding}
    return tag("SW-BASE-TYPE", content, name=name)


def _platform_type(name: str) -> Tag:
    """A platform type: the RTE does not define it, since `Platform_Types.h` does."""
    base = reference("BASE-TYPE-REF", paths.PLATFORM.of(paths.BASE_TYPES, name), "SW-BASE-TYPE")
    kind = {"CATEGORY": "VALUE", "TYPE-EMITTER": "Platform_Type"}
    return tag(paths.IMPLEMENTATION_TYPE, kind, definition_properties(base), name=name)


def packages(known: Library) -> list[Package]:
    """The packages of the file of types."""
    document = known.model
    own = [each for each in document.implementation_types if each.category != "VALUE"]
    shown = {each.display_name: each.name for each in document.units}
    return [
        Package(paths.IMPLEMENTATION_TYPES, tuple(_implementation(each, known) for each in own)),
        Package(paths.APPLICATION_TYPES, tuple(_application(each, known) for each in document.application_types)),
        Package(COMPU_METHODS, tuple(_compu_method(each, known) for each in document.compu_methods)),
        *units.packages(shown, {}, known.paths),
        Package(CONSTRAINTS, tuple(constraint(each.name, each.min, each.max) for each in document.constraints)),
        Package(paths.TYPE_MAPPINGS, (_mapping(known),)),
    ]


def _implementation(entry: model.ImplementationType, known: Library) -> Tag:
    properties, elements = None, None
    if entry.category == "TYPE_REFERENCE":
        method = references_of_number(known.paths, entry.compu_method)
        properties = definition_properties(*method, known.implementation_reference(entry.base or "uint8"))
    elif entry.category == "ARRAY":
        size: Child = {"ARRAY-SIZE": entry.length or 1, "ARRAY-SIZE-SEMANTICS": "FIXED-SIZE"}
        elements = tag("SUB-ELEMENTS", _part("Element", entry.element or "uint8", known, size))
    else:
        members = entry.members or ()
        parts = (_part(each.name, each.type, known, description(each.description)) for each in members)
        elements = listed("SUB-ELEMENTS", parts)
    about = trace([("TypeRef", entry.reference)])
    return tag(paths.IMPLEMENTATION_TYPE, {"CATEGORY": entry.category}, about, properties, elements, name=entry.name)


def _part(name: str, type_name: str, known: Library, about: Child) -> Tag:
    """A member of a structure, or the element of an array."""
    properties = definition_properties(known.implementation_reference(type_name))
    return tag(f"{paths.IMPLEMENTATION_TYPE}-ELEMENT", {"CATEGORY": "TYPE_REFERENCE"}, about, properties, name=name)


def _application(entry: model.ApplicationType, known: Library) -> Tag:
    content: Tag | None
    if entry.category == "ARRAY":
        size: Child = {"ARRAY-SIZE-SEMANTICS": "FIXED-SIZE", "MAX-NUMBER-OF-ELEMENTS": entry.length or 1}
        content = tag("ELEMENT", *_typed(entry.element or "", known), size, name="Element")
    elif entry.category == "STRUCTURE":
        members = (
            tag("APPLICATION-RECORD-ELEMENT", description(each.description), *_typed(each.type, known), name=each.name)
            for each in entry.members or ()
        )
        content = listed("ELEMENTS", members)
    else:
        content = definition_properties(
            tag("SW-CALIBRATION-ACCESS", text="READ-ONLY"),
            *references_of_number(known.paths, entry.compu_method, entry.constraint, entry.unit),
        )
    about = (description(entry.description), {"CATEGORY": entry.category})
    return tag(APPLICATION_TYPE[entry.category], *about, content, name=entry.name)


def _typed(name: str, known: Library) -> Iterable[Child]:
    """Category and type of an element."""
    found = known.application_types.get(name)
    yield {"CATEGORY": found.category if found else "VALUE"}
    yield known.type_reference("TYPE-TREF", name)


def _compu_method(entry: model.CompuMethod, known: Library) -> Tag:
    limits = ("LOWER-LIMIT", "UPPER-LIMIT")
    scales = [text_scale(each.symbol, *(limit(end, each.value) for end in limits)) for each in entry.symbols or ()]
    if entry.category == "LINEAR":
        scales = [_linear_scale(Fraction(entry.factor or "1"), Fraction(entry.offset or "0"))]
    return compu_method(entry.name, entry.category, scales, references_of_number(known.paths, unit=entry.unit))


def _linear_scale(factor: Fraction, offset: Fraction) -> Tag:
    """A scale of whole numbers: exact, whatever the factor is."""
    denominator = factor.denominator * offset.denominator
    return linear_scale(str(offset * denominator), str(factor * denominator), str(denominator))


def _mapping(known: Library) -> Tag:
    """Datatype of the code for an application type and for the modes of a group."""
    maps = (
        tag(
            "DATA-TYPE-MAP",
            known.type_reference("APPLICATION-DATA-TYPE-REF", each.name),
            known.implementation_reference(each.implementation),
        )
        for each in known.model.application_types
    )
    modes = (
        tag(
            "MODE-REQUEST-TYPE-MAP",
            known.implementation_reference(each.type),
            reference("MODE-GROUP-REF", known.path(paths.MODE_GROUPS, each.name), paths.MODE_GROUP),
        )
        for each in known.model.mode_groups
    )
    content = (listed("DATA-TYPE-MAPS", maps), listed("MODE-REQUEST-TYPE-MAPS", modes))
    return tag("DATA-TYPE-MAPPING-SET", *content, name=paths.TYPE_MAPPING_SET)


def mode_groups(known: Library) -> Package:
    """The package of mode declaration groups. Modes have the numbers that the core takes."""
    return Package(paths.MODE_GROUPS, tuple(_mode_group(each, known) for each in known.model.mode_groups))


def _mode_group(group: model.ModeGroup, known: Library) -> Tag:
    initial = known.path(paths.MODE_GROUPS, group.name, group.initial)
    return tag(
        paths.MODE_GROUP,
        {"CATEGORY": "EXPLICIT_ORDER", "ON-TRANSITION-VALUE": group.on_transition},
        reference("INITIAL-MODE-REF", initial, "MODE-DECLARATION"),
        listed(
            "MODE-DECLARATIONS",
            (tag("MODE-DECLARATION", {"VALUE": each.value}, name=each.name) for each in group.modes),
        ),
        name=group.name,
    )
