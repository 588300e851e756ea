"""Integration JSON from anywhere: read and checked."""

from sigcat import codes
from sigcat.integration.autosar_classic.model import ClassicIntegration
from sigcat.integration.autosar_classic.problems.document import problems_of
from sigcat.integration.checked_document import DocumentKind
from sigcat.limits import DEFAULT_LIMITS, Limits

_KIND = DocumentKind("autosar-classic", ClassicIntegration, codes.NOT_WRITABLE_AS_CLASSIC, problems_of)


def read_integration(data: bytes, name: str, limits: Limits = DEFAULT_LIMITS) -> ClassicIntegration:
    """The model of an Integration JSON. Raises InputRefused with everything that is wrong."""
    return _KIND.read(data, name, limits)
