"""Integration JSON from anywhere: read and checked."""

from sigcat import codes
from sigcat.integration.autosar_classic.model import ClassicIntegration
from sigcat.integration.autosar_classic.problems.document import problems_of
from sigcat.integration.checked_document import DocumentKind

read_integration = DocumentKind("autosar-classic", ClassicIntegration, codes.NOT_WRITABLE_AS_CLASSIC, problems_of).read
"""The model of an Integration JSON. Raises InputRefused with everything that is wrong."""
