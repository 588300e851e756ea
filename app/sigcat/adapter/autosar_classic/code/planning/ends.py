"""Data elements of a component, and what its core has for each of them."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from itertools import islice

from sigcat.adapter.autosar_classic.code.plan import DataEnd, RteType
from sigcat.adapter.autosar_classic.code.rte_types import type_of
from sigcat.adapter.host.host_plan import HostPlan, HostValue
from sigcat.integration.autosar_classic.model import ClassicIntegration, Component, DataElement, Element, Port, Use


@dataclass(frozen=True)
class SwcContext:
    """A component of an integration, and the host that it is for its function."""

    model: ClassicIntegration
    component: Component
    host: HostPlan
    types: Mapping[str, RteType]

    @cached_property
    def elements(self) -> Mapping[tuple[str, str], DataElement]:
        """Data elements, by interface and name."""
        interfaces = self.model.sender_receiver_interfaces
        return {(one.name, each.name): each for one in interfaces for each in one.elements}

    def type_of(self, name: str) -> RteType:
        """The datatype with a name of the document."""
        return type_of(name, self.model, self.types)

    def data(self, direction: str) -> Iterator[tuple[Port, Element, DataElement]]:
        """Data elements that the component requires or provides."""
        for port in self.component.ports:
            if port.kind == "SenderReceiver" and port.direction == direction:
                for element in port.elements:
                    yield port, element, self.elements[port.interface, element.name]


# -- received -----------------------------------------------------------------------------------------------------


def received(context: SwcContext) -> Iterator[DataEnd]:
    """Ports that the component requires."""
    for port, element, data in context.data("Required"):
        ends = (_received(port, element, data, use, context) for use in element.uses or ())
        yield from islice(filter(None, ends), 1)


def _received(port: Port, element: Element, data: DataElement, use: Use, context: SwcContext) -> DataEnd | None:
    signal = context.host.consumed.get((use.call or "", use.interface))
    if signal is not None and (core := signal.port) is not None:
        immediate = frozenset(call for call, item in core.consumers if item.is_immediate)
        end = _end(port, element, data, use, context, signal)
        return end._replace(
            tells_of_rejection=core.tells_of_rejection, tells_of_loss=core.tells_of_loss, immediate_in=immediate
        )
    status = context.host.received_status(use.interface) or context.host.received_status(port.interface)
    return _end(port, element, data, use, context, status) if status else None


def _end(port: Port, element: Element, data: DataElement, use: Use, context: SwcContext, value: HostValue) -> DataEnd:
    return DataEnd(
        port=port.name,
        element=element.name,
        type=context.type_of(data.type),
        wire=value.wire,
        place=value.name,
        comment=value.comment,
        columns=_columns(data, use),
        is_queue=bool(data.queued),
        room=element.queue_length or 1,
        has_update=bool(element.update),
        has_transformer_errors=port.reports_transformer_errors,
    )


def _columns(data: DataElement, use: Use) -> tuple[str, ...]:
    """A signal is called by its path; what has a name that is known everywhere, by both."""
    if use.kind in ("signal", "queue"):
        return (data.vss_path or use.interface,)
    return tuple(dict.fromkeys(filter(None, (use.interface, data.vss_path))))


# -- sent ---------------------------------------------------------------------------------------------------------


def sent(context: SwcContext) -> Iterator[DataEnd]:
    """Ports that the component provides."""
    for port, element, data in context.data("Provided"):
        ends = (_sent(port, element, data, use, context) for use in element.uses or ())
        yield from islice(filter(None, ends), 1)


def _sent(port: Port, element: Element, data: DataElement, use: Use, context: SwcContext) -> DataEnd | None:
    value = context.host.provided.get((use.call or "", use.interface)) or context.host.sent_status(use.interface)
    if value is None:
        return None
    return _end(port, element, data, use, context, value)._replace(has_count=value.is_queue, call=value.call)
