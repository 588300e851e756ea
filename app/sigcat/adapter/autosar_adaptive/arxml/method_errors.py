"""Application errors of methods: why a function does not answer a request (section 12 of the core)."""

from collections.abc import Iterable
from typing import NamedTuple

from sigcat.adapter.arxml.paths import Paths
from sigcat.adapter.arxml.tree import Package, Tag, description, namespaces, reference, references, tag
from sigcat.adapter.autosar_adaptive.arxml.paths import ERRORS
from sigcat.function.document.text import Text
from sigcat.integration.autosar_adaptive.model import Method


class MethodError(NamedTuple):
    """An error that a method may return."""

    name: str
    """Its short name, which is the enumerator in C++ (SWS_CM_11266)."""
    code: int
    reply: str
    """Its constant in the core."""
    description: str


DOMAIN = "FunctionMethod"
"""Short name of the error domain: FunctionMethodErrc, FunctionMethodErrorDomain (SWS_CORE_10901, SWS_CORE_10931)."""
DOMAIN_ID = 0x3030931128873625
"""The same for all applications, so that a consumer knows the errors of a provider that was integrated apart."""
METHOD_ERRORS = (
    MethodError("kExcluded", 1, "EXCLUDED", "The mode excludes the call, or the function is not initialized."),
    MethodError("kBadArgument", 2, "BAD_ARGUMENT", "An argument has a number that its enumeration does not name."),
)


def packages(methods: Iterable[Method], namespace: tuple[str, ...], paths: Paths) -> list[Package]:
    """The domain and its errors; nothing without methods."""
    if not any(methods):
        return []
    domain = tag("AP-APPLICATION-ERROR-DOMAIN", namespaces(namespace), {"VALUE": DOMAIN_ID}, name=DOMAIN)
    return [Package(ERRORS, (domain, *(_error(each, paths) for each in METHOD_ERRORS)))]


def _error(error: MethodError, paths: Paths) -> Tag:
    return tag(
        "AP-APPLICATION-ERROR",
        description(Text(error.description)),
        {"ERROR-CODE": error.code},
        reference("ERROR-DOMAIN-REF", paths.of(ERRORS, DOMAIN), "AP-APPLICATION-ERROR-DOMAIN"),
        name=error.name,
    )


def possible_errors(paths: Paths) -> Tag | None:
    """References of an operation to the errors."""
    errors = (paths.of(ERRORS, each.name) for each in METHOD_ERRORS)
    return references("POSSIBLE-AP-ERROR-REF", errors, "AP-APPLICATION-ERROR")
