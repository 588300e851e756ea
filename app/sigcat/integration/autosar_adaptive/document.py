"""Integration JSON from anywhere: read, completed by rule where it has no ids, and checked."""

from sigcat import codes
from sigcat.errors import InputRefused
from sigcat.function.document.document import pointer_text
from sigcat.integration.autosar_adaptive.completion import completed
from sigcat.integration.autosar_adaptive.model import IntegrationModel
from sigcat.integration.autosar_adaptive.problems import problems_of
from sigcat.integration.checked_document import DocumentKind

_KIND = DocumentKind("autosar-adaptive", IntegrationModel, codes.NOT_WRITABLE_AS_ARXML, problems_of, completed)
read_integration = _KIND.read
"""The model of an Integration JSON, completed. Raises InputRefused with everything that is wrong."""


def writable(model: IntegrationModel) -> IntegrationModel:
    """The model with every id, event group and name that ARXML needs. Raises InputRefused if it cannot be written."""
    whole = completed(model)
    problems = tuple(problems_of(whole))
    if problems:
        findings = tuple(
            codes.NOT_WRITABLE_AS_ARXML.finding(problem.message, pointer=pointer_text(problem.pointer), fix=problem.fix)
            for problem in problems
        )
        raise InputRefused("The integration cannot be written as ARXML.", findings)
    return whole
