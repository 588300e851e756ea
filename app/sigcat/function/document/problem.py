"""A problem of a function, before it is a finding: its subject, and the problems that cause it."""

from collections.abc import Iterator
from typing import Literal, NamedTuple

from sigcat.catalogue.model.interfaces import Category
from sigcat.findings import RuleCode
from sigcat.function.document.document import Pointer

Kind = Category | Literal["function", "component", "method", "datatype"]
"""Kinds of subjects: interfaces of the catalogue by their category, and other parts of a function."""


class Subject(NamedTuple):
    """A part of a function that a problem is about, or that is missing."""

    kind: Kind
    name: str
    """Name or path of an interface, otherwise the name of the part."""
    attributes: tuple[str, ...] = ()
    """Attributes of the interface that are wrong, or contradict each other, as the catalogue names them."""


class Problem(NamedTuple):
    """One thing that is wrong. `pointer` leads into the document that was looked at: a declaration, or Function JSON."""

    rule: RuleCode
    pointer: Pointer
    message: str
    fix: str = ""
    subject: Subject | None = None
    cause: Subject | None = None
    """Missing part of the function, where that is the problem: if it could not be resolved, that has been said."""
    circle: tuple[Subject, ...] = ()
    """Every member of a circle of interfaces that lead to each other."""

    first: Pointer | None = None
    """The first place of something that is given again at `pointer`."""

    @property
    def path(self) -> str:
        """Name or path of the subject, as findings have it."""
        return self.subject.name if self.subject else ""


Problems = Iterator[Problem]
