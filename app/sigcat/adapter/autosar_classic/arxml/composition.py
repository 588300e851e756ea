"""The composition: components, connections between them, ports to the outside."""

from sigcat.adapter.arxml.tree import Package, Tag, listed, reference, tag
from sigcat.adapter.autosar_classic.arxml import paths
from sigcat.adapter.autosar_classic.arxml.library import Library
from sigcat.adapter.autosar_classic.arxml.ports import outer_port, side_of
from sigcat.integration.autosar_classic.model import Assembly, Delegation, PortReference, Prototype


def package(known: Library) -> Package:
    """The package of the composition."""
    composition = known.model.composition
    connectors = [_assembly(each, known) for each in composition.assemblies]
    connectors += (_delegation(each, known) for each in composition.delegations)
    whole = tag(
        paths.COMPOSITION,
        listed("PORTS", (outer_port(each, known) for each in composition.ports)),
        listed("COMPONENTS", (_prototype(each, known) for each in composition.prototypes)),
        listed("CONNECTORS", connectors),
        known.type_mappings(),
        name=composition.name,
    )
    return Package(paths.COMPOSITIONS, (whole,))


def _prototype(prototype: Prototype, known: Library) -> Tag:
    has_code = all(each.name != prototype.type for each in known.model.parameter_components)
    kind = paths.APPLICATION_COMPONENT if has_code else paths.PARAMETER_COMPONENT
    target = reference("TYPE-TREF", known.path(paths.COMPONENTS, prototype.type), kind)
    return tag(paths.PROTOTYPE, target, name=prototype.name)


def _inner(tag_name: str, side: str, inner: PortReference, known: Library) -> Tag:
    """Reference to a port of a component; `side` is P or R."""
    types = {each.name: each.type for each in known.model.composition.prototypes}
    port = known.path(paths.COMPONENTS, types[inner.component], inner.port)
    return tag(
        tag_name,
        known.prototype("CONTEXT-COMPONENT-REF", inner.component),
        reference(f"TARGET-{side}-PORT-REF", port, f"{side}-PORT-PROTOTYPE"),
    )


def _assembly(connector: Assembly, known: Library) -> Tag:
    provider = _inner("PROVIDER-IREF", "P", connector.provider, known)
    requester = _inner("REQUESTER-IREF", "R", connector.requester, known)
    return tag("ASSEMBLY-SW-CONNECTOR", provider, requester, name=connector.name)


def _delegation(connector: Delegation, known: Library) -> Tag:
    composition = known.model.composition
    outer = next(each for each in composition.ports if each.name == connector.outer)
    side = side_of(outer.direction)
    path = known.path(paths.COMPOSITIONS, composition.name, outer.name)
    return tag(
        "DELEGATION-SW-CONNECTOR",
        tag("INNER-PORT-IREF", _inner(f"{side}-PORT-IN-COMPOSITION-INSTANCE-REF", side, connector.inner, known)),
        reference("OUTER-PORT-REF", path, f"{side}-PORT-PROTOTYPE"),
        name=connector.name,
    )
