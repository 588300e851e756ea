"""Context in which every interface of a function is resolved: the catalogue, and its lookups."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property

from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.catalogue.model.interfaces import (
    Category,
    by_interface_name,
    category_of,
    function_of,
    interface_name,
    interface_paths,
)
from sigcat.findings import RuleCode
from sigcat.function.document.document import Pointer
from sigcat.function.document.problem import Problem, Subject
from sigcat.function.extension.defined_nodes import Definitions
from sigcat.function.function_json.datatypes.primitive_types import BY_VSS
from sigcat.function.function_json.datatypes.type_list import TypeList
from sigcat.function.resolving.meant_signals import MeantSignals
from sigcat.names import last_name


@dataclass(frozen=True)
class Context:
    """The catalogue of one function. Datatypes are gathered in the order in which interfaces refer to them."""

    catalogue: Catalogue
    function: str
    """Name of the function."""
    definitions: Definitions = field(default_factory=Definitions)
    """Definitions of the function."""
    signals: Mapping[str, str] = field(default_factory=dict)
    """Names of the signals that the function consumes, by their paths."""
    problems: list[Problem] = field(default_factory=list)
    """Problems of the declaration, in the order in which its parts are resolved."""

    def report(self, rule: RuleCode, at: Pointer, message: str, fix: str = "", subject: Subject | None = None) -> None:
        """Add a problem at a place of the declaration."""
        self.problems.append(Problem(rule, at, message, fix, subject))

    @cached_property
    def meant(self) -> MeantSignals:
        """Proposals for paths that the catalogue does not have."""
        return MeantSignals(self.catalogue)

    @cached_property
    def types(self) -> TypeList:
        """The datatypes that the function refers to."""
        return TypeList(self.catalogue)

    @cached_property
    def interfaces(self) -> Mapping[str, str]:
        """Paths of the catalogue's interfaces by interface name."""
        return by_interface_name(self.catalogue.nodes)

    @cached_property
    def datatypes(self) -> tuple[str, ...]:
        """Names of datatypes: those of VSS, and paths of structs."""
        return (*BY_VSS, *(node.path for node in self.catalogue.nodes.values() if node.type == "struct"))

    @cached_property
    def instances(self) -> Mapping[str, str]:
        """The first instance of each definition, by the definition's path."""
        first: dict[str, str] = {}
        for node in self.catalogue.nodes.values():
            first.setdefault(node.template, node.path)
        return first

    def path_of(self, name: str) -> str:
        """Path of the interface of a name; the name itself if there is none."""
        return self.interfaces.get(name, name)

    def node(self, reference: str, category: Category) -> Node | None:
        """The node of an interface given by name or path; of one of the function itself the last name is enough."""
        named = self.catalogue.get(self.path_of(reference))
        return named or self.catalogue.get(self._own.get((category, reference), ""))

    def call_name(self, reference: str) -> str:
        """The name of a call that is given by name or path; the reference itself, if there is no such call."""
        node = self.node(reference, "scheduling")
        return interface_name(node.path) or reference if node is not None else reference

    def data(self, reference: str) -> Node | None:
        """The node at a path; of a parameter of the function itself the last name is enough."""
        return self.catalogue.get(reference) or self.own_parameters.get(reference)

    @cached_property
    def own_parameters(self) -> Mapping[str, Node]:
        """The parameters of the function itself by last name."""
        root = self.catalogue.roots[0].path if self.catalogue.roots else ""
        branch = self.catalogue.get(f"{root}.Function.{self.function}.Parameter")
        return {node.name: node for node in branch.children} if branch is not None else {}

    def names(self, category: Category) -> list[str]:
        """Names of the interfaces of a category."""
        return [name for name, path in self.interfaces.items() if category_of(path) == category]

    def own_names(self, category: Category) -> list[str]:
        """Last names of the function's own interfaces of a category."""
        return [last for own, last in self._own if own == category]

    @cached_property
    def _own(self) -> Mapping[tuple[Category | None, str], str]:
        """Paths of the function's own interfaces by category and last name."""
        own = (path for path in interface_paths(self.catalogue.nodes) if function_of(path) == self.function)
        return {(category_of(path), last_name(path)): path for path in own}
