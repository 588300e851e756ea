"""Application component types with their ports, stored parameters, and executables with their root components."""

from collections.abc import Iterable, Sequence
from typing import Literal

from sigcat.adapter.arxml.tree import Package, Tag, description, listed, port, reference, tag, trace
from sigcat.adapter.autosar_adaptive.arxml import paths
from sigcat.adapter.autosar_adaptive.arxml.adaptive_type_elements import Library, parameter_presentation
from sigcat.integration.autosar_adaptive.code import MethodUse
from sigcat.integration.autosar_adaptive.model import Component, ServiceInterface, Use
from sigcat.integration.autosar_adaptive.storages import ADAPTER_STORAGE, StoredParameter, storage_name, storages
from sigcat.integration.autosar_names import short_name

COMPONENT = "ADAPTIVE-APPLICATION-SW-COMPONENT-TYPE"
STORAGE = "PERSISTENCY-KEY-VALUE-STORAGE-INTERFACE"
MONITOR = "DIAGNOSTIC-MONITOR-INTERFACE"
MONITOR_NAME = "ErrorMonitor"
SUPERVISION = "PHM-SUPERVISED-ENTITY-INTERFACE"
SUPERVISION_PORT = "Supervision"
IGNITION_CYCLE = "IgnitionCycle"
DATA_ELEMENT = "PERSISTENCY-DATA-ELEMENT"
COUNTS = (("Occurrences", "uint16_t"), ("IgnitionCycles", "uint16_t"), ("HasFailed", "bool"), ("IsTested", "bool"))
"""Stored values of each error: keys after its name, and words of their datatypes."""


def packages(components: Sequence[Component], known: Library) -> list[Package]:
    """The packages of the file of components."""
    return [
        Package(paths.STORAGES, tuple(storage for each in components for storage in _storages(each, known))),
        Package(paths.MONITORS, (tag(MONITOR, name=MONITOR_NAME),) if any(map(reported_errors, components)) else ()),
        Package(paths.SUPERVISIONS, tuple(_supervision(each) for each in components if checkpoints(each))),
        Package(paths.COMPONENTS, tuple(_component(each, known) for each in components)),
        Package(paths.EXECUTABLES, tuple(_executable(each, known) for each in components)),
        Package(
            paths.PROCESS_DESIGNS,
            tuple(tag("PROCESS-DESIGN", executables(each, known), name=design_name(each)) for each in components),
        ),
    ]


def port_name(interface: ServiceInterface) -> str:
    """Name of the port of a service."""
    return short_name(f"{interface.name}_{'P' if interface.role == 'Provider' else 'R'}Port")


def root_name(component: Component) -> str:
    """Name of the root component of an executable."""
    return short_name(f"{component.name}_Root")


def root_reference(component: Component, known: Library) -> Tag:
    """Reference to the root component, as the context of its elements."""
    root = known.path(paths.EXECUTABLES, component.executable, root_name(component))
    return reference("CONTEXT-ROOT-SW-COMPONENT-PROTOTYPE-REF", root, "ROOT-SW-COMPONENT-PROTOTYPE")


def _component(component: Component, known: Library) -> Tag:
    ports = [_port(interface, known) for interface in component.services]
    for name, is_written in storage_ports(component).items():
        storage = known.path(paths.STORAGES, storage_name(component, name))
        ports.append(port("PR" if is_written else "R", storage, STORAGE, name=name))
    monitor = known.path(paths.MONITORS, MONITOR_NAME)
    ports += (port("R", monitor, MONITOR, name=monitor_port(error)) for error in reported_errors(component))
    if checkpoints(component):
        supervision = known.path(paths.SUPERVISIONS, supervision_name(component))
        ports.append(port("R", supervision, SUPERVISION, name=SUPERVISION_PORT))
    text, facts = description(component.description), trace(_facts(component))
    return tag(COMPONENT, text, facts, listed("PORTS", ports), name=component.name)


def _facts(component: Component) -> Iterable[tuple[str, object]]:
    """Fields of a component for which the metamodel has no place, such as its calls."""
    yield from (("Function", component.function), ("Version", component.version), ("Code", component.code))
    yield from (("HeaderFile", header) for header in component.header_files or ())
    for mode in component.function_modes or ():
        yield "Mode", f"{mode.name}: {', '.join(mode.calls or ()) or 'no call'}"
        yield f"Mode.{mode.name}.Description", mode.description
    for call in component.calls:
        yield "Call", call.name
        yield call.name, call.model_dump(mode="json", exclude={"name"})


def _port(interface: ServiceInterface, known: Library) -> Tag:
    side: Literal["P", "R"] = "P" if interface.role == "Provider" else "R"
    path = known.path(paths.INTERFACES, interface.name)
    return port(side, path, "SERVICE-INTERFACE", trace(_uses(interface)), name=port_name(interface))


def _uses(interface: ServiceInterface) -> Iterable[tuple[str, object]]:
    """Use of the service by the component: the calls that use each element, and how the code stores values."""
    for provider in interface.providers or ():
        yield from (("Provider", provider.name), ("Contract", provider.contract))
    for services in interface.services:
        for event in services.events:
            yield from ((f"{event.name}.DataMapping", variable) for variable in event.data_mapping or ())
            yield from ((f"{event.name}.{use.call}", _used(use)) for use in event.uses or ())
        yield from ((f"{field.name}.Calls", field.calls) for field in services.fields)
        yield from ((f"{method.name}.Calls", method.calls) for method in services.methods)
        for method in services.methods:
            for argument in (*(method.inputs or ()), *(method.outputs or ())):
                yield f"{method.name}.{argument.name}.CodeDatatype", argument.code_datatype
        for method in services.methods:
            yield from ((f"{method.name}.{use.call}", _method_used(use)) for use in method.uses or ())


def _used(use: Use) -> dict[str, object]:
    """The interface of the function, and how its code holds the value."""
    interface = use.signal or use.queue
    written = use.model_dump(mode="json", exclude={"call", "component", "signal", "queue"}, exclude_none=True)
    return written | (interface.model_dump(mode="json", exclude_none=True) if interface else {})


def _method_used(use: MethodUse) -> dict[str, object]:
    """The method of the function, without the parts that the service interface has."""
    left_out = {"name", "description", "inputs", "outputs"}
    return {"Function": use.function, **use.method.model_dump(mode="json", exclude=left_out, exclude_none=True)}


def reported_errors(component: Component) -> tuple[str, ...]:
    """Errors that the component reports, by the names of their interfaces."""
    return tuple(
        field.error.name
        for interface in component.services if interface.role == "Provider"
        for services in interface.services
        for field in services.fields if field.error is not None
    )  # fmt: skip


def monitor_port(error: str) -> str:
    """The port that reports an error to the diagnosis."""
    return short_name(f"{error}_Monitor")


def checkpoints(component: Component) -> tuple[str, ...]:
    """Calls whose ends are reported to the health management: those with alive supervision that no mode excludes.

    The health management cannot pause where a mode excludes a call.
    """
    modes = component.function_modes or ()
    return tuple(
        call.name
        for call in component.calls
        if call.watchdog and call.watchdog.alive and all(call.name in (mode.calls or ()) for mode in modes)
    )


def supervision_name(component: Component) -> str:
    """Name of the interface over which a component reports its checkpoints."""
    return short_name(f"{component.name}_Supervision")


def _supervision(component: Component) -> Tag:
    reported = (
        tag("PHM-CHECKPOINT", {"CHECKPOINT-ID": number}, name=short_name(call))
        for number, call in enumerate(checkpoints(component))
    )
    return tag(SUPERVISION, listed("CHECKPOINTS", reported), name=supervision_name(component))


def stored_counts(component: Component) -> Iterable[tuple[str, str]]:
    """Keys and names of the stored data of errors."""
    errors = reported_errors(component)
    yield from [(IGNITION_CYCLE, "uint32")] if errors else ()
    for error in errors:
        yield from ((short_name(f"{error}_{key}"), word) for key, word in COUNTS)


def storage_ports(component: Component) -> dict[str, bool]:
    """Names of the ports of its storages, which are those of the storages; whether it writes there too."""
    ports = {name: any(each.is_learned for each in stored) for name, stored in storages(component).items()}
    return {**ports, ADAPTER_STORAGE: True} if reported_errors(component) else ports


def _storages(component: Component, known: Library) -> Iterable[Tag]:
    for name, stored in storages(component).items():
        elements = [_parameter(each, known) for each in stored]
        yield tag(STORAGE, listed("DATA-ELEMENTS", elements), name=storage_name(component, name))
    counts = [tag(DATA_ELEMENT, known.typed(word), name=key) for key, word in stored_counts(component)]
    if counts:
        yield tag(STORAGE, listed("DATA-ELEMENTS", counts), name=storage_name(component, ADAPTER_STORAGE))


def _parameter(stored: StoredParameter, known: Library) -> Tag:
    """Named by its key, which is what the application reads."""
    parameter, kind = stored.parameter, stored.parameter.datatype
    facts = [
        ("Name", parameter.name if parameter.name != stored.key else None),
        ("VssPath", parameter.vss_path), ("InterfaceType", parameter.interface_type), ("Attribute", parameter.attribute),
        ("Default", kind.default), ("InitValue", kind.init_value), ("RangeErrorAction", parameter.range_error_action),
        ("AsilLevel", parameter.asil_level), ("Variable", parameter.variable),
        ("Function", parameter.function), ("Calls", parameter.calls), ("CodeDatatype", parameter.code_datatype),
        ("VssDatatype", parameter.vss_datatype), ("VssUnit", parameter.vss_unit),
        ("VssSymbols", [each.model_dump(mode="json") for each in parameter.vss_symbols or ()]),
        ("ConversionFactor", parameter.conversion_factor), ("ConversionOffset", parameter.conversion_offset),
        ("Scaling", kind.scaling), ("Offset", kind.offset), ("Code", parameter.code),
    ]  # fmt: skip
    return tag(
        DATA_ELEMENT,
        description(parameter.description),
        trace(facts),
        known.properties(parameter_presentation(parameter)),
        known.typed(kind.word),
        name=stored.key,
    )


def _executable(component: Component, known: Library) -> Tag:
    application = reference("APPLICATION-TYPE-TREF", known.path(paths.COMPONENTS, component.name), COMPONENT)
    root = tag("ROOT-SW-COMPONENT-PROTOTYPE", application, name=root_name(component))
    kind = {"CATEGORY": "APPLICATION_LEVEL", "REPORTING-BEHAVIOR": "REPORTS-EXECUTION-STATE"}
    return tag("EXECUTABLE", kind, root, name=component.executable)


def executables(component: Component, known: Library) -> Tag:
    """Reference to an executable from a process, or from its design."""
    executable = reference("EXECUTABLE-REF", known.path(paths.EXECUTABLES, component.executable), "EXECUTABLE")
    return executable if known.release.has_one_executable else tag("EXECUTABLE-REFS", executable)


def design_name(component: Component) -> str:
    """Name of the design of a component's process."""
    return short_name(f"{component.name}_Design")
