"""Checks of single nodes, beside their texts: units, deprecation, instances, paths."""

import re
from collections.abc import Iterator
from itertools import pairwise

from sigcat.catalogue.model.definition import Definition, labels_of
from sigcat.findings import shown
from sigcat.names import did_you_mean, parent_path
from sigcat.rules.checks.kind import NodeTest, TreeTest
from sigcat.rules.patterns import compile_pattern
from sigcat.rules.problem import Problem, Repair
from sigcat.rules.record import Rule
from sigcat.rules.tree import Tree

_RANGE = r"\[(\d+),(\d+)\]$"
_TARGET = r"moved to\s+([A-Za-z0-9_]+(?:\.[A-Za-z0-9_]+)+)"


def deprecated_unit(_rule: Rule, tree: Tree) -> NodeTest:
    """The unit is not deprecated."""

    def test(definition: Definition) -> Iterator[Problem]:
        name = definition.values["unit"]
        unit = tree.vocabulary.unit(name) if isinstance(name, str) else None
        if unit is not None and unit.deprecation:
            message = f"Unit {unit.key!r} is deprecated: {unit.deprecation}"
            yield Problem(
                definition, message if message.endswith(".") else f"{message}.", "unit", facts={"unit": unit.key}
            )

    return test


def unit_spelling(_rule: Rule, tree: Tree) -> NodeTest:
    """The unit is written by its key, as the file of units spells it."""

    def test(definition: Definition) -> Iterator[Problem]:
        written = next((s.values["unit"] for s in reversed(definition.statements) if "unit" in s.values), None)
        unit = tree.vocabulary.unit(written) if isinstance(written, str) else None
        if unit is not None and written != unit.key:
            message = f"The unit must be written as its key {unit.key!r}, not {written!r}."
            yield Problem(definition, message, "unit", f"Write {unit.key!r}.", repair=Repair("replace", unit.key))

    return test


def deprecation_target(_rule: Rule, tree: Tree) -> NodeTest:
    """Require that a node which `deprecation` says has moved is in the tree.

    The target may be relative to a branch above, as release 5.0 writes it.
    """

    def test(definition: Definition) -> Iterator[Problem]:
        target = moved_to(definition)
        if target and not _leads_somewhere(target, definition.path, tree):
            message = f"`deprecation` must name a node of the tree, not {target!r}."
            yield Problem(definition, message, "deprecation", did_you_mean(target, tree.definitions))

    return test


def moved_to(definition: Definition) -> str:
    """Return the path to which the deprecation of a node says that it has moved; empty without one."""
    match = re.search(_TARGET, str(definition.values["deprecation"]))
    return match[1] if match else ""


def _leads_somewhere(target: str, path: str, tree: Tree) -> bool:
    """Whether the target is a path of the tree, or one relative to a branch above the node."""
    names = path.split(".")
    return any(tree.resolve(".".join((*names[:count], target))) for count in range(len(names)))


def instance_start(rule: Rule, _tree: Tree) -> NodeTest:
    """Ranges of instances start at `first`."""
    first = rule.options["first"]

    def test(definition: Definition) -> Iterator[Problem]:
        for within, entry in labels_of(definition.values):
            match = re.search(_RANGE, entry) if isinstance(entry, str) else None
            if match and int(match[1]) != first and int(match[1]) <= int(match[2]):
                message = f"Range {shown(entry)} must start at {first}, not {int(match[1])}."
                yield Problem(definition, message, "instances", f"Count instances from {first}.", within=within)

    return test


def instance_duplicates(_rule: Rule, _tree: Tree) -> NodeTest:
    """No instance is named twice at one level; case does not count."""

    def test(definition: Definition) -> Iterator[Problem]:
        seen: dict[tuple[int, str], str] = {}
        for within, entry in labels_of(definition.values):
            label = str(entry)
            key = (within[0] if len(within) > 1 else -1, label.lower())
            other = seen.get(key)
            seen[key] = label
            if other is not None:
                how = "is listed twice" if other == label else f"differs from {other!r} only in case"
                message = f"Instance {label!r} {how}."
                yield Problem(definition, message, "instances", "Remove or rename one of the two.", within=within)

    return test


def unique_path(_rule: Rule, tree: Tree) -> TreeTest:
    """No two paths differ in case only."""

    def test() -> Iterator[Problem]:
        first = tree.catalogue.first_spellings
        for definition in tree.judged:
            path, other = definition.path, first[definition.path.lower()]
            if other != path and not _follows(path, other):
                message = f"Path {path!r} differs from {other!r} only in case."
                yield Problem(definition, message, fix="Rename one of the two.", facts={"other": other})
            for instance, beside in tree.beside_instances(definition) if "instances" in definition.values else ():
                if instance != beside and instance.lower() == beside.lower():
                    message = f"Instance {instance!r} differs from {beside!r} only in case."
                    yield Problem(definition, message, "instances", "Rename one of the two.", {"other": beside})

    return test


def _follows(path: str, other: str) -> bool:
    """Whether two paths differ only because those of their branches do: that is reported for the branches."""
    above, other_above = parent_path(path), parent_path(other)
    return above != other_above and path[len(above) :] == other[len(other_above) :]


def twice_written(rule: Rule, tree: Tree) -> TreeTest:
    """No node is written in two files of the base tree, or twice through includes, with different values.

    A branch without other attributes than `type`, `description` and `comment` may be restated.
    """
    ignored = frozenset(rule.options.get("ignored", ()))

    def test() -> Iterator[Problem]:
        for definition in tree.judged:
            base = [s for s in definition.statements if not s.file.overlay] if len(definition.statements) > 1 else []
            for earlier, later in pairwise(base):
                both = [k for k in later.values if k in earlier.values and k not in ignored]
                differing = [k for k in both if later.values[k] != earlier.values[k]]
                if differing:
                    origin = earlier.origin(differing[0])
                    message = f"`{differing[0]}` has another value in {origin.file}:{origin.line}."
                    yield Problem(later, message, differing[0], "Keep one of the two.")

    return test


def path_depth(rule: Rule, _tree: Tree) -> NodeTest:
    """A path has at most `most` names."""
    most = rule.options["most"]

    def test(definition: Definition) -> Iterator[Problem]:
        count = definition.path.count(".") + 1
        if count > most:
            yield Problem(definition, f"The path must have at most {most} names, not {count}.")

    return test


def path(rule: Rule, _tree: Tree) -> NodeTest:
    """The whole path matches `pattern` as a whole."""
    pattern = compile_pattern(rule.options["pattern"], trusted=rule.trusted)

    def test(definition: Definition) -> Iterator[Problem]:
        if not pattern.matches(definition.path):
            message = f"Path {definition.path!r} must match {pattern.text}."
            yield Problem(definition, message, facts={"path": definition.path})

    return test
