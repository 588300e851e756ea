"""Parts of an Integration JSON that ARXML cannot have: names, datatypes and ids that AUTOSAR does not accept."""

from collections.abc import Iterable, Iterator

from sigcat.function.document.document import Pointer
from sigcat.function.function_json.walk import parts
from sigcat.integration.agreement import argument_counts
from sigcat.integration.autosar_adaptive.deployment import identifiers
from sigcat.integration.autosar_adaptive.deployment.someip_settings import TransformationSettings
from sigcat.integration.autosar_adaptive.e2e import E2eProtection
from sigcat.integration.autosar_adaptive.model import (
    ArxmlDeployment,
    Component,
    IntegrationModel,
    ServiceInterface,
    Services,
    TypeEntry,
    Use,
)
from sigcat.integration.autosar_adaptive.processes import process_problems
from sigcat.integration.autosar_adaptive.someip.versions import Version, version_of
from sigcat.integration.autosar_adaptive.storages import ADAPTER_STORAGE, storage_name, storages
from sigcat.integration.autosar_names import short_name
from sigcat.integration.datatypes import BY_ADAPTIVE
from sigcat.integration.problem import Problem
from sigcat.integration.references import places
from sigcat.names import IDENTIFIER

_PRIMITIVES = {row.autosar.lower() for row in BY_ADAPTIVE.values()}
_OTHER_PORTS = {ADAPTER_STORAGE.lower(), "supervision"}
_PORT_ENDINGS = ("_pport", "_rport", "_monitor")
"""Ports of a component that are not storages of parameters."""
_SERVICES = "ComponentList/*/ServiceInterfaceList/*"


def problems_of(model: IntegrationModel) -> Iterator[Problem]:
    """Everything in a completed model that ARXML cannot have."""
    types = {entry.name for entry in model.datatypes or ()}
    if model.deployment is not None:
        yield from _name(("Deployment", "Package"), model.deployment.package, "package")
        yield from _name(("Deployment", "FunctionGroup"), model.deployment.function_group, "function group")
        yield from _lengths(model, model.deployment)
    yield from _names(((("DataTypes", i), entry.name) for i, entry in enumerate(model.datatypes or ())), "datatype")
    yield from _type_references(model, types)
    at: Pointer = ("ComponentList",)
    yield from _names((((*at, i), item.name) for i, item in enumerate(model.components)), "component")
    yield from _names((((*at, i), item.executable) for i, item in enumerate(model.components)), "executable")
    yield from _uses(model)
    for index, component in enumerate(model.components):
        yield from _in_component(component, (*at, index), types)
    yield from _method_arguments(model)
    yield from _names(_storage_interfaces(model), "storage interface")
    yield from _identifiers(model)
    yield from _versions(model)
    for component, problem in process_problems(model.components):
        position = model.components.index(component)
        yield Problem((*at, position, "Processes"), problem.message, problem.fix)
    for position, component in enumerate(model.components):
        listed = enumerate(component.processes or ())
        yield from _names((((*at, position, "Processes", i), each.name) for i, each in listed), "process")


def _uses(model: IntegrationModel) -> Iterator[Problem]:
    """Sides of events that have no interface of a function."""
    for at, part in parts(model):
        if isinstance(part, Use) and part.signal is None and part.queue is None:
            message = f"A use of {part.component} must have `Signal` or `Queue`."
            yield Problem(at, message, "Give the interface, as it is in Function JSON.")


def _lengths(model: IntegrationModel, deployment: ArxmlDeployment) -> Iterator[Problem]:
    chosen: list[tuple[Pointer, TransformationSettings]] = [(("Deployment",), deployment.transformation)]
    services = places(model, _SERVICES)
    chosen += [(at, each.transformation) for at, each in services if each.transformation is not None]
    for at, transformation in chosen:
        for entry in model.datatypes or () if transformation.array_length == 0 else ():
            if entry.is_open:
                message = f"`arrayLength` must not be 0: {entry.name} is an array of open length."
                yield Problem((*at, "Transformation", "arrayLength"), message, "Use 1, 2 or 4.")


def _in_component(component: Component, at: Pointer, types: set[str]) -> Iterator[Problem]:
    listed = enumerate(component.parameters or ())
    yield from _names((((*at, "ParameterList", i), parameter.name) for i, parameter in listed), "parameter")
    modes = enumerate(dict.fromkeys(component.modes))
    yield from _names((((*at, "FunctionGroupModes", i), mode) for i, mode in modes), "mode")
    for index, parameter in enumerate(component.parameters or ()):
        yield from _word((*at, "ParameterList", index), parameter.datatype.word, parameter.name, types)
    yield from _in_storages(component, at)
    roles = [(interface.name, interface.role) for interface in component.services]
    for index, interface in enumerate(component.services):
        here = (*at, "ServiceInterfaceList", index)
        yield from _name(here, interface.name, "service")
        if roles.index((interface.name, interface.role)) != index:
            message = f"Service {interface.name!r} must be listed once in each role, not twice."
            yield Problem(here, message, "Merge the two.")
        lists = [((*here, "ServiceList", position), services) for position, services in enumerate(interface.services)]
        yield from _names((place for below, services in lists for place in _elements(services, below)), "element")
        for below, services in lists:
            yield from _in_services(services, below, types)


def _in_storages(component: Component, at: Pointer) -> Iterator[Problem]:
    """Storages are ports, and keys are elements of their interfaces."""
    positions = {id(entry): (*at, "ParameterList", i) for i, entry in enumerate(component.parameters or ())}
    stored = storages(component)
    yield from _names(((positions[id(held[0].parameter)], name) for name, held in stored.items()), "storage")
    for name, held in stored.items():
        here = positions[id(held[0].parameter)]
        if name.lower() in _OTHER_PORTS or name.lower().endswith(_PORT_ENDINGS):
            message = f"The name of a storage must not be that of another port, {name!r}."
            yield Problem(here, message, f"Use {name + 'Storage'!r}.")
        yield from _names(((positions[id(each.parameter)], each.key) for each in held), "key")


def _storage_interfaces(model: IntegrationModel) -> Iterator[tuple[Pointer, str]]:
    """Names as in the ARXML, where those of all components are in one package."""
    for index, component in enumerate(model.components):
        for name in (*storages(component), ADAPTER_STORAGE):
            yield ("ComponentList", index), storage_name(component, name)


def _elements(services: Services, at: Pointer) -> Iterator[tuple[Pointer, str]]:
    """Places and names of events, methods and fields."""
    yield from (((*at, "Events", i), event.name) for i, event in enumerate(services.events))
    yield from (((*at, "Methods", i), method.name) for i, method in enumerate(services.methods))
    yield from (((*at, "Fields", i), field.name) for i, field in enumerate(services.fields))


def _in_services(services: Services, at: Pointer, types: set[str]) -> Iterator[Problem]:
    groups = {item.event_group for item in services.events} | {item.event_group for item in services.fields}
    for group in sorted(group for group in groups if group):
        yield from _name(at, group, "event group")
    for index, method in enumerate(services.methods):
        arguments = (*(method.inputs or ()), *(method.outputs or ()))
        yield from _names((((*at, "Methods", index), argument.name) for argument in arguments), "argument")
        for argument in arguments:
            yield from _word((*at, "Methods", index), argument.datatype, f"{method.name}.{argument.name}", types)
    for index, field in enumerate(services.fields):
        yield from _word((*at, "Fields", index), field.word, field.name, types)
    for index, event in enumerate(services.events):
        yield from _word((*at, "Events", index), event.datatype, event.name, types)


def _method_arguments(model: IntegrationModel) -> Iterator[Problem]:
    """Methods have as many arguments and results as in the functions that offer or use them."""
    counts = argument_counts(model.functions or ())
    for at, method in places(model, f"{_SERVICES}/ServiceList/*/Methods/*"):
        own = (len(method.inputs or ()), len(method.outputs or ()))
        names = {use.method.name for use in method.uses or ()} & counts.keys()
        if any(own not in counts[name] for name in names):
            message = f"{method.name} must have the arguments and results that it has in its functions."
            yield Problem(at, message, "Integrate the functions again.")


def _word(pointer: Pointer, word: str, owner: str, types: set[str]) -> Iterator[Problem]:
    if word not in types and word not in BY_ADAPTIVE:
        yield Problem(pointer, f"Datatype {word!r} of {owner} is not defined.", "Define it under `DataTypes`.")


def _names(places: Iterable[tuple[Pointer, str]], what: str) -> Iterator[Problem]:
    seen: dict[str, str] = {}
    for pointer, name in places:
        yield from _name(pointer, name, what)
        if name.lower() in seen:
            message = f"The {what} names {seen[name.lower()]!r} and {name!r} must differ in more than case."
            yield Problem(pointer, message, "Rename one of them.")
        seen[name.lower()] = name


def _name(pointer: Pointer, name: str, what: str) -> Iterator[Problem]:
    if not IDENTIFIER.fullmatch(name):
        message = (
            f"The {what} name must be at most 128 letters, digits and underscores, a letter first, not {name[:60]!r}."
        )
        yield Problem(pointer, message, f"Use {short_name(name)[:60]!r}.")


def _type_references(model: IntegrationModel, types: set[str]) -> Iterator[Problem]:
    for index, entry in enumerate(model.datatypes or ()):
        yield from _members(entry, ("DataTypes", index))
        stated = filter(None, (entry.type, entry.storage, entry.c_definition))
        for word in (*(field.type for field in entry.fields or ()), *stated):
            yield from _word(("DataTypes", index), word, entry.name, types)


def _members(entry: TypeEntry, at: Pointer) -> Iterator[Problem]:
    if entry.name.lower() in _PRIMITIVES:
        yield Problem(at, f"A datatype must not have the name of a primitive, {entry.name!r}.", "Rename it.")
    yield from _names((((*at, "Field", i), field.name) for i, field in enumerate(entry.fields or ())), "member")
    yield from _names((((*at, "EnumField", i), item.symbol) for i, item in enumerate(entry.symbols or ())), "value")
    if entry.kind == "array" and not entry.element:
        yield Problem(at, f"The array {entry.name} must have the datatype of its elements.", "Set its `Type`.")


def _versions(model: IntegrationModel) -> Iterator[Problem]:
    """Services that components of the set have in different versions."""
    known: dict[str, tuple[Version, str]] = {}
    for at, interface in places(model, _SERVICES):
        component, found = model.components[int(at[1])].name, version_of(interface)
        version, owner = known.setdefault(interface.name, (found, component))
        if version != found:
            message = f"{interface.name} must have one version, not {version} in {owner} and {found} in {component}."
            yield Problem((*at, "MajorVersion"), message, "Write the same version in each component.")


def _identifiers(model: IntegrationModel) -> Iterator[Problem]:
    """Ids that two have, or that SOME/IP does not know; an element of one name in one service is one element."""
    owners: dict[tuple[str, str, int], str] = {}
    for at, interface in places(model, _SERVICES):
        for kind, owner, value, span in numbers_of(interface):
            if not span.first <= value <= span.last:
                message = f"The id of {owner} must be from {span.first} to {span.last}, not {value}."
                yield Problem(at, message, "Use another one.")
            other = owners.setdefault((*kind, value), owner)
            if other != owner:
                message = f"{other} and {owner} must have different ids, not both {value}."
                yield Problem(at, message, "Change one of them.")


def numbers_of(interface: ServiceInterface) -> Iterator[tuple[tuple[str, str], str, int, identifiers.Span]]:
    """Scope and kind, owner, id and its range, of every id of a service."""
    name = interface.name
    assert interface.service_id is not None
    assert interface.instance_id is not None
    yield ("", "service"), name, interface.service_id, identifiers.SERVICES
    yield (name, "instance"), name, interface.instance_id, identifiers.INSTANCES
    for group in interface.event_groups or ():
        yield (name, "group"), f"{name}.{group.name}", group.id, identifiers.EVENT_GROUPS
    for services in interface.services:
        for event in services.events:
            yield (name, "event"), f"{name}.{event.name}", event.event_id or 0, identifiers.EVENTS
            if event.protection:
                yield ("", "data id"), f"{name}.{event.name}", *_data_id(event.protection)
        for field in services.fields:
            yield (name, "event"), f"{name}.{field.name}", field.notifier_id or 0, identifiers.EVENTS
            if field.protection:
                yield ("", "data id"), f"{name}.{field.name}", *_data_id(field.protection)
            else:
                yield (name, "method"), f"{name}.Get{field.name}", field.getter_id or 0, identifiers.METHODS
        for method in services.methods:
            yield (name, "method"), f"{name}.{method.name}", method.method_id or 0, identifiers.METHODS


def _data_id(protection: E2eProtection) -> tuple[int, identifiers.Span]:
    return protection.data_id, identifiers.data_ids(protection.profile)
