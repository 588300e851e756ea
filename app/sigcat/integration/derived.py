"""Result of every derivation: the Integration JSON of a platform with its findings and its report."""

from typing import Generic, NamedTuple, TypeVar

from sigcat.findings import Finding
from sigcat.integration.report import Entry

M = TypeVar("M")


class Derived(NamedTuple, Generic[M]):
    """The document, the findings about it, and where each field of each interface went."""

    model: M
    findings: tuple[Finding, ...]
    report: tuple[Entry, ...]
