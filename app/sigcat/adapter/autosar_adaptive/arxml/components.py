"""Application component types with their ports, stored parameters, and executables with their root components."""

from collections.abc import Iterable

from pydantic import BaseModel

from sigcat.adapter.arxml.paths import Paths
from sigcat.adapter.arxml.tree import Package, Tag, description, listed, reference, tag, trace
from sigcat.adapter.autosar_adaptive.arxml.paths import (
    COMPONENTS,
    EXECUTABLES,
    INTERFACES,
    MONITORS,
    PROCESS_DESIGNS,
    STORAGES,
    SUPERVISIONS,
    TYPE,
)
from sigcat.adapter.autosar_adaptive.arxml.releases import Release
from sigcat.adapter.autosar_adaptive.arxml.types import Library, Presentation
from sigcat.integration.autosar_adaptive.code import MethodUse
from sigcat.integration.autosar_adaptive.model import Call, Component, Method, ServiceInterface, Use
from sigcat.integration.autosar_adaptive.storages import ADAPTER_STORAGE, StoredParameter, storage_name, storages
from sigcat.integration.autosar_names import short_name

COMPONENT = "ADAPTIVE-APPLICATION-SW-COMPONENT-TYPE"
STORAGE = "PERSISTENCY-KEY-VALUE-STORAGE-INTERFACE"
MONITOR = "DIAGNOSTIC-MONITOR-INTERFACE"
MONITOR_NAME = "ErrorMonitor"
SUPERVISION = "PHM-SUPERVISED-ENTITY-INTERFACE"
SUPERVISION_PORT = "Supervision"
IGNITION_CYCLE = "IgnitionCycle"
COUNTS = (("Occurrences", "uint16_t"), ("IgnitionCycles", "uint16_t"), ("HasFailed", "bool"), ("IsTested", "bool"))
"""Stored values of each error: keys after its name, and words of their datatypes."""


def packages(components: Iterable[Component], known: Library, release: Release) -> list[Package]:
    """The packages of the file of components."""
    listed_components = list(components)
    return [
        Package(STORAGES, tuple(_storages(listed_components, known))),
        Package(MONITORS, (tag(MONITOR, name=MONITOR_NAME),) if any(map(reported_errors, listed_components)) else ()),
        Package(SUPERVISIONS, tuple(_supervision(item) for item in listed_components if checkpoints(item))),
        Package(COMPONENTS, tuple(_component(item, known) for item in listed_components)),
        Package(EXECUTABLES, tuple(_executable(item, known) for item in listed_components)),
        Package(PROCESS_DESIGNS, tuple(_process_design(item, release, known) for item in listed_components)),
    ]


def port_name(interface: ServiceInterface) -> str:
    """Name of the port of a service."""
    return short_name(f"{interface.name}_{'P' if interface.role == 'Provider' else 'R'}Port")


def root_name(component: Component) -> str:
    """Name of the root component of an executable."""
    return short_name(f"{component.name}_Root")


def _component(component: Component, known: Library) -> Tag:
    ports = [_port(interface, known) for interface in component.services]
    ports += (_storage_port(component, name, known, is_written=both) for name, both in storage_ports(component).items())
    ports += (_monitor_port(name, known) for name in reported_errors(component))
    if checkpoints(component):
        ports.append(_supervision_port(component, known))
    return tag(
        COMPONENT,
        description(component.description),
        trace(_facts(component)),
        listed("PORTS", ports),
        name=component.name,
    )


def _facts(component: Component) -> list[tuple[str, object]]:
    """Fields of a component for which the metamodel has no place."""
    identity = [("Function", component.function), ("Version", component.version)]
    return [
        *identity,
        ("Code", _dumped(component.code)),
        *_headers(component),
        *_modes(component),
        *_calls(component.calls),
    ]


def _dumped(part: BaseModel | None) -> dict[str, object] | None:
    return part.model_dump(mode="json", exclude_none=True) if part is not None else None


def _headers(component: Component) -> list[tuple[str, object]]:
    return [("HeaderFile", header) for header in component.header_files or ()]


def _modes(component: Component) -> list[tuple[str, object]]:
    facts: list[tuple[str, object]] = []
    for mode in component.function_modes or ():
        facts.append(("Mode", f"{mode.name}: {', '.join(mode.calls or ()) or 'no call'}"))
        facts.append((f"Mode.{mode.name}.Description", mode.description))
    return facts


def _calls(calls: Iterable[Call]) -> list[tuple[str, object]]:
    """Calls have no element in the manifests of AUTOSAR adaptive: each is listed with its fields, `name.field`."""
    facts: list[tuple[str, object]] = []
    for call in calls:
        facts.append(("Call", call.name))
        written = call.model_dump(mode="json", exclude_none=True)
        facts.extend((f"{call.name}.{field}", value) for field, value in written.items() if field != "Name")
    return facts


def _port(interface: ServiceInterface, known: Library) -> Tag:
    path = known.paths.of(INTERFACES, interface.name)
    if interface.role == "Provider":
        target = reference("PROVIDED-INTERFACE-TREF", path, "SERVICE-INTERFACE")
        return tag("P-PORT-PROTOTYPE", _mapped(interface), target, name=port_name(interface))
    target = reference("REQUIRED-INTERFACE-TREF", path, "SERVICE-INTERFACE")
    return tag("R-PORT-PROTOTYPE", _mapped(interface), target, name=port_name(interface))


def _mapped(interface: ServiceInterface) -> Tag | None:
    """Use of the service by the component: the calls that use each element, and how the code stores values."""
    facts: list[tuple[str, object]] = [
        fact for provider in interface.providers or () for fact in (("Provider", provider.name), ("Contract", provider.contract))
    ]  # fmt: skip
    for services in interface.services:
        for event in services.events:
            facts.extend((f"{event.name}.DataMapping", variable) for variable in event.data_mapping or ())
            facts.extend((f"{event.name}.{use.call}", _used(use)) for use in event.uses or ())
        facts.extend((f"{field.name}.Calls", field.calls) for field in services.fields)
        facts.extend((f"{method.name}.Calls", method.calls) for method in services.methods)
        facts.extend(fact for method in services.methods for fact in _arguments(method))
        facts.extend(
            (f"{method.name}.{use.call}", _method_used(use)) for method in services.methods for use in method.uses or ()
        )
    return trace(facts)


def _used(use: Use) -> dict[str, object]:
    """The interface of the function, and how its code holds the value."""
    interface = use.signal or use.queue
    written = use.model_dump(mode="json", exclude={"call", "component", "signal", "queue"}, exclude_none=True)
    return written | (interface.model_dump(mode="json", exclude_none=True) if interface else {})


def _arguments(method: Method) -> Iterable[tuple[str, object]]:
    for argument in (*(method.inputs or ()), *(method.outputs or ())):
        yield f"{method.name}.{argument.name}.CodeDatatype", argument.code_datatype


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


def _monitor_port(error: str, known: Library) -> Tag:
    path = known.paths.of(MONITORS, MONITOR_NAME)
    return tag("R-PORT-PROTOTYPE", reference("REQUIRED-INTERFACE-TREF", path, MONITOR), name=monitor_port(error))


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
        tag("PHM-CHECKPOINT", tag("CHECKPOINT-ID", text=number), name=short_name(call))
        for number, call in enumerate(checkpoints(component))
    )
    return tag(SUPERVISION, listed("CHECKPOINTS", reported), name=supervision_name(component))


def _supervision_port(component: Component, known: Library) -> Tag:
    path = known.paths.of(SUPERVISIONS, supervision_name(component))
    return tag("R-PORT-PROTOTYPE", reference("REQUIRED-INTERFACE-TREF", path, SUPERVISION), name=SUPERVISION_PORT)


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


def _storage_port(component: Component, storage: str, known: Library, *, is_written: bool) -> Tag:
    path = known.paths.of(STORAGES, storage_name(component, storage))
    if is_written:
        return tag("PR-PORT-PROTOTYPE", reference("PROVIDED-REQUIRED-INTERFACE-TREF", path, STORAGE), name=storage)
    return tag("R-PORT-PROTOTYPE", reference("REQUIRED-INTERFACE-TREF", path, STORAGE), name=storage)


def _storages(components: Iterable[Component], known: Library) -> Iterable[Tag]:
    for component in components:
        for name, stored in storages(component).items():
            elements = [_parameter(each, known) for each in stored]
            yield tag(STORAGE, listed("DATA-ELEMENTS", elements), name=storage_name(component, name))
        if reported_errors(component):
            counts = [_count(key, word, known) for key, word in stored_counts(component)]
            yield tag(STORAGE, listed("DATA-ELEMENTS", counts), name=storage_name(component, ADAPTER_STORAGE))


def _count(key: str, word: str, known: Library) -> Tag:
    return tag("PERSISTENCY-DATA-ELEMENT", reference("TYPE-TREF", known.type_path(word), TYPE), name=key)


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
        ("Scaling", kind.scaling), ("Offset", kind.offset), ("Code", _dumped(parameter.code)),
    ]  # fmt: skip
    return tag(
        "PERSISTENCY-DATA-ELEMENT",
        description(parameter.description),
        trace(facts),
        known.properties(Presentation(kind.unit or None, None, None, kind.min, kind.max)),
        reference("TYPE-TREF", known.type_path(kind.word), TYPE),
        name=stored.key,
    )


def _executable(component: Component, known: Library) -> Tag:
    path = known.paths.of(COMPONENTS, component.name)
    root = tag(
        "ROOT-SW-COMPONENT-PROTOTYPE", reference("APPLICATION-TYPE-TREF", path, COMPONENT), name=root_name(component)
    )
    return tag(
        "EXECUTABLE",
        tag("CATEGORY", text="APPLICATION_LEVEL"),
        tag("REPORTING-BEHAVIOR", text="REPORTS-EXECUTION-STATE"),
        root,
        name=component.executable,
    )


def _process_design(component: Component, release: Release, known: Library) -> Tag:
    executable = executables(component, release, known.paths)
    return tag("PROCESS-DESIGN", executable, name=design_name(component))


def executables(component: Component, release: Release, paths: Paths) -> Tag:
    """Reference to an executable from a process, or from its design."""
    executable = reference("EXECUTABLE-REF", paths.of(EXECUTABLES, component.executable), "EXECUTABLE")
    return executable if release.has_one_executable else tag("EXECUTABLE-REFS", executable)


def design_name(component: Component) -> str:
    """Name of the design of a component's process."""
    return short_name(f"{component.name}_Design")
