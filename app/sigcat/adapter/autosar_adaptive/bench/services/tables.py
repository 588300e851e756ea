"""Ids, times and ports of a service: what a vendor's platform takes of the manifests at run time."""

from collections.abc import Iterable
from typing import NamedTuple

from sigcat.adapter.autosar_adaptive.arxml.method_errors import DOMAIN, METHOD_ERRORS
from sigcat.adapter.autosar_adaptive.bench.headers import includes
from sigcat.adapter.autosar_adaptive.bench.services.method_errors import errors_path
from sigcat.adapter.autosar_adaptive.bench.services.services import Service, error_namespace, hexadecimal
from sigcat.adapter.autosar_adaptive.cpp_names import instance_specifier
from sigcat.adapter.templates import rendered
from sigcat.integration.autosar_adaptive.model import IntegrationModel
from sigcat.integration.autosar_adaptive.processes import processes
from sigcat.integration.autosar_names import short_name

_TEMPLATE = "adapter/autosar_adaptive/bench/services/tables.cpp.j2"


class _Instance(NamedTuple):
    """A port with its instance of the service."""

    port: str
    number: str
    process: str = ""
    """The further process of an executable that has it, if it is of one."""


def tables_source(service: Service, model: IntegrationModel) -> str:
    """The tables themselves."""
    deployment = model.deployment
    assert deployment is not None
    transformation = service.whole.interface.transformation or deployment.transformation
    return rendered(
        _TEMPLATE,
        service=service,
        includes=includes([service.tables_header, *([errors_path(service.types)] if service.methods else [])]),
        number=hexadecimal(service.whole.interface.service_id),
        instances=[*_instances(service, model)],
        error_domain="::".join(("", *error_namespace(model), f"Get{DOMAIN}ErrorDomain")),
        errors=METHOD_ERRORS,
        transformation=transformation,
        is_big_endian=transformation.byte_order == "big-endian",
        is_utf16=transformation.string_encoding == "UTF-16",
        alignment=transformation.alignment // 8,  # in bytes
        times={name: f"{value:g}" for name, value in deployment.service_discovery},
    )


def _instances(service: Service, model: IntegrationModel) -> Iterable[_Instance]:
    for process in processes(model.components):
        further = process.name if process.is_further else ""
        for interface in process.services:
            if interface.name == service.name:
                port = instance_specifier(process.component, interface)
                yield _Instance(port, hexadecimal(interface.instance_id), further)
    yield _Instance(player_port(service.name, model), hexadecimal(service.whole.interface.instance_id))


def player_port(service: str, model: IntegrationModel) -> str:
    """The port of the player, which offers what no component provides, and uses what one does."""
    roles = {interface.role for part in model.components for interface in part.services if interface.name == service}
    side = "R" if "Provider" in roles else "P"
    return f"Player/Player_Root/{short_name(f'{service}_{side}Port')}"
