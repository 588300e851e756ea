"""Component types with their ports and behavior, their implementations, and the sections that these are placed in."""

from collections.abc import Iterable

from sigcat.adapter.arxml.tree import Package, Tag, description, listed, reference, tag, trace
from sigcat.adapter.autosar_classic.arxml.behavior import Within, behavior
from sigcat.adapter.autosar_classic.arxml.library import Library
from sigcat.adapter.autosar_classic.arxml.needs import dependencies
from sigcat.adapter.autosar_classic.arxml.paths import (
    APPLICATION_COMPONENT,
    BEHAVIOR,
    COMPONENTS,
    IMPLEMENTATIONS,
    PARAMETER_COMPONENT,
    RUNNABLE,
    SECTIONS,
    TYPE_MAPPING_SET,
    TYPE_MAPPINGS,
)
from sigcat.adapter.autosar_classic.arxml.ports import port
from sigcat.adapter.autosar_classic.arxml.releases import Release
from sigcat.integration.autosar_classic.model import ClassicIntegration, Component, MemorySection, ParameterComponent
from sigcat.integration.autosar_names import short_name

_SECTION_TYPES = {
    "CODE": "CODE",
    "VAR_CLEARED": "VAR",
    "VAR_INIT": "VAR",
    "CONST": "CONST",
    "CALIB": "CALPRM",
}
_INITIALIZATION = {"VAR_CLEARED": "CLEARED", "VAR_INIT": "INIT"}


def implementation_name(component: str) -> str:
    """Name of the implementation of a component."""
    return short_name(f"{component}_Implementation")


def packages(model: ClassicIntegration, known: Library, release: Release) -> list[Package]:
    """The packages of the file of components."""
    places = [Within(component, known, release) for component in model.components]
    return [
        Package(SECTIONS, tuple(_sections(model.components))),
        Package(
            COMPONENTS,
            (*map(_component, places), *(_parameter_component(each, known) for each in model.parameter_components)),
        ),
        Package(IMPLEMENTATIONS, tuple(map(_implementation, places))),
    ]


def _component(at: Within) -> Tag:
    component = at.component
    return tag(
        APPLICATION_COMPONENT,
        description(component.description),
        trace(list(_facts(component))),
        listed("PORTS", (port(each, at.known) for each in component.ports)),
        tag("INTERNAL-BEHAVIORS", behavior(at, dependencies(at))),
        name=component.name,
    )


def _facts(component: Component) -> Iterable[tuple[str, object]]:
    yield from (("Function", component.function), ("Version", component.version), ("AsilLevel", component.asil_level))
    yield "Code", component.code.model_dump(mode="json", exclude_none=True) if component.code else None


def _parameter_component(component: ParameterComponent, known: Library) -> Tag:
    mapping = known.paths.of(TYPE_MAPPINGS, TYPE_MAPPING_SET)
    return tag(
        PARAMETER_COMPONENT,
        listed("PORTS", (port(each, known) for each in component.ports)),
        tag("DATA-TYPE-MAPPING-REFS", reference("DATA-TYPE-MAPPING-REF", mapping, "DATA-TYPE-MAPPING-SET")),
        name=component.name,
    )


def _sections(components: Iterable[Component]) -> Iterable[Tag]:
    """A method for each name of a section, whichever components have it: the RTE puts the component before the name."""
    named: dict[str, list[MemorySection]] = {}
    for component in components:
        for section in component.sections:
            named.setdefault(section.name, []).append(section)
    for name, sections in named.items():
        kind = sections[0].kind
        policy = _INITIALIZATION.get(kind)
        facts = [("AsilLevel", tuple(dict.fromkeys(each.asil_level for each in sections))), ("Kind", kind)]
        yield tag(
            "SW-ADDR-METHOD",
            trace(facts),
            tag("MEMORY-ALLOCATION-KEYWORD-POLICY", text="ADDR-METHOD-SHORT-NAME"),
            tag("SECTION-INITIALIZATION-POLICY", text=policy) if policy else None,
            tag("SECTION-TYPE", text=_SECTION_TYPES[kind]),
            name=name,
        )


def _implementation(at: Within) -> Tag:
    component = at.component
    sources = [tag("AUTOSAR-ENGINEERING-OBJECT", tag("SHORT-LABEL", text=f"{component.name}.c"),
                   tag("CATEGORY", text="SWSRC"))]  # fmt: skip
    stacks = [
        tag(
            "ROUGH-ESTIMATE-STACK-USAGE",
            reference("EXECUTABLE-ENTITY-REF", at.path(each.name), RUNNABLE),
            tag("MEMORY-CONSUMPTION", text=each.stack_size),
            name=each.name,
        )
        for each in component.runnables
        if each.stack_size
    ]
    consumption = tag(
        "RESOURCE-CONSUMPTION",
        listed("MEMORY-SECTIONS", (_section(each, at) for each in component.sections)),
        listed("STACK-USAGES", stacks),
        name="Resources",
    )
    return tag(
        "SWC-IMPLEMENTATION",
        tag("CODE-DESCRIPTORS", tag("CODE", tag("ARTIFACT-DESCRIPTORS", *sources), name="Source")),
        tag("PROGRAMMING-LANGUAGE", text="C"),
        consumption,
        reference("BEHAVIOR-REF", at.path(), BEHAVIOR),
        name=implementation_name(component.name),
    )


def _section(section: MemorySection, at: Within) -> Tag:
    """A section: `Component_START_SEC_NAME` is made of the prefix, which is the component, and its symbol."""
    runnables = [
        reference("EXECUTABLE-ENTITY-REF", at.path(each.name), RUNNABLE)
        for each in at.component.runnables
        if each.section == section.name
    ]
    method = at.known.paths.of(SECTIONS, section.name)
    return tag(
        "MEMORY-SECTION",
        trace([("StackSize", section.stack_size)]),
        tag("ALIGNMENT", text=section.alignment),
        listed("EXECUTABLE-ENTITY-REFS", runnables),
        reference("SW-ADDRMETHOD-REF", method, "SW-ADDR-METHOD"),
        tag("SYMBOL", text=section.name),
        name=section.name,
    )
