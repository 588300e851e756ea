"""A function that is resolved, with the position of every field: what is checked, written and integrated."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import NamedTuple

from sigcat.findings import Finding, RuleCode
from sigcat.function.document.document import Document, Pointer, Position
from sigcat.function.document.problem import Problem
from sigcat.function.function_json.model import FunctionJson


class Origin(NamedTuple):
    """Place where a part of a function was declared, and its own parts by their keys and indexes in Function JSON."""

    pointer: Pointer
    parts: Mapping[str | int, "Origin"] = {}

    def of(self, pointer: Pointer) -> Pointer:
        """Return where the part at a pointer was declared, or the nearest one around it."""
        origin = self
        for key in pointer:
            part = origin.parts.get(key)
            if part is None:
                break
            origin = part
        return origin.pointer

    def exactly(self, pointer: Pointer) -> Pointer | None:
        """Return the place at which the part at a pointer was declared; None if it was not."""
        origin = self
        for key in pointer:
            if key not in origin.parts:
                return None
            origin = origin.parts[key]
        return origin.pointer


@dataclass(frozen=True)
class ResolvedFunction:
    """A function, its document, and the place of each part in it."""

    function: FunctionJson
    document: Document
    origin: Origin | None = None
    """None where the document is the Function JSON itself."""

    @property
    def name(self) -> str:
        """Name of the function."""
        return self.function.info.function_name

    def source(self, pointer: Pointer) -> Pointer:
        """The part of the document that a part of the Function JSON was made from."""
        return pointer if self.origin is None else self.origin.of(pointer)

    def position(self, pointer: Pointer) -> Position:
        """Line and column of the source of a part of the Function JSON."""
        return self.document.position(self.source(pointer))

    def finding(self, rule: RuleCode, pointer: Pointer, message: str, fix: str = "", path: str = "") -> Finding:
        """A finding about a part of the Function JSON, where it was declared."""
        return self.document.finding(rule, self.source(pointer), message, fix, path)

    def findings(self, problems: Iterable[Problem]) -> tuple[Finding, ...]:
        """Problems of the Function JSON as findings."""
        return tuple(
            self.document.finding(
                each.rule,
                self.source(each.pointer),
                each.message,
                each.fix,
                each.path,
                first=self.source_of_first(each),
            )
            for each in problems
        )

    def source_of_first(self, problem: Problem) -> Pointer | None:
        """The part of the document that the first of two equal parts was made from."""
        return None if problem.first is None else self.source(problem.first)
