"""Structs of messages beside those of the core."""

from collections.abc import Iterator

from sigcat import codes
from sigcat.adapter.core.plan import WireStruct, WireType
from sigcat.adapter.ros2.node_context import NodeContext
from sigcat.adapter.ros2.plan import InterfaceType, StructPair
from sigcat.errors import InputRefused
from sigcat.integration.ros2.model import Message
from sigcat.integration.ros2.services import CLIENT, SERVER
from sigcat.integration.ros2.topics import PUBLISHER, SUBSCRIPTION


def struct_pairs(context: NodeContext, package: str) -> tuple[StructPair, ...]:
    """The structs that a node takes and gives, each after those that it holds."""
    known = {struct.name: struct for struct in context.host.core.structs}
    found: dict[str, StructPair] = {}
    for field_type, wire in _uses(context):
        if wire.is_struct:
            _add(context.messages[_element(field_type)], known[wire.c], found, known, package, context)
    return tuple(found.values())


def _element(field_type: str) -> str:
    """`Point[4]` → `Point`."""
    return field_type.partition("[")[0]


def _uses(context: NodeContext) -> Iterator[tuple[str, WireType]]:
    """Datatypes of fields, and of the places of the core."""
    for role in (SUBSCRIPTION, PUBLISHER):
        for call, topic in context.topics(role):
            for mapping in topic.mappings:
                known = context.host.consumed if role == SUBSCRIPTION else context.host.provided
                if (value := known.get((call, mapping.signal))) is not None:
                    yield mapping.field_type, value.wire
    for service in (*context.services(SERVER), *context.services(CLIENT)):
        method = context.host.methods[service.method]
        for maps, arguments in ((service.request, method.arguments), (service.response, method.results)):
            yield from ((each.field_type, argument.value.wire) for each, argument in zip(maps, arguments, strict=True))


def _add(
    message: Message, struct: WireStruct, found: dict[str, StructPair], known: dict[str, WireStruct], package: str,
    context: NodeContext,
) -> None:  # fmt: skip
    if len(message.fields) != len(struct.fields):
        text = f"The message {message.name} must have the {len(struct.fields)} members of its struct, not {len(message.fields)}."
        finding = codes.NOT_WRITABLE_AS_ROS2.finding(text, pointer="/InterfacePackageList/0/Messages")
        raise InputRefused("The integration cannot become packages.", (finding,))
    for field, member in zip(message.fields, struct.fields, strict=True):
        if member.c in known:
            _add(context.messages[_element(field.datatype)], known[member.c], found, known, package, context)
    members = tuple(field.name for field in message.fields)
    found.setdefault(struct.name, StructPair(InterfaceType(package, "msg", message.name), members, struct))
