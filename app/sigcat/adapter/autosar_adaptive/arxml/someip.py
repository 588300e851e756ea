"""Common properties of all SOME/IP services: serialization, and the timing of service discovery."""

from collections.abc import Iterable, Sequence

from sigcat.adapter.arxml.tree import Package, Tag, reference, references, seconds, tag
from sigcat.adapter.autosar_adaptive.arxml.adaptive_type_elements import Library
from sigcat.adapter.autosar_adaptive.arxml.interfaces import Whole
from sigcat.adapter.autosar_adaptive.arxml.paths import DISCOVERY, INTERFACES, TRANSFORMATION
from sigcat.integration.autosar_adaptive.deployment.someip_settings import (
    ServiceDiscoverySettings,
    TransformationSettings,
)
from sigcat.integration.autosar_adaptive.model import ArxmlDeployment
from sigcat.integration.autosar_names import short_name

_SET, _MAPPINGS, _PROPERTIES = "SomeIp", "SomeIp_Mappings", "Default"
_PROPERTIES_TAG = "AP-SOMEIP-TRANSFORMATION-PROPS"
_MAPPING_TAG = "TRANSFORMATION-PROPS-TO-SERVICE-INTERFACE-ELEMENT-MAPPING"
_BYTE_ORDERS = {"big-endian": "MOST-SIGNIFICANT-BYTE-FIRST", "little-endian": "MOST-SIGNIFICANT-BYTE-LAST"}
_SESSIONS = {True: "SESSION-HANDLING-ACTIVE", False: "SESSION-HANDLING-INACTIVE"}


def packages(chosen: ArxmlDeployment, services: Sequence[Whole], known: Library) -> list[Package]:
    """The packages of transformation properties and of service discovery."""
    return [
        Package(TRANSFORMATION, (_transformation_set(chosen, services), *_transformation_mappings(services, known))),
        Package(DISCOVERY, tuple(_discovery(chosen.service_discovery))),
    ]


EVENT = "SOMEIP-EVENT-DEPLOYMENT"
NOTIFIER = "Notifier"
"""Name of the deployment of a field's event, in that of the field."""


def element_name(name: str) -> str:
    """Name of the deployment of an event, a field or a method."""
    return short_name(f"{name}_SomeIp")


# -- transformation -----------------------------------------------------------------------------------------------


def _transformation_set(chosen: ArxmlDeployment, services: Iterable[Whole]) -> Tag:
    apart = ((_properties_name(service), service.interface.transformation) for service in services)
    own = (_transformation(name, stated) for name, stated in apart if stated is not None)
    properties = tag("TRANSFORMATION-PROPSS", _transformation(_PROPERTIES, chosen.transformation), *own)
    return tag("TRANSFORMATION-PROPS-SET", properties, name=_SET)


def _properties_name(service: Whole) -> str:
    """Name of the properties that hold for a service."""
    return short_name(f"{service.name}_Properties") if service.interface.transformation else _PROPERTIES


def _transformation(name: str, chosen: TransformationSettings) -> Tag:
    lengths = {"ARRAY": chosen.array_length, "STRING": chosen.string_length, "STRUCT": chosen.struct_length}
    return tag(
        _PROPERTIES_TAG,
        {"ALIGNMENT": chosen.alignment, "BYTE-ORDER": _BYTE_ORDERS[chosen.byte_order]},
        {"SESSION-HANDLING": _SESSIONS[chosen.session_handling], "STRING-ENCODING": chosen.string_encoding},
        {f"SIZE-OF-{kind}-LENGTH-FIELD": size for kind, size in lengths.items()},
        name=name,
    )


def _transformation_mappings(services: Iterable[Whole], known: Library) -> tuple[Tag, ...]:
    mappings = tuple(_transformation_mapping(service, known) for service in services)
    if not known.release.has_sets or not mappings:
        return mappings
    return (tag(f"{_MAPPING_TAG}-SET", tag("MAPPINGS", *mappings), name=_MAPPINGS),)


def _transformation_mapping(service: Whole, known: Library) -> Tag:
    path = known.path(INTERFACES, service.name)
    properties = known.path(TRANSFORMATION, _SET, _properties_name(service))
    return tag(
        _MAPPING_TAG,
        references("EVENT-REF", (f"{path}/{each.name}" for each in service.events), "VARIABLE-DATA-PROTOTYPE"),
        references("FIELD-REF", (f"{path}/{each.name}" for each in service.fields), "FIELD"),
        references("METHOD-REF", (f"{path}/{each.name}" for each in service.methods), "CLIENT-SERVER-OPERATION"),
        reference("TRANSFORMATION-PROPS-REF", properties, _PROPERTIES_TAG),
        name=short_name(f"{service.name}_Transformation"),
    )


# -- service discovery --------------------------------------------------------------------------------------------

_SIDES = {True: "Server", False: "Client"}
"""Sides of a service, by whether they provide it."""


def instance_timing(*, provides: bool, known: Library) -> Tag:
    """The reference of a service instance to its timing."""
    side, path = _SIDES[provides], known.path(DISCOVERY, _SIDES[provides])
    return reference(f"SD-{side.upper()}-CONFIG-REF", path, _timing_tag(side, "SERVICE-INSTANCE"))


def event_group_timing(*, provides: bool, known: Library) -> Tag:
    """The reference of an event group of an instance to its timing."""
    side, path = _SIDES[provides], known.path(DISCOVERY, f"{_SIDES[provides]}Events")
    name = f"SD-{side.upper()}-EVENT-GROUP-TIMING-CONFIG-REF"
    return reference(name, path, _timing_tag(side, "EVENT-GROUP-TIMING"))


def _timing_tag(side: str, part: str) -> str:
    return f"SOMEIP-SD-{side.upper()}-{part}-CONFIG"


def _discovery(chosen: ServiceDiscoverySettings) -> Iterable[Tag]:
    limits = {"MAX-VALUE": seconds(chosen.response_delay_max), "MIN-VALUE": seconds(chosen.response_delay_min)}
    response = tag("REQUEST-RESPONSE-DELAY", limits)
    offer = {"SERVICE-OFFER-TIME-TO-LIVE": chosen.offer_time_to_live}
    cycle = {"OFFER-CYCLIC-DELAY": seconds(chosen.offer_cyclic_delay)}
    find = {"SERVICE-FIND-TIME-TO-LIVE": chosen.find_time_to_live}
    server, client = _SIDES[True], _SIDES[False]
    yield tag(_timing_tag(server, "SERVICE-INSTANCE"), _initial("OFFER", chosen), cycle, offer, response, name=server)
    yield tag(_timing_tag(client, "SERVICE-INSTANCE"), _initial("FIND", chosen), find, name=client)
    yield tag(_timing_tag(server, "EVENT-GROUP-TIMING"), response, name=f"{server}Events")
    subscription = {"TIME-TO-LIVE": chosen.subscribe_time_to_live}
    yield tag(_timing_tag(client, "EVENT-GROUP-TIMING"), response, subscription, name=f"{client}Events")


def _initial(purpose: str, chosen: ServiceDiscoverySettings) -> Tag:
    return tag(
        f"INITIAL-{purpose}-BEHAVIOR",
        {"INITIAL-DELAY-MAX-VALUE": seconds(chosen.initial_delay_max)},
        {"INITIAL-DELAY-MIN-VALUE": seconds(chosen.initial_delay_min)},
        {"INITIAL-REPETITIONS-BASE-DELAY": seconds(chosen.repetitions_base_delay)},
        {"INITIAL-REPETITIONS-MAX": chosen.repetitions_max},
    )
