"""Function group, processes, SOME/IP deployments, service instances and their mapping to ports."""

from collections.abc import Iterable, Sequence

from sigcat.adapter.arxml.tree import Child, Package, Tag, listed, reference, references, seconds, tag
from sigcat.adapter.autosar_adaptive.arxml import e2e, health, paths, someip
from sigcat.adapter.autosar_adaptive.arxml.adaptive_type_elements import Library
from sigcat.adapter.autosar_adaptive.arxml.components import design_name, executables, port_name, root_reference
from sigcat.adapter.autosar_adaptive.arxml.interfaces import Whole
from sigcat.adapter.autosar_adaptive.arxml.someip import EVENT, NOTIFIER, element_name
from sigcat.integration.autosar_adaptive import model
from sigcat.integration.autosar_adaptive.deployment.transport import DEFAULT_TRANSPORT
from sigcat.integration.autosar_adaptive.processes import Process, processes
from sigcat.integration.autosar_adaptive.startup import NO_STARTUP
from sigcat.integration.autosar_names import short_name

OFF = "Off"
"""State in which nothing of a function group runs; AUTOSAR wants every function group to have it and to begin in it."""
STARTUP_SET = "StartupConfigurationSet"
GROUP_SUFFIX = "_Group"
DEPLOYMENT = "SOMEIP-SERVICE-INTERFACE-DEPLOYMENT"


def packages(document: model.IntegrationModel, services: Sequence[Whole], known: Library) -> list[Package]:
    """The packages of the file of deployment."""
    assert document.deployment is not None
    components, function_group = document.components, document.deployment.function_group
    states = {mode: _state(mode, function_group, known) for component in components for mode in component.modes}
    run = processes(components)
    pairs = [(process, interface) for process in run for interface in process.services]
    return [
        Package(paths.FUNCTION_GROUPS, _function_groups(components, function_group, known)),
        Package(paths.STARTUP, _startups(components, known)),
        Package(paths.PROCESSES, tuple(_process(each, function_group, known) for each in run)),
        Package(paths.DEPLOYMENTS, tuple(_deployment(service, known) for service in services)),
        *someip.packages(document.deployment, services, known),
        e2e.package(document),
        health.package(run, states, known),
        Package(paths.INSTANCES, tuple(_instance(*pair, known) for pair in pairs)),
        Package(paths.MAPPINGS, tuple(_mapping(*pair, known) for pair in pairs)),
    ]


# -- function group and processes ---------------------------------------------------------------------------------


def _states_name(function_group: str) -> str:
    return short_name(f"{function_group}_States")


def _set_name(function_group: str) -> str:
    return short_name(f"{function_group}_Set")


def _function_groups(components: Iterable[model.Component], group: str, known: Library) -> tuple[Tag, ...]:
    modes = dict.fromkeys(mode for component in components for mode in component.modes)
    states = [OFF, *(mode for mode in modes if mode != OFF)]
    declared = (tag("MODE-DECLARATION", name=state) for state in states)
    path = known.path(paths.FUNCTION_GROUPS, _states_name(group))
    initial = reference("INITIAL-MODE-REF", f"{path}/{OFF}", "MODE-DECLARATION")
    target = reference("TYPE-TREF", path, "MODE-DECLARATION-GROUP")
    prototype = tag("MODE-DECLARATION-GROUP-PROTOTYPE", target, name=group)
    return (
        tag("MODE-DECLARATION-GROUP", initial, listed("MODE-DECLARATIONS", declared), name=_states_name(group)),
        tag("FUNCTION-GROUP-SET", tag("FUNCTION-GROUPS", prototype), name=_set_name(group)),
    )


def _startup_name(component: model.Component) -> str:
    return short_name(f"{component.name}_Startup")


def _startups(components: Iterable[model.Component], known: Library) -> tuple[Tag, ...]:
    configurations = tuple(map(_startup, components))
    if not known.release.has_sets:
        return configurations
    return (tag("STARTUP-CONFIG-SET", listed("STARTUP-CONFIGS", configurations), name=STARTUP_SET),)


def _startup_path(component: model.Component, known: Library) -> str:
    names = (STARTUP_SET, _startup_name(component)) if known.release.has_sets else (_startup_name(component),)
    return known.path(paths.STARTUP, *names)


def _startup(component: model.Component) -> Tag:
    chosen = component.startup or NO_STARTUP
    variables = (chosen.environment or {}).items()
    limits = {"ENTER-TIMEOUT-VALUE": chosen.enter_timeout, "EXIT-TIMEOUT-VALUE": chosen.exit_timeout}
    return tag(
        "STARTUP-CONFIG",
        listed(
            "ENVIRONMENT-VARIABLES",
            (tag("TAG-WITH-OPTIONAL-VALUE", {"KEY": key, "VALUE": value}) for key, value in variables),
        ),
        listed("PROCESS-ARGUMENTS", (tag("PROCESS-ARGUMENT", {"ARGUMENT": each}) for each in chosen.arguments or ())),
        {"SCHEDULING-POLICY": chosen.policy, "SCHEDULING-PRIORITY": chosen.priority},
        {"TERMINATION-BEHAVIOR": "PROCESS-IS-NOT-SELF-TERMINATING"},
        listed("TIMEOUT", (tag(name, text=seconds(time)) for name, time in limits.items() if time is not None)),
        name=_startup_name(component),
    )


def _process(process: Process, group: str, known: Library) -> Tag:
    component = process.component
    states = listed("FUNCTION-GROUP-STATE-IREFS", (_state(mode, group, known) for mode in component.modes))
    startup = reference("STARTUP-CONFIG-REF", _startup_path(component, known), "STARTUP-CONFIG")
    return tag(
        "PROCESS",
        reference("DESIGN-REF", known.path(paths.PROCESS_DESIGNS, design_name(component)), "PROCESS-DESIGN"),
        executables(component, known),
        {"NUMBER-OF-RESTART-ATTEMPTS": component.startup.restart_attempts if component.startup else None},
        tag("STATE-DEPENDENT-STARTUP-CONFIGS", tag("STATE-DEPENDENT-STARTUP-CONFIG", states, startup)),
        name=process.name,
    )


def _state(mode: str, group: str, known: Library) -> Tag:
    prototype = known.path(paths.FUNCTION_GROUPS, _set_name(group), group)
    target = known.path(paths.FUNCTION_GROUPS, _states_name(group), mode)
    return tag(
        "FUNCTION-GROUP-STATE-IREF",
        reference("CONTEXT-MODE-DECLARATION-GROUP-PROTOTYPE-REF", prototype, "MODE-DECLARATION-GROUP-PROTOTYPE"),
        reference("TARGET-MODE-DECLARATION-REF", target, "MODE-DECLARATION"),
    )


# -- SOME/IP ------------------------------------------------------------------------------------------------------


def deployment_name(service: str) -> str:
    """Name of the SOME/IP deployment of a service."""
    return short_name(f"{service}_SomeIp")


def _deployment(service: Whole, known: Library) -> Tag:
    interface = known.path(paths.INTERFACES, service.name)
    own = known.path(paths.DEPLOYMENTS, deployment_name(service.name))
    protocol = (service.interface.transport or DEFAULT_TRANSPORT).protocol
    version = {"MAJOR-VERSION": service.version.major, "MINOR-VERSION": service.version.minor}
    return tag(
        DEPLOYMENT,
        listed("EVENT-DEPLOYMENTS", (_event(each, interface, protocol) for each in service.events)),
        listed("FIELD-DEPLOYMENTS", (_field(each, interface, protocol) for each in service.fields)),
        listed("METHOD-DEPLOYMENTS", (_method(each, interface, protocol) for each in service.methods)),
        reference("SERVICE-INTERFACE-REF", interface, "SERVICE-INTERFACE"),
        listed("EVENT-GROUPS", (_group(each, service, own) for each in service.event_groups)),
        {"SERVICE-INTERFACE-ID": service.interface.service_id},
        tag("SERVICE-INTERFACE-VERSION", version),
        name=deployment_name(service.name),
    )


def _event(event: model.Event, interface: str, protocol: str) -> Tag:
    return tag(
        EVENT,
        reference("EVENT-REF", f"{interface}/{event.name}", "VARIABLE-DATA-PROTOTYPE"),
        {"EVENT-ID": event.event_id, "MAXIMUM-SEGMENT-LENGTH": event.segment_length, "TRANSPORT-PROTOCOL": protocol},
        name=element_name(event.name),
    )


def _field(field: model.ServiceField, interface: str, protocol: str) -> Tag:
    getter = {"METHOD-ID": field.getter_id, "TRANSPORT-PROTOCOL": protocol}
    return tag(
        "SOMEIP-FIELD-DEPLOYMENT",
        reference("FIELD-REF", f"{interface}/{field.name}", "FIELD"),
        tag("GET", getter, name="Get") if field.getter_id else None,
        tag("NOTIFIER", {"EVENT-ID": field.notifier_id, "TRANSPORT-PROTOCOL": protocol}, name=NOTIFIER),
        name=element_name(field.name),
    )


def _method(method: model.Method, interface: str, protocol: str) -> Tag:
    operation = reference("METHOD-REF", f"{interface}/{method.name}", "CLIENT-SERVER-OPERATION")
    numbers = {"METHOD-ID": method.method_id, "TRANSPORT-PROTOCOL": protocol}
    return tag("SOMEIP-METHOD-DEPLOYMENT", operation, numbers, name=element_name(method.name))


def group_name(name: str) -> str:
    """Name of an event group; no deployment of an event ends like it."""
    return short_name(f"{name}{GROUP_SUFFIX}")


def _group(group: model.EventGroup, service: Whole, own: str) -> Tag:
    senders = [f"{own}/{element_name(each.name)}" for each in service.events if each.event_group == group.name]
    fields = (each.name for each in service.fields if each.event_group == group.name)
    senders += (f"{own}/{element_name(name)}/{NOTIFIER}" for name in fields)
    events = references("EVENT-REF", senders, EVENT)
    return tag("SOMEIP-EVENT-GROUP", {"EVENT-GROUP-ID": group.id}, events, name=group_name(group.name))


# -- instances ----------------------------------------------------------------------------------------------------


def instance_name(process: Process, interface: model.ServiceInterface) -> str:
    """Name of a process's instance of a service."""
    return short_name(f"{process.stem}_{port_name(interface)}_Instance")


def _instance(process: Process, interface: model.ServiceInterface, known: Library) -> Tag:
    own = known.path(paths.DEPLOYMENTS, deployment_name(interface.name))
    is_provider = interface.role == "Provider"
    word = "PROVIDED" if is_provider else "REQUIRED"
    groups = (
        tag(
            f"SOMEIP-{word}-EVENT-GROUP",
            reference("EVENT-GROUP-REF", f"{own}/{group_name(group.name)}", "SOMEIP-EVENT-GROUP"),
            *_multicast(interface),
            someip.event_group_timing(provides=is_provider, known=known),
            name=group_name(group.name),
        )
        for group in interface.event_groups or ()
    )
    return tag(
        f"{word}-SOMEIP-SERVICE-INSTANCE",
        e2e.properties(interface, own, known),
        reference("SERVICE-INTERFACE-DEPLOYMENT-REF", own, DEPLOYMENT),
        listed(f"{word}-EVENT-GROUPS", groups),
        someip.instance_timing(provides=is_provider, known=known),
        {"SERVICE-INSTANCE-ID" if is_provider else "REQUIRED-SERVICE-INSTANCE-ID": interface.instance_id},
        name=instance_name(process, interface),
    )


def _multicast(interface: model.ServiceInterface) -> Iterable[Child]:
    """Multicast address of an event group, and the number of subscribers from which it is used."""
    chosen = interface.transport.multicast if interface.transport else None
    if chosen is not None and interface.role == "Provider":
        yield {"EVENT-MULTICAST-UDP-PORT": chosen.port, "MULTICAST-THRESHOLD": chosen.threshold}
        yield {"IPV-4-MULTICAST-IP-ADDRESS": chosen.address}


def _mapping(process: Process, interface: model.ServiceInterface, known: Library) -> Tag:
    component = process.component
    is_provider = interface.role == "Provider"
    port = known.path(paths.COMPONENTS, component.name, port_name(interface))
    instance = known.path(paths.INSTANCES, instance_name(process, interface))
    kind = f"{'PROVIDED' if is_provider else 'REQUIRED'}-SOMEIP-SERVICE-INSTANCE"
    return tag(
        "SERVICE-INSTANCE-TO-PORT-PROTOTYPE-MAPPING",
        tag(
            "PORT-PROTOTYPE-IREF",
            root_reference(component, known) if known.release.has_root_of_port else None,
            reference("TARGET-PORT-PROTOTYPE-REF", port, "P-PORT-PROTOTYPE" if is_provider else "R-PORT-PROTOTYPE"),
        ),
        reference("PROCESS-REF", known.path(paths.PROCESSES, process.name), "PROCESS"),
        reference("SERVICE-INSTANCE-REF", instance, kind),
        name=short_name(f"{instance_name(process, interface)}_Mapping"),
    )
