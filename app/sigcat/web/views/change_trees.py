"""Changes as trees, one for each class that has some: the worst class first."""

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from sigcat.catalogue.comparing.changes import CLASSES, Change

SIGNS = {"added": "+", "removed": "−", "changed": "~", "moved": "→"}


class Branch(NamedTuple):
    """A branch of the tree of changes, with the changes that stand directly in it."""

    name: str
    path: str
    changes: tuple[Change, ...]
    branches: tuple["Branch", ...]
    total: int


def worst_first(changes: Iterable[Change]) -> list[Change]:
    """Breaking changes before those of the other classes; otherwise in their order."""
    return sorted(changes, key=lambda change: CLASSES.index(change.compatibility))


def trees_of(changes: Sequence[Change]) -> list[tuple[str, Branch]]:
    """A tree for each class that has changes, the worst first."""
    by_class = {name: [change for change in changes if change.compatibility == name] for name in CLASSES}
    return [(name, tree_of(members)) for name, members in by_class.items() if members]


def tree_of(changes: Sequence[Change]) -> Branch:
    """Changes below the branches in which they stand, by the path that users of the old tree know.

    A branch that holds nothing but one branch is drawn together with it.
    """
    return _branch("", "", [(place_of(change).split(".")[:-1], change) for change in changes])


def _branch(name: str, path: str, changes: Sequence[tuple[list[str], Change]]) -> Branch:
    here = tuple(change for names, change in changes if not names)
    below: dict[str, list[tuple[list[str], Change]]] = {}
    for names, change in changes:
        if names:
            below.setdefault(names[0], []).append((names[1:], change))
    if not here and len(below) == 1:
        ((only, rest),) = below.items()
        return _branch(f"{name}.{only}" if name else only, f"{path}.{only}" if path else only, rest)
    branches = (_branch(each, f"{path}.{each}" if path else each, rest) for each, rest in below.items())
    return Branch(name, path, here, tuple(branches), len(changes))


def place_of(change: Change) -> str:
    """Return the places of changes for users of the old tree."""
    return change.former or change.path
