"""Service interfaces with events, methods and fields."""

from collections.abc import Iterable
from typing import NamedTuple, TypeVar

from sigcat.adapter.arxml.tree import Package, Tag, description, listed, namespaces, tag, trace
from sigcat.adapter.autosar_adaptive.arxml.adaptive_type_elements import Library, Presentation, presentation
from sigcat.adapter.autosar_adaptive.arxml.method_errors import possible_errors
from sigcat.adapter.autosar_adaptive.arxml.paths import INTERFACES
from sigcat.integration.autosar_adaptive import model
from sigcat.integration.autosar_adaptive.deployment.namespaces import parts
from sigcat.integration.autosar_adaptive.someip.versions import Version, version_of

Item = TypeVar("Item", model.Event, model.Method, model.ServiceField, model.EventGroup)


class Whole(NamedTuple):
    """A service with what all components together have of it."""

    interface: model.ServiceInterface
    """As its provider has it, if one of the components is."""
    namespace: str
    events: tuple[model.Event, ...]
    methods: tuple[model.Method, ...]
    fields: tuple[model.ServiceField, ...]
    event_groups: tuple[model.EventGroup, ...]

    @property
    def name(self) -> str:
        """Its short name."""
        return self.interface.name

    @property
    def version(self) -> Version:
        """Its version, which both sides state."""
        return version_of(self.interface)


def wholes(document: model.IntegrationModel) -> tuple[Whole, ...]:
    """Every service of the document, by name. Of an element that several list, the provider's one counts."""
    assert document.deployment is not None
    namespace = document.deployment.namespace or ""
    by_name: dict[str, list[model.ServiceInterface]] = {}
    for component in document.components:
        for interface in component.services:
            by_name.setdefault(interface.name, []).append(interface)
    return tuple(
        _joined_sides(sorted(found, key=lambda interface: interface.role != "Provider"), namespace)
        for _, found in sorted(by_name.items())
    )


def _joined_sides(found: list[model.ServiceInterface], namespace: str) -> Whole:
    parts = [services for interface in found for services in interface.services]
    return Whole(
        found[0],
        found[0].namespace or namespace,
        _each(event for part in parts for event in part.events),
        _each(method for part in parts for method in part.methods),
        _each(field for part in parts for field in part.fields),
        _each(group for interface in found for group in interface.event_groups or ()),
    )


def _each(items: Iterable[Item]) -> tuple[Item, ...]:
    """Items by name, of several with one name the first."""
    first: dict[str, Item] = {}
    for item in items:
        first.setdefault(item.name, item)
    return tuple(first[name] for name in sorted(first))


def package(services: Iterable[Whole], known: Library) -> Package:
    """The package of service interfaces."""
    return Package(INTERFACES, tuple(_interface(service, known) for service in services))


def _interface(service: Whole, known: Library) -> Tag:
    names = [item.name for items in (service.events, service.fields, service.methods) for item in items]
    return tag(
        "SERVICE-INTERFACE",
        trace([("Origin", service.interface.origin)]),
        namespaces(parts(service.namespace), names),
        {"MAJOR-VERSION": service.version.major, "MINOR-VERSION": service.version.minor},
        listed("EVENTS", (_event(event, known) for event in service.events)),
        listed("FIELDS", (_field(field, known) for field in service.fields)),
        listed("METHODS", (_method(method, known) for method in service.methods)),
        name=service.name,
    )


def _event(event: model.Event, known: Library) -> Tag:
    return tag(
        "VARIABLE-DATA-PROTOTYPE",
        description(event.description),
        trace([("VssPath", event.vss_path), ("CycleTimeMs", event.cycle_time)]),
        known.properties(presentation(event)),
        known.typed(event.datatype),
        name=event.name,
    )


def _field(field: model.ServiceField, known: Library) -> Tag:
    status = (("Error", field.error), ("SafetyReaction", field.safety_reaction), ("Mode", field.mode))
    return tag(
        "FIELD",
        description(field.description),
        trace([("VssPath", field.vss_path), *status]),
        known.typed(field.word),
        {"HAS-GETTER": not field.protection, "HAS-NOTIFIER": True, "HAS-SETTER": False},
        name=field.name,
    )


def _method(method: model.Method, known: Library) -> Tag:
    arguments = (
        _argument(argument, direction, known)
        for direction, arguments in (("IN", method.inputs), ("OUT", method.outputs))
        for argument in arguments or ()
    )
    return tag(
        "CLIENT-SERVER-OPERATION",
        description(method.description),
        listed("ARGUMENTS", arguments),
        {"FIRE-AND-FORGET": False},
        possible_errors(known.paths),
        name=method.name,
    )


def _argument(argument: model.MethodArgument, direction: str, known: Library) -> Tag:
    return tag(
        "ARGUMENT-DATA-PROTOTYPE",
        known.properties(Presentation(argument.unit)),
        known.typed(argument.datatype),
        {"DIRECTION": direction},
        name=argument.name,
    )
