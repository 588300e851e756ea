"""From functions to the Integration JSON of AUTOSAR adaptive, without any further input."""

from collections.abc import Sequence

from sigcat import codes
from sigcat.asil import is_above
from sigcat.function.document.text import Text
from sigcat.function.exchange import Part, contracts_of
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.function.function_json.walk import data_of
from sigcat.integration.autosar_adaptive import model, protection
from sigcat.integration.autosar_adaptive.adaptive_types import TypeTable
from sigcat.integration.autosar_adaptive.component_calls import calls, function_modes, parameters
from sigcat.integration.autosar_adaptive.context import Context
from sigcat.integration.autosar_adaptive.deployment.namespaces import namespace_of
from sigcat.integration.autosar_adaptive.deployment.settings import (
    NO_SETTINGS,
    AutosarAdaptiveSettings,
    ComponentSettings,
    ServiceSettings,
)
from sigcat.integration.autosar_adaptive.field_targets import field_targets
from sigcat.integration.autosar_adaptive.processes import further_processes, process_problems
from sigcat.integration.autosar_adaptive.services.component_views import view
from sigcat.integration.autosar_adaptive.services.disagreements import report_disagreements
from sigcat.integration.autosar_adaptive.services.elements import Service, element_paths, services
from sigcat.integration.autosar_adaptive.services.grouping import MODES, SAFETY
from sigcat.integration.autosar_adaptive.someip.segmentation import segmented
from sigcat.integration.autosar_adaptive.someip.versions import FIRST, parsed
from sigcat.integration.autosar_adaptive.startup import (
    HIGHEST_PRIORITY,
    StartupSettings,
    startup,
    unwritable,
)
from sigcat.integration.autosar_adaptive.units import units_of
from sigcat.integration.autosar_adaptive.unused import report_units, report_unused
from sigcat.integration.autosar_context import application_information, autosar_context, meta_information
from sigcat.integration.autosar_names import short_name
from sigcat.integration.deployment import NO_DEPLOYMENT, Deployment
from sigcat.integration.derived import Derived
from sigcat.integration.not_carried import report_not_carried

UNKNOWN_PROVIDER = "SOME/IP"
"""Provider of a service that comes from somewhere in the network, as the authors write it."""
_PROTECT = "State a `profile` under `e2e` in the deployment file, or protect it in the code."
_PROTECT_METHOD = (
    f"{protection.METHODS_ARE_NOT_PROTECTED} Send its arguments and results as signals, with their ASIL and a profile."
)


def derive(
    functions: Sequence[ResolvedFunction],
    deployment: Deployment = NO_DEPLOYMENT,
    settings: AutosarAdaptiveSettings = NO_SETTINGS,
) -> Derived[model.IntegrationModel]:
    """The integration of a function or a set of functions. The order in which they are given does not matter."""
    context = autosar_context(functions, deployment, settings, TypeTable)
    app = context.application
    all_services = protection.protected(services(context), context)
    report_disagreements(all_services, context)
    _report_asil(all_services, context)
    protection.report_unset_errors(all_services, context)
    components = tuple(_component(part, all_services, context) for part in context.parts)
    _report_open_arrays(context)
    integration = model.IntegrationModel(
        meta=model.MetaInformation(**meta_information(codes.DATE_MISSING, context)),
        info=model.FunctionInformation(**application_information(app)),
        components=components,
        datatypes=context.types.entries or None,
        deployment=_arxml_deployment(context),
        provenance=app.provenance,
        functions=app.wholes,
    )
    integration = segmented(integration, context)
    protection.report_open_lengths(integration, context)
    _report_processes(components, context)
    report_unused(all_services, context)
    report_units(units_of(integration), context)
    targets = field_targets(context, all_services)
    report_not_carried(codes.FIELD_NOT_CARRIED, targets, app.functions, context.findings)
    return Derived(integration, context.findings.findings, targets)


def _report_open_arrays(context: Context) -> None:
    """Report arrays of open length where the deployment has no length sent before arrays."""
    settings = context.settings
    chosen = (settings.transformation, *(service.transformation for service in settings.services))
    if all(each is None or each.array_length for each in chosen):
        return
    for entry in context.types.entries:
        if entry.is_open:
            message = f"`arrayLength` must not be 0 in the deployment file: {entry.name} is an array of open length."
            context.findings.report(codes.ARRAY_WITHOUT_LENGTH, message, entry.name, "Use 1, 2 or 4.")


def _report_processes(components: Sequence[model.Component], context: Context) -> None:
    """One finding for each further process of the deployment that cannot be."""
    for _, problem in process_problems(components):
        context.findings.report(codes.ID_REFUSED, problem.message, problem.process, problem.fix)


def _report_asil(all_services: Sequence[Service], context: Context) -> None:
    """One finding for each interface above QM that nothing protects end to end."""
    for _, side in protection.unprotected_sides(all_services):
        if is_above(side.asil, "QM") and protection.states_asil(side):
            message = f"{side.identity} has ASIL {side.asil}, and its service has no end-to-end protection."
            fix = _PROTECT_METHOD if side.kind == "method" else _PROTECT
            context.findings.report(codes.ASIL_NOT_PROTECTED, message, side, fix, key="AsilLevel")


def _component(part: Part, all_services: Sequence[Service], context: Context) -> model.Component:
    settings = context.settings.components.get(part.name) or ComponentSettings.model_validate({})
    made = calls(part, element_paths(all_services), context)
    modes = tuple(dict.fromkeys(mode for call in made for mode in call.modes))
    component = model.Component(
        name=part.name,
        executable=settings.executable or short_name(f"{part.name}Executable"),
        header_files=_header_files(part, settings),
        modes=modes,
        calls=made,
        parameters=parameters(part, context),
        services=tuple(_interfaces(part, all_services, context)),
        function=part.function_name,
        version=part.function.info.version,
        description=part.function.info.description,
        code=part.function.code,
        function_modes=function_modes(part),
        processes=further_processes(settings.processes) or None,
    )
    return component.model_copy(update={"startup": _startup(component, settings, part, context)})


def _startup(component: model.Component, settings: ComponentSettings, part: Part, context: Context) -> StartupSettings:
    """Return the start settings of a component's process; a priority that cannot be written is reported."""
    wishes = component.wishes if settings.startup.priority is None else ()
    refused = {wish.call for wish in unwritable(wishes)}
    for call in part.component.runnables:
        if call.name in refused:
            message = f"Priority of {call.name} of {part.function_name} must be from 1 to {HIGHEST_PRIORITY}, as that of a process is, not {call.priority!r}."
            fix = f"Correct it in the function, or set `priority` under `startup` of component {part.name} in the deployment file."
            context.findings.report(codes.PRIORITY_OUT_OF_RANGE, message, call, fix, key="Priority")
    return startup(settings.startup, component.wishes)


def _header_files(part: Part, settings: ComponentSettings) -> tuple[str, ...] | None:
    """The headers of the code; else the one that a code generator writes, if the function names variables of its code."""
    if settings.header_files is not None:
        return tuple(settings.header_files) or None
    if part.function.code is not None and part.function.code.headers:
        return part.function.code.headers
    has_variables = any(
        item.variable for each in contracts_of(part) for item in (*data_of(each), *(each.parameters or ()))
    )
    return (f"{part.name}.h",) if has_variables else None


def _interfaces(part: Part, all_services: Sequence[Service], context: Context) -> list[model.ServiceInterface]:
    """Services of a component, what it consumes first, as in the published example."""
    seen = ((service, view(service, part.name, context)) for service in all_services)
    made = (_interface(service, *content, context) for service, content in seen if content is not None)
    return sorted(made, key=lambda interface: (interface.role, interface.name))


def _interface(service: Service, content: model.Services, provides: bool, context: Context) -> model.ServiceInterface:
    used = {event.event_group for event in content.events} | {field.event_group for field in content.fields}
    contract = Text(context.settings.contract)
    providers = tuple(
        model.Provider(name=name, deployment="SOME/IP", instance_id=service.instance, contract=contract)
        for name in _provider_names(service, content, context)
    )
    groups = sorted((name, number) for name, number in service.event_groups.items() if name in used)
    stated = _of_outside(service, context)
    version = parsed(context.settings.versions.get(service.name, str(FIRST)))
    return model.ServiceInterface(
        name=service.name,
        role="Provider" if provides else "Consumer",
        services=(content,),
        providers=None if provides else providers,
        service_id=service.id,
        major_version=version.major,
        minor_version=version.minor,
        instance_id=service.instance,
        event_groups=tuple(model.EventGroup(name=name, id=number) for name, number in groups) or None,
        namespace=stated.namespace if stated else None,
        transformation=stated.transformation if stated else None,
        transport=context.settings.transport.get(service.name),
        origin=service.group.origin,
    )


def _of_outside(service: Service, context: Context) -> ServiceSettings | None:
    """Return the deployment's settings for a service that no function of the set provides."""
    if service.group.provider:
        return None
    return next((each for each in context.settings.services if each.name == service.group.name), None)


def _provider_names(service: Service, content: model.Services, context: Context) -> list[Text]:
    """The component of the set, or who the deployment or the functions say provides it; else only the network is known."""
    if service.group.provider:
        return [Text(service.group.provider)]
    app = context.application
    manager = {SAFETY: app.safety_manager, MODES: app.mode_manager}.get(service.group.origin)
    if manager:
        return [manager]
    uses = [use.interface.external_provider for event in content.events for use in event.uses or ()]
    return sorted({name for name in uses if name}) or [Text(UNKNOWN_PROVIDER)]


def _arxml_deployment(context: Context) -> model.ArxmlDeployment:
    name, settings = short_name(context.application.name), context.settings
    return model.ArxmlDeployment(
        package=settings.package or name,
        function_group=settings.function_group or short_name(f"{name}FunctionGroup"),
        release=settings.release,
        namespace=settings.namespace or namespace_of(context.application.name),
        type_namespace=settings.type_namespace,
        header_folders=settings.header_folders,
        transformation=settings.transformation,
        service_discovery=settings.service_discovery,
        units=dict(settings.units) or None,
    )
