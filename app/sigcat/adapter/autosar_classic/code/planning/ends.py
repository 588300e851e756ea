"""Data elements of a component, and what its core has for each of them."""

from collections.abc import Iterator, Mapping
from itertools import islice

from sigcat.adapter.autosar_classic.code.plan import DataEnd, RteType
from sigcat.adapter.autosar_classic.code.types import type_of
from sigcat.adapter.core.places import CorePlaces, StatusPlace
from sigcat.adapter.core.plan import CorePlan
from sigcat.adapter.core.plan import Port as CorePort
from sigcat.function.function_json.model import FunctionJson
from sigcat.integration.autosar_classic.model import ClassicIntegration, Component, DataElement, Element, Port, Use


class SwcContext(CorePlaces):
    """A component of an integration, beside the core of its function."""

    def __init__(
        self,
        model: ClassicIntegration,
        component: Component,
        function: FunctionJson,
        core: CorePlan,
        types: Mapping[str, RteType],
    ) -> None:
        super().__init__(function, core)
        self.model = model
        self.component = component
        self.types = types
        self.elements = {
            (one.name, each.name): each for one in model.sender_receiver_interfaces for each in one.elements
        }

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
    core = context.port(use.call, use.interface)
    if core is not None:
        immediate = frozenset(call for call, item in core.consumers if item.is_immediate)
        end = _end(port, element, data, use, context, core)
        return end._replace(
            tells_of_rejection=core.tells_of_rejection, tells_of_loss=core.tells_of_loss, immediate_in=immediate
        )
    status = context.received_status(use.interface) or context.received_status(port.interface)
    return _end(port, element, data, use, context, status) if status else None


def _end(
    port: Port,
    element: Element,
    data: DataElement,
    use: Use,
    context: SwcContext,
    place: CorePort | StatusPlace,
) -> DataEnd:
    return DataEnd(
        port=port.name,
        element=element.name,
        type=type_of(data.type, context.model, context.types),
        wire=place.wire,
        place=place.name,
        comment=place.comment,
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
    output = context.output(use.call, use.interface)
    if output is not None:
        named, call = output.named, next(step.name for step in context.core.steps if output in step.outputs)
        place = StatusPlace(named.name, output.value.wire, named.comment)
        end = _end(port, element, data, use, context, place)
        return end._replace(has_count=output.queue is not None, call=call)
    status = context.sent_status(use.interface)
    return _end(port, element, data, use, context, status) if status else None
