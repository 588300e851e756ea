"""Services of a component, and what its core has for each of their elements."""

from collections.abc import Iterator, Mapping
from typing import NamedTuple

from sigcat.adapter.autosar_adaptive.application.plan import (
    CalledMethod,
    Provided,
    Receiver,
    Required,
    SentEvent,
    SentField,
)
from sigcat.adapter.autosar_adaptive.cpp_names import ServiceNames, TypeNames, instance_specifier, member_name
from sigcat.adapter.core.plan import Port
from sigcat.adapter.host.plan import HostPlan, HostValue
from sigcat.integration.autosar_adaptive.model import Component, Event, MethodArgument, ServiceField, ServiceInterface

SAMPLES = 16
"""Values of an event that wait while the handler runs."""


class ComponentContext(NamedTuple):
    """A component of an integration, and the host that it is for its function."""

    component: Component
    host: HostPlan
    types: TypeNames
    names: Mapping[str, ServiceNames]


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
            for value, port in _received(event, context.host):
                capacity = max(SAMPLES, *(item.queue.length if item.queue else 0 for _, item in port.consumers))
                type_ = context.types.type(event.datatype)
                yield Receiver(
                    member_name(event.name),
                    value.name,
                    type_,
                    value.wire,
                    capacity,
                    value.comment,
                    port.tells_of_rejection,
                    event.protection is not None,
                )
        for field in services.fields:
            taken = context.host.received_status(_status_name(field))
            if taken is not None:
                type_ = context.types.type(field.word)
                yield Receiver(
                    member_name(field.name),
                    taken.name,
                    type_,
                    taken.wire,
                    SAMPLES,
                    taken.comment,
                    is_protected=field.protection is not None,
                )


def _sent_events(interface: ServiceInterface, context: ComponentContext) -> Iterator[SentEvent]:
    for services in interface.services:
        for event in services.events:
            for value in _values(event, context.host.provided):
                own = context.host.own_ports[value.name]
                yield SentEvent(member_name(event.name), value.name, value.is_queue, value.comment, own)


def _received(event: Event, host: HostPlan) -> Iterator[tuple[HostValue, Port]]:
    return ((value, value.port) for value in _values(event, host.consumed) if value.port is not None)


def _values(event: Event, known: Mapping[tuple[str, str], HostValue]) -> list[HostValue]:
    """Values of the core on one side of an event, each once."""
    ends = (known.get((use.call, use.interface.name)) for use in event.uses or ())
    return list({each.name: each for each in ends if each is not None}.values())


def _sent_fields(interface: ServiceInterface, context: ComponentContext) -> Iterator[SentField]:
    for field in (field for services in interface.services for field in services.fields):
        error, place = context.host.errors.get(_status_name(field)), context.host.sent_status(_status_name(field))
        if place is not None:
            again = _repeated_by(field, error.call if error else None, context)
            yield SentField(
                member_name(field.name), place.name, context.types.type(field.word), error.passed if error else None,
                error, place.comment, place.wire.c, again,
            )  # fmt: skip


def _repeated_by(field: ServiceField, call: str | None, context: ComponentContext) -> str | None:
    """The call that evaluates a protected status, or else the first one."""
    steps = [step.name for step in context.host.core.steps]
    if field.protection is None or not steps:
        return None
    return call if call in steps else steps[0]


def _status_name(field: ServiceField) -> str:
    """Name of the interface of a field."""
    status = field.error or field.safety_reaction or field.mode
    return status.name if status else field.name


def _methods(interface: ServiceInterface, context: ComponentContext) -> Iterator[CalledMethod]:
    for services in interface.services:
        for method in services.methods:
            used = next(
                (
                    context.host.methods[use.method.name]
                    for use in method.uses or ()
                    if use.method.name in context.host.methods
                ),
                None,
            )
            if used is not None:
                arguments, results = _typed(method.inputs, context), _typed(method.outputs, context)
                yield CalledMethod(member_name(method.name), used, arguments, results)


def _typed(arguments: tuple[MethodArgument, ...] | None, context: ComponentContext) -> tuple[tuple[str, str], ...]:
    return tuple((each.name, context.types.type(each.datatype)) for each in arguments or ())
