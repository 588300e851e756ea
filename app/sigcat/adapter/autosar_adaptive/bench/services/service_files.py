"""Files of a service: datatypes and outputs of methods that its sides share, the proxy, and the skeleton."""

from collections.abc import Iterable, Mapping

from sigcat.adapter.autosar_adaptive.bench.headers import guard, includes
from sigcat.adapter.autosar_adaptive.bench.services.method_errors import errors_path
from sigcat.adapter.autosar_adaptive.bench.services.services import Service
from sigcat.adapter.templates import rendered
from sigcat.integration.datatypes import BY_ADAPTIVE

_ROOM = "adapter/autosar_adaptive/bench/services"


def service_headers(service: Service) -> Mapping[str, str]:
    """Headers by their paths as they are included."""
    names = service.names
    return {
        names.common_header: _header("common", names.common_header, service, _of_common(service)),
        names.proxy_header: _header("proxy", names.proxy_header, service, _of_proxy(service)),
        names.skeleton_header: _header("skeleton", names.skeleton_header, service, _of_skeleton(service)),
        service.tables_header: _header("tables", service.tables_header, service, ["bench/description.h"]),
    }


def proxy_source(service: Service) -> str:
    """The constructor, which connects the elements: apart, so that including the header costs little."""
    return rendered(f"{_ROOM}/proxy.cpp.j2", service=service, includes=includes([service.names.proxy_header]))


def skeleton_source(service: Service) -> str:
    """Constructors, and what hands requests to methods."""
    names = [service.names.skeleton_header, *(["<utility>"] if service.methods else [])]
    return rendered(f"{_ROOM}/skeleton.cpp.j2", service=service, includes=includes(names))


def _header(kind: str, path: str, service: Service, names: Iterable[str]) -> str:
    return rendered(f"{_ROOM}/{kind}.h.j2", service=service, includes=includes(names), guard=guard(path))


def _of_common(service: Service) -> Iterable[str]:
    yield from service.types.headers(service.words)
    if any(word in BY_ADAPTIVE for word in service.words):
        yield "<cstdint>"
    if service.methods:
        yield errors_path(service.types)


def _of_proxy(service: Service) -> Iterable[str]:
    yield from (service.names.common_header, service.tables_header, "bench/proxy_base.h")
    used = {"proxy_event.h": service.events, "proxy_field.h": service.fields, "proxy_method.h": service.methods}
    yield from (f"bench/{name}" for name, elements in used.items() if elements)


def _of_skeleton(service: Service) -> Iterable[str]:
    yield from (service.names.common_header, service.tables_header, "bench/skeleton_base.h")
    used = {"skeleton_event.h": service.events, "skeleton_field.h": service.fields}
    yield from (f"bench/{name}" for name, elements in used.items() if elements)
