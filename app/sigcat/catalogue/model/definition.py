"""A node's definition: what all layers together say about it, and the problems of that."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any, NamedTuple

from sigcat.catalogue.model.vocabulary import Vocabulary
from sigcat.catalogue.reading.statement import Origin, Statement
from sigcat.findings import Finding, RuleCode
from sigcat.patterns import Matching

BRANCH = "branch"
STRUCT = "struct"
SIGNALS = ("sensor", "actuator", "attribute")
PROPERTY = "property"
TYPES = (BRANCH, *SIGNALS, STRUCT, PROPERTY)

COMMON_ATTRIBUTES = frozenset(
    ("type", "description", "comment", "delete", "deprecation", "constUID", "fka", "instantiate")
)
BRANCH_ATTRIBUTES = COMMON_ATTRIBUTES | {"instances", "instances_relation", "aggregate", "is_instance"}
DATA_ATTRIBUTES = COMMON_ATTRIBUTES | {
    "datatype", "arraysize", "min", "max", "pattern", "unit", "enum", "allowed", "default"
}  # fmt: skip
CORE_ATTRIBUTES = BRANCH_ATTRIBUTES | DATA_ATTRIBUTES


class Problem(NamedTuple):
    """Yield the problems of a definition, each with its attribute (empty: the node itself)."""

    rule: RuleCode
    attribute: str
    message: str
    fix: str = ""
    within: tuple[int, ...] = ()
    """Steps from the attribute to the item that the problem is about; of a mapping, to its key."""
    brought_by: str = ""
    """The attribute of a later statement that caused the problem; the finding points to it. Empty: `attribute` itself."""


class Scope(NamedTuple):
    """References of definitions: units and struct datatypes; and the time limit of their patterns."""

    vocabulary: Vocabulary
    matching: Matching
    structs: Mapping[str, "Mapping[str, Definition]"] = {}
    """Properties by name, for each struct by path."""
    struct_paths: Mapping[str, Sequence[str]] = {}
    """Paths of structs, in their order, by last name."""


class Definition:
    """Definition of one node in all layers together. Frozen; shared by every instance of the node."""

    __slots__ = ("is_instance", "path", "problems", "statements", "values")

    def __init__(
        self,
        path: str,
        statements: tuple[Statement, ...],
        values: Mapping[str, Any],
        problems: tuple[Problem, ...] = (),
        is_instance: bool = False,
    ) -> None:
        self.path = path
        self.statements = statements
        self.values = values
        self.problems = problems
        self.is_instance = is_instance

    def __repr__(self) -> str:
        return f"<Definition {self.path}: {self.type}>"

    @property
    def type(self) -> str:
        """Node type: branch, sensor, actuator, attribute, struct or property; empty if undefined."""
        value = self.values.get("type")
        return value if isinstance(value, str) else ""

    @property
    def is_added(self) -> bool:
        """Whether an overlay adds the node."""
        return bool(self.statements and self.statements[0].file.overlay)

    def origin(self, attribute: str = "") -> Origin:
        """Return the last place of the value of an attribute; without one, the first place of the node."""
        if attribute:
            for statement in reversed(self.statements):
                if attribute in statement.values:
                    return statement.origin(attribute)
        return self.statements[0].origin() if self.statements else Origin("", 0, 0)

    def origin_within(self, attribute: str, steps: Sequence[int | str], *, at_key: bool = False) -> Origin:
        """Return the last place of an item of a list or mapping; the place of the attribute, if that is not known."""
        if steps:
            for statement in reversed(self.statements):
                origin = statement.origin_within(attribute, steps, at_key=at_key)
                if origin is not None:
                    return origin
        return self.origin(attribute)

    def last_written(self, attributes: Sequence[str]) -> str:
        """Return the attribute that was written last, of those that make a problem together."""
        return next((name for s in reversed(self.statements) for name in attributes if name in s.values), attributes[0])

    def spelled(self, attribute: str) -> str:
        """The key under which the last file that says something of the node has an attribute, or would have it."""
        return self.statements[-1].spelled(attribute) if self.statements else attribute

    def history(self, attribute: str) -> tuple[tuple[Any, Origin], ...]:
        """Every value that the layers gave an attribute, first to last, with its origin."""
        return tuple(
            (statement.values[attribute], statement.origin(attribute))
            for statement in self.statements
            if attribute in statement.values
        )

    @property
    def extended(self) -> dict[str, Any]:
        """Attributes that VSS does not define, such as `ASILlevel`."""
        return {name: value for name, value in self.values.items() if name not in CORE_ATTRIBUTES}

    def with_problems(self, problems: tuple[Problem, ...]) -> "Definition":
        """The same definition with other problems."""
        return Definition(self.path, self.statements, self.values, problems, self.is_instance)

    def finding(self, problem: Problem, path: str = "") -> Finding:
        """A problem as a finding, where its cause was written."""
        within = () if problem.brought_by else problem.within
        origin = self.origin_within(problem.brought_by or problem.attribute, within, at_key=True)
        return problem.rule.finding(problem.message, *origin.position, path or self.path, fix=problem.fix)


def merged_values(base: Mapping[str, Any], update: Mapping[str, Any]) -> dict[str, Any]:
    """`base` with the values of `update`; mappings inside are merged, everything else is replaced."""
    merged = dict(base)
    for name, value in update.items():
        before = merged.get(name)
        if isinstance(value, dict) and isinstance(before, dict):
            merged[name] = merged_values(before, value)
        else:
            merged[name] = value
    return merged


def merged_statements(statements: Sequence[Statement]) -> Mapping[str, Any]:
    """The values that statements give together; later statements win, attribute by attribute."""
    values = statements[0].values
    for statement in statements[1:]:
        values = merged_values(values, statement.values)
    return values


def instances_of(values: Mapping[str, Any]) -> list[Any]:
    """The instances of a branch as a list, whatever form they were written in."""
    instances = values.get("instances")
    if instances is None:
        return []
    return [instances] if isinstance(instances, str) else list(instances) if isinstance(instances, list) else []


def labels_of(values: Mapping[str, Any]) -> Iterator[tuple[tuple[int, ...], Any]]:
    """Every label of the instances, ranges unexpanded, with the steps that lead to it."""
    is_list = isinstance(values.get("instances"), list)
    for i, entry in enumerate(instances_of(values)):
        if isinstance(entry, list):
            yield from (((i, j), item) for j, item in enumerate(entry))
        else:
            yield (i,) if is_list else (), entry
