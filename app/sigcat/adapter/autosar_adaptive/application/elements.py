"""Services of a component, and what its core has for each of their elements."""

from collections.abc import Callable, Iterator, Mapping
from functools import cached_property
from typing import NamedTuple, TypeVar

from sigcat.adapter.autosar_adaptive.application.plan import (
    CalledMethod,
    Provided,
    Receiver,
    Required,
    SentEvent,
    SentField,
)
from sigcat.adapter.autosar_adaptive.cpp_names import ServiceNames, TypeNames, instance_specifier, member_name
from sigcat.adapter.core.identifiers import identifier
from sigcat.adapter.core.places import CorePlaces
from sigcat.adapter.core.plan import CorePlan, WireType
from sigcat.function.document.document import Pointer
from sigcat.function.function_json.model import FunctionJson
from sigcat.integration.autosar_adaptive.model import Component, Event, MethodArgument, ServiceField, ServiceInterface

T = TypeVar("T")
SAMPLES = 16
"""Values of an event that wait while the handler runs."""


class Taken(NamedTuple):
    """A place of the core that takes values."""

    function: str
    wire: WireType
    capacity: int
    comment: str


class ComponentContext(CorePlaces):
    """A component of an integration, beside the core of its function."""

    def __init__(
        self,
        component: Component,
        function: FunctionJson,
        core: CorePlan,
        types: TypeNames,
        names: Mapping[str, ServiceNames],
    ) -> None:
        super().__init__(function, core)
        self.component = component
        self.types = types
        self.names = names

    @cached_property
    def status(self) -> Mapping[str, Taken]:
        """Places that take errors of others, safety reactions and the mode, by the name of the interface."""
        core = self.core
        found = {error.name: Taken(error.name, error.wire, SAMPLES, error.comment) for error in core.foreign_errors}
        for each in (*core.reactions, *([core.mode_in] if core.mode_in else ())):
            found[self.name_of(each.named)] = Taken(each.named.name, each.wire, SAMPLES, each.named.comment)
        return found


def required_services(context: ComponentContext) -> tuple[Required, ...]:
    """Services that the component uses."""
    return tuple(
        Required(
            interface.name,
            context.names[interface.name],
            instance_specifier(context.component, interface),
            tuple(_receivers(interface, context)),
            tuple(_methods(interface, context)),
        )
        for interface in context.component.services
        if interface.role != "Provider"
    )


def provided_services(context: ComponentContext) -> tuple[Provided, ...]:
    """Services that the component offers."""
    return tuple(
        Provided(
            interface.name,
            context.names[interface.name],
            instance_specifier(context.component, interface),
            tuple(_sent_events(interface, context)),
            tuple(_sent_fields(interface, context)),
            tuple(_methods(interface, context)),
        )
        for interface in context.component.services
        if interface.role == "Provider"
    )


def _receivers(interface: ServiceInterface, context: ComponentContext) -> Iterator[Receiver]:
    for services in interface.services:
        for event in services.events:
            for port in _distinct(event, context, context.ports.get):
                capacity = max(SAMPLES, *(item.queue.length if item.queue else 0 for _, item in port.consumers))
                type_ = context.types.type(event.datatype)
                yield Receiver(
                    member_name(event.name),
                    port.name,
                    type_,
                    port.wire,
                    capacity,
                    port.comment,
                    port.tells_of_rejection,
                    event.protection is not None,
                )
        for field in services.fields:
            taken = context.status.get(_status_name(field)) or context.status.get(identifier(_status_name(field)))
            if taken is not None:
                type_ = context.types.type(field.word)
                yield Receiver(
                    member_name(field.name),
                    taken.function,
                    type_,
                    taken.wire,
                    taken.capacity,
                    taken.comment,
                    is_protected=field.protection is not None,
                )


def _sent_events(interface: ServiceInterface, context: ComponentContext) -> Iterator[SentEvent]:
    for services in interface.services:
        for event in services.events:
            for output in _distinct(event, context, context.outputs.get):
                named = output.named
                own = tuple(_distinct(event, context, context.ports.get))
                yield SentEvent(member_name(event.name), named.name, output.queue is not None, named.comment, own)


def _distinct(event: Event, context: ComponentContext, of: Callable[[Pointer], T | None]) -> list[T]:
    """Values of the core on both sides of an event, each once."""
    pointers = [context.data_pointers.get((use.call, use.interface.name)) for use in event.uses or ()]
    found = {id(each): each for pointer in pointers if pointer is not None and (each := of(pointer)) is not None}
    return list(found.values())


def _sent_fields(interface: ServiceInterface, context: ComponentContext) -> Iterator[SentField]:
    mode = context.core.mode_out
    for services in interface.services:
        for field in services.fields:
            name, type_ = _status_name(field), context.types.type(field.word)
            error = context.errors.get(name)
            if error is not None:
                named, again = error.named, _repeated_by(field, error.call, context)
                yield SentField(
                    member_name(field.name), named.name, type_, error.passed, error, named.comment, error.wire.c, again
                )
            elif mode is not None and context.name_of(mode.named) == name:
                named, again = mode.named, _repeated_by(field, None, context)
                yield SentField(
                    member_name(field.name), named.name, type_, None, None, named.comment, mode.wire.c, again
                )


def _repeated_by(field: ServiceField, call: str | None, context: ComponentContext) -> str | None:
    """The call that evaluates a protected status, or else the first one."""
    steps = [step.name for step in context.core.steps]
    if field.protection is None or not steps:
        return None
    return call if call in steps else steps[0]


def _status_name(field: ServiceField) -> str:
    """Name of the interface of a field."""
    status = field.error or field.safety_reaction or field.mode
    return status.name if status else field.name


def _methods(interface: ServiceInterface, context: ComponentContext) -> Iterator[CalledMethod]:
    known = {context.name_of(method.named): method for method in context.core.methods}
    for services in interface.services:
        for method in services.methods:
            used = next((known[use.method.name] for use in method.uses or () if use.method.name in known), None)
            if used is not None:
                arguments, results = _typed(method.inputs, context), _typed(method.outputs, context)
                yield CalledMethod(member_name(method.name), used, arguments, results)


def _typed(arguments: tuple[MethodArgument, ...] | None, context: ComponentContext) -> tuple[tuple[str, str], ...]:
    return tuple((each.name, context.types.type(each.datatype)) for each in arguments or ())
