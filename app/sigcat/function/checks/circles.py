"""Interfaces that lead back to themselves."""

from collections.abc import Iterable, Mapping

from sigcat.catalogue.model import circles as names
from sigcat.function.document.problem import Kind, Subject

Circle = tuple[Subject, ...]


def circles(following: Mapping[str, Iterable[str]], kind: Kind, attribute: str) -> Mapping[str, Circle]:
    """The members of each circle, by the name of each of them. `attribute` is the one that leads on."""
    found = [tuple(Subject(kind, name, (attribute,)) for name in group) for group in names.circles(following)]
    return {subject.name: circle for circle in found for subject in circle}
