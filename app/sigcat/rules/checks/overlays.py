"""Checks of overlays: what each statement of one does to the tree below it."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from sigcat.catalogue.composing.instance_names import count_instances, instance_names
from sigcat.catalogue.exporting.static_id import static_id_of
from sigcat.catalogue.model.definition import BRANCH, Definition, instances_of, merged_statements, merged_values
from sigcat.catalogue.reading.statement import Statement
from sigcat.findings import shown
from sigcat.limits import COMPARED_INSTANCES
from sigcat.names import parent_path
from sigcat.rules.checks.kind import NodeTest, TreeTest, is_bound, listed
from sigcat.rules.near_paths import near_path
from sigcat.rules.problem import Problem
from sigcat.rules.record import Rule
from sigcat.rules.tree import Tree


def unknown_node(_rule: Rule, tree: Tree) -> NodeTest:
    """A node that an overlay adds has a `type`; one without was meant to change a node that is there."""

    def test(definition: Definition) -> Iterator[Problem]:
        first = definition.statements[0]
        is_new = bool(first.file.overlay) and not any("type" in s.values for s in definition.statements)
        if is_new and not first.values.get("delete") and not tree.is_instance(definition.path):
            message = f"The overlay changes {definition.path!r}, which does not exist."
            fix = near_path(definition.path, tree)
            yield Problem(first, message, fix=f"{fix} Give it a `type` if it is a new node.".lstrip())

    return test


def deletes_nothing(_rule: Rule, tree: Tree) -> NodeTest:
    """`delete: true` is written for a node that an earlier layer has, and not for the root."""

    def test(definition: Definition) -> Iterator[Problem]:
        first = definition.statements[0]
        written = _last_of_overlay(definition, "delete")
        if "." not in definition.path and written is not None:
            message = f"The root {definition.path!r} cannot be deleted."
            yield Problem(written, message, "delete", "Delete the branches below it.", at_name=True)
        elif first.file.overlay and first.values.get("delete") and not tree.resolve_other(definition.path):
            message = f"The overlay deletes {definition.path!r}, which does not exist."
            fix = near_path(definition.path, tree)
            yield Problem(first, message, "delete", fix or "Remove it.", at_name=True)

    return test


def changes(rule: Rule, _tree: Tree) -> NodeTest:
    """An overlay gives none of `attributes` another value than the tree below it, and none of `given` where that has none."""
    attributes = tuple(rule.options["attributes"])
    given = frozenset(rule.options.get("given", ()))

    def test(definition: Definition) -> Iterator[Problem]:
        for attribute in attributes if _in_base(definition) else ():
            base = _base_value(definition, attribute)
            statement = _last_of_overlay(definition, attribute)
            if statement is None:
                continue
            value = statement.values[attribute]
            facts = {"attribute": attribute}
            if base is not None and _differs(value, base):
                message = f"The overlay changes `{attribute}` from {shown(base)} to {shown(value)}."
                yield Problem(statement, message, attribute, facts=facts)
            elif base is None and attribute in given and not _is_meant_anyway(attribute, value, definition):
                message = f"The overlay gives `{attribute}` {shown(value)} to a node that has none."
                yield Problem(statement, message, attribute, facts=facts)

    return test


def _is_meant_anyway(attribute: str, value: Any, definition: Definition) -> bool:
    """Whether a value is what a node without it has: the identifier that is computed for it."""
    base = _base_values(definition)
    return attribute == "constUID" and str(value).lower() == static_id_of(definition.path, base).lower()


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


def below_deleted(_rule: Rule, tree: Tree) -> TreeTest:
    """An overlay writes nothing below a branch that it deletes, or that an earlier layer deletes."""

    def test() -> Iterator[Problem]:
        order = {layer.name: number for number, layer in enumerate(tree.overlays)}
        told: set[tuple[str, str]] = set()
        for definition in tree.judged if order else ():
            branch = _deleted_above(definition.path, tree)
            if branch is None or not definition.type:
                continue
            deleting = order.get(_deletion(branch).file.overlay, -1)
            for statement in definition.statements:
                number, key = order.get(statement.file.overlay, -1), (branch.path, statement.file.overlay)
                if number >= max(deleting, 0) and not statement.values.get("delete") and key not in told:
                    told.add(key)
                    message = f"{definition.path!r} is not in the tree: {branch.path!r} is deleted."
                    yield Problem(statement, message, fix=f"Keep {branch.path!r}, or delete what is below it by name.")

    return test


def _deleted_above(path: str, tree: Tree) -> Definition | None:
    """The topmost branch above a path that is deleted. The root cannot be."""
    names = path.split(".")
    above = (tree.definitions.get(".".join(names[:count])) for count in range(2, len(names)))
    return next((branch for branch in above if branch is not None and branch.values.get("delete")), None)


def _deletion(branch: Definition) -> Statement:
    return next(statement for statement in reversed(branch.statements) if "delete" in statement.values)


def keeps_instances(_rule: Rule, tree: Tree) -> NodeTest:
    """Report paths that an overlay changes below a branch: it must not remove instances, or add them to a branch without."""

    def test(definition: Definition) -> Iterator[Problem]:
        if not _in_base(definition) or definition.values.get("delete"):
            return
        instances = _last_of_overlay(definition, "instances", "instances_relation")
        if instances is not None and definition.type == BRANCH:
            yield from _other_instances(definition, instances, tree)
        instantiate = _last_of_overlay(definition, "instantiate")
        if instantiate is not None:
            yield from _instantiated_otherwise(definition, instantiate, tree)

    return test


def _other_instances(definition: Definition, statement: Statement, tree: Tree) -> Iterator[Problem]:
    path, attribute = definition.path, "instances" if "instances" in statement.values else "instances_relation"
    gone = sorted(_holders(path, _base_values(definition)) - _holders(path, definition.values))
    if gone and (gone != [path] or _holds_instantiated(path, tree)):
        yield Problem(statement, f"The overlay changes `{attribute}`: {_moved(gone)}.", attribute)


def _instantiated_otherwise(definition: Definition, statement: Statement, tree: Tree) -> Iterator[Problem]:
    """Report an overlay that moves a node into the instances of its branch, or out of them."""
    before = _base_values(definition)
    above = tree.definitions.get(parent_path(definition.path))
    has_instances = above is not None and bool(instances_of(above.values))
    now = definition.values.get("instantiate", True)
    if has_instances and before.get("instantiate", True) is not now:
        where = "below the instances" if now else "beside the instances"
        message = f"The overlay changes `instantiate`: {definition.path!r} moves to a path {where}."
        yield Problem(statement, message, "instantiate")


def _holders(path: str, values: Mapping[str, Any]) -> set[str]:
    """The paths right below which the nodes of a branch are: of its last instances, or its own without any."""
    instances = instances_of(values)
    if not instances or count_instances(instances) > COMPARED_INSTANCES:
        return {path}
    top = parent_path(path) if values.get("instances_relation") == "sibling" else path
    holders, roots = {top}, [top]
    for entry in instances:
        names = list(instance_names(entry))
        made = [f"{root}.{name}" for name in names for root in roots]
        holders = holders.difference(roots).union(made)
        if len(names) > 1 or isinstance(entry, list):
            roots = made
    return holders


def _holds_instantiated(path: str, tree: Tree) -> bool:
    below = (child for child in tree.children.get(path, ()) if _in_base(child))
    return any(child.values.get("instantiate", True) for child in below)


def _moved(gone: Sequence[str]) -> str:
    named = listed(gone) if len(gone) <= 3 else f"`{gone[0]}` and {len(gone) - 1} more paths"
    return f"what is below {named} is no longer there"


def _base_values(definition: Definition) -> Mapping[str, Any]:
    return merged_statements([s for s in definition.statements if not s.file.overlay])


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
    """The name of an overlay's file: its folder on a server is private, and for the user's own file the finding has it."""
    return overlay.rpartition("/")[2]


def _in_base(definition: Definition) -> bool:
    return any(not s.file.overlay for s in definition.statements)


def _base_value(definition: Definition, attribute: str) -> Any:
    values = (
        s.values[attribute] for s in reversed(definition.statements) if not s.file.overlay and attribute in s.values
    )
    return next(values, None)


def _last_of_overlay(definition: Definition, *attributes: str) -> Statement | None:
    """The last statement of an overlay that gives one of the attributes."""
    written = (s for s in reversed(definition.statements) if s.file.overlay)
    return next((s for s in written if any(attribute in s.values for attribute in attributes)), None)


def _differs(one: Any, other: Any) -> bool:
    """Whether values differ; of mappings, which are merged, whether those that both have do."""
    if isinstance(one, dict) and isinstance(other, dict):
        return any(key in other and _differs(value, other[key]) for key, value in one.items())
    return bool(one != other) and str(one).lower() != str(other).lower()


def _narrowed(attribute: str, base: Any, now: Any) -> str:
    if attribute == "min" and is_bound(now) and (base is None or (is_bound(base) and now > base)):
        return f"{shown(base)} becomes {now}" if base is not None else f"it had no limit and becomes {now}"
    if attribute == "max" and is_bound(now) and (base is None or (is_bound(base) and now < base)):
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
