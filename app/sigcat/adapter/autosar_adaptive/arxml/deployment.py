"""Function group, processes, SOME/IP deployments, service instances and their mapping to ports."""

from collections.abc import Iterable, Sequence

from sigcat.adapter.arxml.paths import Paths
from sigcat.adapter.arxml.tree import Package, Tag, listed, reference, seconds, tag
from sigcat.adapter.autosar_adaptive.arxml import e2e, health, someip
from sigcat.adapter.autosar_adaptive.arxml.components import (
    design_name,
    executables,
    port_name,
    root_name,
)
from sigcat.adapter.autosar_adaptive.arxml.interfaces import Whole
from sigcat.adapter.autosar_adaptive.arxml.paths import (
    COMPONENTS,
    DEPLOYMENTS,
    EXECUTABLES,
    FUNCTION_GROUPS,
    INSTANCES,
    INTERFACES,
    MAPPINGS,
    PROCESS_DESIGNS,
    PROCESSES,
    STARTUP,
)
from sigcat.adapter.autosar_adaptive.arxml.releases import Release
from sigcat.adapter.autosar_adaptive.arxml.someip import EVENT, NOTIFIER, element_name
from sigcat.integration.autosar_adaptive.model import Component, Event, IntegrationModel, ServiceField, ServiceInterface
from sigcat.integration.autosar_adaptive.processes import Process, processes
from sigcat.integration.autosar_adaptive.startup import NO_STARTUP, StartupSettings
from sigcat.integration.autosar_names import short_name

OFF = "Off"
"""State in which nothing of a function group runs; AUTOSAR wants every function group to have it and to begin in it."""
STARTUP_SET = "StartupConfigurationSet"
GROUP_SUFFIX = "_Group"
DEPLOYMENT = "SOMEIP-SERVICE-INTERFACE-DEPLOYMENT"


def packages(model: IntegrationModel, services: Sequence[Whole], release: Release, paths: Paths) -> list[Package]:
    """The packages of the file of deployment."""
    assert model.deployment is not None
    components, function_group = model.components, model.deployment.function_group
    run = processes(components)
    pairs = [(process, interface) for process in run for interface in process.services]
    return [
        Package(FUNCTION_GROUPS, _function_groups(components, function_group, paths)),
        Package(STARTUP, _startups(components, release)),
        Package(PROCESSES, tuple(_process(each, function_group, release, paths) for each in run)),
        Package(DEPLOYMENTS, tuple(_deployment(service, paths) for service in services)),
        *someip.packages(model.deployment, services, release, paths),
        e2e.package(model),
        health.package(run, _states(components, function_group, paths), release, paths),
        Package(INSTANCES, tuple(_instance(*pair, paths) for pair in pairs)),
        Package(MAPPINGS, tuple(_mapping(*pair, release, paths) for pair in pairs)),
    ]


# -- function group and processes ---------------------------------------------------------------------------------


def _states_name(function_group: str) -> str:
    return short_name(f"{function_group}_States")


def _set_name(function_group: str) -> str:
    return short_name(f"{function_group}_Set")


def _function_groups(components: Iterable[Component], group: str, paths: Paths) -> tuple[Tag, ...]:
    modes = dict.fromkeys(mode for component in components for mode in component.modes)
    states = [OFF, *(mode for mode in modes if mode != OFF)]
    declared = (tag("MODE-DECLARATION", name=state) for state in states)
    path = paths.of(FUNCTION_GROUPS, _states_name(group))
    prototype = tag(
        "MODE-DECLARATION-GROUP-PROTOTYPE", reference("TYPE-TREF", path, "MODE-DECLARATION-GROUP"), name=group
    )
    return (
        tag(
            "MODE-DECLARATION-GROUP",
            reference("INITIAL-MODE-REF", f"{path}/{OFF}", "MODE-DECLARATION"),
            listed("MODE-DECLARATIONS", declared),
            name=_states_name(group),
        ),
        tag("FUNCTION-GROUP-SET", tag("FUNCTION-GROUPS", prototype), name=_set_name(group)),
    )


def _startup_name(component: Component) -> str:
    return short_name(f"{component.name}_Startup")


def _startups(components: Iterable[Component], release: Release) -> tuple[Tag, ...]:
    configurations = tuple(map(_startup, components))
    if not release.has_sets:
        return configurations
    return (tag("STARTUP-CONFIG-SET", listed("STARTUP-CONFIGS", configurations), name=STARTUP_SET),)


def _startup_path(component: Component, release: Release, paths: Paths) -> str:
    names = (STARTUP_SET, _startup_name(component)) if release.has_sets else (_startup_name(component),)
    return paths.of(STARTUP, *names)


def _startup(component: Component) -> Tag:
    chosen = component.startup or NO_STARTUP
    variables = (
        tag("TAG-WITH-OPTIONAL-VALUE", tag("KEY", text=key), tag("VALUE", text=value))
        for key, value in (chosen.environment or {}).items()
    )
    arguments = (tag("PROCESS-ARGUMENT", tag("ARGUMENT", text=each)) for each in chosen.arguments or ())
    return tag(
        "STARTUP-CONFIG",
        listed("ENVIRONMENT-VARIABLES", variables),
        listed("PROCESS-ARGUMENTS", arguments),
        tag("SCHEDULING-POLICY", text=chosen.policy),
        tag("SCHEDULING-PRIORITY", text=chosen.priority),
        tag("TERMINATION-BEHAVIOR", text="PROCESS-IS-NOT-SELF-TERMINATING"),
        _timeout(chosen),
        name=_startup_name(component),
    )


def _timeout(chosen: StartupSettings) -> Tag | None:
    limits = {"ENTER-TIMEOUT-VALUE": chosen.enter_timeout, "EXIT-TIMEOUT-VALUE": chosen.exit_timeout}
    return listed("TIMEOUT", (tag(name, text=seconds(limit)) for name, limit in limits.items() if limit is not None))


def _process(process: Process, group: str, release: Release, paths: Paths) -> Tag:
    component = process.component
    states = listed("FUNCTION-GROUP-STATE-IREFS", (_state(mode, group, paths) for mode in component.modes))
    startup = reference("STARTUP-CONFIG-REF", _startup_path(component, release, paths), "STARTUP-CONFIG")
    attempts = component.startup.restart_attempts if component.startup else None
    return tag(
        "PROCESS",
        reference("DESIGN-REF", paths.of(PROCESS_DESIGNS, design_name(component)), "PROCESS-DESIGN"),
        executables(component, release, paths),
        tag("NUMBER-OF-RESTART-ATTEMPTS", text=attempts) if attempts is not None else None,
        tag("STATE-DEPENDENT-STARTUP-CONFIGS", tag("STATE-DEPENDENT-STARTUP-CONFIG", states, startup)),
        name=process.name,
    )


def _states(components: Iterable[Component], group: str, paths: Paths) -> dict[str, Tag]:
    return {mode: _state(mode, group, paths) for component in components for mode in component.modes}


def _state(mode: str, group: str, paths: Paths) -> Tag:
    prototype = paths.of(FUNCTION_GROUPS, _set_name(group), group)
    target = paths.of(FUNCTION_GROUPS, _states_name(group), mode)
    return tag(
        "FUNCTION-GROUP-STATE-IREF",
        reference("CONTEXT-MODE-DECLARATION-GROUP-PROTOTYPE-REF", prototype, "MODE-DECLARATION-GROUP-PROTOTYPE"),
        reference("TARGET-MODE-DECLARATION-REF", target, "MODE-DECLARATION"),
    )


# -- SOME/IP ------------------------------------------------------------------------------------------------------


def deployment_name(service: str) -> str:
    """Name of the SOME/IP deployment of a service."""
    return short_name(f"{service}_SomeIp")


def _deployment(service: Whole, paths: Paths) -> Tag:
    interface = paths.of(INTERFACES, service.name)
    own, protocol = paths.of(DEPLOYMENTS, deployment_name(service.name)), service.transport.protocol
    return tag(
        DEPLOYMENT,
        listed("EVENT-DEPLOYMENTS", (_event(each, interface, protocol) for each in service.events)),
        listed("FIELD-DEPLOYMENTS", (_field(each, interface, protocol) for each in service.fields)),
        listed("METHOD-DEPLOYMENTS", (_method(m.name, m.method_id, interface, protocol) for m in service.methods)),
        reference("SERVICE-INTERFACE-REF", interface, "SERVICE-INTERFACE"),
        listed("EVENT-GROUPS", (_group(name, number, service, own) for name, number in _groups(service))),
        tag("SERVICE-INTERFACE-ID", text=service.service_id),
        tag(
            "SERVICE-INTERFACE-VERSION",
            tag("MAJOR-VERSION", text=service.version.major),
            tag("MINOR-VERSION", text=service.version.minor),
        ),
        name=deployment_name(service.name),
    )


def _groups(service: Whole) -> list[tuple[str, int]]:
    return [(group.name, group.id) for group in service.event_groups]


def _event(event: Event, interface: str, protocol: str) -> Tag:
    return tag(
        EVENT,
        reference("EVENT-REF", f"{interface}/{event.name}", "VARIABLE-DATA-PROTOTYPE"),
        tag("EVENT-ID", text=event.event_id),
        *([tag("MAXIMUM-SEGMENT-LENGTH", text=event.segment_length)] if event.segment_length else []),
        tag("TRANSPORT-PROTOCOL", text=protocol),
        name=element_name(event.name),
    )


def _field(field: ServiceField, interface: str, protocol: str) -> Tag:
    name, notifier, getter = field.name, field.notifier_id, field.getter_id
    return tag(
        "SOMEIP-FIELD-DEPLOYMENT",
        reference("FIELD-REF", f"{interface}/{name}", "FIELD"),
        tag("GET", tag("METHOD-ID", text=getter), tag("TRANSPORT-PROTOCOL", text=protocol), name="Get")
        if getter
        else None,
        tag("NOTIFIER", tag("EVENT-ID", text=notifier), tag("TRANSPORT-PROTOCOL", text=protocol), name=NOTIFIER),
        name=element_name(name),
    )


def _method(name: str, number: int | None, interface: str, protocol: str) -> Tag:
    return tag(
        "SOMEIP-METHOD-DEPLOYMENT",
        reference("METHOD-REF", f"{interface}/{name}", "CLIENT-SERVER-OPERATION"),
        tag("METHOD-ID", text=number),
        tag("TRANSPORT-PROTOCOL", text=protocol),
        name=element_name(name),
    )


def group_name(name: str) -> str:
    """Name of an event group; no deployment of an event ends like it."""
    return short_name(f"{name}{GROUP_SUFFIX}")


def _group(name: str, number: int, service: Whole, own: str) -> Tag:
    events = [f"{own}/{element_name(event.name)}" for event in service.events if event.event_group == name]
    fields = [f"{own}/{element_name(field.name)}/{NOTIFIER}" for field in service.fields if field.event_group == name]
    references = (reference("EVENT-REF", path, EVENT) for path in (*events, *fields))
    return tag(
        "SOMEIP-EVENT-GROUP",
        tag("EVENT-GROUP-ID", text=number),
        listed("EVENT-REFS", references),
        name=group_name(name),
    )


# -- instances ----------------------------------------------------------------------------------------------------


def instance_name(process: Process, interface: ServiceInterface) -> str:
    """Name of a process's instance of a service."""
    return short_name(f"{process.stem}_{port_name(interface)}_Instance")


def _instance(process: Process, interface: ServiceInterface, paths: Paths) -> Tag:
    own = paths.of(DEPLOYMENTS, deployment_name(interface.name))
    is_provider = interface.role == "Provider"
    word = "PROVIDED" if is_provider else "REQUIRED"
    groups = (
        tag(
            f"SOMEIP-{word}-EVENT-GROUP",
            reference("EVENT-GROUP-REF", f"{own}/{group_name(group.name)}", "SOMEIP-EVENT-GROUP"),
            *(_multicast(interface) if is_provider else ()),
            someip.event_group_timing(provides=is_provider, paths=paths),
            name=group_name(group.name),
        )
        for group in interface.event_groups or ()
    )
    return tag(
        f"{word}-SOMEIP-SERVICE-INSTANCE",
        e2e.properties(interface, own, paths),
        reference("SERVICE-INTERFACE-DEPLOYMENT-REF", own, DEPLOYMENT),
        listed(f"{word}-EVENT-GROUPS", groups),
        someip.instance_timing(provides=is_provider, paths=paths),
        tag("SERVICE-INSTANCE-ID" if is_provider else "REQUIRED-SERVICE-INSTANCE-ID", text=interface.instance_id),
        name=instance_name(process, interface),
    )


def _multicast(interface: ServiceInterface) -> Iterable[Tag]:
    """Multicast address of an event group, and the number of subscribers from which it is used."""
    chosen = interface.transport.multicast if interface.transport else None
    if chosen is not None:
        yield tag("EVENT-MULTICAST-UDP-PORT", text=chosen.port)
        yield tag("IPV-4-MULTICAST-IP-ADDRESS", text=chosen.address)
        yield tag("MULTICAST-THRESHOLD", text=chosen.threshold)


def _mapping(process: Process, interface: ServiceInterface, release: Release, paths: Paths) -> Tag:
    component = process.component
    is_provider = interface.role == "Provider"
    root = paths.of(EXECUTABLES, component.executable, root_name(component))
    port = paths.of(COMPONENTS, component.name, port_name(interface))
    instance = paths.of(INSTANCES, instance_name(process, interface))
    kind = f"{'PROVIDED' if is_provider else 'REQUIRED'}-SOMEIP-SERVICE-INSTANCE"
    return tag(
        "SERVICE-INSTANCE-TO-PORT-PROTOTYPE-MAPPING",
        tag(
            "PORT-PROTOTYPE-IREF",
            reference("CONTEXT-ROOT-SW-COMPONENT-PROTOTYPE-REF", root, "ROOT-SW-COMPONENT-PROTOTYPE")
            if release.has_root_of_port
            else None,
            reference("TARGET-PORT-PROTOTYPE-REF", port, "P-PORT-PROTOTYPE" if is_provider else "R-PORT-PROTOTYPE"),
        ),
        reference("PROCESS-REF", paths.of(PROCESSES, process.name), "PROCESS"),
        reference("SERVICE-INSTANCE-REF", instance, kind),
        name=short_name(f"{instance_name(process, interface)}_Mapping"),
    )
