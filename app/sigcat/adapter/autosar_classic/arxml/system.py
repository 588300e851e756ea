"""The extract of the ECU: its root composition, which component runs on it, which element is which signal."""

from collections.abc import Iterable

from sigcat.adapter.arxml.tree import Package, Tag, conditional, listed, reference, tag, trace
from sigcat.adapter.autosar_classic.arxml import paths
from sigcat.adapter.autosar_classic.arxml.components import implementation_name
from sigcat.adapter.autosar_classic.arxml.library import Library
from sigcat.adapter.autosar_classic.arxml.ports import port_reference
from sigcat.integration.autosar_classic.model import ClassicIntegration, Prototype, SystemSignal
from sigcat.integration.autosar_names import short_name

ROOT = "RootComposition"
ROOT_PROTOTYPE = "ROOT-SW-COMPOSITION-PROTOTYPE"


def system_name(model: ClassicIntegration) -> str:
    """Name of the system, which is the extract of the ECU."""
    return short_name(f"{model.ecu.name}_Extract")


def root_reference(tag_name: str, known: Library) -> Tag:
    """Reference to the root composition in the extract."""
    return reference(tag_name, known.path(paths.SYSTEMS, system_name(known.model), ROOT), ROOT_PROTOTYPE)


def ecu_reference(tag_name: str, known: Library) -> Tag:
    """Reference to the ECU."""
    return reference(tag_name, known.path(paths.ECUS, known.model.ecu.name), "ECU-INSTANCE")


def packages(known: Library) -> list[Package]:
    """The packages of the file of the system."""
    model = known.model
    signals = {each.signal: each for each in model.ecu.signals}
    sized = [each for each in signals.values() if each.length]
    return [
        Package(paths.SYSTEM_SIGNALS, tuple(_signal(each) for each in signals.values())),
        Package(paths.I_SIGNALS, tuple(_i_signal(each, known) for each in sized)),
        Package(paths.ECUS, (tag("ECU-INSTANCE", name=model.ecu.name),)),
        Package(paths.SYSTEMS, (_system(sized, known),)),
    ]


def _signal(signal: SystemSignal) -> Tag:
    facts = trace([("Message", signal.message), ("Database", signal.database)])
    return tag("SYSTEM-SIGNAL", facts, {"DYNAMIC-LENGTH": False}, name=signal.signal)


def _i_signal_name(signal: SystemSignal) -> str:
    return short_name(f"I_{signal.signal}")


def _i_signal(signal: SystemSignal, known: Library) -> Tag:
    content = {"DATA-TYPE-POLICY": "LEGACY", "LENGTH": signal.length}
    return tag("I-SIGNAL", content, _signal_reference(signal, known), name=_i_signal_name(signal))


def _signal_reference(signal: SystemSignal, known: Library) -> Tag:
    return reference("SYSTEM-SIGNAL-REF", known.path(paths.SYSTEM_SIGNALS, signal.signal), "SYSTEM-SIGNAL")


def _system(sized: list[SystemSignal], known: Library) -> Tag:
    model = known.model
    targets = (known.path(paths.I_SIGNALS, _i_signal_name(each)) for each in sized)
    signals = (reference("FIBEX-ELEMENT-REF", path, "I-SIGNAL") for path in targets)
    members = (ecu_reference("FIBEX-ELEMENT-REF", known), *signals)
    composition = known.path(paths.COMPOSITIONS, model.composition.name)
    root = tag(ROOT_PROTOTYPE, reference("SOFTWARE-COMPOSITION-TREF", composition, paths.COMPOSITION), name=ROOT)
    mapping = tag(
        "SYSTEM-MAPPING",
        listed("DATA-MAPPINGS", (_data_mapping(each, known) for each in model.ecu.signals)),
        listed("SW-IMPL-MAPPINGS", (_implementation(each.name, known) for each in model.components)),
        tag("SW-MAPPINGS", _ecu_mapping(known)),
        name="Mapping",
    )
    return tag(
        "SYSTEM",
        {"CATEGORY": "ECU_EXTRACT", "ECU-EXTRACT-VERSION": model.meta.version, "SYSTEM-VERSION": model.meta.version},
        listed("FIBEX-ELEMENTS", map(conditional, members)),
        tag("MAPPINGS", mapping),
        tag("ROOT-SOFTWARE-COMPOSITIONS", root),
        name=system_name(model),
    )


def _components(prototypes: Iterable[Prototype], known: Library) -> Tag | None:
    """References to components of the composition, as it is in the extract."""
    root = root_reference("CONTEXT-COMPOSITION-REF", known)
    targets = (known.prototype("TARGET-COMPONENT-REF", each.name) for each in prototypes)
    return listed("COMPONENT-IREFS", (tag("COMPONENT-IREF", root, target) for target in targets))


def _ecu_mapping(known: Library) -> Tag:
    components = _components(known.model.composition.prototypes, known)
    return tag("SWC-TO-ECU-MAPPING", components, ecu_reference("ECU-INSTANCE-REF", known), name="ComponentsToEcu")


def _implementation(component: str, known: Library) -> Tag:
    path = known.path(paths.IMPLEMENTATIONS, implementation_name(component))
    return tag(
        "SWC-TO-IMPL-MAPPING",
        reference("COMPONENT-IMPLEMENTATION-REF", path, "SWC-IMPLEMENTATION"),
        _components((each for each in known.model.composition.prototypes if each.type == component), known),
        name=short_name(f"{component}_ToImplementation"),
    )


def _data_mapping(signal: SystemSignal, known: Library) -> Tag:
    composition = known.model.composition
    outer = next(each for each in composition.ports if each.name == signal.port)
    port = known.path(paths.COMPOSITIONS, composition.name, outer.name)
    element = known.path(paths.INTERFACES, outer.interface, signal.element)
    return tag(
        "SENDER-RECEIVER-TO-SIGNAL-MAPPING",
        {"COMMUNICATION-DIRECTION": "OUT" if outer.direction == "Provided" else "IN"},
        tag(
            "DATA-ELEMENT-IREF",
            root_reference("CONTEXT-COMPOSITION-REF", known),
            port_reference("CONTEXT-PORT-REF", port, outer.direction),
            reference("TARGET-DATA-PROTOTYPE-REF", element, paths.VARIABLE),
        ),
        _signal_reference(signal, known),
    )
