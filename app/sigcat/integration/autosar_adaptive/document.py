"""Integration JSON from anywhere: read, checked, and completed by rule where it has no ids."""

import re
from collections.abc import Iterable, Iterator
from typing import NamedTuple

from pydantic import ValidationError

from sigcat import codes
from sigcat.errors import InputRefused
from sigcat.findings import Finding, has_errors
from sigcat.function.document.document import Document, Pointer, pointer_text
from sigcat.function.document.read_json import read_json
from sigcat.function.document.structure import structural_findings
from sigcat.integration.autosar_adaptive.identifiers import (
    EVENT_GROUPS,
    EVENTS,
    INSTANCES,
    METHODS,
    SERVICES,
    Span,
    assign,
)
from sigcat.integration.autosar_adaptive.model import (
    Component,
    DeploymentNames,
    Event,
    EventGroup,
    IntegrationModel,
    Method,
    ServiceField,
    ServiceInterface,
    Services,
    TypeEntry,
)
from sigcat.integration.autosar_names import short_name
from sigcat.integration.datatypes import BY_ADAPTIVE
from sigcat.limits import DEFAULT_LIMITS, Limits

_PRIMITIVES = {row.autosar.lower() for row in BY_ADAPTIVE.values()}
_SHORT_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]{0,127}")


def read_integration(data: bytes, name: str, limits: Limits = DEFAULT_LIMITS) -> IntegrationModel:
    """The model of an Integration JSON, completed. Raises InputRefused with everything that is wrong."""
    document = read_json(data, name, limits)
    findings: tuple[Finding, ...] = document.findings
    if not has_errors(findings):
        try:
            model = IntegrationModel.model_validate(document.value, by_name=False)
        except ValidationError as error:
            findings = (*findings, *structural_findings(error, document, IntegrationModel))
        else:
            whole = _filled(model)
            findings = tuple(_finding(defect, document) for defect in _defects(whole))
            if not findings:
                return whole
    raise InputRefused(f"{name} must be Integration JSON as `sigcat integrate autosar-adaptive` writes it.", findings)


def completed(model: IntegrationModel) -> IntegrationModel:
    """The model with every id, event group and name that ARXML needs. Raises InputRefused if it cannot be written."""
    whole = _filled(model)
    defects = tuple(_defects(whole))
    if defects:
        findings = tuple(
            codes.NOT_WRITABLE_AS_ARXML.finding(defect.message, pointer=pointer_text(defect.pointer), fix=defect.fix)
            for defect in defects
        )
        raise InputRefused("The integration cannot be written as ARXML.", findings)
    return whole


# -- what cannot be written ---------------------------------------------------------------------------------------


class Defect(NamedTuple):
    """What AUTOSAR has no name, number or datatype for, and where it stands."""

    pointer: Pointer
    message: str
    fix: str = ""


def _finding(defect: Defect, document: Document) -> Finding:
    return document.finding(codes.NOT_WRITABLE_AS_ARXML, defect.pointer, defect.message, defect.fix)


def _defects(model: IntegrationModel) -> Iterator[Defect]:
    types = {entry.name for entry in model.datatypes or ()}
    if model.deployment is not None:
        yield from _name(("Deployment", "Package"), model.deployment.package, "package")
        yield from _name(("Deployment", "FunctionGroup"), model.deployment.function_group, "function group")
    yield from _names(((("DataTypes", i), entry.name) for i, entry in enumerate(model.datatypes or ())), "datatype")
    yield from _type_references(model, types)
    at: Pointer = ("ComponentList",)
    yield from _names((((*at, i), item.name) for i, item in enumerate(model.components)), "component")
    yield from _names((((*at, i), item.executable) for i, item in enumerate(model.components)), "executable")
    for index, component in enumerate(model.components):
        yield from _in_component(component, (*at, index), types)
    yield from _identifiers(model)


def _in_component(component: Component, at: Pointer, types: set[str]) -> Iterator[Defect]:
    listed = enumerate(component.parameters or ())
    yield from _names((((*at, "ParameterList", i), parameter.name) for i, parameter in listed), "parameter")
    modes = enumerate(dict.fromkeys(component.modes))
    yield from _names((((*at, "FunctionGroupModes", i), mode) for i, mode in modes), "mode")
    for index, parameter in enumerate(component.parameters or ()):
        yield from _word((*at, "ParameterList", index), parameter.datatype.word, parameter.name, types)
    roles = [(interface.name, interface.role) for interface in component.services]
    for index, interface in enumerate(component.services):
        here = (*at, "ServiceInterfaceList", index)
        yield from _name(here, interface.name, "service")
        if roles.index((interface.name, interface.role)) != index:
            yield Defect(
                here, f"Service {interface.name!r} must be listed once in each role, not twice.", "Merge the two."
            )
        for position, services in enumerate(interface.services):
            yield from _in_services(services, (*here, "ServiceList", position), types)


def _in_services(services: Services, at: Pointer, types: set[str]) -> Iterator[Defect]:
    places: list[tuple[Pointer, str]] = [((*at, "Events", i), event.name) for i, event in enumerate(services.events)]
    places += [((*at, "Methods", i), method.name) for i, method in enumerate(services.methods)]
    places += [((*at, "Fields", i), field.name) for i, field in enumerate(services.fields)]
    yield from _names(places, "element")
    groups = {item.event_group for item in services.events} | {item.event_group for item in services.fields}
    for group in sorted(group for group in groups if group):
        yield from _name(at, group, "event group")
    for index, method in enumerate(services.methods):
        arguments = (*(method.inputs or ()), *(method.outputs or ()))
        yield from _names((((*at, "Methods", index), argument.name) for argument in arguments), "argument")
        for argument in arguments:
            yield from _word((*at, "Methods", index), argument.datatype, f"{method.name}.{argument.name}", types)
    for index, field in enumerate(services.fields):
        yield from _word((*at, "Fields", index), field.datatype or "uint8_t", field.name, types)
    for index, event in enumerate(services.events):
        yield from _word((*at, "Events", index), event.datatype, event.name, types)


def _word(pointer: Pointer, word: str, owner: str, types: set[str]) -> Iterator[Defect]:
    if word not in types and word not in BY_ADAPTIVE:
        yield Defect(pointer, f"Datatype {word!r} of {owner} is not defined.", "Define it under `DataTypes`.")


def _names(places: Iterable[tuple[Pointer, str]], what: str) -> Iterator[Defect]:
    seen: dict[str, str] = {}
    for pointer, name in places:
        yield from _name(pointer, name, what)
        if name.lower() in seen:
            message = f"The {what} names {seen[name.lower()]!r} and {name!r} must differ in more than case."
            yield Defect(pointer, message, "Rename one of them.")
        seen[name.lower()] = name


def _name(pointer: Pointer, name: str, what: str) -> Iterator[Defect]:
    if not _SHORT_NAME.fullmatch(name):
        message = f"The name of a {what} must be at most 128 letters, digits and underscores, a letter first, not {name[:60]!r}."
        yield Defect(pointer, message, f"Use {short_name(name)[:60]!r}.")


def _type_references(model: IntegrationModel, types: set[str]) -> Iterator[Defect]:
    for index, entry in enumerate(model.datatypes or ()):
        yield from _members(entry, ("DataTypes", index))
        words = [field.type for field in entry.fields or ()]
        words += [word for word in (entry.type, entry.storage, entry.c_definition) if word]
        for word in words:
            if word not in types and word not in BY_ADAPTIVE:
                message = f"Datatype {word!r} of {entry.name} is not defined."
                yield Defect(("DataTypes", index), message, "Define it under `DataTypes`.")


def _members(entry: TypeEntry, at: Pointer) -> Iterator[Defect]:
    if entry.name.lower() in _PRIMITIVES:
        yield Defect(at, f"A datatype must not have the name of a primitive, {entry.name!r}.", "Rename it.")
    yield from _names((((*at, "Field", i), field.name) for i, field in enumerate(entry.fields or ())), "member")
    yield from _names((((*at, "EnumField", i), item.symbol) for i, item in enumerate(entry.symbols or ())), "value")
    if entry.kind == "array" and not entry.element:
        yield Defect(at, f"The array {entry.name} must have the datatype of its elements.", "Set its `Type`.")


def _identifiers(model: IntegrationModel) -> Iterator[Defect]:
    """Ids that two have, or that SOME/IP does not know; an element of one name in one service is one element."""
    owners: dict[tuple[str, str, int], str] = {}
    for index, component in enumerate(model.components):
        for number, interface in enumerate(component.services):
            at: Pointer = ("ComponentList", index, "ServiceInterfaceList", number)
            for kind, owner, value, span in _numbers(interface):
                if not span.first <= value <= span.last:
                    yield Defect(
                        at,
                        f"The id of {owner} must be from {span.first} to {span.last}, not {value}.",
                        "Use another one.",
                    )
                other = owners.setdefault((*kind, value), owner)
                if other != owner:
                    yield Defect(
                        at, f"{other} and {owner} must have different ids, not both {value}.", "Change one of them."
                    )


def _numbers(interface: ServiceInterface) -> Iterator[tuple[tuple[str, str], str, int, Span]]:
    """Scope and kind, owner, id and its range, of every id of a service."""
    name = interface.name
    assert interface.service_id is not None
    assert interface.instance_id is not None
    yield ("", "service"), name, interface.service_id, SERVICES
    yield ("", "instance"), name, interface.instance_id, INSTANCES
    for group in interface.event_groups or ():
        yield (name, "group"), f"{name}.{group.name}", group.id, EVENT_GROUPS
    for services in interface.services:
        for event in services.events:
            yield (name, "event"), f"{name}.{event.name}", event.event_id or 0, EVENTS
        for field in services.fields:
            yield (name, "event"), f"{name}.{field.name}", field.notifier_id or 0, EVENTS
            yield (name, "method"), f"{name}.Get{field.name}", field.getter_id or 0, METHODS
        for method in services.methods:
            yield (name, "method"), f"{name}.{method.name}", method.method_id or 0, METHODS


def identifiers_of(model: IntegrationModel) -> dict[str, int]:
    """Every id of a model under the key that fixes it in a deployment: whatever is added later, these stay."""
    found: dict[str, int] = {}
    for component in _filled(model).components:
        for interface in component.services:
            for (_, kind), owner, value, _ in _numbers(interface):
                found[f"{owner}:instance" if kind == "instance" else owner] = value
    return dict(sorted(found.items()))


# -- what is filled in --------------------------------------------------------------------------------------------


class _Numbers(NamedTuple):
    services: dict[str, int]
    instances: dict[str, int]
    events: dict[str, dict[str, int]]
    methods: dict[str, dict[str, int]]
    groups: dict[str, dict[str, int]]


def _filled(model: IntegrationModel) -> IntegrationModel:
    """The model with ids by the rule of `derive` wherever it has none, and with names for the deployment."""
    listed = [interface for component in model.components for interface in component.services]
    names = {interface.name for interface in listed}
    numbers = _Numbers(
        _ids(names, SERVICES, {item.name: item.service_id for item in listed}, ""),
        _ids(names, INSTANCES, {item.name: item.instance_id for item in listed}, ":instance"),
        {name: _events(name, listed) for name in names},
        {name: _methods(name, listed) for name in names},
        {name: _groups(name, listed) for name in names},
    )
    components = tuple(
        component.model_copy(update={"services": tuple(_with_ids(item, numbers) for item in component.services)})
        for component in model.components
    )
    application = short_name(model.info.name)
    default = DeploymentNames(package=application, function_group=short_name(f"{application}FunctionGroup"))
    return model.model_copy(update={"components": components, "deployment": model.deployment or default})


def _ids(names: Iterable[str], span: Span, given: dict[str, int | None], scope: str) -> dict[str, int]:
    fixed = {name: number for name, number in given.items() if number is not None}
    return assign(names, span, fixed, scope).ids


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
        given.update({f"Get{field.name}": field.getter_id for field in services.fields})
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
    ids = {"notifier_id": events[field.name], "getter_id": methods[f"Get{field.name}"]}
    return field.model_copy(update={**ids, "event_group": field.event_group or "Fields"})
