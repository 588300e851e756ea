"""Problems that checks yield: of one node or line, not yet a finding of a rule."""

from collections.abc import Mapping, Sequence
from typing import Any, Literal, NamedTuple, Protocol

from sigcat.catalogue.reading.statement import Origin


class Subject(Protocol):
    """Subject of a problem: a definition, or a single statement of an overlay."""

    @property
    def path(self) -> str:
        """Path of the node."""

    def origin(self, attribute: str = "") -> Origin:
        """Return the place of an attribute, or of the node."""

    def origin_within(self, attribute: str, steps: Sequence[int | str], *, at_key: bool = False) -> Origin | None:
        """Return the place of an item of a list or mapping."""


class Repair(NamedTuple):
    """A change of the bytes of one scalar, one attribute or one comment that repairs a problem.

    `safe` means that no reader of the tree sees another meaning: texts for people, spellings.
    """

    kind: Literal[
        "replace", "capitalize", "append", "rewrite", "remove attribute", "rename attribute", "remove suppression",
        "break line",
    ]  # fmt: skip
    text: str = ""
    safe: bool = True

    def of(self, text: str) -> str:
        """Return the changed text."""
        if self.kind == "capitalize":
            return text[:1].upper() + text[1:]
        return f"{text}{self.text}" if self.kind == "append" else self.text


class Problem(NamedTuple):
    """A problem of a node. `facts` fill the template of the rule's own message, where it has one."""

    subject: Subject
    message: str
    attribute: str = ""
    fix: str = ""
    facts: Mapping[str, Any] = {}
    repair: Repair | None = None
    at_name: bool = False
    """Whether the finding points at the attribute's name, not at its value."""
    within: tuple[int | str, ...] = ()
    """Steps from the attribute to the item that is wrong: the index in a list, the key or index in a mapping."""


class LineProblem(NamedTuple):
    """A problem of one line of a file, whichever node it belongs to; line and column count from 1."""

    line: int
    column: int
    message: str
    fix: str = ""
    repair: Repair | None = None
