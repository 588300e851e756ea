"""The diagnostic extract: events, function identifiers and what inhibits them, and the components that they belong to."""

from collections.abc import Iterable

from sigcat.adapter.arxml.tree import Package, Tag, description, listed, reference, tag, trace
from sigcat.adapter.autosar_classic.arxml.behavior import Within
from sigcat.adapter.autosar_classic.arxml.composition import prototype_path
from sigcat.adapter.autosar_classic.arxml.library import Library
from sigcat.adapter.autosar_classic.arxml.needs import DEPENDENCY, dependency_name
from sigcat.adapter.autosar_classic.arxml.paths import (
    DIAGNOSTIC_EVENTS,
    DIAGNOSTIC_MAPPINGS,
    ECUS,
    FUNCTION_IDENTIFIERS,
    PROTOTYPE,
)
from sigcat.adapter.autosar_classic.arxml.releases import Release
from sigcat.adapter.autosar_classic.arxml.system import ROOT_PROTOTYPE, root_path
from sigcat.integration.autosar_classic.model import ClassicIntegration, Component, DiagnosticEvent, Inhibition
from sigcat.integration.autosar_names import distinct, short_name

_EVENT, _IDENTIFIER, _INHIBIT, _SOURCE = (
    "DIAGNOSTIC-EVENT",
    "DIAGNOSTIC-FUNCTION-IDENTIFIER",
    "DIAGNOSTIC-FUNCTION-IDENTIFIER-INHIBIT",
    "DIAGNOSTIC-FUNCTION-INHIBIT-SOURCE",
)


def packages(model: ClassicIntegration, known: Library, release: Release) -> list[Package]:
    """The packages of the diagnostic extract; they are empty if nothing is diagnosed."""
    events = [(component, each) for component in model.components for each in component.diagnostic_events]
    identifiers = [(component, each) for component in model.components for each in component.inhibitions]
    mappings = [_port_mapping(*pair, model, known, release) for pair in events]
    mappings += [_function_mapping(*pair, model, known, release) for pair in identifiers]
    mappings += [each for _, inhibition in identifiers for each in _source_mappings(inhibition, model, known)]
    inhibits = [_inhibit(each, model, known) for _, each in identifiers]
    owned = [Package(DIAGNOSTIC_EVENTS, tuple(_event(each, release) for _, each in events)),
             Package(FUNCTION_IDENTIFIERS, (*(tag(_IDENTIFIER, name=each.name) for _, each in identifiers), *inhibits)),
             Package(DIAGNOSTIC_MAPPINGS, tuple(mappings))]  # fmt: skip
    if not events and not identifiers:
        return owned
    return [*owned, Package("Diagnosis", (_contribution(owned, model, known),))]


def _event(event: DiagnosticEvent, release: Release) -> Tag:
    """An event. The core has matured the error before it is reported: without debouncing here."""
    limit = "CONFIRMATION-THRESHOLD" if release.has_confirmation_threshold else "EVENT-FAILURE-CYCLE-COUNTER-THRESHOLD"
    return tag(
        _EVENT,
        description(event.description),
        trace([("Error", event.error), ("AsilLevel", event.asil_level)]),
        tag(limit, text=event.ignition_limit) if event.ignition_limit else None,
        tag("EVENT-KIND", text="SWC"),
        tag("RECOVERABLE-IN-SAME-OPERATION-CYCLE", text="true"),
        name=event.name,
    )


def _inhibit_name(inhibition: Inhibition) -> str:
    return short_name(f"{inhibition.name}_Inhibit")


def _sources(inhibition: Inhibition, model: ClassicIntegration) -> dict[str, str]:
    """Conditions that inhibit a function: events of this set, and the sources that represent them.

    Other errors are events of other ECUs.
    """
    reported = {each.error: each.name for component in model.components for each in component.diagnostic_events}
    events = [reported[error] for error in inhibition.events if error in reported]
    return distinct({event: short_name(f"By_{event}") for event in events})


def _inhibit(inhibition: Inhibition, model: ClassicIntegration, known: Library) -> Tag:
    identifier = known.paths.of(FUNCTION_IDENTIFIERS, inhibition.name)
    sources = (tag(_SOURCE, name=name) for name in _sources(inhibition, model).values())
    return tag(
        _INHIBIT,
        trace([("Condition", inhibition.condition), ("Events", inhibition.events)]),
        reference("FUNCTION-IDENTIFIER-REF", identifier, _IDENTIFIER),
        listed("INHIBIT-SOURCES", sources),
        tag("INHIBITION-MASK", text=inhibition.mask.replace("_", "-")),
        name=_inhibit_name(inhibition),
    )


def _source_mappings(inhibition: Inhibition, model: ClassicIntegration, known: Library) -> Iterable[Tag]:
    for event, name in _sources(inhibition, model).items():
        source = known.paths.of(FUNCTION_IDENTIFIERS, _inhibit_name(inhibition), name)
        yield tag(
            "DIAGNOSTIC-INHIBIT-SOURCE-EVENT-MAPPING",
            reference("DIAGNOSTIC-EVENT-REF", known.paths.of(DIAGNOSTIC_EVENTS, event), _EVENT),
            reference("INHIBITION-SOURCE-REF", source, _SOURCE),
            name=short_name(f"{inhibition.name}_{name}"),
        )


def _in_system(
    name: str, component: Component, need: str, model: ClassicIntegration, known: Library, release: Release
) -> Tag:
    """Reference to the dependency of a component in the extract of the ECU."""
    prototype = next(each.name for each in model.composition.prototypes if each.type == component.name)
    return tag(
        name,
        reference("CONTEXT-ROOT-SW-COMPOSITION-REF", root_path(model, known), ROOT_PROTOTYPE),
        reference("CONTEXT-SW-COMPONENT-PROTOTYPE-REF", prototype_path(prototype, model.composition, known), PROTOTYPE),
        reference(
            "TARGET-SWC-SERVICE-DEPENDENCY-REF",
            Within(component, known, release).path(dependency_name(need)),
            DEPENDENCY,
        ),
    )


def _port_mapping(
    component: Component, event: DiagnosticEvent, model: ClassicIntegration, known: Library, release: Release
) -> Tag:
    return tag(
        "DIAGNOSTIC-EVENT-PORT-MAPPING",
        reference("DIAGNOSTIC-EVENT-REF", known.paths.of(DIAGNOSTIC_EVENTS, event.name), _EVENT),
        _in_system("SWC-SERVICE-DEPENDENCY-IN-SYSTEM-IREF", component, event.name, model, known, release),
        name=short_name(f"{event.name}_Port"),
    )


def _function_mapping(
    component: Component, inhibition: Inhibition, model: ClassicIntegration, known: Library, release: Release
) -> Tag:
    identifier = known.paths.of(FUNCTION_IDENTIFIERS, inhibition.name)
    return tag(
        "DIAGNOSTIC-FIM-FUNCTION-MAPPING",
        reference("MAPPED-FUNCTION-REF", identifier, _IDENTIFIER),
        _in_system("MAPPED-SWC-SERVICE-DEPENDENCY-IREF", component, inhibition.name, model, known, release),
        name=short_name(f"{inhibition.name}_Function"),
    )


def _contribution(owned: list[Package], model: ClassicIntegration, known: Library) -> Tag:
    """The set of everything here, which is what an extract hands over."""
    members = (
        tag(
            "DIAGNOSTIC-COMMON-ELEMENT-REF-CONDITIONAL",
            reference("DIAGNOSTIC-COMMON-ELEMENT-REF", known.paths.of(package.name, element.name or ""), element.tag),
        )
        for package in owned
        for element in package.elements
    )
    ecu = reference("ECU-INSTANCE-REF", known.paths.of(ECUS, model.ecu.name), "ECU-INSTANCE")
    return tag(
        "DIAGNOSTIC-CONTRIBUTION-SET",
        tag("CATEGORY", text="DIAGNOSTIC_ECU_EXTRACT"),
        tag("ECU-INSTANCE-REFS", ecu),
        listed("ELEMENTS", members),
        name=short_name(f"{model.ecu.name}_Diagnosis"),
    )
