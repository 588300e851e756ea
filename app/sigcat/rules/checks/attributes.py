"""Checks of a node's attributes: which are there, which go together, and in which order their values are."""

from collections.abc import Iterator, Mapping
from typing import Any

from sigcat.catalogue.composing.attribute_values import hashed
from sigcat.catalogue.model.definition import CORE_ATTRIBUTES, Definition
from sigcat.catalogue.reading.vspec_file import nested_node
from sigcat.findings import shown
from sigcat.names import did_you_mean, nearest, parent_path
from sigcat.rules.checks.kind import NodeTest, is_bound, listed, nested
from sigcat.rules.patterns import compile_exception
from sigcat.rules.problem import Problem, Repair
from sigcat.rules.record import Rule
from sigcat.rules.tree import Tree


def required(rule: Rule, tree: Tree) -> NodeTest:
    """Each of `attributes` is there and not empty."""
    names = tuple(rule.options["attributes"])
    known = tree.attributes | CORE_ATTRIBUTES

    def test(definition: Definition) -> Iterator[Problem]:
        for attribute in names:
            if is_empty(definition.values.get(attribute)):
                key = definition.spelled(attribute)
                given = attribute if attribute in definition.values else ""
                misspelled = nearest(key, [name for name in definition.values if name not in known], 1)
                fix = f"Write it for `{misspelled[0]}`." if misspelled else f"Add `{key}`."
                yield Problem(definition, f"The node has no `{key}`.", given, fix, {"attribute": attribute})

    return test


def filled(rule: Rule, _tree: Tree) -> NodeTest:
    """Each attribute that is written has a value, but for those in `except`, which other rules report."""
    ignored = frozenset(rule.options.get("except", ()))

    def test(definition: Definition) -> Iterator[Problem]:
        for attribute, value in definition.values.items():
            if value is None and attribute not in ignored:
                message = f"`{attribute}` has no value."
                yield Problem(
                    definition, message, attribute, "Write one, or remove the line.", {"attribute": attribute}
                )

    return test


def forbidden(rule: Rule, _tree: Tree) -> NodeTest:
    """None of `attributes` is there."""
    names = tuple(rule.options["attributes"])

    def test(definition: Definition) -> Iterator[Problem]:
        for attribute in names:
            if definition.values.get(attribute) is not None:
                message = f"`{attribute}` is not allowed here."
                yield Problem(definition, message, attribute, "Remove it.", {"attribute": attribute}, at_name=True)

    return test


def exclusive(rule: Rule, _tree: Tree) -> NodeTest:
    """At most one of `attributes` is there. The first of them is the one to be removed."""
    names = tuple(rule.options["attributes"])

    def test(definition: Definition) -> Iterator[Problem]:
        present = [name for name in names if definition.values.get(name) is not None]
        if len(present) > 1:
            message = f"{listed(present)} cannot be used together."
            repair = Repair("remove attribute", safe=False)
            fix = f"Remove `{present[0]}`."
            yield Problem(definition, message, present[0], fix, repair=repair, at_name=True)

    return test


def implied(rule: Rule, _tree: Tree) -> NodeTest:
    """Require each of `then`, and none of `never`, where `attribute` has one of `values` (or any value)."""
    attribute = rule.options["attribute"]
    values = rule.options.get("values")
    then, never = rule.options.get("then", ()), rule.options.get("never", ())

    def test(definition: Definition) -> Iterator[Problem]:
        given = definition.values[attribute]
        items = given if isinstance(given, list) else [given]
        first = next((i for i, item in enumerate(items) if values is None or item in values), None)
        if given is None or first is None:
            return
        within = (first,) if isinstance(given, list) else ()
        because = f"`{attribute}: {items[first]}`" if values is not None else f"`{attribute}`"
        facts = {"attribute": attribute, "value": items[first]}
        for name in then:
            if is_empty(nested(definition.values, name)):
                message = f"{because} requires `{name}`."
                missing = {**facts, "missing": name}
                yield Problem(definition, message, attribute, f"Add `{name}`.", missing, within=within)
        for name in never:
            if nested(definition.values, name) is not None:
                message = f"{because} takes no `{name}`."
                top, *within = name.split(".")
                yield Problem(definition, message, top, f"Remove `{name}`.", facts, at_name=True, within=tuple(within))

    return test


def backed(rule: Rule, _tree: Tree) -> NodeTest:
    """Require the value of `attribute` in the list or text `by`."""
    attribute, by, value = rule.options["attribute"], rule.options["by"], rule.options["value"]

    def test(definition: Definition) -> Iterator[Problem]:
        given = definition.values.get(by)
        if definition.values[attribute] is not None and value not in (given if isinstance(given, list) else [given]):
            message = f"`{attribute}` has no effect unless `{by}` includes {value}."
            yield Problem(
                definition, message, attribute, f"Add {value} to `{by}`, or remove `{attribute}`.", at_name=True
            )

    return test


def ordered(rule: Rule, _tree: Tree) -> NodeTest:
    """Numbers among `attributes` do not descend, in the order in which the option lists them."""
    names = tuple(rule.options["attributes"])

    def test(definition: Definition) -> Iterator[Problem]:
        before = ""
        for name in names:
            value = nested(definition.values, name)
            if not is_bound(value):
                continue
            if before and value < nested(definition.values, before):
                least = nested(definition.values, before)
                message = f"`{name}` must be at least `{before}` ({least}), not {value}."
                top, *within = name.split(".")
                fix = f"Raise `{name}`, or lower `{before}`."
                yield Problem(definition, message, top, fix, within=tuple(within))
            before = name

    return test


def default_first(_rule: Rule, _tree: Tree) -> NodeTest:
    """Require the default to be the first item where a single value has `allowed` and `default`, as `vspec --strict` does."""

    def test(definition: Definition) -> Iterator[Problem]:
        values = definition.values
        allowed, default = values.get("allowed"), values["default"]
        is_single = not str(values.get("datatype", "")).endswith("[]")
        if is_single and isinstance(allowed, list) and allowed and default != allowed[0]:
            if default and default not in allowed:
                return  # V011 says so
            message = f"The first item of `allowed` must be the default {shown(default)}, not {shown(allowed[0])}."
            fix = "Move the default to the front: generated enumerations begin with it."
            yield Problem(definition, message, definition.last_written(("default", "allowed")), fix)

    return test


def distinct_items(rule: Rule, _tree: Tree) -> NodeTest:
    """The list in `attribute` has at least one item, and each once."""
    attribute = rule.options["attribute"]

    def test(definition: Definition) -> Iterator[Problem]:
        items = definition.values[attribute]
        if not isinstance(items, list):
            return
        if not items:
            yield Problem(
                definition, f"`{attribute}` must have at least one value.", attribute, "Add values, or remove it."
            )
        seen = set()
        for i, item in enumerate(items):
            key = hashed(item)
            if key in seen:
                message = f"{shown(item)} is listed twice in `{attribute}`."
                yield Problem(definition, message, attribute, "Remove or correct one of the two.", within=(i,))
            seen.add(key)

    return test


def distinct_from_siblings(rule: Rule, tree: Tree) -> NodeTest:
    """The text of `attribute` is not that of an earlier signal of the same branch, unless it holds a match of `except`.

    Overlays are later than the tree.
    """
    attribute = rule.options["attribute"]
    is_exempt = compile_exception(rule.options.get("except"), trusted=rule.trusted)
    first: dict[tuple[str, str], str] = {}
    gathered: set[str] = set()

    def test(definition: Definition) -> Iterator[Problem]:
        above, text = parent_path(definition.path), definition.values[attribute]
        if above not in gathered:
            gathered.add(above)
            for child in sorted(tree.children.get(above, ()), key=lambda child: bool(child.origin(attribute).overlay)):
                first.setdefault((above, str(child.values.get(attribute))), child.path)
        other = first.get((above, str(text)), definition.path)
        if other != definition.path and not is_exempt(str(text)):
            message = f"The {attribute} is that of {other!r}, word for word."
            yield Problem(definition, message, attribute, "Say what sets the two apart.")

    return test


def known_attributes(rule: Rule, tree: Tree) -> NodeTest:
    """Every attribute is one of VSS, one in a rule's table of fields, or one that the configuration names."""
    known = CORE_ATTRIBUTES | tree.attributes | {str(name) for name in rule.options.get("attributes", ())}

    def test(definition: Definition) -> Iterator[Problem]:
        if definition.values.keys() <= known:
            return
        for attribute in definition.values:
            if attribute not in known and not nested_node(attribute, definition.values[attribute]):
                yield _unknown(definition, attribute, known)

    return test


def _unknown(definition: Definition, attribute: str, known: frozenset[str]) -> Problem:
    near = nearest(attribute, sorted(known), limit=1)
    fix = (
        did_you_mean(attribute, sorted(known))
        or "Add it to `extended-attributes` of [lint] in sigcat.toml, or remove it."
    )
    is_free = bool(near) and near[0] not in definition.values
    repair = Repair("rename attribute", near[0], safe=False) if is_free else None
    message = f"Unknown attribute `{attribute}`."
    return Problem(definition, message, attribute, fix, {"attribute": attribute}, repair, at_name=True)


def is_empty(value: Any) -> bool:
    """Whether the value is missing: none at all, a blank text, an empty list or mapping."""
    return value is None or value in ("", [], {}) or (isinstance(value, str) and not value.strip())


def extended_attributes(rules: tuple[Rule, ...]) -> frozenset[str]:
    """Names of attributes that the tables of fields of these rules define."""
    names: set[str] = set()
    for rule in rules:
        fields = rule.options.get("fields")
        if isinstance(fields, Mapping):
            names.update(name for name, field in fields.items() if isinstance(field, dict))
    return frozenset(names)
