"""Ids and names that an Integration JSON leaves out, by the rule of `derive`."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

from sigcat.integration.autosar_adaptive.deployment import identifiers
from sigcat.integration.autosar_adaptive.deployment.namespaces import namespace_of
from sigcat.integration.autosar_adaptive.model import (
    ArxmlDeployment,
    Event,
    EventGroup,
    IntegrationModel,
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
    listed = model.interfaces_by_name()
    numbers = _Numbers(
        _ids({name: each[-1].service_id for name, each in listed.items()}, identifiers.SERVICES, ""),
        _instances({name: each[-1].instance_id for name, each in listed.items()}),
        {name: _events(name, each) for name, each in listed.items()},
        {name: _methods(name, each) for name, each in listed.items()},
        {name: _groups(name, each) for name, each in listed.items()},
    )
    model = model.with_interfaces(lambda each: _with_ids(each, numbers))
    components = tuple(
        each.model_copy(update={"startup": startup(each.startup or NO_STARTUP, each.wishes)})
        for each in model.components
    )
    application = short_name(model.info.name)
    default = ArxmlDeployment(package=application, function_group=short_name(f"{application}FunctionGroup"))
    deployment = model.deployment or default
    namespace = deployment.namespace or namespace_of(model.info.name)
    named = deployment.model_copy(update={"namespace": namespace})
    return model.model_copy(update={"components": components, "deployment": named})


def _ids(given: Mapping[str, int | None], span: identifiers.Span, scope: str) -> dict[str, int]:
    fixed = {name: number for name, number in given.items() if number is not None}
    return identifiers.assign(given, span, fixed, scope).ids


def _instances(given: Mapping[str, int | None]) -> dict[str, int]:
    """Instances by the rule, each for its service alone: two services may have instances with one id."""
    return {
        name: identifiers.assign((name,), identifiers.RULED_INSTANCES, scope=identifiers.INSTANCE).ids[name]
        if number is None
        else number
        for name, number in given.items()
    }


def _events(name: str, listed: Iterable[ServiceInterface]) -> dict[str, int]:
    given: dict[str, int | None] = {}
    for services in (each for interface in listed for each in interface.services):
        given |= {event.name: event.event_id for event in services.events}
        given |= {field.name: field.notifier_id for field in services.fields}
    return _ids(given, identifiers.EVENTS, f"{name}.")


def _methods(name: str, listed: Iterable[ServiceInterface]) -> dict[str, int]:
    given: dict[str, int | None] = {}
    for services in (each for interface in listed for each in interface.services):
        given |= {method.name: method.method_id for method in services.methods}
        given |= {f"Get{field.name}": field.getter_id for field in services.fields if not field.protection}
    return _ids(given, identifiers.METHODS, f"{name}.")


def _groups(name: str, listed: Sequence[ServiceInterface]) -> dict[str, int]:
    given: dict[str, int | None] = {}
    for interface in listed:
        given |= dict.fromkeys(_event_groups(interface))
    for interface in listed:
        given |= {group.name: group.id for group in interface.event_groups or ()}
    return _ids(given, identifiers.EVENT_GROUPS, f"{name}.")


def _event_groups(interface: ServiceInterface) -> Iterator[str]:
    yield from map(_event_group, interface.events)
    yield from map(_event_group, interface.fields)


def _event_group(each: Event | ServiceField) -> str:
    return each.event_group or ("Events" if isinstance(each, Event) else "Fields")


def _with_ids(interface: ServiceInterface, numbers: _Numbers) -> ServiceInterface:
    name = interface.name
    parts = tuple(_services_with_ids(services, name, numbers) for services in interface.services)
    used = set(_event_groups(interface))
    groups = tuple(
        EventGroup(name=key, id=number) for key, number in sorted(numbers.groups[name].items()) if key in used
    )
    ids = {"service_id": numbers.services[name], "instance_id": numbers.instances[name]}
    return interface.model_copy(update={**ids, "services": parts, "event_groups": groups or None})


def _services_with_ids(services: Services, name: str, numbers: _Numbers) -> Services:
    ids, methods = numbers.events[name], numbers.methods[name]
    return services.model_copy(
        update={
            "events": tuple(
                each.model_copy(update={"event_id": ids[each.name], "event_group": _event_group(each)})
                for each in services.events
            ),
            "methods": tuple(each.model_copy(update={"method_id": methods[each.name]}) for each in services.methods),
            "fields": tuple(_field_with_ids(each, ids, methods) for each in services.fields),
        }
    )


def _field_with_ids(field: ServiceField, events: dict[str, int], methods: dict[str, int]) -> ServiceField:
    ids = {"notifier_id": events[field.name], "getter_id": methods.get(f"Get{field.name}")}
    return field.model_copy(update={**ids, "event_group": _event_group(field)})
