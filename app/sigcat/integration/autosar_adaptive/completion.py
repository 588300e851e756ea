"""Ids and names that an Integration JSON leaves out, by the rule of `derive`."""

from collections.abc import Iterable, Mapping
from typing import NamedTuple

from sigcat.integration.autosar_adaptive.deployment.identifiers import (
    EVENT_GROUPS,
    EVENTS,
    INSTANCE,
    METHODS,
    RULED_INSTANCES,
    SERVICES,
    Span,
    assign,
)
from sigcat.integration.autosar_adaptive.deployment.namespaces import namespace_of
from sigcat.integration.autosar_adaptive.model import (
    ArxmlDeployment,
    Event,
    EventGroup,
    IntegrationModel,
    Method,
    ServiceField,
    ServiceInterface,
    Services,
)
from sigcat.integration.autosar_adaptive.startup import NO_STARTUP, startup
from sigcat.integration.autosar_names import short_name


class _Numbers(NamedTuple):
    services: dict[str, int]
    instances: dict[str, int]
    events: dict[str, dict[str, int]]
    methods: dict[str, dict[str, int]]
    groups: dict[str, dict[str, int]]


def completed(model: IntegrationModel) -> IntegrationModel:
    """The model with ids by the rule of `derive` wherever it has none, and with names for the deployment."""
    listed = [interface for component in model.components for interface in component.services]
    names = {interface.name for interface in listed}
    numbers = _Numbers(
        _ids(names, SERVICES, {item.name: item.service_id for item in listed}, ""),
        _instances({item.name: item.instance_id for item in listed}),
        {name: _events(name, listed) for name in names},
        {name: _methods(name, listed) for name in names},
        {name: _groups(name, listed) for name in names},
    )
    components = tuple(
        component.model_copy(
            update={
                "services": tuple(_with_ids(item, numbers) for item in component.services),
                "startup": startup(component.startup or NO_STARTUP, component.wishes),
            }
        )
        for component in model.components
    )
    application = short_name(model.info.name)
    default = ArxmlDeployment(package=application, function_group=short_name(f"{application}FunctionGroup"))
    deployment = model.deployment or default
    namespace = deployment.namespace or namespace_of(model.info.name)
    named = deployment.model_copy(update={"namespace": namespace})
    return model.model_copy(update={"components": components, "deployment": named})


def _ids(names: Iterable[str], span: Span, given: dict[str, int | None], scope: str) -> dict[str, int]:
    fixed = {name: number for name, number in given.items() if number is not None}
    return assign(names, span, fixed, scope).ids


def _instances(given: Mapping[str, int | None]) -> dict[str, int]:
    """Instances by the rule, each for its service alone: two services may have instances with one id."""
    return {
        name: assign((name,), RULED_INSTANCES, scope=INSTANCE).ids[name] if number is None else number
        for name, number in given.items()
    }


def _parts(name: str, listed: Iterable[ServiceInterface]) -> list[Services]:
    return [services for interface in listed if interface.name == name for services in interface.services]


def _events(name: str, listed: Iterable[ServiceInterface]) -> dict[str, int]:
    given: dict[str, int | None] = {}
    for services in _parts(name, listed):
        given.update({event.name: event.event_id for event in services.events})
        given.update({field.name: field.notifier_id for field in services.fields})
    return _ids(given, EVENTS, given, f"{name}.")


def _methods(name: str, listed: Iterable[ServiceInterface]) -> dict[str, int]:
    given: dict[str, int | None] = {}
    for services in _parts(name, listed):
        given.update({method.name: method.method_id for method in services.methods})
        given.update({f"Get{field.name}": field.getter_id for field in services.fields if not field.protection})
    return _ids(given, METHODS, given, f"{name}.")


def _groups(name: str, listed: Iterable[ServiceInterface]) -> dict[str, int]:
    given: dict[str, int | None] = {}
    for services in _parts(name, listed):
        given.update(dict.fromkeys((event.event_group or "Events" for event in services.events), None))
        given.update(dict.fromkeys((field.event_group or "Fields" for field in services.fields), None))
    for interface in listed:
        if interface.name == name:
            given.update({group.name: group.id for group in interface.event_groups or ()})
    return _ids(given, EVENT_GROUPS, given, f"{name}.")


def _with_ids(interface: ServiceInterface, numbers: _Numbers) -> ServiceInterface:
    name = interface.name
    parts = tuple(_services_with_ids(services, name, numbers) for services in interface.services)
    used = {event.event_group for part in parts for event in part.events}
    used |= {field.event_group for part in parts for field in part.fields}
    groups = tuple(
        EventGroup(name=key, id=number) for key, number in sorted(numbers.groups[name].items()) if key in used
    )
    return interface.model_copy(
        update={
            "service_id": numbers.services[name],
            "instance_id": numbers.instances[name],
            "services": parts,
            "event_groups": groups or None,
        }
    )


def _services_with_ids(services: Services, name: str, numbers: _Numbers) -> Services:
    events, methods = numbers.events[name], numbers.methods[name]
    return services.model_copy(
        update={
            "events": tuple(_event_with_id(event, events) for event in services.events),
            "methods": tuple(_method_with_id(method, methods) for method in services.methods),
            "fields": tuple(_field_with_ids(field, events, methods) for field in services.fields),
        }
    )


def _event_with_id(event: Event, ids: dict[str, int]) -> Event:
    return event.model_copy(update={"event_id": ids[event.name], "event_group": event.event_group or "Events"})


def _method_with_id(method: Method, ids: dict[str, int]) -> Method:
    return method.model_copy(update={"method_id": ids[method.name]})


def _field_with_ids(field: ServiceField, events: dict[str, int], methods: dict[str, int]) -> ServiceField:
    ids = {"notifier_id": events[field.name], "getter_id": methods.get(f"Get{field.name}")}
    return field.model_copy(update={**ids, "event_group": field.event_group or "Fields"})
