"""Checks of overlays: what each statement of one does to the tree below it."""

from collections.abc import Iterator
from typing import Any

from sigcat.catalogue.model.definition import Definition, merged_values
from sigcat.catalogue.reading.statement import Statement
from sigcat.findings import shown
from sigcat.limits import PROPOSALS
from sigcat.names import did_you_mean, last_name, nearest, parent_path
from sigcat.rules.checks.kind import NodeTest, TreeTest, is_number, listed
from sigcat.rules.problem import Problem
from sigcat.rules.record import Rule
from sigcat.rules.tree import Tree


def _near(path: str, tree: Tree) -> str:
    """What was probably meant: a child of the same branch, or else a node of that name, or one with a similar path."""
    if _leads_below_instances(path, tree):
        return did_you_mean(path, [other for other, known in tree.expanded.items() if known.type])
    own = last_name(path)
    beside = {name: other for name, other in tree.typed.get(parent_path(path), {}).items() if other != path}
    near = nearest(own, beside)
    if near:
        return did_you_mean(path, [beside[name] for name in near])
    if beside:
        return did_you_mean(path, [c[own] for c in tree.typed.values() if c.get(own, path) != path])
    others = (other for children in tree.typed.values() for other in children.values())
    return did_you_mean(path, [other for other in others if other != path])


def _leads_below_instances(path: str, tree: Tree) -> bool:
    """Whether a part of a path names an instance: what was meant is then below one too."""
    above = parent_path(path)
    while above and not tree.is_instance(above):
        above = parent_path(above)
    return bool(above)


def unknown_node(_rule: Rule, tree: Tree) -> NodeTest:
    """A node that an overlay adds has a `type`; one without was meant to change a node that is there."""

    proposals = iter(range(PROPOSALS))

    def test(definition: Definition) -> Iterator[Problem]:
        first = definition.statements[0]
        is_new = bool(first.file.overlay) and not any("type" in s.values for s in definition.statements)
        if is_new and not first.values.get("delete") and not tree.is_instance(definition.path):
            message = f"The overlay changes {definition.path!r}, which does not exist."
            fix = _near(definition.path, tree) if next(proposals, None) is not None else ""
            yield Problem(first, message, fix=f"{fix} Give it a `type` if it is a new node.".lstrip())

    return test


def deletes_nothing(_rule: Rule, tree: Tree) -> NodeTest:
    """`delete: true` is written for a node that an earlier layer has."""

    proposals = iter(range(PROPOSALS))

    def test(definition: Definition) -> Iterator[Problem]:
        first = definition.statements[0]
        if first.file.overlay and first.values.get("delete") and not tree.resolve_other(definition.path):
            message = f"The overlay deletes {definition.path!r}, which does not exist."
            fix = _near(definition.path, tree) if next(proposals, None) is not None else ""
            yield Problem(first, message, "delete", fix or "Remove it.", at_name=True)

    return test


def changes(rule: Rule, _tree: Tree) -> NodeTest:
    """An overlay gives none of `attributes` another value than the tree below it."""
    attributes = tuple(rule.options["attributes"])

    def test(definition: Definition) -> Iterator[Problem]:
        for attribute in attributes if _in_base(definition) else ():
            base = _base_value(definition, attribute)
            statement = _last_of_overlay(definition, attribute)
            if base is not None and statement is not None and _differs(statement.values[attribute], base):
                message = (
                    f"The overlay changes `{attribute}` from {shown(base)} to {shown(statement.values[attribute])}."
                )
                yield Problem(statement, message, attribute, facts={"attribute": attribute})

    return test


def narrows(_rule: Rule, _tree: Tree) -> NodeTest:
    """An overlay does not take values away: a higher `min`, a lower `max`, fewer `allowed`, fewer of an `enum`."""

    def test(definition: Definition) -> Iterator[Problem]:
        for attribute in ("min", "max", "allowed", "enum") if _in_base(definition) else ():
            statement = _last_of_overlay(definition, attribute)
            if statement is None:
                continue
            reason = _narrowed(attribute, _base_value(definition, attribute), definition.values.get(attribute))
            if reason:
                yield Problem(statement, f"The overlay narrows `{attribute}`: {reason}.", attribute)

    return test


def conflict(rule: Rule, _tree: Tree) -> NodeTest:
    """Two overlays give the same attribute of a node different values; the message has the order in which they apply."""
    ignored = frozenset(rule.options.get("ignored", ()))

    def test(definition: Definition) -> Iterator[Problem]:
        written = [s for s in definition.statements if s.file.overlay]
        if len({s.file.overlay for s in written}) < 2:
            return
        for attribute in dict.fromkeys(name for s in written for name in s.values if name not in ignored):
            setting = [s for s in written if attribute in s.values]
            if len({s.file.overlay for s in setting}) > 1 and _differs(
                setting[-1].values[attribute], setting[0].values[attribute]
            ):
                steps = [f"{_name(s.file.overlay)} sets {shown(s.values[attribute])}" for s in setting]
                message = f"Overlays disagree on `{attribute}`: {', then '.join(steps)}; the last one applies."
                yield Problem(setting[-1], message, attribute, "Set it in one of them.")

    return test


def no_effect(_rule: Rule, tree: Tree) -> TreeTest:
    """An overlay changes at least one value of at least one node."""

    def test() -> Iterator[Problem]:
        effective: set[str] = set()
        first: dict[str, Statement] = {}
        for definition in tree.catalogue.overlaid:
            before: dict[str, Any] = {}
            for statement in definition.statements:
                overlay = statement.file.overlay
                after = merged_values(before, statement.values)
                if overlay and overlay not in effective:
                    first[overlay] = min(first.get(overlay, statement), statement, key=Statement.origin)
                    if after != before:
                        effective.add(overlay)
                before = after
        for overlay, statement in first.items():
            if overlay not in effective:
                yield Problem(statement, f"Overlay {_name(overlay)!r} changes nothing.", fix="Remove it.")

    return test


def _name(overlay: str) -> str:
    """The name of an overlay's file: where that stands on a server is nobody's concern, and of one's own the finding has it."""
    return overlay.rpartition("/")[2]


def _in_base(definition: Definition) -> bool:
    return any(not s.file.overlay for s in definition.statements)


def _base_value(definition: Definition, attribute: str) -> Any:
    values = (
        s.values[attribute] for s in reversed(definition.statements) if not s.file.overlay and attribute in s.values
    )
    return next(values, None)


def _last_of_overlay(definition: Definition, attribute: str) -> Statement | None:
    statements = (s for s in reversed(definition.statements) if s.file.overlay and attribute in s.values)
    return next(statements, None)


def _differs(one: Any, other: Any) -> bool:
    return bool(one != other) and str(one).lower() != str(other).lower()


def _narrowed(attribute: str, base: Any, now: Any) -> str:
    if attribute == "min" and is_number(now) and (base is None or (is_number(base) and now > base)):
        return f"{shown(base)} becomes {now}" if base is not None else f"it had no limit and becomes {now}"
    if attribute == "max" and is_number(now) and (base is None or (is_number(base) and now < base)):
        return f"{shown(base)} becomes {now}" if base is not None else f"it had no limit and becomes {now}"
    if attribute in ("allowed", "enum") and isinstance(now, list | dict):
        if not isinstance(base, list | dict):
            return "any value was allowed"
        kept = {_comparable(item) for item in now}
        gone = [str(item) for item in base if _comparable(item) not in kept]
        return f"{listed(gone)} {'is' if len(gone) == 1 else 'are'} no longer allowed" if gone else ""
    return ""


def _comparable(item: Any) -> Any:
    """A label as it is; of a collection, which is none, its text."""
    return str(item) if isinstance(item, list | dict) else item
