"""End-to-end protection of events and notifiers of fields: profiles and data ids."""

from collections.abc import Iterable

from sigcat.adapter.arxml.tree import Package, Tag, listed, reference, tag
from sigcat.adapter.autosar_adaptive.arxml.adaptive_type_elements import Library
from sigcat.adapter.autosar_adaptive.arxml.paths import E2E
from sigcat.adapter.autosar_adaptive.arxml.someip import EVENT, NOTIFIER, element_name
from sigcat.integration.autosar_adaptive.e2e import E2eProtection
from sigcat.integration.autosar_adaptive.model import Event, IntegrationModel, ServiceField, ServiceInterface
from sigcat.integration.autosar_names import short_name

_SET = "Profiles"
_CONFIGURATION = "E-2-E-PROFILE-CONFIGURATION"


def package(model: IntegrationModel) -> Package:
    """The package of profiles; it is empty if nothing is protected."""
    services = (interface for component in model.components for interface in component.services)
    protections = (event.protection for interface in services for event in _protected(interface))
    found = {_name(protection): protection for protection in protections if protection}
    configurations = listed(f"{_CONFIGURATION}S", (_configuration(found[name]) for name in sorted(found)))
    return Package(E2E, (tag(f"{_CONFIGURATION}-SET", configurations, name=_SET),) if found else ())


def _name(protection: E2eProtection) -> str:
    return f"Profile{protection.profile:02d}_MaxDeltaCounter{protection.max_delta_counter}"


def _configuration(protection: E2eProtection) -> Tag:
    return tag(
        _CONFIGURATION,
        {"MAX-DELTA-COUNTER": protection.max_delta_counter, "PROFILE-NAME": f"PROFILE_{protection.profile:02d}"},
        name=_name(protection),
    )


def properties(interface: ServiceInterface, deployment: str, known: Library) -> Tag | None:
    """Data ids and profiles of an instance; `deployment` is the path of the deployment of its service."""
    protected = _protected(interface)
    return listed("E-2-E-EVENT-PROTECTION-PROPSS", (_properties(event, deployment, known) for event in protected))


def _properties(event: Event | ServiceField, deployment: str, known: Library) -> Tag:
    assert event.protection is not None
    notifier = f"/{NOTIFIER}" if isinstance(event, ServiceField) else ""
    return tag(
        "END-2-END-EVENT-PROTECTION-PROPS",
        tag("DATA-IDS", {"DATA-ID": event.protection.data_id}),
        reference("E-2-E-PROFILE-CONFIGURATION-REF", known.path(E2E, _SET, _name(event.protection)), _CONFIGURATION),
        reference("EVENT-REF", f"{deployment}/{element_name(event.name)}{notifier}", EVENT),
        name=short_name(f"{event.name}_E2e"),
    )


def _protected(interface: ServiceInterface) -> Iterable[Event | ServiceField]:
    yield from (event for part in interface.services for event in part.events if event.protection is not None)
    yield from (field for part in interface.services for field in part.fields if field.protection is not None)
