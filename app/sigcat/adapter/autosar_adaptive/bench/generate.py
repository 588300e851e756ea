"""From an integration model to what a vendor's generator would write: datatypes, proxies, skeletons."""

from collections.abc import Mapping, Sequence

from sigcat.adapter.autosar_adaptive.bench import datatypes
from sigcat.adapter.autosar_adaptive.bench.codecs import NAME, codecs_source
from sigcat.adapter.autosar_adaptive.bench.common import common_header
from sigcat.adapter.autosar_adaptive.bench.method_errors import errors_header, errors_path
from sigcat.adapter.autosar_adaptive.bench.proxies import proxy_header, proxy_source
from sigcat.adapter.autosar_adaptive.bench.services import Service, services
from sigcat.adapter.autosar_adaptive.bench.skeletons import skeleton_header, skeleton_source
from sigcat.adapter.autosar_adaptive.bench.tables import tables_header, tables_source
from sigcat.adapter.autosar_adaptive.bench.unusable_names import unusable_names
from sigcat.adapter.autosar_adaptive.cpp_names import type_names
from sigcat.adapter.files import GeneratedFile
from sigcat.errors import InputRefused
from sigcat.integration.autosar_adaptive.document import writable
from sigcat.integration.autosar_adaptive.model import IntegrationModel

TARGET = "generated_services"
"""Library of CMake that an application links."""


def generate(model: IntegrationModel) -> tuple[GeneratedFile, ...]:
    """Headers, sources and the CMake library of them. The same model gives the same bytes.

    Raises InputRefused if the model names what AUTOSAR cannot, or C++.
    """
    whole = writable(model)
    listed, names = services(whole), type_names(whole)
    if findings := tuple(unusable_names(listed)):
        raise InputRefused("The services cannot be generated.", findings)
    headers = {**datatypes.headers(whole, names)}
    if any(service.whole.methods for service in listed):
        headers[errors_path(names)] = errors_header(names, listed[0].errors)
    sources = {NAME: codecs_source(whole, listed, names)}
    for service in listed:
        headers |= _headers(service)
        sources |= _sources(service, whole)
    files = {
        "CMakeLists.txt": _cmake(sorted(sources)),
        **{f"include/{path}": text for path, text in headers.items()},
        **{f"src/{path}": text for path, text in sources.items()},
    }
    return tuple(GeneratedFile(path, text.encode("utf-8")) for path, text in sorted(files.items()))


def _headers(service: Service) -> Mapping[str, str]:
    return {
        service.names.common_header: common_header(service),
        service.names.proxy_header: proxy_header(service),
        service.names.skeleton_header: skeleton_header(service),
        service.tables_header: tables_header(service),
    }


def _sources(service: Service, model: IntegrationModel) -> Mapping[str, str]:
    stem = "/".join((*service.names.namespace, service.names.stem.lower()))
    return {
        f"{stem}_proxy.cpp": proxy_source(service),
        f"{stem}_skeleton.cpp": skeleton_source(service),
        f"{stem}_tables.cpp": tables_source(service, model),
    }


def _cmake(sources: Sequence[str]) -> str:
    listed = "\n".join(f"    src/{path}" for path in sources)
    return f"""# Datatypes, proxies and skeletons, as a vendor's generator would make them of the ARXML.
add_library({TARGET} STATIC
{listed}
)
target_include_directories({TARGET} PUBLIC include)
target_link_libraries({TARGET} PUBLIC bench)
"""
