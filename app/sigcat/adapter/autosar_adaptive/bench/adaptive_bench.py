"""From an integration model to what a vendor's generator would write: datatypes, proxies, skeletons."""

from collections.abc import Mapping

from sigcat.adapter.autosar_adaptive.bench.datatypes import datatypes
from sigcat.adapter.autosar_adaptive.bench.datatypes.codecs import NAME, codecs_source
from sigcat.adapter.autosar_adaptive.bench.services.method_errors import errors_header, errors_path
from sigcat.adapter.autosar_adaptive.bench.services.service_files import proxy_source, service_headers, skeleton_source
from sigcat.adapter.autosar_adaptive.bench.services.services import Service, error_namespace, services
from sigcat.adapter.autosar_adaptive.bench.services.tables import tables_source
from sigcat.adapter.autosar_adaptive.bench.services.unusable_names import unusable_names
from sigcat.adapter.autosar_adaptive.cpp_names import type_names
from sigcat.adapter.files import GeneratedFile
from sigcat.adapter.templates import rendered
from sigcat.errors import InputRefused
from sigcat.integration.autosar_adaptive.document import writable
from sigcat.integration.autosar_adaptive.model import IntegrationModel


def generate(model: IntegrationModel) -> tuple[GeneratedFile, ...]:
    """Headers, sources and the CMake library of them. The same model gives the same bytes.

    Raises InputRefused if the model names what AUTOSAR cannot, or C++.
    """
    whole = writable(model)
    listed, names = services(whole), type_names(whole)
    if findings := tuple(unusable_names(listed)):
        raise InputRefused("The services cannot be generated.", findings)
    headers = {**datatypes.headers(whole, names)}
    if any(service.methods for service in listed):
        headers[errors_path(names)] = errors_header(names, error_namespace(whole))
    sources = {NAME: codecs_source(whole, listed, names)}
    for service in listed:
        headers |= service_headers(service)
        sources |= _sources(service, whole)
    files = {
        "CMakeLists.txt": rendered("adapter/autosar_adaptive/bench/CMakeLists.txt.j2", sources=sorted(sources)),
        **{f"include/{path}": text for path, text in headers.items()},
        **{f"src/{path}": text for path, text in sources.items()},
    }
    return tuple(GeneratedFile(path, text.encode("utf-8")) for path, text in sorted(files.items()))


def _sources(service: Service, model: IntegrationModel) -> Mapping[str, str]:
    stem = "/".join((*service.names.namespace, service.names.stem.lower()))
    return {
        f"{stem}_proxy.cpp": proxy_source(service),
        f"{stem}_skeleton.cpp": skeleton_source(service),
        f"{stem}_tables.cpp": tables_source(service, model),
    }
