"""From an integration and the plans of its cores to the plan of the applications."""

from collections.abc import Iterable, Iterator, Mapping

from sigcat import codes
from sigcat.adapter.autosar_adaptive.application.plan import (
    ApplicationPlan,
    ComponentPlan,
    ExecutablePlan,
    Monitor,
    Storage,
    Stored,
)
from sigcat.adapter.autosar_adaptive.application.planning.elements import (
    ComponentContext,
    provided_services,
    required_services,
)
from sigcat.adapter.autosar_adaptive.application.planning.structs import struct_pairs
from sigcat.adapter.autosar_adaptive.application.planning.threads import joined_calls, threads_of
from sigcat.adapter.autosar_adaptive.arxml.components import (
    SUPERVISION_PORT,
    checkpoints,
    monitor_port,
    root_name,
    storage_ports,
)
from sigcat.adapter.autosar_adaptive.arxml.interfaces import wholes
from sigcat.adapter.autosar_adaptive.cpp_names import ServiceNames, TypeNames, service_names, type_names
from sigcat.adapter.core.plan import CorePlan
from sigcat.adapter.host.host_plan import HostPlan
from sigcat.adapter.source_cores import Holder, SourceCores, wrong_holders
from sigcat.errors import InputRefused
from sigcat.findings import Finding
from sigcat.integration.autosar_adaptive.deployment.namespaces import parts as namespace_parts
from sigcat.integration.autosar_adaptive.model import Component, IntegrationModel
from sigcat.integration.autosar_adaptive.storages import StoredParameter, stored_parameters
from sigcat.names import snake_case

_TAKEN = {"all", "application", "arxml", "bench", "clean", "core", "core_runtime", "edit_cache", "generated", "help", "install", "package",
          "player", "player_messages", "rebuild_cache", "test"}  # fmt: skip
"""Folders of an application, and targets that CMake has: no executable can be called so."""


def derive(model: IntegrationModel, cores: SourceCores) -> ApplicationPlan:
    """The plan of the applications. Raises InputRefused if a component does not have its own function."""
    assert model.deployment is not None
    holders = (
        Holder(each.name, each.function or "", f"/ComponentList/{index}/Function")
        for index, each in enumerate(model.components)
    )
    shared = list(wrong_holders(holders, cores, codes.NOT_WRITABLE_AS_ARXML, "an application"))
    if found := shared or list(_unusable(model.components, cores)):
        raise InputRefused("The integration cannot become an application.", tuple(found))
    names = {service.name: service_names(service, model) for service in wholes(model)}
    types = type_names(model)
    components = [
        (component.executable, _component(model, component, cores[component.function or ""], types, names))
        for component in model.components
    ]
    return ApplicationPlan(
        model.info.name,
        tuple(namespace_parts(model.deployment.namespace or "application")),
        tuple(
            ExecutablePlan(name, tuple(plan for executable, plan in components if executable == name))
            for name in dict.fromkeys(executable for executable, _ in components)
        ),
    )


def _unusable(components: Iterable[Component], cores: SourceCores) -> Iterator[Finding]:
    """Parts of an edited document from which no application can be made."""
    for index, component in enumerate(components):
        at = f"/ComponentList/{index}"
        if component.executable.lower() in _TAKEN:
            message = f"No executable must be called {component.executable}: the folder or the target of that name is another one."
            yield codes.NOT_WRITABLE_AS_ARXML.finding(message, pointer=f"{at}/ExecutableName", fix="Rename it.")
        host = cores.get(component.function or "")
        listed = {each.parameter.variable for each in stored_parameters(component)}
        for parameter in host.core.parameters if host else ():
            if parameter.variable not in listed:
                message = (
                    f"{component.name} must list the parameter in {parameter.variable} of its function, and does not."
                )
                fix = "Integrate it again."
                yield codes.NOT_WRITABLE_AS_ARXML.finding(message, pointer=f"{at}/ParameterList", fix=fix)


def _component(
    model: IntegrationModel,
    component: Component,
    host: HostPlan,
    types: TypeNames,
    names: Mapping[str, ServiceNames],
) -> ComponentPlan:
    assert model.deployment is not None
    context = ComponentContext(component, host, types, names)
    structs = struct_pairs(host, model, types)
    required, provided = required_services(context), provided_services(context)
    ports = f"{component.executable}/{root_name(component)}"
    storages = {name: Storage(name, f"{ports}/{name}") for name in storage_ports(component)}
    joined = joined_calls(host.core, component.calls)
    return ComponentPlan(
        name=component.name,
        stem=snake_case(component.name),
        host=host,
        required=required,
        provided=provided,
        structs=structs,
        type_headers=tuple(types.headers(pair.type.rpartition("::")[2] for pair in structs)),
        monitors=tuple(Monitor(error, name, f"{ports}/{monitor_port(name)}") for name, error in host.errors.items()),
        storages=tuple(storages.values()),
        stored=tuple(_stored(component, host.core, storages)),
        supervision=f"{ports}/{SUPERVISION_PORT}",
        checkpoints=checkpoints(component),
        threads=threads_of(host.core, joined),
        joined=joined,
        error_namespace=tuple(namespace_parts(model.deployment.namespace or "")),
    )


def _stored(component: Component, core: CorePlan, storages: Mapping[str, Storage]) -> Iterator[Stored]:
    """Stored values of a component. A value that is read has the key of its element in the ARXML."""
    places: dict[str | None, StoredParameter] = {}
    for each in stored_parameters(component):
        places.setdefault(each.parameter.variable, each)
    for parameter in core.parameters:
        place = places[parameter.variable]
        yield Stored(parameter, storages[place.storage], place.key)
