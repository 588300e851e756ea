"""Services of a component, and what its core has for each of their elements."""

from collections.abc import Iterator, Mapping
from typing import NamedTuple

from sigcat.adapter.autosar_adaptive.application.names import cpp_type
from sigcat.adapter.autosar_adaptive.application.plan import (
    CalledMethod,
    Passed,
    Provided,
    Receiver,
    Required,
    SentEvent,
    SentField,
)
from sigcat.adapter.autosar_adaptive.cpp_names import ServiceNames, TypeNames, instance_specifier, member_name
from sigcat.adapter.core.plan import Argument, Port
from sigcat.adapter.host.host_plan import HostPlan, HostValue
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
        Required(*_common(each, context), tuple(_receivers(each, context)))
        for each in context.component.services
        if each.role != "Provider"
    )


def provided_services(context: ComponentContext) -> tuple[Provided, ...]:
    """Services that the component offers."""
    return tuple(
        Provided(*_common(each, context), tuple(_sent_events(each, context)), tuple(_sent_fields(each, context)))
        for each in context.component.services
        if each.role == "Provider"
    )


def _common(
    interface: ServiceInterface, context: ComponentContext
) -> tuple[str, ServiceNames, str, tuple[CalledMethod, ...]]:
    port = instance_specifier(context.component, interface)
    return interface.name, context.names[interface.name], port, tuple(_methods(interface, context))


def _receivers(interface: ServiceInterface, context: ComponentContext) -> Iterator[Receiver]:
    for services in interface.services:
        for event in services.events:
            for value, port in _received(event, context.host):
                capacity = max(SAMPLES, *(item.queue.length if item.queue else 0 for _, item in port.consumers))
                yield _receiver(event, event.datatype, value, capacity, context)._replace(
                    wakes=bool(port.triggers), tells_of_rejection=port.tells_of_rejection
                )
        for field in services.fields:
            taken = context.host.received_status(_status_name(field))
            if taken is not None:
                yield _receiver(field, field.word, taken, SAMPLES, context)


def _receiver(
    element: Event | ServiceField, datatype: str, value: HostValue, capacity: int, context: ComponentContext
) -> Receiver:
    return Receiver(
        member_name(element.name),
        value.name,
        cpp_type(context.types.type(datatype)),
        value.wire,
        capacity,
        value.comment,
        is_protected=element.protection is not None,
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
    names, known = context.names[interface.name], context.host.methods
    for method in (method for services in interface.services for method in services.methods):
        used = next((known[use.method.name] for use in method.uses or () if use.method.name in known), None)
        if used is not None:
            member = member_name(method.name)
            struct = f"::{names.element('proxy', 'methods', member)}::Output"
            if interface.role == "Provider":
                struct = f"::{names.skeleton}::{member}Output"
            arguments = _passed(method.inputs, used.arguments, context)
            results = _passed(method.outputs, used.results, context)
            yield CalledMethod(member, used.named.name, struct if results else "void", arguments, results)


def _passed(
    listed: tuple[MethodArgument, ...] | None, core: tuple[Argument, ...], context: ComponentContext
) -> tuple[Passed, ...]:
    pairs = zip(listed or (), core, strict=True)
    return tuple(Passed(each.name, own.name, cpp_type(context.types.type(each.datatype))) for each, own in pairs)
