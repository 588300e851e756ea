"""Changes between two catalogues, each with a class for its consumers."""

import datetime as dt
from collections.abc import Iterable
from typing import Any, Literal, NamedTuple, get_args

Class = Literal["breaking", "risky", "compatible", "text"]
Kind = Literal["removed", "moved", "changed", "added"]
Evidence = Literal["", "fka", "deprecation", "same definition"]

CLASSES: tuple[Class, ...] = get_args(Class)
"""Classes from the worst to the most harmless."""
KINDS: tuple[Kind, ...] = get_args(Kind)
ORDER = "order"
"""Name of the order of the nodes of a branch, where attributes are named."""


class AttributeChange(NamedTuple):
    """One attribute of a node. None means that the attribute is absent."""

    name: str
    old: Any
    new: Any
    rule: str
    """Row of the class table (app/sigcat/catalogue/comparing/compatibility.py) that decided."""
    compatibility: Class
    rules: tuple[str, ...] = ()
    """Every row that the change falls under."""


class Change(NamedTuple):
    """One change; equal changes of the instances of a branch are one."""

    kind: Kind
    compatibility: Class
    rule: str
    """Row of the class table that decided."""
    path: str
    """Path of the node now, or before it was removed. Of several instances: the path without their names."""
    type: str
    """Type of the node now, or before, if it is gone."""
    paths: tuple[str, ...]
    """Every path that the change concerns; of a subtree, its topmost path."""
    leaves: int
    """Signals in the subtrees at all `paths` that came, went or moved with them; 0 for `changed`."""
    former: str = ""
    """Path of the node before, if it moved or is in a branch that moved; like `path`."""
    former_paths: tuple[str, ...] = ()
    """Aligned with `paths`; empty where nothing moved."""
    attributes: tuple[AttributeChange, ...] = ()
    evidence: Evidence = ""
    """Evidence that a node moved. `same definition` is a guess."""
    came: tuple[str, ...] = ()
    """Topmost paths that were added when `instances` changed."""
    went: tuple[str, ...] = ()
    """Topmost paths that were removed when `instances` changed."""
    note: str = ""
    """The deprecation text of a node that is gone."""
    effects: tuple[str, ...] = ()
    """Further effects on generated forms: rows of the table of bindings (app/sigcat/catalogue/comparing/bindings.py)."""

    @property
    def is_guess(self) -> bool:
        """Whether the move is only a guess."""
        return self.evidence == "same definition"

    @property
    def sort_key(self) -> tuple[list[str], int, list[str]]:
        """By the path that users of the old tree know."""
        return ((self.former or self.path).split("."), KINDS.index(self.kind), self.path.split("."))


def worst(classes: Iterable[Class]) -> Class:
    """The worst of the classes; `text` if there are none."""
    return min(classes, key=CLASSES.index, default="text")


def at_least(compatibility: Class, bound: Class) -> bool:
    """Whether a class is as bad as `bound` or worse."""
    return CLASSES.index(compatibility) <= CLASSES.index(bound)


def same(old: Any, new: Any) -> bool:
    """Whether two values say the same. 1 and 1.0 do, 1 and true do not, .nan equals itself, and a date its text."""
    if isinstance(old, dict) and isinstance(new, dict):
        return old.keys() == new.keys() and all(same(value, new[name]) for name, value in old.items())
    if isinstance(old, list) and isinstance(new, list):
        return len(old) == len(new) and all(map(same, old, new))
    if isinstance(old, bool) is not isinstance(new, bool):
        return False
    if isinstance(old, dt.date) is not isinstance(new, dt.date):
        return bool(_text_of(old) == _text_of(new))
    return bool(old == new or (old != old and new != new))  # noqa: PLR0124 -- only .nan differs from itself


def _text_of(value: Any) -> Any:
    """A date as JSON has it; everything else as it is."""
    return value.isoformat() if isinstance(value, dt.date) else value
