"""Knowledge of checks about the whole tree: instances, children, interfaces by name.

Everything is computed when it is first asked for: a run in which no rule needs it does not pay for it.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING

from sigcat.catalogue.composing.compose import expanded_paths
from sigcat.catalogue.composing.expand_instances import refined_values
from sigcat.catalogue.composing.instance_names import levels_of_instances
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.model.definition import Definition
from sigcat.catalogue.model.vocabulary import Vocabulary
from sigcat.catalogue.reading.layers import Layer
from sigcat.names import last_name, parent_path

if TYPE_CHECKING:
    from sigcat.catalogue.network.can_database import CanDatabase


class Tree:
    """A composed catalogue as the checks see it: definitions before the expansion of instances."""

    def __init__(
        self,
        catalogue: Catalogue,
        attributes: Iterable[str] = (),
        judged: Iterable[Definition] | None = None,
        can: "CanDatabase | None" = None,
    ) -> None:
        self.catalogue = catalogue
        self.definitions: Mapping[str, Definition] = catalogue.definitions
        self.vocabulary: Vocabulary = catalogue.vocabulary
        self.attributes = frozenset(attributes)
        """Extended attributes that the rules or the configuration know."""
        self.judged = self.definitions.values() if judged is None else tuple(judged)
        """The definitions that are checked; the others are there to be looked up."""
        self.can = can
        """The CAN database that mappings are checked against, if there is one."""
        self._holders: dict[str, bool] = {}

    @property
    def overlays(self) -> tuple[Layer, ...]:
        """Overlays in the order in which they apply."""
        return self.catalogue.overlays

    @property
    def children(self) -> Mapping[str, Sequence[Definition]]:
        """Definitions directly below a path."""
        return self.catalogue.children

    @cached_property
    def typed(self) -> Mapping[str, Mapping[str, str]]:
        """Paths of the nodes that have a type, below each branch by their last names: what a wrong path may have meant."""
        typed: dict[str, dict[str, str]] = {}
        for path, definition in self.definitions.items():
            if definition.type:
                typed.setdefault(parent_path(path), {})[last_name(path)] = path
        return typed

    @cached_property
    def expanded(self) -> Mapping[str, Definition]:
        """The definition of every path with instances expanded; the paths as written without a tree."""
        written = self.definitions
        expanded = {path: written[own] for path, own in expanded_paths(self.catalogue) if own in written}
        return expanded or written

    @property
    def interfaces(self) -> Mapping[str, Definition]:
        """Definitions of error, safety reaction, mode and scheduling interfaces by interface name."""
        return self.catalogue.interfaces

    def below(self, path: str, name: str) -> Definition | None:
        """The definition of a child."""
        return self.definitions.get(f"{path}.{name}")

    @cached_property
    def uninstantiated(self) -> Mapping[str, list[Definition]]:
        """Definitions that are beside the instances of the branch above, by the path of that branch."""
        found: dict[str, list[Definition]] = {}
        for path, definition in self.definitions.items():
            if definition.values.get("instantiate") is False:
                found.setdefault(parent_path(path), []).append(definition)
        return found

    def beside_instances(self, definition: Definition) -> Iterator[tuple[str, str]]:
        """Paths of the first instances of a branch, each with that of a node that is written beside it."""
        is_sibling = definition.values.get("instances_relation") == "sibling"
        above = parent_path(definition.path) if is_sibling else definition.path
        beside = (self.children if is_sibling else self.uninstantiated).get(above, ())
        names = sorted(next(levels_of_instances(definition.values), ())) if beside else ()
        for child in beside:
            yield from ((f"{above}.{name}", child.path) for name in names)

    def resolve(self, path: str) -> Definition | None:
        """The definition that a path leads to, names of instances included."""
        exact = self.definitions.get(path)
        if exact is not None:
            return exact
        return _resolve(path.split("."), self.definitions)

    def resolve_other(self, path: str) -> Definition | None:
        """The definition that a path leads to through the names of instances, other than one written for it alone."""
        return _resolve(path.split("."), self.definitions) if self.is_instance(path) else None

    def resolved(self, definition: Definition) -> Definition:
        """Return the values that are written for one instance, with all that it has from its definition."""
        if not self.may_hold_instances(parent_path(definition.path)):
            return definition
        other = self.resolve_other(definition.path)
        if other is None:
            return definition
        values = {name: value for name, value in refined_values(other, definition).items() if name != "instances"}
        return Definition(definition.path, (*other.statements, *definition.statements), values)

    def may_hold_instances(self, path: str) -> bool:
        """Whether what is right below a path may be an instance; asked once for all that is there."""
        known = self._holders.get(path)
        if known is None:
            own = self.definitions.get(path)
            known = bool(path) and (own is None or "instances" in own.values or self.is_instance(path))
            self._holders[path] = known
        return known

    def is_instance(self, path: str) -> bool:
        """Whether the path names an instance, or leads to a definition through the names of instances."""
        names = path.split(".")
        plain = _without_instances(names, self.definitions)
        return plain is not None and len(plain) < len(names)


def _resolve(names: list[str], definitions: Mapping[str, Definition]) -> Definition | None:
    plain = _without_instances(names, definitions)
    return definitions.get(".".join(plain)) if plain is not None else None


def _without_instances(names: list[str], definitions: Mapping[str, Definition]) -> list[str] | None:
    """The names without those of instances; None where one is neither a child nor an instance.

    Below an instance is what is instantiated, once all levels of instances are named.
    """
    plain: list[str] = []
    left: list[frozenset[str]] = []
    is_below_instance = False
    for name in names:
        if left and name in left[0]:
            left = left[1:]
            is_below_instance = True
            continue
        child = definitions.get(".".join((*plain, name)))
        if child is None or (is_below_instance and (left or child.values.get("instantiate") is False)):
            return None
        plain.append(name)
        left = list(levels_of_instances(child.values))
        is_below_instance = False
    return plain
