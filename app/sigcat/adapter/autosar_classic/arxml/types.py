"""Platform types, implementation and application types, what their numbers mean, and how one becomes the other."""

from collections.abc import Iterable
from fractions import Fraction

from sigcat.adapter.arxml import units
from sigcat.adapter.arxml.paths import COMPU_METHODS, CONSTRAINTS, UNITS
from sigcat.adapter.arxml.tree import Package, Tag, definition_properties, description, listed, reference, tag, trace
from sigcat.adapter.autosar_classic.arxml.library import Library
from sigcat.adapter.autosar_classic.arxml.paths import (
    APPLICATION_TYPES,
    BASE_TYPES,
    IMPLEMENTATION_TYPE,
    IMPLEMENTATION_TYPES,
    MODE_GROUP,
    MODE_GROUPS,
    PLATFORM,
    TYPE_MAPPING_SET,
    TYPE_MAPPINGS,
)
from sigcat.integration.autosar_classic.model import (
    ApplicationType,
    ClassicIntegration,
    CompuMethod,
    DataConstraint,
    ImplementationType,
    ModeGroup,
)

_PLATFORM_TYPES = {
    "boolean": (8, "BOOLEAN"),
    **{f"uint{size}": (size, "NONE") for size in (8, 16, 32, 64)},
    **{f"sint{size}": (size, "2C") for size in (8, 16, 32, 64)},
    **{f"float{size}": (size, "IEEE754") for size in (32, 64)},
}
"""Size in bits and encoding of each platform type (AUTOSAR_SWS_PlatformTypes)."""


def platform_packages(model: ClassicIntegration) -> list[Package]:
    """The platform types that the document uses, where every vendor has them."""
    used = {each.base or each.name for each in model.implementation_types if each.category != "ARRAY"}
    names = [name for name in _PLATFORM_TYPES if name in used | {group.type for group in model.mode_groups}]
    return [
        Package(BASE_TYPES, tuple(map(_base_type, names))),
        Package(IMPLEMENTATION_TYPES, tuple(map(_platform_type, names))),
    ]


def _base_type(name: str) -> Tag:
    size, encoding = _PLATFORM_TYPES[name]
    return tag(
        "SW-BASE-TYPE",
        tag("CATEGORY", text="FIXED_LENGTH"),
        tag("BASE-TYPE-SIZE", text=size),
        tag("BASE-TYPE-ENCODING", text=encoding),
        name=name,
    )


def _platform_type(name: str) -> Tag:
    """A platform type: the RTE does not define it, since `Platform_Types.h` does."""
    base = reference("BASE-TYPE-REF", PLATFORM.of(BASE_TYPES, name), "SW-BASE-TYPE")
    return tag(
        IMPLEMENTATION_TYPE,
        tag("CATEGORY", text="VALUE"),
        definition_properties(base),
        tag("TYPE-EMITTER", text="Platform_Type"),
        name=name,
    )


def packages(model: ClassicIntegration, known: Library) -> list[Package]:
    """The packages of the file of types."""
    own = [each for each in model.implementation_types if each.category != "VALUE"]
    shown = {each.display_name: each.name for each in model.units}
    return [
        Package(IMPLEMENTATION_TYPES, tuple(_implementation(each, known) for each in own)),
        Package(APPLICATION_TYPES, tuple(_application(each, known) for each in model.application_types)),
        Package(COMPU_METHODS, tuple(_compu_method(each, known) for each in model.compu_methods)),
        *units.packages(shown, {}, known.paths),
        Package(CONSTRAINTS, tuple(map(_constraint, model.constraints))),
        Package(TYPE_MAPPINGS, (_mapping(model, known),)),
    ]


def _implementation(entry: ImplementationType, known: Library) -> Tag:
    properties, elements = None, None
    if entry.category == "TYPE_REFERENCE":
        properties = definition_properties(
            *known.properties(compu_method=entry.compu_method), _referred(entry.base or "uint8", known)
        )
    elif entry.category == "ARRAY":
        elements = tag("SUB-ELEMENTS", _array_element(entry, known))
    else:
        elements = listed(
            "SUB-ELEMENTS",
            (
                tag(
                    f"{IMPLEMENTATION_TYPE}-ELEMENT",
                    description(each.description),
                    tag("CATEGORY", text="TYPE_REFERENCE"),
                    definition_properties(_referred(each.type, known)),
                    name=each.name,
                )
                for each in entry.members or ()
            ),
        )
    category = tag("CATEGORY", text=entry.category)
    about = trace([("TypeRef", entry.reference)])
    return tag(IMPLEMENTATION_TYPE, category, about, properties, elements, name=entry.name)


def _array_element(entry: ImplementationType, known: Library) -> Tag:
    return tag(
        f"{IMPLEMENTATION_TYPE}-ELEMENT",
        tag("CATEGORY", text="TYPE_REFERENCE"),
        tag("ARRAY-SIZE", text=entry.length or 1),
        tag("ARRAY-SIZE-SEMANTICS", text="FIXED-SIZE"),
        definition_properties(_referred(entry.element or "uint8", known)),
        name="Element",
    )


def _referred(name: str, known: Library) -> Tag:
    return reference("IMPLEMENTATION-DATA-TYPE-REF", known.implementation_path(name), IMPLEMENTATION_TYPE)


def _application(entry: ApplicationType, known: Library) -> Tag:
    text = description(entry.description)
    category = tag("CATEGORY", text=entry.category)
    if entry.category == "ARRAY":
        element = tag(
            "ELEMENT",
            tag("CATEGORY", text=_category(entry.element or "", known)),
            known.type_reference("TYPE-TREF", entry.element or ""),
            tag("ARRAY-SIZE-SEMANTICS", text="FIXED-SIZE"),
            tag("MAX-NUMBER-OF-ELEMENTS", text=entry.length or 1),
            name="Element",
        )
        return tag("APPLICATION-ARRAY-DATA-TYPE", text, category, element, name=entry.name)
    if entry.category == "STRUCTURE":
        members = (
            tag(
                "APPLICATION-RECORD-ELEMENT",
                description(each.description),
                tag("CATEGORY", text=_category(each.type, known)),
                known.type_reference("TYPE-TREF", each.type),
                name=each.name,
            )
            for each in entry.members or ()
        )
        return tag("APPLICATION-RECORD-DATA-TYPE", text, category, listed("ELEMENTS", members), name=entry.name)
    properties = definition_properties(
        tag("SW-CALIBRATION-ACCESS", text="READ-ONLY"),
        *known.properties(compu_method=entry.compu_method, constraint=entry.constraint, unit=entry.unit),
    )
    return tag("APPLICATION-PRIMITIVE-DATA-TYPE", text, category, properties, name=entry.name)


def _category(name: str, known: Library) -> str:
    found = known.application_types.get(name)
    return found.category if found else "VALUE"


def _compu_method(entry: CompuMethod, known: Library) -> Tag:
    unit = reference("UNIT-REF", known.paths.of(UNITS, entry.unit), "UNIT") if entry.unit else None
    scales = [_text_scale(each.symbol, each.value) for each in entry.symbols or ()]
    if entry.category == "LINEAR":
        scales = [_linear_scale(Fraction(entry.factor or "1"), Fraction(entry.offset or "0"))]
    content = listed("COMPU-SCALES", scales)
    return tag(
        "COMPU-METHOD",
        tag("CATEGORY", text=entry.category),
        unit,
        tag("COMPU-INTERNAL-TO-PHYS", content) if content else None,
        name=entry.name,
    )


def _text_scale(symbol: str, value: int) -> Tag:
    return tag(
        "COMPU-SCALE",
        tag("SYMBOL", text=symbol),
        _limit("LOWER-LIMIT", value),
        _limit("UPPER-LIMIT", value),
        tag("COMPU-CONST", tag("VT", text=symbol)),
    )


def _linear_scale(factor: Fraction, offset: Fraction) -> Tag:
    """Value = (offset + factor × number) ÷ denominator, all of them whole numbers: exact, whatever the factor is."""
    denominator = factor.denominator * offset.denominator
    return tag(
        "COMPU-SCALE",
        tag(
            "COMPU-RATIONAL-COEFFS",
            tag(
                "COMPU-NUMERATOR",
                tag("V", text=str(offset * denominator)),
                tag("V", text=str(factor * denominator)),
            ),
            tag("COMPU-DENOMINATOR", tag("V", text=str(denominator))),
        ),
    )


def _limit(name: str, value: float) -> Tag:
    return Tag(name, (), str(value), None, (("INTERVAL-TYPE", "CLOSED"),))


def _constraint(entry: DataConstraint) -> Tag:
    rule = tag(
        "PHYS-CONSTRS",
        _limit("LOWER-LIMIT", entry.min) if entry.min is not None else None,
        _limit("UPPER-LIMIT", entry.max) if entry.max is not None else None,
    )
    return tag("DATA-CONSTR", tag("DATA-CONSTR-RULES", tag("DATA-CONSTR-RULE", rule)), name=entry.name)


def _mapping(model: ClassicIntegration, known: Library) -> Tag:
    """Datatype of the code for an application type and for the modes of a group."""
    maps = (
        tag(
            "DATA-TYPE-MAP",
            known.type_reference("APPLICATION-DATA-TYPE-REF", each.name),
            reference(
                "IMPLEMENTATION-DATA-TYPE-REF", known.implementation_path(each.implementation), IMPLEMENTATION_TYPE
            ),
        )
        for each in model.application_types
    )
    modes = (
        tag(
            "MODE-REQUEST-TYPE-MAP",
            reference("IMPLEMENTATION-DATA-TYPE-REF", known.implementation_path(each.type), IMPLEMENTATION_TYPE),
            reference("MODE-GROUP-REF", known.paths.of(MODE_GROUPS, each.name), MODE_GROUP),
        )
        for each in model.mode_groups
    )
    return tag(
        "DATA-TYPE-MAPPING-SET",
        listed("DATA-TYPE-MAPS", maps),
        listed("MODE-REQUEST-TYPE-MAPS", modes),
        name=TYPE_MAPPING_SET,
    )


def mode_groups(groups: Iterable[ModeGroup], known: Library) -> Package:
    """The package of mode declaration groups. Modes have the numbers that the core takes."""
    return Package(MODE_GROUPS, tuple(_mode_group(each, known) for each in groups))


def _mode_group(group: ModeGroup, known: Library) -> Tag:
    modes = (tag("MODE-DECLARATION", tag("VALUE", text=each.value), name=each.name) for each in group.modes)
    initial = known.paths.of(MODE_GROUPS, group.name, group.initial)
    return tag(
        MODE_GROUP,
        tag("CATEGORY", text="EXPLICIT_ORDER"),
        reference("INITIAL-MODE-REF", initial, "MODE-DECLARATION"),
        listed("MODE-DECLARATIONS", modes),
        tag("ON-TRANSITION-VALUE", text=group.on_transition),
        name=group.name,
    )
