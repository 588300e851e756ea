"""From functions to the Integration JSON of AUTOSAR adaptive, without any further input."""

import re
from collections.abc import Sequence
from typing import NamedTuple

from app.errors import UsageError
from app.findings import Finding
from app.function.model import FunctionJson
from app.integration.autosar_adaptive import model
from app.integration.autosar_adaptive.calls import calls, function_modes, parameters
from app.integration.autosar_adaptive.elements import Service, disagreements, services, view
from app.integration.autosar_adaptive.grouping import placed
from app.integration.autosar_adaptive.settings import ComponentSettings
from app.integration.autosar_adaptive.targets import report
from app.integration.autosar_adaptive.types import TypeTable
from app.integration.autosar_adaptive.work import Part, Work, items
from app.integration.deployment import DEFAULT_DEPLOYMENT, Deployment
from app.integration.autosar_names import short_name
from app.integration.report import Entry

NO_DATE = "1970-01-01"
"""Date of a document whose functions have none: the published schema wants one, and today's would change the bytes."""


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
        deployment=_transport(ordered, deployment),
        provenance=tuple(f.provenance.model_dump(mode="json") for f in ordered if f.provenance) or None,
    )
    return Derived(made, tuple(dict.fromkeys(work.findings)), report(work, sides, all_services))


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
        parameters=parameters(part, types),
        services=tuple(_interfaces(part, all_services, types, work)),
        function=part.function_name,
        description=part.function.info.description,
        function_modes=function_modes(part),
    )


def _header_files(part: Part, settings: ComponentSettings) -> tuple[str, ...] | None:
    """The header that a code generator writes for a component, if the function tells variables of its code."""
    if settings.header_files is not None:
        return tuple(settings.header_files) or None
    contracts = [contract for call in part.component.runnables for contract in call.contracts or ()]
    listed = [item for c in contracts for item in (*(c.signals or ()), *(c.queues or ()), *(c.parameters or ()))]
    return (f"{part.name}.h",) if any(item.variable for item in listed) else None


def _interfaces(part: Part, all_services: Sequence[Service], types: TypeTable, work: Work) -> list[model.ServiceInterface]:
    """Services of a component, what it consumes first, as in the published example."""
    made = []
    for service in all_services:
        seen = view(service, part.name, types, work)
        if seen is not None:
            made.append(_interface(service, *seen, work))
    return sorted(made, key=lambda interface: (interface.role, interface.name))


def _interface(service: Service, content: model.Services, provides: bool, work: Work) -> model.ServiceInterface:
    used = {item.event_group for item in (*content.events, *content.fields)}
    provider = model.Provider(
        name=service.group.provider.name if service.group.provider else "SOME/IP",
        deployment="SOME/IP",
        instance_id=service.instance,
        contract=work.deployment.autosar_adaptive.contract,
    )
    groups = sorted((number, name) for name, number in service.event_groups.items() if name in used)
    return model.ServiceInterface(
        name=service.name,
        role="Provider" if provides else "Consumer",
        services=(content,),
        providers=None if provides else (provider,),
        service_id=service.id,
        instance_id=service.instance,
        event_groups=tuple(model.EventGroup(name=name, id=number) for number, name in groups) or None,
        origin=service.group.origin,
    )


def _meta(functions: Sequence[FunctionJson], work: Work) -> model.MetaInformation:
    deployment = work.deployment
    date = deployment.date.isoformat() if deployment.date else max(map(_date, functions))
    if date == NO_DATE:
        message = f"No function has a date: {NO_DATE} is written, as the published schema wants one."
        work.report("A001", "info", message, fix="Give one in the deployment, or in a function.")
    return model.MetaInformation(
        authority=deployment.authority or _joined(function.meta.authority for function in functions),
        author=deployment.author or _joined(function.meta.schema_author for function in functions),
        date=date,
        version=deployment.version or "1.0.0",
    )


def _date(function: FunctionJson) -> str:
    match = re.fullmatch(r"(\d{2}).(\d{2}).(\d{4})", function.meta.date or "")
    return f"{match[3]}-{match[2]}-{match[1]}" if match else NO_DATE


def _joined(texts: "Sequence[str | None] | object") -> str:
    return "; ".join(dict.fromkeys(text for text in texts if text))  # type: ignore[attr-defined]


def _info(functions: Sequence[FunctionJson], deployment: Deployment) -> model.FunctionInformation:
    descriptions = [function.info.description for function in functions]
    return model.FunctionInformation(
        name=application_name(functions, deployment),
        responsible=deployment.responsible or _joined(function.info.function_responsible for function in functions),
        description=deployment.description or " ".join(descriptions),
        functions=tuple(function.info.function_name for function in functions),
    )


def _transport(functions: Sequence[FunctionJson], deployment: Deployment) -> model.Transport:
    name = short_name(application_name(functions, deployment))
    settings = deployment.autosar_adaptive
    return model.Transport(
        package=settings.package or name,
        function_group=settings.function_group or short_name(f"{name}FunctionGroup"),
        port=settings.port,
    )
