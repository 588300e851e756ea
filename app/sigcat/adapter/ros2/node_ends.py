"""Topics and services of a node, and what its core has for each of their fields."""

from collections.abc import Iterator

from sigcat.adapter.core.identifiers import identifier, unique
from sigcat.adapter.core.numbers import type_of_c
from sigcat.adapter.core.plan import Method, WireType
from sigcat.adapter.host.host_plan import HostPlan, HostValue
from sigcat.adapter.ros2.node_context import NodeContext
from sigcat.adapter.ros2.plan import (
    ArgumentField,
    Fixed,
    InterfaceType,
    MethodService,
    Publisher,
    ReceivedField,
    SentField,
    Subscription,
    Symbol,
)
from sigcat.integration.ros2.model import ArgumentMap, FieldMapping, QualityOfService, RosTopic, StatusTopic
from sigcat.integration.ros2.services import CLIENT, SERVER
from sigcat.integration.ros2.topics import PUBLISHER, SUBSCRIPTION


def interface_type(text: str) -> InterfaceType:
    """`eco_control_interfaces/msg/Speed`, taken apart."""
    package, kind, name = text.split("/")
    return InterfaceType(package, kind, name)


def _member(topic: str, taken: dict[str, str]) -> str:
    """A name for a topic, unique in the node."""
    taken[topic] = unique(identifier(topic.strip("/").replace("/", "_")), taken.values())
    return taken[topic]


def _status_topics(context: NodeContext, role: str) -> Iterator[StatusTopic]:
    node = context.node
    return (topic for topic in (*node.error_topics, *node.reaction_topics, *node.modes) if topic.role == role)


def _text_symbols(mapping: FieldMapping, wire: WireType) -> tuple[Symbol, ...]:
    """Texts of an enumeration, if its field is text."""
    is_text = mapping.field_type.startswith("string")
    return tuple(Symbol(text, number) for text, number in wire.symbols) if is_text else ()


# -- subscriptions ------------------------------------------------------------------------------------------------


def subscriptions(context: NodeContext) -> tuple[Subscription, ...]:
    """The topics that the node takes, each once. What the function itself publishes needs no message."""
    own = {topic.name for _, topic in context.topics(PUBLISHER)}
    found: dict[str, list[tuple[str, RosTopic]]] = {}
    for call, topic in context.topics(SUBSCRIPTION):
        if topic.name not in own:
            found.setdefault(topic.name, []).append((call, topic))
    names: dict[str, str] = {}
    made = [_subscription(name, ends, names, context) for name, ends in found.items()]
    made += [_status_subscription(topic, taken, names)
             for topic in _status_topics(context, SUBSCRIPTION)
             if (taken := _received_status(topic, context)) is not None]  # fmt: skip
    return tuple(each for each in made if each.takes)


def _subscription(
    name: str, ends: list[tuple[str, RosTopic]], names: dict[str, str], context: NodeContext
) -> Subscription:
    takes: dict[str, ReceivedField] = {}
    for call, topic in ends:
        for mapping in topic.mappings:
            value = context.host.consumed.get((call, mapping.signal))
            if value is not None:
                takes[value.name] = _received_field(mapping, value)
    first = ends[0][1]
    assert first.message is not None
    quality = _combined([topic.quality for _, topic in ends if topic.quality is not None])
    return Subscription(name, interface_type(first.message), _member(name, names), quality, tuple(takes.values()))


def _received_field(mapping: FieldMapping, value: HostValue) -> ReceivedField:
    symbols = () if mapping.number_field else _text_symbols(mapping, value.wire)
    field = mapping.number_field or mapping.field
    nameless = _nameless(value.wire) if symbols else None
    wakes = value.port is not None and bool(value.port.triggers)
    return ReceivedField(value.name, field, value.wire, value.comment, symbols, nameless, wakes=wakes)


_FIRST_NAMELESS = 2**31 - 1
"""The highest number that is tried: code reads better with one of few digits."""


def _nameless(wire: WireType) -> int | None:
    kind, named = type_of_c(wire.c), {number for _, number in wire.symbols}
    if kind is None:
        return None
    numbers = range(min(int(kind.largest), _FIRST_NAMELESS), int(kind.smallest) - 1, -1)
    return next((number for number in numbers if number not in named), None)


def _combined(qualities: list[QualityOfService]) -> QualityOfService:
    """One subscription for all calls: the deepest, with the shortest deadline."""
    deadlines = [each.deadline for each in qualities if each.deadline is not None]
    depth = max(each.depth for each in qualities)
    return qualities[0].model_copy(update={"depth": depth, "deadline": min(deadlines, default=None)})


def _status_subscription(topic: StatusTopic, taken: ReceivedField, names: dict[str, str]) -> Subscription:
    member = _member(topic.topic, names)
    return Subscription(topic.topic, interface_type(topic.message), member, topic.quality, (taken,))


def _received_status(topic: StatusTopic, context: NodeContext) -> ReceivedField | None:
    """The input that receives an error of others, a safety reaction or the mode."""
    place = context.host.received_status(topic.interface)
    if place is None:
        return None
    return ReceivedField(
        place.name, topic.field, place.wire, place.comment, numbers=_differing(tuple(enumerate(place.numbers)))
    )


def _differing(numbers: tuple[tuple[int, int], ...]) -> tuple[tuple[int, int], ...]:
    """Pairs of numbers; none if the message has those of the core: 0 says that all is well, and 1 that it is not."""
    return () if all(one == other for one, other in numbers) else numbers


# -- publishers ---------------------------------------------------------------------------------------------------


def publishers(context: NodeContext) -> tuple[Publisher, ...]:
    """The topics that the node gives, each once: data, then errors, safety reactions and the mode."""
    found: dict[str, list[tuple[str, RosTopic]]] = {}
    for call, topic in context.topics(PUBLISHER):
        found.setdefault(topic.name, []).append((call, topic))
    names: dict[str, str] = {}
    made = [_publisher(name, ends, names, context) for name, ends in found.items()]
    made += [Publisher(topic.topic, interface_type(topic.message), _member(topic.topic, names), topic.quality, (given,),
                       is_status=True)
             for topic in _status_topics(context, PUBLISHER)
             if (given := _sent_status(topic, context)) is not None]  # fmt: skip
    return tuple(each for each in made if each.gives)


def _publisher(name: str, ends: list[tuple[str, RosTopic]], names: dict[str, str], context: NodeContext) -> Publisher:
    gives: dict[str, SentField] = {}
    for call, topic in ends:
        for mapping in topic.mappings:
            value = context.host.provided.get((call, mapping.signal))
            if value is not None:
                gives[value.name] = _sent_field(mapping, value, context.host)
    first = ends[0][1]
    assert first.message is not None
    assert first.quality is not None
    return Publisher(
        name, interface_type(first.message), _member(name, names), first.quality, tuple(gives.values()),
        stamp=first.stamp, fixed=tuple(Fixed(each.field, each.value) for each in first.values or ()),
    )  # fmt: skip


def _sent_field(mapping: FieldMapping, value: HostValue, host: HostPlan) -> SentField:
    return SentField(
        place=value.name,
        field=mapping.field,
        wire=value.wire,
        comment=value.comment,
        is_queue=value.is_queue,
        number_field=mapping.number_field,
        symbols=_text_symbols(mapping, value.wire),
        own_ports=host.own_ports[value.name],
    )


def _sent_status(topic: StatusTopic, context: NodeContext) -> SentField | None:
    """Sent status of an error, a safety reaction or the mode."""
    place = context.host.sent_status(topic.interface)
    if place is None:
        return None
    numbers = _differing(tuple((number, index) for index, number in enumerate(place.numbers)))
    return SentField(place.name, topic.field, place.wire, place.comment, numbers=numbers)


# -- services -----------------------------------------------------------------------------------------------------


def services(context: NodeContext, role: str) -> tuple[MethodService, ...]:
    """Methods that the function offers (Server) or uses (Client)."""
    assert role in (SERVER, CLIENT)
    names: dict[str, str] = {}
    found: dict[str, MethodService] = {}
    for service in context.services(role):
        method = context.host.methods.get(service.method)
        if method is not None and service.name not in found:
            found[service.name] = MethodService(
                topic=service.name,
                service=interface_type(service.service),
                member=_member(service.name, names),
                method=method,
                request=_fields(service.request, method, is_request=True),
                response=_fields(service.response, method, is_request=False),
                success=service.success,
            )
    return tuple(found.values())


def _fields(maps: tuple[ArgumentMap, ...], method: Method, *, is_request: bool) -> tuple[ArgumentField, ...]:
    arguments = method.arguments if is_request else method.results
    return tuple(ArgumentField(each.field, argument) for each, argument in zip(maps, arguments, strict=True))
