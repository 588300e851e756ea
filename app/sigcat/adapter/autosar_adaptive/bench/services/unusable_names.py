"""Names that ARXML permits and C++ does not: those that hide others, or that two classes would have."""

from collections.abc import Iterator, Mapping, Sequence

from sigcat import codes
from sigcat.adapter.autosar_adaptive.bench.services.services import Element, Service, ServiceMethod
from sigcat.findings import Finding

_OF_EVERY_PROXY = {"Create", "FindService", "StartFindService", "StopFindService", "GetHandle", "HandleType"}
_OF_EVERY_SKELETON = {"OfferService", "StopOfferService", "ProcessNextMethodCall"}
_OF_THE_PLATFORM = ("ara", "std", "bench")


def unusable_names(services: Sequence[Service]) -> Iterator[Finding]:
    """A finding for each."""
    for service in services:
        yield from _hiding(service)
        yield from _taken(service)
    yield from _shared(services)


def _hiding(service: Service) -> Iterator[Finding]:
    inner = {*service.names.namespace[1:], *service.types.namespace[1:]}
    outer = {*_OF_THE_PLATFORM, *service.types.namespace[:1]}
    found = sorted((inner & outer) | ({"bench"} & {*service.names.namespace[:1], *service.types.namespace[:1]}))
    for name in found:
        message = (
            f"The namespace of {service.name} must not have {name} in it, which hides the namespace {name} of others."
        )
        yield codes.NOT_WRITABLE_AS_ARXML.finding(message, fix="Rename it under `namespace` of the deployment.")


def _taken(service: Service) -> Iterator[Finding]:
    for elements in _kinds(service).values():
        for element in elements:
            if element.member in _OF_EVERY_PROXY | _OF_EVERY_SKELETON:
                message = f"{element.name} of {service.name} must have another name: every proxy or skeleton has one of this name."
                yield codes.NOT_WRITABLE_AS_ARXML.finding(message, fix="Rename it.")


def _shared(services: Sequence[Service]) -> Iterator[Finding]:
    owners: dict[tuple[tuple[str, ...], str, str], str] = {}
    for service in services:
        for kind, elements in _kinds(service).items():
            for element in elements:
                key = (service.names.namespace, kind, element.member)
                owner = owners.setdefault(key, service.name)
                if owner != service.name:
                    message = (
                        f"{owner} and {service.name} must not both have {element.name} in one namespace, as AUTOSAR "
                        "names its class without the service."
                    )
                    fix = "Give one of them its own `namespace` in the deployment."
                    yield codes.NOT_WRITABLE_AS_ARXML.finding(message, fix=fix)


def _kinds(service: Service) -> Mapping[str, Sequence[Element | ServiceMethod]]:
    return {"events": service.events, "fields": service.fields, "methods": service.methods}
