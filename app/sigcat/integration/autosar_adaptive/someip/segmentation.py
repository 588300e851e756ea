"""Events that are longer than a datagram: SOME/IP-TP sends them in segments (PRS_SOMEIPProtocol, AUTOSAR R23-11)."""

from collections.abc import Iterator, Mapping

from sigcat import codes
from sigcat.function.function_json.datatypes.primitive_types import c_type
from sigcat.integration.autosar_adaptive.context import Context
from sigcat.integration.autosar_adaptive.deployment.someip_settings import (
    DEFAULT_TRANSFORMATION,
    TransformationSettings,
)
from sigcat.integration.autosar_adaptive.deployment.transport import DEFAULT_TRANSPORT
from sigcat.integration.autosar_adaptive.model import Event, IntegrationModel, ServiceInterface, TypeEntry
from sigcat.integration.datatypes import BY_ADAPTIVE

LONGEST_PAYLOAD = 1400
"""Bytes that a datagram over UDP carries without segments."""
SEGMENT = 1392
"""Bytes of a segment: the largest multiple of 16 below it."""
_TEXT = "string"
_E2E_HEADERS = {4: 12, 5: 3, 6: 5, 7: 20}
"""Bytes of the header of each profile of end-to-end protection (PRS_E2EProtocol, AUTOSAR R23-11)."""


def segmented(model: IntegrationModel, context: Context) -> IntegrationModel:
    """The document with the length of segments at each event that needs them, and a finding for each."""
    types = {entry.name: entry for entry in model.datatypes or ()}
    for key, size in dict(_long_events(model, types)).items():
        message = f"{key} has up to {size:,} bytes, and is sent in segments of {SEGMENT:,} bytes (SOME/IP-TP)."
        context.findings.report(codes.EVENT_IN_SEGMENTS, message, key)
    return model.with_interfaces(lambda each: _in_service(each, model, types))


def _long_events(model: IntegrationModel, types: Mapping[str, TypeEntry]) -> Iterator[tuple[str, int]]:
    for interface in filter(_is_udp, model.interfaces):
        for event in interface.events:
            size = _payload(event, types, _layout(interface, model))
            if size is not None and size > LONGEST_PAYLOAD:
                yield f"{interface.name}.{event.name}", size


def _in_service(
    interface: ServiceInterface, model: IntegrationModel, types: Mapping[str, TypeEntry]
) -> ServiceInterface:
    layout = _layout(interface, model)

    def made(event: Event) -> Event:
        size = _payload(event, types, layout)
        is_long = _is_udp(interface) and (size is None or size > LONGEST_PAYLOAD)
        return event.model_copy(update={"segment_length": SEGMENT if is_long else None})

    services = tuple(each.model_copy(update={"events": tuple(map(made, each.events))}) for each in interface.services)
    return interface.model_copy(update={"services": services})


def _is_udp(interface: ServiceInterface) -> bool:
    """Whether messages are datagrams, which have a longest payload."""
    return (interface.transport or DEFAULT_TRANSPORT).protocol == "UDP"


def _layout(interface: ServiceInterface, model: IntegrationModel) -> TransformationSettings:
    return interface.transformation or (model.deployment.transformation if model.deployment else DEFAULT_TRANSFORMATION)


def _payload(event: Event, types: Mapping[str, TypeEntry], layout: TransformationSettings) -> int | None:
    """Largest payload of an event in bytes; None if its length is open."""
    size = size_of(event.datatype, types, layout)
    header = _E2E_HEADERS[event.protection.profile] if event.protection else 0
    return None if size is None else size + header


def size_of(word: str, types: Mapping[str, TypeEntry], layout: TransformationSettings, depth: int = 0) -> int | None:
    """Bytes of a value in SOME/IP; None if they vary, or nothing defines the datatype."""
    entry = types.get(word)
    if word in BY_ADAPTIVE and entry is None:
        primitive = c_type(BY_ADAPTIVE[word].c)
        return primitive.bits // 8 if primitive is not None and word != _TEXT else None
    if entry is None or entry.is_open or depth > len(types):
        return None
    if entry.kind == "array":
        element = size_of(entry.element, types, layout, depth + 1)
        return None if element is None else layout.array_length + element * int(entry.dimension or 0)
    if entry.kind == "structure":
        sizes = [size_of(each.type, types, layout, depth + 1) for each in entry.fields or ()]
        known = [size for size in sizes if size is not None]
        return layout.struct_length + sum(known) if len(known) == len(sizes) else None
    return size_of(entry.storage or entry.c_definition or "", types, layout, depth + 1)
