"""The error domain of methods, as a vendor's generator would make it of the ARXML (SWS_CM_11266)."""

from sigcat.adapter.autosar_adaptive.arxml.method_errors import DOMAIN, DOMAIN_ID, METHOD_ERRORS
from sigcat.adapter.autosar_adaptive.bench.headers import guard
from sigcat.adapter.autosar_adaptive.cpp_names import TypeNames
from sigcat.adapter.templates import rendered

_TEMPLATE = "adapter/autosar_adaptive/bench/services/error_domain.h.j2"


def errors_header(names: TypeNames, namespace: tuple[str, ...]) -> str:
    """The header that the common header of a service with methods includes."""
    number = f"0x{DOMAIN_ID:016X}"
    return rendered(
        _TEMPLATE,
        guard=guard(errors_path(names)),
        namespace="::".join(namespace),
        domain=DOMAIN,
        number=number,
        errors=METHOD_ERRORS,
    )


def errors_path(names: TypeNames) -> str:
    """The header as it is included."""
    return "/".join((*names.folders, f"{DOMAIN.lower()}_error_domain.h"))
