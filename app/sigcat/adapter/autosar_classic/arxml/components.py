"""Component types with their ports and behavior, their implementations, and the sections that these are placed in."""

from collections.abc import Iterable

from sigcat.adapter.arxml.tree import Package, Tag, description, listed, reference, references, tag, trace
from sigcat.adapter.autosar_classic.arxml import paths
from sigcat.adapter.autosar_classic.arxml.behavior import Within, behavior
from sigcat.adapter.autosar_classic.arxml.library import Library
from sigcat.adapter.autosar_classic.arxml.needs import dependencies
from sigcat.adapter.autosar_classic.arxml.ports import port
from sigcat.integration.autosar_classic.model import Component, MemorySection, ParameterComponent
from sigcat.integration.autosar_names import short_name

_SECTION_TYPES = {"CODE": "CODE", "VAR_CLEARED": "VAR", "VAR_INIT": "VAR", "CONST": "CONST", "CALIB": "CALPRM"}
_INITIALIZATION = {"VAR_CLEARED": "CLEARED", "VAR_INIT": "INIT"}


def implementation_name(component: str) -> str:
    """Name of the implementation of a component."""
    return short_name(f"{component}_Implementation")


def packages(known: Library) -> list[Package]:
    """The packages of the file of components."""
    model = known.model
    places = [Within(component, known) for component in model.components]
    components = [*map(_component, places), *(_parameter_component(each, known) for each in model.parameter_components)]
    return [
        Package(paths.SECTIONS, tuple(_sections(model.components))),
        Package(paths.COMPONENTS, tuple(components)),
        Package(paths.IMPLEMENTATIONS, tuple(map(_implementation, places))),
    ]


def _component(at: Within) -> Tag:
    component = at.component
    facts = (("Function", component.function), ("Version", component.version), ("AsilLevel", component.asil_level))
    return tag(
        paths.APPLICATION_COMPONENT,
        description(component.description),
        trace((*facts, ("Code", component.code))),
        listed("PORTS", (port(each, at.known) for each in component.ports)),
        tag("INTERNAL-BEHAVIORS", behavior(at, dependencies(at))),
        name=component.name,
    )


def _parameter_component(component: ParameterComponent, known: Library) -> Tag:
    ports = listed("PORTS", (port(each, known) for each in component.ports))
    return tag(paths.PARAMETER_COMPONENT, ports, known.type_mappings(), name=component.name)


def _sections(components: Iterable[Component]) -> Iterable[Tag]:
    """A method for each name of a section, whichever components have it: the RTE puts the component before the name."""
    named: dict[str, list[MemorySection]] = {}
    for component in components:
        for section in component.sections:
            named.setdefault(section.name, []).append(section)
    for name, sections in named.items():
        kind = sections[0].kind
        facts = [("AsilLevel", tuple(dict.fromkeys(each.asil_level for each in sections))), ("Kind", kind)]
        yield tag(
            "SW-ADDR-METHOD",
            trace(facts),
            {"MEMORY-ALLOCATION-KEYWORD-POLICY": "ADDR-METHOD-SHORT-NAME", "SECTION-TYPE": _SECTION_TYPES[kind]},
            {"SECTION-INITIALIZATION-POLICY": _INITIALIZATION.get(kind)},
            name=name,
        )


def _implementation(at: Within) -> Tag:
    component = at.component
    source = tag("AUTOSAR-ENGINEERING-OBJECT", {"SHORT-LABEL": f"{component.name}.c", "CATEGORY": "SWSRC"})
    stacks = (
        tag(
            "ROUGH-ESTIMATE-STACK-USAGE",
            reference("EXECUTABLE-ENTITY-REF", at.path(each.name), paths.RUNNABLE),
            {"MEMORY-CONSUMPTION": each.stack_size},
            name=each.name,
        )
        for each in component.runnables
        if each.stack_size
    )
    sections = listed("MEMORY-SECTIONS", (_section(each, at) for each in component.sections))
    return tag(
        "SWC-IMPLEMENTATION",
        tag("CODE-DESCRIPTORS", tag("CODE", tag("ARTIFACT-DESCRIPTORS", source), name="Source")),
        {"PROGRAMMING-LANGUAGE": "C"},
        tag("RESOURCE-CONSUMPTION", sections, listed("STACK-USAGES", stacks), name="Resources"),
        reference("BEHAVIOR-REF", at.path(), paths.BEHAVIOR),
        name=implementation_name(component.name),
    )


def _section(section: MemorySection, at: Within) -> Tag:
    """A section: `Component_START_SEC_NAME` is made of the prefix, which is the component, and its symbol."""
    runnables = (at.path(each.name) for each in at.component.runnables if each.section == section.name)
    return tag(
        "MEMORY-SECTION",
        trace([("StackSize", section.stack_size)]),
        {"ALIGNMENT": section.alignment, "SYMBOL": section.name},
        references("EXECUTABLE-ENTITY-REF", runnables, paths.RUNNABLE),
        reference("SW-ADDRMETHOD-REF", at.known.path(paths.SECTIONS, section.name), "SW-ADDR-METHOD"),
        name=section.name,
    )
