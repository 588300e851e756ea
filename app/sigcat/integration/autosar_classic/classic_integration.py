"""From functions to the Integration JSON of AUTOSAR Classic, without any further input."""

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from sigcat import codes
from sigcat.findings import Finding, has_errors
from sigcat.function.document.document import pointer_text
from sigcat.function.document.text import Text
from sigcat.function.exchange import Part
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.integration.autosar_classic import findings, model, service_needs
from sigcat.integration.autosar_classic.base_software import ECU_MODE, ECU_MODES, SERVICE_TYPES, SERVICES
from sigcat.integration.autosar_classic.composition import composition_of
from sigcat.integration.autosar_classic.context import Context, named_calls
from sigcat.integration.autosar_classic.datatypes.classic_types import TypeTable
from sigcat.integration.autosar_classic.deployment.settings import NO_SETTINGS, AutosarClassicSettings
from sigcat.integration.autosar_classic.e2e import report_unknown_elements
from sigcat.integration.autosar_classic.elements import Element, by_part, elements_of
from sigcat.integration.autosar_classic.events import events_of
from sigcat.integration.autosar_classic.field_targets import field_targets
from sigcat.integration.autosar_classic.interfaces import data_interface, method_interface, mode_interface
from sigcat.integration.autosar_classic.parameters import (
    calibration,
    internal_parameters,
    parameter_interface,
    parameter_port,
)
from sigcat.integration.autosar_classic.partitioning import asil_of, partition_entries, report_lower_calls, sections
from sigcat.integration.autosar_classic.ports import data_ports, kind_of_port
from sigcat.integration.autosar_classic.problems.document import problems_of
from sigcat.integration.autosar_classic.runnables import AREA, CALLS, Behaviour, runnables_of
from sigcat.integration.autosar_classic.signals import report_narrow_signals, system_signals
from sigcat.integration.autosar_classic.tasks import init_batches_of, tasks_of
from sigcat.integration.autosar_context import application_information, autosar_context, meta_information
from sigcat.integration.autosar_names import short_name
from sigcat.integration.deployment import NO_DEPLOYMENT, Deployment
from sigcat.integration.derived import Derived
from sigcat.integration.finding_collector import FindingCollector
from sigcat.integration.not_carried import report_not_carried
from sigcat.integration.unknown_paths import report_unknown_paths


def derive(
    functions: Sequence[ResolvedFunction],
    deployment: Deployment = NO_DEPLOYMENT,
    settings: AutosarClassicSettings = NO_SETTINGS,
) -> Derived[model.ClassicIntegration]:
    """The integration of a function or a set of functions. The order in which they are given does not matter."""
    context = autosar_context(functions, deployment, settings, _types)
    app = context.application
    elements = elements_of(context)
    interfaces = _interfaces(elements, context)
    findings.report_meanings(elements, context)
    own = by_part(elements)
    behaviours = {part.name: _behaviour(part, own[part.name], context) for part in context.parts}
    components = tuple(_component(each, interfaces, context) for each in behaviours.values())
    integration = _document(elements, interfaces, behaviours, components, context)
    targets = field_targets(context, elements)
    findings.report_asil(elements, integration.composition, context)
    report_unknown_paths(codes.DEPLOYMENT_NAMES_NOTHING_CLASSIC, app, context.findings)
    report_unknown_elements(elements, context)
    report_narrow_signals(elements, integration, context)
    findings.report_calls(context)
    findings.report_long_names(context)
    findings.report_order(integration.ecu.tasks, _priorities(components, behaviours), context)
    report_not_carried(codes.FIELD_NOT_CARRIED_CLASSIC, targets, app.functions, context.findings)
    for part in context.parts:
        report_lower_calls(part, context)
    partitions = (
        row for part, each in zip(context.parts, components, strict=True) for row in partition_entries(part, each)
    )
    return Derived(integration, (*context.findings.findings, *_refused(integration, context)), (*targets, *partitions))


class _Interfaces(NamedTuple):
    data: tuple[model.SenderReceiverInterface, ...]
    operations: tuple[model.ClientServerInterface, ...]
    modes: tuple[model.ModeSwitchInterface, ...]
    groups: tuple[model.ModeGroup, ...]


def _document(
    elements: Sequence[Element],
    interfaces: _Interfaces,
    behaviours: Mapping[str, Behaviour],
    components: tuple[model.Component, ...],
    context: Context,
) -> model.ClassicIntegration:
    app, settings = context.application, context.settings
    calibrations = _calibrations(context)
    calibrated = tuple(parameter_interface(part, context) for part in context.parts if _over_ports(part, context))
    composition = composition_of(components, calibrations, elements, context)
    return model.ClassicIntegration(
        meta=model.MetaInformation(**meta_information(codes.DATE_MISSING_CLASSIC, context)),
        info=model.ApplicationInformation(**application_information(app)),
        deployment=model.ClassicDeployment(
            package=settings.package or short_name(app.name), release=settings.release, tick=settings.tick
        ),
        **context.types.lists(),
        mode_groups=tuple(sorted(interfaces.groups, key=lambda each: each.name)),
        sender_receiver_interfaces=interfaces.data,
        client_server_interfaces=interfaces.operations,
        mode_switch_interfaces=interfaces.modes,
        parameter_interfaces=calibrated,
        components=components,
        parameter_components=calibrations,
        composition=composition,
        ecu=model.Ecu(
            name=settings.ecu or short_name(f"{app.name}Ecu"),
            signals=system_signals(elements, composition, context),
            init_batches=init_batches_of(components, behaviours),
            tasks=tasks_of(components, behaviours),
        ),
        provenance=app.provenance,
        functions=app.wholes,
    )


def _refused(integration: model.ClassicIntegration, context: Context) -> Iterator[Finding]:
    """Report what an RTE generator would refuse, where no other error explains it."""
    if not has_errors(context.findings.findings):
        for problem in problems_of(integration):
            at = pointer_text(problem.pointer)
            yield codes.NOT_WRITABLE_AS_CLASSIC.finding(problem.message, pointer=at, fix=problem.fix)


def _types(found: FindingCollector) -> TypeTable:
    """Datatypes that every set has."""
    types = TypeTable(found)
    for vss in ("boolean", "uint8", "uint16", "uint32", "uint64"):
        types.primitive(vss)
    for name, base in SERVICE_TYPES.items():
        types.service_type(name, base)
    return types


def _interfaces(elements: Sequence[Element], context: Context) -> _Interfaces:
    """One for each element, and those of the base software."""
    modes = [mode_interface(each, context) for each in elements if kind_of_port(each) == "ModeSwitch"]
    methods = [method_interface(each, context) for each in elements if kind_of_port(each) == "ClientServer"]
    return _Interfaces(
        tuple(data_interface(each, context) for each in elements if kind_of_port(each) == "SenderReceiver"),
        tuple(sorted((*methods, *SERVICES), key=lambda each: each.name)),
        tuple(sorted((*(each for each, _ in modes), ECU_MODE), key=lambda each: each.name)),
        (*(group for _, group in modes), ECU_MODES),
    )


def _priorities(
    components: Sequence[model.Component], behaviours: Mapping[str, Behaviour]
) -> dict[tuple[str, str], int]:
    """Declared priorities of cyclic calls, by component and event."""
    found: dict[tuple[str, str], int] = {}
    for component in components:
        calls = {each.name: each.call for each in behaviours[component.name].steps}
        for event in component.events:
            call = calls.get(event.runnable)
            number = call.priority_number if call is not None else None
            if event.kind == "Timing" and number is not None:
                found[component.name, event.name] = number
    return found


def _over_ports(part: Part, context: Context) -> bool:
    return context.settings.parameters == "ports" and bool(calibration(part))


def _behaviour(part: Part, elements: Sequence[Element], context: Context) -> Behaviour:
    calls = named_calls(part)
    ports = [*data_ports(part, elements, context), *service_needs.service_ports(part, calls)]
    if _over_ports(part, context):
        ports.append(parameter_port(part, "Required", context))
    internal = () if context.settings.parameters == "ports" else tuple(each.name for each in calibration(part))
    ports.sort(key=lambda port: port.name)
    return Behaviour(part, calls, tuple(ports), service_needs.nv_blocks(part), context.settings.tick, internal)


def _component(behaviour: Behaviour, interfaces: _Interfaces, context: Context) -> model.Component:
    part, runnables = behaviour.part, runnables_of(behaviour)
    received = behaviour.mode_port.interface if behaviour.mode_port else ""
    groups = {group.name: group for group in interfaces.groups}
    modes = next((groups[each.group].modes for each in interfaces.modes if each.name == received), ())
    is_internal = context.settings.parameters == "internal"
    return model.Component(
        name=part.name,
        kind="Application",
        function=part.function_name,
        version=part.function.info.version,
        description=part.function.info.description,
        ports=behaviour.ports,
        runnables=runnables,
        events=events_of(behaviour, runnables, tuple(mode.name for mode in modes)),
        exclusive_areas=_areas(behaviour),
        memories=service_needs.memories(part),
        parameters=tuple(internal_parameters(part, context)) if is_internal else (),
        nv_blocks=behaviour.nv_blocks,
        diagnostic_events=service_needs.monitors(part),
        supervised_entities=service_needs.supervised_entities(part, behaviour.calls),
        inhibitions=service_needs.inhibitions(part),
        sections=sections(part, runnables),
        asil_level=asil_of(part),
        code=part.function.code,
    )


def _areas(behaviour: Behaviour) -> tuple[model.ExclusiveArea, ...]:
    core = model.ExclusiveArea(name=AREA, description=Text("The core: one runnable is in it at a time."))
    code = model.ExclusiveArea(name=CALLS, description=Text("The function's code: no method runs while a call does."))
    return (core, code) if behaviour.offers else (core,)


def _calibrations(context: Context) -> tuple[model.ParameterComponent, ...]:
    parts = [part for part in context.parts if _over_ports(part, context)]
    if not parts:
        return ()
    return (
        model.ParameterComponent(
            name=short_name(f"{context.application.name}Calibration"),
            ports=tuple(parameter_port(part, "Provided", context) for part in parts),
        ),
    )
