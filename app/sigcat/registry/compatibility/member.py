"""Functions of a vehicle line as the checks of a set take them."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property, partial

from sqlalchemy import Connection

from sigcat.function.checks.schedule.order import previous_calls
from sigcat.function.document.read_json import read_json
from sigcat.function.exchange import exchange_of, parts_of
from sigcat.function.function_file import CheckedFunction
from sigcat.function.function_json.reading import read_function
from sigcat.function.function_json.walk import errors, runnables
from sigcat.registry.candidates.candidate import Candidate
from sigcat.registry.candidates.candidates import ReadFunction
from sigcat.registry.published import Published
from sigcat.registry.reference import Reference
from sigcat.registry.storing.content import content_of
from sigcat.registry.use import Use, from_json

NOWHERE = ("", 0, 0)
"""The place of an element without a file."""


@dataclass(frozen=True, eq=False)
class Member:
    """A function in a set: a published version, or a file that is not published yet."""

    name: str
    version: str
    """Empty for a file."""
    owner: str
    uses: tuple[Use, ...]
    load: Callable[[], CheckedFunction]
    """Read the function: most functions of a line have nothing to do with those that are deployed."""

    @cached_property
    def checked(self) -> CheckedFunction:
        """The function as it was read and checked."""
        return self.load()

    @property
    def label(self) -> str:
        """Name and version."""
        return str(Reference(self.name, self.version)) if self.version else self.name

    @cached_property
    def elements(self) -> frozenset[str]:
        """Identities of everything that it exchanges."""
        return frozenset(use.element for use in self.uses)

    @cached_property
    def declared(self) -> frozenset[str]:
        """Names of its calls and errors, on which those of other functions may depend."""
        return frozenset(use.name for use in self.uses if use.verb in ("runs", "reports"))

    @cached_property
    def dependencies(self) -> frozenset[str]:
        """Names of the calls before its calls, and of the errors on which its errors depend."""
        function = self.checked.function
        if function is None:
            return frozenset()
        calls = (name for _, _, call in runnables(function) for name in previous_calls(call))
        return frozenset((*calls, *(name for _, _, error in errors(function) for name in error.dependencies)))

    def depends_on(self, other: "Member") -> bool:
        """Whether a call or an error depends on one of another function."""
        return other.name != self.name and not self.dependencies.isdisjoint(other.declared)

    @property
    def needed(self) -> tuple[str, ...]:
        """Identities of signals that another function must provide."""
        return tuple(dict.fromkeys(use.element for use in self.uses if use.is_needed))

    @property
    def optional(self) -> tuple[str, ...]:
        """Identities of signals that it consumes if the vehicle has them."""
        return tuple(dict.fromkeys(use.element for use in self.uses if use.verb == "consumes" and use.is_optional))

    @cached_property
    def provided(self) -> frozenset[str]:
        """Identities of everything on which others may rely."""
        return frozenset(use.element for use in self.uses if use.provides)

    def provides(self, element: str) -> bool:
        """Whether it provides a signal."""
        return element in self.provided

    def calls(self, element: str) -> tuple[str, ...]:
        """Names of the calls that use an element."""
        found = (use.call for use in self.uses if element in (use.element, use.path, use.name) and use.call)
        return tuple(dict.fromkeys(found))

    def place(self, element: str) -> tuple[str, int, int]:
        """File, line and column of an element, of which the user has a file; a published version has none."""
        resolved = self.checked.resolved
        if resolved is None or self.version:
            return NOWHERE
        for side in exchange_of(parts_of([resolved.function])).sides:
            if element == side.identity:
                position = resolved.position(side.pointer)
                return self.checked.document.name, position.line, position.column
        return self.checked.document.name, 0, 0


def published_member(connection: Connection, published: Published) -> Member:
    """The function of a published version."""
    uses = from_json(content_of(connection, published.uses))
    load = partial(_read_published, connection, published)
    return Member(published.name, published.version, published.owner, uses, load)


def _read_published(connection: Connection, published: Published) -> CheckedFunction:
    return _read(content_of(connection, published.resolved), published.reference)


def _read(resolved: bytes, reference: Reference) -> CheckedFunction:
    document = read_json(resolved, str(reference))
    function, findings = read_function(document)
    return CheckedFunction(document, function, findings)


def candidate_member(candidate: Candidate) -> Member:
    """The function of a candidate."""
    load = partial(_read, candidate.resolved, candidate.reference)
    return Member(candidate.name, candidate.version, candidate.owner, from_json(candidate.uses), load)


def file_member(read: ReadFunction) -> Member:
    """The function of a file."""
    info = read.function.info
    return Member(info.function_name, "", info.function_responsible.raw, read.uses, lambda: read.checked)
