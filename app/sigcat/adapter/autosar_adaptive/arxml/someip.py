"""Common properties of all SOME/IP services: serialization, and the timing of service discovery."""

from collections.abc import Iterable, Sequence

from sigcat.adapter.arxml.paths import Paths
from sigcat.adapter.arxml.tree import Package, Tag, listed, reference, seconds, tag
from sigcat.adapter.autosar_adaptive.arxml.interfaces import Whole
from sigcat.adapter.autosar_adaptive.arxml.paths import DISCOVERY, INTERFACES, TRANSFORMATION
from sigcat.adapter.autosar_adaptive.arxml.releases import Release
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


def packages(chosen: ArxmlDeployment, services: Sequence[Whole], release: Release, paths: Paths) -> list[Package]:
    """The packages of transformation properties and of service discovery."""
    return [
        Package(
            TRANSFORMATION,
            (_transformation_set(chosen, services), *_transformation_mappings(services, release, paths)),
        ),
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
    apart = ((_properties_name(service), service.transformation) for service in services)
    own = (_transformation(name, stated) for name, stated in apart if stated is not None)
    properties = tag("TRANSFORMATION-PROPSS", _transformation(_PROPERTIES, chosen.transformation), *own)
    return tag("TRANSFORMATION-PROPS-SET", properties, name=_SET)


def _properties_name(service: Whole) -> str:
    """Name of the properties that hold for a service."""
    return short_name(f"{service.name}_Properties") if service.transformation else _PROPERTIES


def _transformation(name: str, chosen: TransformationSettings) -> Tag:
    return tag(
        _PROPERTIES_TAG,
        tag("ALIGNMENT", text=chosen.alignment),
        tag("BYTE-ORDER", text=_BYTE_ORDERS[chosen.byte_order]),
        tag("SESSION-HANDLING", text=_SESSIONS[chosen.session_handling]),
        tag("SIZE-OF-ARRAY-LENGTH-FIELD", text=chosen.array_length),
        tag("SIZE-OF-STRING-LENGTH-FIELD", text=chosen.string_length),
        tag("SIZE-OF-STRUCT-LENGTH-FIELD", text=chosen.struct_length),
        tag("STRING-ENCODING", text=chosen.string_encoding),
        name=name,
    )


def _transformation_mappings(services: Iterable[Whole], release: Release, paths: Paths) -> tuple[Tag, ...]:
    mappings = tuple(_transformation_mapping(service, paths) for service in services)
    if not release.has_sets or not mappings:
        return mappings
    return (tag(f"{_MAPPING_TAG}-SET", tag("MAPPINGS", *mappings), name=_MAPPINGS),)


def _transformation_mapping(service: Whole, paths: Paths) -> Tag:
    path = paths.of(INTERFACES, service.name)
    events = (reference("EVENT-REF", f"{path}/{item.name}", "VARIABLE-DATA-PROTOTYPE") for item in service.events)
    fields = (reference("FIELD-REF", f"{path}/{item.name}", "FIELD") for item in service.fields)
    methods = (reference("METHOD-REF", f"{path}/{item.name}", "CLIENT-SERVER-OPERATION") for item in service.methods)
    return tag(
        _MAPPING_TAG,
        listed("EVENT-REFS", events),
        listed("FIELD-REFS", fields),
        listed("METHOD-REFS", methods),
        reference(
            "TRANSFORMATION-PROPS-REF", paths.of(TRANSFORMATION, _SET, _properties_name(service)), _PROPERTIES_TAG
        ),
        name=short_name(f"{service.name}_Transformation"),
    )


# -- service discovery --------------------------------------------------------------------------------------------

_SERVER, _CLIENT = "Server", "Client"
_SERVER_TAG, _CLIENT_TAG = "SOMEIP-SD-SERVER-SERVICE-INSTANCE-CONFIG", "SOMEIP-SD-CLIENT-SERVICE-INSTANCE-CONFIG"
_EVENTS_OF_SERVER_TAG = "SOMEIP-SD-SERVER-EVENT-GROUP-TIMING-CONFIG"
_EVENTS_OF_CLIENT_TAG = "SOMEIP-SD-CLIENT-EVENT-GROUP-TIMING-CONFIG"


def instance_timing(*, provides: bool, paths: Paths) -> Tag:
    """The reference of a service instance to its timing."""
    if provides:
        return reference("SD-SERVER-CONFIG-REF", paths.of(DISCOVERY, _SERVER), _SERVER_TAG)
    return reference("SD-CLIENT-CONFIG-REF", paths.of(DISCOVERY, _CLIENT), _CLIENT_TAG)


def event_group_timing(*, provides: bool, paths: Paths) -> Tag:
    """The reference of an event group of an instance to its timing."""
    side, kind = (_SERVER, _EVENTS_OF_SERVER_TAG) if provides else (_CLIENT, _EVENTS_OF_CLIENT_TAG)
    return reference(f"SD-{side.upper()}-EVENT-GROUP-TIMING-CONFIG-REF", paths.of(DISCOVERY, f"{side}Events"), kind)


def _discovery(chosen: ServiceDiscoverySettings) -> Iterable[Tag]:
    response = tag(
        "REQUEST-RESPONSE-DELAY",
        tag("MAX-VALUE", text=seconds(chosen.response_delay_max)),
        tag("MIN-VALUE", text=seconds(chosen.response_delay_min)),
    )
    yield tag(
        _SERVER_TAG,
        _initial("INITIAL-OFFER-BEHAVIOR", chosen),
        tag("OFFER-CYCLIC-DELAY", text=seconds(chosen.offer_cyclic_delay)),
        response,
        tag("SERVICE-OFFER-TIME-TO-LIVE", text=chosen.offer_time_to_live),
        name=_SERVER,
    )
    yield tag(
        _CLIENT_TAG,
        _initial("INITIAL-FIND-BEHAVIOR", chosen),
        tag("SERVICE-FIND-TIME-TO-LIVE", text=chosen.find_time_to_live),
        name=_CLIENT,
    )
    yield tag(_EVENTS_OF_SERVER_TAG, response, name=f"{_SERVER}Events")
    time_to_live = tag("TIME-TO-LIVE", text=chosen.subscribe_time_to_live)
    yield tag(_EVENTS_OF_CLIENT_TAG, response, time_to_live, name=f"{_CLIENT}Events")


def _initial(tag_name: str, chosen: ServiceDiscoverySettings) -> Tag:
    return tag(
        tag_name,
        tag("INITIAL-DELAY-MAX-VALUE", text=seconds(chosen.initial_delay_max)),
        tag("INITIAL-DELAY-MIN-VALUE", text=seconds(chosen.initial_delay_min)),
        tag("INITIAL-REPETITIONS-BASE-DELAY", text=seconds(chosen.repetitions_base_delay)),
        tag("INITIAL-REPETITIONS-MAX", text=chosen.repetitions_max),
    )
