"""The composition: components, connections between them, ports to the outside."""

from sigcat.adapter.arxml.tree import Package, Tag, listed, reference, tag
from sigcat.adapter.autosar_classic.arxml.library import Library
from sigcat.adapter.autosar_classic.arxml.paths import (
    APPLICATION_COMPONENT,
    COMPONENTS,
    COMPOSITION,
    COMPOSITIONS,
    PARAMETER_COMPONENT,
    PROTOTYPE,
    TYPE_MAPPING_SET,
    TYPE_MAPPINGS,
)
from sigcat.adapter.autosar_classic.arxml.ports import outer_port, port_tag
from sigcat.integration.autosar_classic.model import (
    Assembly,
    ClassicIntegration,
    Composition,
    Delegation,
    PortReference,
)


def package(model: ClassicIntegration, known: Library) -> Package:
    """The package of the composition."""
    composition = model.composition
    types = {each.name for each in model.parameter_components}
    mapping = known.paths.of(TYPE_MAPPINGS, TYPE_MAPPING_SET)
    prototypes = (
        tag(
            PROTOTYPE,
            reference(
                "TYPE-TREF",
                known.paths.of(COMPONENTS, each.type),
                PARAMETER_COMPONENT if each.type in types else APPLICATION_COMPONENT,
            ),
            name=each.name,
        )
        for each in composition.prototypes
    )
    connectors = [_assembly(each, composition, known) for each in composition.assemblies]
    connectors += [_delegation(each, composition, known) for each in composition.delegations]
    whole = tag(
        COMPOSITION,
        listed("PORTS", (outer_port(each, known) for each in composition.ports)),
        listed("COMPONENTS", prototypes),
        listed("CONNECTORS", connectors),
        tag("DATA-TYPE-MAPPING-REFS", reference("DATA-TYPE-MAPPING-REF", mapping, "DATA-TYPE-MAPPING-SET")),
        name=composition.name,
    )
    return Package(COMPOSITIONS, (whole,))


def prototype_path(name: str, composition: Composition, known: Library) -> str:
    """Path of a component of the composition."""
    return known.paths.of(COMPOSITIONS, composition.name, name)


def _inner(name: str, side: PortReference, composition: Composition, known: Library) -> Tag:
    """Reference to a port of a component: `name` is P or R."""
    types = {each.name: each.type for each in composition.prototypes}
    port = known.paths.of(COMPONENTS, types[side.component], side.port)
    return Tag(
        "",
        (
            reference("CONTEXT-COMPONENT-REF", prototype_path(side.component, composition, known), PROTOTYPE),
            reference(f"TARGET-{name}-PORT-REF", port, f"{name}-PORT-PROTOTYPE"),
        ),
    )


def _assembly(connector: Assembly, composition: Composition, known: Library) -> Tag:
    return tag(
        "ASSEMBLY-SW-CONNECTOR",
        _inner("P", connector.provider, composition, known)._replace(tag="PROVIDER-IREF"),
        _inner("R", connector.requester, composition, known)._replace(tag="REQUESTER-IREF"),
        name=connector.name,
    )


def _delegation(connector: Delegation, composition: Composition, known: Library) -> Tag:
    outer = next(each for each in composition.ports if each.name == connector.outer)
    side = "P" if outer.direction == "Provided" else "R"
    inner = _inner(side, connector.inner, composition, known)._replace(tag=f"{side}-PORT-IN-COMPOSITION-INSTANCE-REF")
    path = known.paths.of(COMPOSITIONS, composition.name, outer.name)
    return tag(
        "DELEGATION-SW-CONNECTOR",
        tag("INNER-PORT-IREF", inner),
        reference("OUTER-PORT-REF", path, port_tag(outer.direction)),
        name=connector.name,
    )
