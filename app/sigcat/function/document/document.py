"""A document that was read: its value, its errors, and the place of every value in it."""

from typing import Any, NamedTuple, Protocol

from sigcat.findings import Finding, RuleCode, first_at

Pointer = tuple[str | int, ...]
"""Keys and indexes from the root of a document to a value in it."""


class Position(NamedTuple):
    """Line and column, from 1; 0 if unknown."""

    line: int = 0
    column: int = 0


class Positions(Protocol):
    """Position of the value at a pointer, or of the nearest one around it that exists; or of its key, if it has one."""

    def __call__(self, pointer: Pointer, *, of_key: bool = False) -> Position: ...


class Document(NamedTuple):
    """A document that was read. `value` is None if it could not be."""

    name: str
    digest: str
    """SHA-256 of the bytes."""
    value: Any
    findings: tuple[Finding, ...]
    position: Positions

    def has(self, pointer: Pointer) -> bool:
        """Whether there is a value at a pointer."""
        value = self.value
        for part in pointer:
            if not has_part(value, part):
                return False
            value = value[part]
        return True

    def finding(
        self, rule: RuleCode, pointer: Pointer, message: str, fix: str = "", path: str = "", *, of_key: bool = False,
        first: Pointer | None = None,
    ) -> Finding:  # fmt: skip
        """A finding at the value of a pointer, or at its key. Its message names the first place of something given again."""
        line, column = self.position(pointer, of_key=of_key)
        if first is not None:
            message = f"{message.removesuffix('.')}, {first_at(self.name, self.position(first).line)}."
        return rule.finding(message, self.name, line, column, path, pointer_text(pointer), fix)


def has_part(value: Any, part: str | int) -> bool:
    """Whether a value is a mapping with a key, or a list with an index."""
    if isinstance(value, dict):
        return part in value
    return isinstance(value, list) and isinstance(part, int) and part < len(value)


def pointer_text(pointer: Pointer) -> str:
    """RFC 6901: `("a", 0, "b/c")` → `/a/0/b~1c`."""
    return "".join("/" + str(part).replace("~", "~0").replace("/", "~1") for part in pointer)
