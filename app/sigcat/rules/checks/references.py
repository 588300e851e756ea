"""Checks of references between interfaces, by interface name: that each exists, and that they form no cycle."""

from collections.abc import Iterator, Mapping
from typing import Any

from sigcat.catalogue.model.definition import Definition
from sigcat.catalogue.model.interfaces import category_of, function_of, interface_name
from sigcat.names import did_you_mean, did_you_mean_last, last_name
from sigcat.rules.checks.kind import NodeTest, TreeTest, nested
from sigcat.rules.problem import Problem
from sigcat.rules.record import Rule
from sigcat.rules.tree import Tree


def reference(rule: Rule, tree: Tree) -> NodeTest:
    """Every name in `attribute` is the interface name of an interface of the category `to`.

    `attribute` may lead into a mapping: `aliveSupervision.error`.
    """
    attribute, category = rule.options["attribute"], rule.options["to"]
    pattern = rule.options.get("external")
    external = pattern.split("*") if pattern else None

    def test(definition: Definition) -> Iterator[Problem]:
        for within, named in _named_items(nested(definition.values, attribute)):
            target = tree.interfaces.get(named)
            if target is not None and category_of(target.path) == category:
                continue
            if target is None and external and named.startswith(external[0]) and named.endswith(external[-1]):
                continue
            yield _unresolved(definition, attribute, within, named, category, tree)

    return test


def names_in(definition: Definition, attribute: str) -> list[str]:
    """The interface names that an attribute of a node refers to."""
    return _item_names(nested(definition.values, attribute))


def cycle(rule: Rule, tree: Tree) -> TreeTest:
    """Following `attribute` from interface to interface forms no cycle."""
    attribute = rule.options["attribute"]
    top = attribute.partition(".")[0]

    def test() -> Iterator[Problem]:
        reported: set[str] = set()
        for name in [name for name, definition in tree.interfaces.items() if top in definition.values]:
            names = () if name in reported else _cycle_through(name, attribute, tree.interfaces)
            if names:
                reported.update(names)
                message = f"`{attribute}` forms a cycle: {' → '.join((*names, names[0]))}."
                yield Problem(tree.interfaces[names[0]], message, attribute, "Remove one of these references.")

    return test


def _item_names(value: Any) -> list[str]:
    return [name for _, name in _named_items(value)]


def _named_items(value: Any) -> list[tuple[tuple[int, ...], str]]:
    """Names, each with the steps that lead to it."""
    items = [((i,), item) for i, item in enumerate(value)] if isinstance(value, list) else [((), value)]
    return [(within, item) for within, item in items if isinstance(item, str) and item]


def _unresolved(
    definition: Definition, attribute: str, within: tuple[int, ...], named: str, category: str, tree: Tree
) -> Problem:
    readable = category.replace("_", " ")
    article = "an" if readable[0] in "aeiou" else "a"
    names = {
        interface: last_name(d.path) for interface, d in tree.interfaces.items() if category_of(d.path) == category
    }
    message = f"`{attribute}` must name {article} {readable} interface of this tree, not {named!r}."
    own = {
        name: last
        for name, last in names.items()
        if function_of(tree.interfaces[name].path) == function_of(definition.path)
    }
    fix = did_you_mean_last(named, own) or did_you_mean(named, names)
    by_path = tree.definitions.get(named)
    if by_path is not None and category_of(named) == category:
        fix = f"Refer to it by its interface name {interface_name(named)!r}."
    fix = fix or f"Correct the name, or define {article} {readable} interface of this name."
    top, *steps = attribute.split(".")
    return Problem(definition, message, top, fix, {"name": named, "attribute": attribute}, within=(*steps, *within))


def _cycle_through(start: str, attribute: str, interfaces: Mapping[str, Definition]) -> tuple[str, ...]:
    """The names on a way from `start` back to itself; empty if there is none. Iterative: chains may be long."""
    before: dict[str, str] = {}
    waiting = [start]
    while waiting:
        name = waiting.pop()
        definition = interfaces.get(name)
        for target in _item_names(nested(definition.values, attribute)) if definition else ():
            if target == start:
                return _way(start, name, before)
            if target in interfaces and target not in before:
                before[target] = name
                waiting.append(target)
    return ()


def _way(start: str, last: str, before: Mapping[str, str]) -> tuple[str, ...]:
    way = [last]
    while way[-1] != start:
        way.append(before[way[-1]])
    return tuple(reversed(way))
