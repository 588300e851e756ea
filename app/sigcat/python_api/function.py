"""A function that was resolved against a catalogue."""

import json
from collections.abc import Collection
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from sigcat.findings import Finding
    from sigcat.function.function_json.resolved_function import ResolvedFunction
    from sigcat.function.node_uses import NodeUse


@dataclass(frozen=True, eq=False)
class Function:
    """A function of a `function.yaml` or Function JSON: every datatype, unit and range is that of the catalogue."""

    _resolved: "ResolvedFunction" = field(repr=False)
    findings: "tuple[Finding, ...]" = field(repr=False)
    """Warnings and notes of its file."""
    _known: Collection[str] = field(repr=False)

    @property
    def name(self) -> str:
        """Name of the function."""
        return self._resolved.name

    @property
    def file(self) -> str:
        """The file that it was read from."""
        return self._resolved.document.name

    @cached_property
    def json(self) -> dict[str, Any]:
        """Function JSON."""
        from sigcat.function.function_json.model import to_json

        document: dict[str, Any] = json.loads(to_json(self._resolved.function))
        return document

    @cached_property
    def uses(self) -> "tuple[NodeUse, ...]":
        """The nodes that the function uses: path, verb (consumes, provides, reports, …), call and own name."""
        from sigcat.function.node_uses import uses_of

        return tuple(uses_of(self.name, self._resolved.function))

    def __repr__(self) -> str:
        return f"<sigcat.Function {self.name!r}>"
