"""What a check yields: one problem of one node or line, not yet a finding of a rule."""

from collections.abc import Mapping, Sequence
from typing import Any, Literal, NamedTuple, Protocol

from sigcat.catalogue.reading.statement import Origin


class Subject(Protocol):
    """What a problem is about: a definition, or a single statement of an overlay."""

    @property
    def path(self) -> str:
        """Path of the node."""

    def origin(self, attribute: str = "") -> Origin:
        """Where an attribute was written, or the node."""

    def origin_within(self, attribute: str, steps: Sequence[int | str], *, at_key: bool = False) -> Origin | None:
        """Where an item of a list or mapping was written."""


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
        """What it makes of a text."""
        if self.kind == "capitalize":
            return text[:1].upper() + text[1:]
        return f"{text}{self.text}" if self.kind == "append" else self.text


class Problem(NamedTuple):
    """What is wrong with a node. `facts` fill the template of the rule's own message, where it has one."""

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
    """What is wrong with one line of a file, whichever node it belongs to; line and column count from 1."""

    line: int
    column: int
    message: str
    fix: str = ""
    repair: Repair | None = None
