"""Checks of a branch and what is below it."""

from collections.abc import Iterator

from sigcat.asil import is_above, level_of, rank
from sigcat.catalogue.model.definition import BRANCH, Definition
from sigcat.catalogue.model.interfaces import category_of
from sigcat.names import either, last_name, parent_path
from sigcat.rules.checks.kind import NodeTest, listed
from sigcat.rules.patterns import compile_pattern
from sigcat.rules.problem import Problem
from sigcat.rules.record import Rule
from sigcat.rules.tree import Tree


def companions(rule: Rule, tree: Tree) -> NodeTest:
    """A branch has a child that matches each pattern of `required`."""
    needed = [compile_pattern(pattern, trusted=rule.trusted) for pattern in rule.options["required"]]

    def test(definition: Definition) -> Iterator[Problem]:
        children = [last_name(child.path) for child in tree.children.get(definition.path, ())]
        missing = [pattern.text for pattern in needed if not any(pattern.matches(name) for name in children)]
        if missing:
            message = f"{definition.path!r} must have {listed(missing)} below it."
            yield Problem(definition, message, fix=f"Add {listed(missing)}.")

    return test


def type_of(rule: Rule, _tree: Tree) -> NodeTest:
    """The node's type is one of `types`."""
    types = tuple(rule.options["types"])

    def test(definition: Definition) -> Iterator[Problem]:
        if definition.type and definition.type not in types:
            message = f"The type must be {either(types)}, not {definition.type}."
            yield Problem(definition, message, "type", f"Write `type: {types[0]}`." if len(types) == 1 else "")

    return test


def asil_of_step(rule: Rule, tree: Tree) -> NodeTest:
    """The ASIL of a step is not below that of any of the interfaces that its function provides (`provides`)."""
    provided = frozenset(rule.options["provides"])

    def test(definition: Definition) -> Iterator[Problem]:
        own = level_of(definition.values.get("ASILlevel"))
        if own is None or definition.type != BRANCH:
            return
        below = _below(parent_path(parent_path(definition.path)), tree)
        levels = ((level_of(other.values.get("ASILlevel")), other) for other in below)
        above = ((level, other) for level, other in levels if level is not None and is_above(level, own))
        wanted = ((level, other) for level, other in above if category_of(other.path) in provided)
        level, highest = max(wanted, key=lambda each: rank(each[0]), default=(None, None))
        if highest is not None:
            message = f"The ASIL must be at least {level}, as that of {highest.path!r}, not {own}."
            yield Problem(definition, message, "ASILlevel", f"Raise `{definition.spelled('ASILlevel')}` to {level}.")

    return test


def _below(path: str, tree: Tree) -> Iterator[Definition]:
    waiting = [path]
    while waiting:
        for child in tree.children.get(waiting.pop(), ()):
            yield child
            waiting.append(child.path)
