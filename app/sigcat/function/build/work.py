"""What the building of one function gathers: findings, datatypes, and where each part of the result comes from."""

from collections.abc import Mapping
from functools import cached_property

from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.catalogue.model.interfaces import Category, by_interface_name, category_of, function_of
from sigcat.findings import Finding
from sigcat.function.document.document import Document, Pointer, pointer_text
from sigcat.function.document.hints import Hints
from sigcat.function.document.severities import SEVERITIES
from sigcat.function.function_json.datatypes import BY_VSS
from sigcat.function.function_json.types import TypeList
from sigcat.names import last_name


class Work:
    """The state of one build. It lives as long as the build and is seen by nobody else."""

    def __init__(self, catalogue: Catalogue, document: Document, function: str) -> None:
        self.catalogue = catalogue
        self.document = document
        self.function = function
        self.findings: list[Finding] = []
        self.types = TypeList(catalogue)
        self.interfaces = by_interface_name(catalogue.nodes)
        """Paths of the catalogue's interfaces by interface name."""
        self.datatypes = (*BY_VSS, *(node.path for node in catalogue.nodes.values() if node.type == "struct"))
        """Names of datatypes: those of VSS, and paths of structs."""
        self.hint = Hints()
        self._told: set[tuple[str, Pointer]] = set()
        self.trace: dict[Pointer, Pointer] = {}
        """From parts of the Function JSON to the parts of the declaration that they were made from."""

    @cached_property
    def instances(self) -> Mapping[str, str]:
        """The first instance of each definition, by the definition's path."""
        first: dict[str, str] = {}
        for node in self.catalogue.nodes.values():
            first.setdefault(node.template, node.path)
        return first

    def report(self, rule: str, at: Pointer, message: str, fix: str = "", path: str = "") -> None:
        """Note a finding at a place of the declaration."""
        self._told.add((rule, at))
        place = self.document.place(at)
        self.findings.append(
            Finding(rule, SEVERITIES[rule], message, self.document.name, *place, path, pointer_text(at), fix)
        )

    def has_told(self, rule: str, at: Pointer) -> bool:
        """Whether there is a finding of this rule at this place."""
        return (rule, at) in self._told

    def node(self, interface: str) -> Node | None:
        """The node of an interface that is given by its name or its path."""
        return self.catalogue.get(self.interfaces.get(interface, interface))

    def own(self, last: str, category: Category) -> Node | None:
        """The node of an interface of the function itself, by the last name of its path."""
        return self.catalogue.get(self._own.get((category, last), ""))

    def own_names(self, category: Category) -> list[str]:
        """Last names of the function's own interfaces of a category."""
        return [last for own, last in self._own if own == category]

    @cached_property
    def _own(self) -> Mapping[tuple[Category | None, str], str]:
        """Paths of the function's own interfaces by category and last name."""
        own = (path for path in self.interfaces.values() if function_of(path) == self.function)
        return {(category_of(path), last_name(path)): path for path in own}
