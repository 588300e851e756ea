"""The extract of the ECU: its root composition, which component runs on it, which element is which signal."""

from sigcat.adapter.arxml.tree import Package, Tag, listed, reference, tag, trace
from sigcat.adapter.autosar_classic.arxml.components import implementation_name
from sigcat.adapter.autosar_classic.arxml.composition import prototype_path
from sigcat.adapter.autosar_classic.arxml.library import Library
from sigcat.adapter.autosar_classic.arxml.paths import (
    COMPOSITION,
    COMPOSITIONS,
    ECUS,
    I_SIGNALS,
    IMPLEMENTATIONS,
    INTERFACES,
    PROTOTYPE,
    SYSTEM_SIGNALS,
    SYSTEMS,
    VARIABLE,
)
from sigcat.adapter.autosar_classic.arxml.ports import port_tag
from sigcat.integration.autosar_classic.model import ClassicIntegration, SystemSignal
from sigcat.integration.autosar_names import short_name

ROOT = "RootComposition"
ROOT_PROTOTYPE = "ROOT-SW-COMPOSITION-PROTOTYPE"


def system_name(model: ClassicIntegration) -> str:
    """Name of the system, which is the extract of the ECU."""
    return short_name(f"{model.ecu.name}_Extract")


def root_path(model: ClassicIntegration, known: Library) -> str:
    """Path of the root composition in the extract."""
    return known.paths.of(SYSTEMS, system_name(model), ROOT)


def packages(model: ClassicIntegration, known: Library) -> list[Package]:
    """The packages of the file of the system."""
    signals = {each.signal: each for each in model.ecu.signals}
    sized = [each for each in signals.values() if each.length]
    return [
        Package(SYSTEM_SIGNALS, tuple(_signal(each) for each in signals.values())),
        Package(I_SIGNALS, tuple(_i_signal(each, known) for each in sized)),
        Package(ECUS, (tag("ECU-INSTANCE", name=model.ecu.name),)),
        Package(SYSTEMS, (_system(model, sized, known),)),
    ]


def _signal(signal: SystemSignal) -> Tag:
    facts = trace([("Message", signal.message), ("Database", signal.database)])
    return tag("SYSTEM-SIGNAL", facts, tag("DYNAMIC-LENGTH", text="false"), name=signal.signal)


def _i_signal(signal: SystemSignal, known: Library) -> Tag:
    return tag(
        "I-SIGNAL",
        tag("DATA-TYPE-POLICY", text="LEGACY"),
        tag("LENGTH", text=signal.length),
        reference("SYSTEM-SIGNAL-REF", known.paths.of(SYSTEM_SIGNALS, signal.signal), "SYSTEM-SIGNAL"),
        name=short_name(f"I_{signal.signal}"),
    )


def _system(model: ClassicIntegration, sized: list[SystemSignal], known: Library) -> Tag:
    members = [reference("FIBEX-ELEMENT-REF", known.paths.of(ECUS, model.ecu.name), "ECU-INSTANCE")]
    members += [
        reference("FIBEX-ELEMENT-REF", known.paths.of(I_SIGNALS, short_name(f"I_{each.signal}")), "I-SIGNAL")
        for each in sized
    ]
    composition = known.paths.of(COMPOSITIONS, model.composition.name)
    mapping = tag(
        "SYSTEM-MAPPING",
        listed("DATA-MAPPINGS", (_data_mapping(each, model, known) for each in model.ecu.signals)),
        listed("SW-IMPL-MAPPINGS", (_implementation(each.name, model, known) for each in model.components)),
        tag("SW-MAPPINGS", _ecu_mapping(model, known)),
        name="Mapping",
    )
    return tag(
        "SYSTEM",
        tag("CATEGORY", text="ECU_EXTRACT"),
        tag("ECU-EXTRACT-VERSION", text=model.meta.version),
        tag("FIBEX-ELEMENTS", *(tag("FIBEX-ELEMENT-REF-CONDITIONAL", each) for each in members)),
        tag("MAPPINGS", mapping),
        tag(
            "ROOT-SOFTWARE-COMPOSITIONS",
            tag(ROOT_PROTOTYPE, reference("SOFTWARE-COMPOSITION-TREF", composition, COMPOSITION), name=ROOT),
        ),
        tag("SYSTEM-VERSION", text=model.meta.version),
        name=system_name(model),
    )


def _component(tag_name: str, prototype: str, model: ClassicIntegration, known: Library) -> Tag:
    return tag(
        tag_name,
        reference("CONTEXT-COMPOSITION-REF", root_path(model, known), ROOT_PROTOTYPE),
        reference("TARGET-COMPONENT-REF", prototype_path(prototype, model.composition, known), PROTOTYPE),
    )


def _ecu_mapping(model: ClassicIntegration, known: Library) -> Tag:
    components = (_component("COMPONENT-IREF", each.name, model, known) for each in model.composition.prototypes)
    return tag(
        "SWC-TO-ECU-MAPPING",
        listed("COMPONENT-IREFS", components),
        reference("ECU-INSTANCE-REF", known.paths.of(ECUS, model.ecu.name), "ECU-INSTANCE"),
        name="ComponentsToEcu",
    )


def _implementation(component: str, model: ClassicIntegration, known: Library) -> Tag:
    prototypes = [each.name for each in model.composition.prototypes if each.type == component]
    path = known.paths.of(IMPLEMENTATIONS, implementation_name(component))
    return tag(
        "SWC-TO-IMPL-MAPPING",
        reference("COMPONENT-IMPLEMENTATION-REF", path, "SWC-IMPLEMENTATION"),
        listed("COMPONENT-IREFS", (_component("COMPONENT-IREF", each, model, known) for each in prototypes)),
        name=short_name(f"{component}_ToImplementation"),
    )


def _data_mapping(signal: SystemSignal, model: ClassicIntegration, known: Library) -> Tag:
    outer = next(each for each in model.composition.ports if each.name == signal.port)
    port = known.paths.of(COMPOSITIONS, model.composition.name, outer.name)
    element = known.paths.of(INTERFACES, outer.interface, signal.element)
    return tag(
        "SENDER-RECEIVER-TO-SIGNAL-MAPPING",
        tag("COMMUNICATION-DIRECTION", text="OUT" if outer.direction == "Provided" else "IN"),
        tag(
            "DATA-ELEMENT-IREF",
            reference("CONTEXT-COMPOSITION-REF", root_path(model, known), ROOT_PROTOTYPE),
            reference("CONTEXT-PORT-REF", port, port_tag(outer.direction)),
            reference("TARGET-DATA-PROTOTYPE-REF", element, VARIABLE),
        ),
        reference("SYSTEM-SIGNAL-REF", known.paths.of(SYSTEM_SIGNALS, signal.signal), "SYSTEM-SIGNAL"),
    )
