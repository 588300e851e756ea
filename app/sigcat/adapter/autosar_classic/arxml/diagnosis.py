"""The diagnostic extract: events, function identifiers and what inhibits them, and the components that they belong to."""

from collections.abc import Iterable

from sigcat.adapter.arxml.tree import Package, Tag, conditional, description, listed, reference, tag, trace
from sigcat.adapter.autosar_classic.arxml.behavior import Within
from sigcat.adapter.autosar_classic.arxml.library import Library
from sigcat.adapter.autosar_classic.arxml.needs import DEPENDENCY, dependency_name
from sigcat.adapter.autosar_classic.arxml.paths import DIAGNOSTIC_EVENTS, DIAGNOSTIC_MAPPINGS, FUNCTION_IDENTIFIERS
from sigcat.adapter.autosar_classic.arxml.releases import Release
from sigcat.adapter.autosar_classic.arxml.system import ecu_reference, root_reference
from sigcat.integration.autosar_classic.model import DiagnosticEvent, Inhibition
from sigcat.integration.autosar_names import distinct, short_name

_EVENT = "DIAGNOSTIC-EVENT"
_IDENTIFIER = "DIAGNOSTIC-FUNCTION-IDENTIFIER"
_SOURCE = "DIAGNOSTIC-FUNCTION-INHIBIT-SOURCE"


def packages(known: Library) -> list[Package]:
    """The packages of the diagnostic extract; they are empty if nothing is diagnosed."""
    places = [Within(component, known) for component in known.model.components]
    events = [(each, at) for at in places for each in at.component.diagnostic_events]
    inhibitions = [(each, at) for at in places for each in at.component.inhibitions]
    mappings = [_port_mapping(*pair) for pair in events]
    mappings += (_function_mapping(*pair) for pair in inhibitions)
    mappings += (each for inhibition, _ in inhibitions for each in _source_mappings(inhibition, known))
    identifiers = [tag(_IDENTIFIER, name=each.name) for each, _ in inhibitions]
    identifiers += (_inhibit(each, known) for each, _ in inhibitions)
    owned = [
        Package(DIAGNOSTIC_EVENTS, tuple(_event(each, known.release) for each, _ in events)),
        Package(FUNCTION_IDENTIFIERS, tuple(identifiers)),
        Package(DIAGNOSTIC_MAPPINGS, tuple(mappings)),
    ]
    return [*owned, Package("Diagnosis", (_contribution(owned, known),))] if mappings else owned


def _event(event: DiagnosticEvent, release: Release) -> Tag:
    """An event. The core has matured the error before it is reported: without debouncing here."""
    limit = "CONFIRMATION-THRESHOLD" if release.has_confirmation_threshold else "EVENT-FAILURE-CYCLE-COUNTER-THRESHOLD"
    return tag(
        _EVENT,
        description(event.description),
        trace([("Error", event.error), ("AsilLevel", event.asil_level)]),
        {limit: event.ignition_limit or None, "EVENT-KIND": "SWC", "RECOVERABLE-IN-SAME-OPERATION-CYCLE": True},
        name=event.name,
    )


def _inhibit_name(inhibition: Inhibition) -> str:
    return short_name(f"{inhibition.name}_Inhibit")


def _sources(inhibition: Inhibition, known: Library) -> dict[str, str]:
    """Conditions that inhibit a function: events of this set, and the sources that represent them.

    Other errors are events of other ECUs.
    """
    reported = {each.error: each.name for component in known.model.components for each in component.diagnostic_events}
    events = [reported[error] for error in inhibition.events if error in reported]
    return distinct({event: short_name(f"By_{event}") for event in events})


def _inhibit(inhibition: Inhibition, known: Library) -> Tag:
    identifier = known.path(FUNCTION_IDENTIFIERS, inhibition.name)
    sources = (tag(_SOURCE, name=name) for name in _sources(inhibition, known).values())
    return tag(
        f"{_IDENTIFIER}-INHIBIT",
        trace([("Condition", inhibition.condition), ("Events", inhibition.events)]),
        reference("FUNCTION-IDENTIFIER-REF", identifier, _IDENTIFIER),
        listed("INHIBIT-SOURCES", sources),
        {"INHIBITION-MASK": inhibition.mask.replace("_", "-")},
        name=_inhibit_name(inhibition),
    )


def _source_mappings(inhibition: Inhibition, known: Library) -> Iterable[Tag]:
    for event, name in _sources(inhibition, known).items():
        source = known.path(FUNCTION_IDENTIFIERS, _inhibit_name(inhibition), name)
        yield tag(
            "DIAGNOSTIC-INHIBIT-SOURCE-EVENT-MAPPING",
            reference("DIAGNOSTIC-EVENT-REF", known.path(DIAGNOSTIC_EVENTS, event), _EVENT),
            reference("INHIBITION-SOURCE-REF", source, _SOURCE),
            name=short_name(f"{inhibition.name}_{name}"),
        )


def _in_system(tag_name: str, need: str, at: Within) -> Tag:
    """Reference to the dependency of a component in the extract of the ECU."""
    prototypes = at.known.model.composition.prototypes
    prototype = next(each.name for each in prototypes if each.type == at.component.name)
    return tag(
        tag_name,
        root_reference("CONTEXT-ROOT-SW-COMPOSITION-REF", at.known),
        at.known.prototype("CONTEXT-SW-COMPONENT-PROTOTYPE-REF", prototype),
        reference("TARGET-SWC-SERVICE-DEPENDENCY-REF", at.path(dependency_name(need)), DEPENDENCY),
    )


def _port_mapping(event: DiagnosticEvent, at: Within) -> Tag:
    return tag(
        "DIAGNOSTIC-EVENT-PORT-MAPPING",
        reference("DIAGNOSTIC-EVENT-REF", at.known.path(DIAGNOSTIC_EVENTS, event.name), _EVENT),
        _in_system("SWC-SERVICE-DEPENDENCY-IN-SYSTEM-IREF", event.name, at),
        name=short_name(f"{event.name}_Port"),
    )


def _function_mapping(inhibition: Inhibition, at: Within) -> Tag:
    return tag(
        "DIAGNOSTIC-FIM-FUNCTION-MAPPING",
        reference("MAPPED-FUNCTION-REF", at.known.path(FUNCTION_IDENTIFIERS, inhibition.name), _IDENTIFIER),
        _in_system("MAPPED-SWC-SERVICE-DEPENDENCY-IREF", inhibition.name, at),
        name=short_name(f"{inhibition.name}_Function"),
    )


def _contribution(owned: list[Package], known: Library) -> Tag:
    """The set of everything here, which is what an extract hands over."""
    elements = ((known.path(package.name, each.name or ""), each.tag) for package in owned for each in package.elements)
    members = (conditional(reference("DIAGNOSTIC-COMMON-ELEMENT-REF", *element)) for element in elements)
    return tag(
        "DIAGNOSTIC-CONTRIBUTION-SET",
        {"CATEGORY": "DIAGNOSTIC_ECU_EXTRACT"},
        tag("ECU-INSTANCE-REFS", ecu_reference("ECU-INSTANCE-REF", known)),
        listed("ELEMENTS", members),
        name=short_name(f"{known.model.ecu.name}_Diagnosis"),
    )
