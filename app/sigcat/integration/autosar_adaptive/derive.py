"""From functions to the Integration JSON of AUTOSAR adaptive, without any further input."""

import re
from collections.abc import Iterable, Sequence
from typing import NamedTuple

from sigcat import codes
from sigcat.errors import UsageError
from sigcat.findings import Finding
from sigcat.function.function_json.model import Contract, FunctionJson
from sigcat.integration.autosar_adaptive import model
from sigcat.integration.autosar_adaptive.calls import calls, function_modes, parameters
from sigcat.integration.autosar_adaptive.elements import Service, disagreements, services, view
from sigcat.integration.autosar_adaptive.field_targets import report
from sigcat.integration.autosar_adaptive.grouping import placed
from sigcat.integration.autosar_adaptive.settings import ComponentSettings
from sigcat.integration.autosar_adaptive.types import TypeTable
from sigcat.integration.autosar_adaptive.unused import tell_unused
from sigcat.integration.autosar_adaptive.work import Part, Work, items
from sigcat.integration.autosar_names import short_name
from sigcat.integration.deployment import DEFAULT_DEPLOYMENT, Deployment
from sigcat.integration.report import NOT_CARRIED, Entry

NO_DATE = "1970-01-01"
"""Date of a document whose functions have none: the published schema wants one, and today's would change the bytes."""

UNKNOWN_PROVIDER = "SOME/IP"
"""Provider of a service that comes from somewhere in the network, as the authors write it."""


class Derived(NamedTuple):
    """What was derived, what is to be said about it, and where each field went."""

    model: model.IntegrationModel
    findings: tuple[Finding, ...]
    report: tuple[Entry, ...]


def derive(functions: Sequence[FunctionJson], deployment: Deployment = DEFAULT_DEPLOYMENT) -> Derived:
    """The integration of a function or a set of functions. The order in which they are given does not matter."""
    if not functions:
        raise UsageError("There is no function to integrate: name one at least.")
    ordered = sorted(functions, key=lambda function: function.info.function_name)
    _refuse_doubles(ordered)
    work = Work(ordered, deployment)
    types = TypeTable(work)
    sides = placed(list(items(work.parts)), work)
    all_services = services(sides, work)
    disagreements(all_services, types, work)
    components = tuple(_component(part, all_services, types, work) for part in work.parts)
    made = model.IntegrationModel(
        meta=_meta(ordered, work),
        info=_info(ordered, deployment),
        components=components,
        datatypes=types.entries or None,
        deployment=_deployment_names(ordered, deployment),
        provenance=tuple(f.provenance.model_dump(mode="json") for f in ordered if f.provenance) or None,
    )
    tell_unused(sides, all_services, work)
    told = report(work, sides, all_services)
    _tell_left_out(told, work)
    return Derived(made, tuple(dict.fromkeys(work.findings)), told)


def _tell_left_out(told: Sequence[Entry], work: Work) -> None:
    for entry in told:
        if entry.target == NOT_CARRIED:
            message = f"{entry.field} of {entry.interface} ({entry.function}) is not carried: {entry.note}."
            work.report(codes.FIELD_NOT_CARRIED, message, entry.interface)


def _refuse_doubles(functions: Sequence[FunctionJson]) -> None:
    names = [function.info.function_name for function in functions]
    twice = sorted({name for name in names if names.count(name) > 1})
    if twice:
        raise UsageError(f"A set has each function once; given twice: {', '.join(twice)}.")


def application_name(functions: Sequence[FunctionJson], deployment: Deployment) -> str:
    """Name of the application: as the deployment says, or the names of its functions."""
    return deployment.name or " and ".join(function.info.function_name for function in functions)


def _component(part: Part, all_services: Sequence[Service], types: TypeTable, work: Work) -> model.Component:
    settings = work.deployment.autosar_adaptive.components.get(part.name) or ComponentSettings.model_validate({})
    made = calls(part, work)
    modes = tuple(dict.fromkeys(mode for call in made for mode in call.modes))
    return model.Component(
        name=part.name,
        executable=settings.executable or short_name(f"{part.name}Executable"),
        header_files=_header_files(part, settings),
        modes=modes,
        calls=made,
        parameters=parameters(part, types, work),
        services=tuple(_interfaces(part, all_services, types, work)),
        function=part.function_name,
        version=part.function.info.version,
        description=part.function.info.description,
        function_modes=function_modes(part),
    )


def _header_files(part: Part, settings: ComponentSettings) -> tuple[str, ...] | None:
    """The header that a code generator writes for a component, if the function tells variables of its code."""
    if settings.header_files is not None:
        return tuple(settings.header_files) or None
    contracts = [contract for call in part.component.runnables for contract in call.contracts or ()]
    return (f"{part.name}.h",) if any(map(_tells_variables, contracts)) else None


def _tells_variables(contract: Contract) -> bool:
    return (
        any(item.variable for item in contract.signals or ())
        or any(item.variable for item in contract.queues or ())
        or any(item.variable for item in contract.parameters or ())
    )


def _interfaces(
    part: Part, all_services: Sequence[Service], types: TypeTable, work: Work
) -> list[model.ServiceInterface]:
    """Services of a component, what it consumes first, as in the published example."""
    made = []
    for service in all_services:
        seen = view(service, part.name, types, work)
        if seen is not None:
            made.append(_interface(service, *seen, work))
    return sorted(made, key=lambda interface: (interface.role, interface.name))


def _interface(service: Service, content: model.Services, provides: bool, work: Work) -> model.ServiceInterface:
    used = {event.event_group for event in content.events} | {field.event_group for field in content.fields}
    providers = tuple(
        model.Provider(
            name=name, deployment="SOME/IP", instance_id=service.instance,
            contract=work.deployment.autosar_adaptive.contract,
        )
        for name in _provider_names(service, content)
    )  # fmt: skip
    groups = sorted((name, number) for name, number in service.event_groups.items() if name in used)
    return model.ServiceInterface(
        name=service.name,
        role="Provider" if provides else "Consumer",
        services=(content,),
        providers=None if provides else providers,
        service_id=service.id,
        instance_id=service.instance,
        event_groups=tuple(model.EventGroup(name=name, id=number) for name, number in groups) or None,
        origin=service.group.origin,
    )


def _provider_names(service: Service, content: model.Services) -> list[str]:
    """The component of the set, or who the functions say provides it from outside; else only the network is known."""
    if service.group.provider is not None:
        return [service.group.provider.name]
    uses = [use.interface.external_provider for event in content.events for use in event.uses or ()]
    return sorted({name for name in uses if name}) or [UNKNOWN_PROVIDER]


def _meta(functions: Sequence[FunctionJson], work: Work) -> model.MetaInformation:
    deployment = work.deployment
    date = deployment.date.isoformat() if deployment.date else max(map(_date, functions))
    if date == NO_DATE:
        message = f"No function has a date: {NO_DATE} is written, as the published schema wants one."
        work.report(codes.DATE_MISSING, message, fix="Give one in the deployment, or in a function.")
    return model.MetaInformation(
        authority=deployment.authority or _joined(function.meta.authority for function in functions),
        author=deployment.author or _joined(function.meta.schema_author for function in functions),
        date=date,
        version=deployment.version or "1.0.0",
    )


def _date(function: FunctionJson) -> str:
    match = re.fullmatch(r"(\d{2}).(\d{2}).(\d{4})", function.meta.date or "")
    return f"{match[3]}-{match[2]}-{match[1]}" if match else NO_DATE


def _joined(texts: Iterable[str | None]) -> str:
    return "; ".join(dict.fromkeys(text for text in texts if text))


def _info(functions: Sequence[FunctionJson], deployment: Deployment) -> model.FunctionInformation:
    descriptions = [function.info.description for function in functions]
    return model.FunctionInformation(
        name=application_name(functions, deployment),
        responsible=deployment.responsible or _joined(function.info.function_responsible for function in functions),
        description=deployment.description or " ".join(descriptions),
        functions=tuple(function.info.function_name for function in functions),
    )


def _deployment_names(functions: Sequence[FunctionJson], deployment: Deployment) -> model.DeploymentNames:
    name = short_name(application_name(functions, deployment))
    settings = deployment.autosar_adaptive
    return model.DeploymentNames(
        package=settings.package or name,
        function_group=settings.function_group or short_name(f"{name}FunctionGroup"),
    )
