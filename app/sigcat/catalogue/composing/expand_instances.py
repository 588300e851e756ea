"""Expand instances: a branch is defined once and is in the tree several times.

`instances: [Row[1,2], [Left, Right]]` puts what is below a branch under Row1.Left, Row1.Right, Row2.Left and
Row2.Right. A node that is written out below one instance refines that instance alone. Corner cases are as in vss-tools
6.1 (`expand_instances`).

Drafts are shared: all instances of a branch hold the same drafts below, until one of them is refined.
"""

from collections.abc import Mapping
from typing import Any

from sigcat.catalogue.composing.blame import with_blame
from sigcat.catalogue.composing.build_tree import Draft
from sigcat.catalogue.composing.check_definition import checked_definition
from sigcat.catalogue.composing.instance_names import count_instances, instance_names
from sigcat.catalogue.model.definition import BRANCH, Definition, Scope, instances_of, merged_values
from sigcat.limits import Limits

_FILLED_IN: Mapping[str, Any] = {"delete": False, "instantiate": True}
_FILLED_IN_BRANCH: Mapping[str, Any] = {"instances_relation": "child", "aggregate": False}


class TooManyNodes(Exception):
    """The expansion would have more nodes than the limit. `draft` is the branch whose instances are too many."""

    def __init__(self, draft: Draft, count: int) -> None:
        super().__init__(f"{count:,} nodes")
        self.draft = draft
        self.count = count


def expand_instances(root: Draft, scope: Scope, limits: Limits) -> Draft:
    """The tree with every branch that has instances expanded. Raises TooManyNodes."""
    expansion = _Expansion(scope, limits)
    (tree, *_) = _expanded(root, expansion)
    if _size(tree, expansion) > limits.nodes:
        raise TooManyNodes(root, _size(tree, expansion))
    return tree


class _Expansion:
    """State of one expansion: a draft that is in the tree many times is expanded and measured once."""

    def __init__(self, scope: Scope, limits: Limits) -> None:
        self.scope = scope
        self.limits = limits
        self.expanded: dict[int, tuple[Draft, list[Draft]]] = {}
        """By identity of the draft, which is kept so that the identity stays its own."""
        self.sizes: dict[int, tuple[Draft, int]] = {}


class _Growing:
    """A generated instance to which nodes are still being added."""

    def __init__(self, name: str, definition: Definition) -> None:
        self.name = name
        self.definition = definition
        self.children: dict[str, _Growing | Draft] = {}

    def finished(self) -> Draft:
        children = {
            name: child.finished() if isinstance(child, _Growing) else child for name, child in self.children.items()
        }
        return Draft(self.name, self.definition, children)


def _size(draft: Draft, expansion: _Expansion) -> int:
    if not draft.children:
        return 1
    known = expansion.sizes.get(id(draft))
    if known is None:
        size = 1 + sum(_size(child, expansion) for child in draft.children.values())
        expansion.sizes[id(draft)] = known = (draft, size)
    return known[1]


def _expanded(draft: Draft, expansion: _Expansion) -> list[Draft]:
    """The draft expanded, and after it the siblings that its instances put beside it."""
    if not draft.children and draft.definition.type != BRANCH:
        return [draft]
    known = expansion.expanded.get(id(draft))
    if known is not None:
        return known[1]
    instances = instances_of(draft.definition.values) if draft.definition.type == BRANCH else []
    if instances:
        holder, *siblings = _with_instances(draft, instances, expansion)
        result = [_with_children_expanded(part, expansion) for part in (holder, *siblings)]
    else:
        result = [_with_children_expanded(draft, expansion)]
    expansion.expanded[id(draft)] = (draft, result)
    return result


def _with_children_expanded(draft: Draft, expansion: _Expansion) -> Draft:
    children: dict[str, Draft] = {}
    siblings: list[Draft] = []
    changed = False
    for child in draft.children.values():
        expanded, *beside = _expanded(child, expansion)
        changed = changed or expanded is not child or bool(beside)
        children[expanded.name] = expanded
        siblings.extend(beside)
    children.update((sibling.name, sibling) for sibling in siblings)
    return draft._replace(children=children) if changed else draft


def _with_instances(draft: Draft, instances: list[Any], expansion: _Expansion) -> list[Draft]:
    """The branch with its instances below it, or beside it where `instances_relation` is `sibling`."""
    count = count_instances(instances)
    if count > expansion.limits.nodes:
        raise TooManyNodes(draft, count)
    is_beside = draft.definition.values.get("instances_relation") == "sibling"
    holder = _Growing(draft.name, _without_instances(draft.definition, is_instance=draft.definition.is_instance))
    holder.children.update({name: child for name, child in draft.children.items() if not _is_instantiated(child)})
    top = _Growing("", holder.definition) if is_beside else holder
    generated = _generate(top, _without_instances(draft.definition, is_instance=True), instances)
    moved = {name: child for name, child in draft.children.items() if _is_instantiated(child)}
    below = {name: child for name, child in moved.items() if is_beside or name not in top.children}
    for instance in generated:
        if not instance.children:
            instance.children.update(below)
    if is_beside:
        return [holder.finished(), *top.finished().children.values()]
    return [_with_refinements(holder.finished(), moved, expansion.scope)]


def _with_refinements(holder: Draft, written: Mapping[str, Draft], scope: Scope) -> Draft:
    """The branch with its instances refined by what is written out for them."""
    children = {
        name: _refined(child, written[name], scope) if name in written else child
        for name, child in holder.children.items()
    }
    return holder._replace(children=children)


def _generate(top: _Growing, definition: Definition, instances: list[Any]) -> list[_Growing]:
    """Add an instance for each name: below all instances of the entry before, if that entry had several names."""
    roots = [top]
    generated: list[_Growing] = []
    for entry in instances:
        names = list(instance_names(entry))
        nodes: list[_Growing] = []
        for name in names:
            for root in roots:
                node = _Growing(name, definition)
                root.children[name] = node
                nodes.append(node)
        generated.extend(nodes)
        if len(names) > 1 or isinstance(entry, list):
            roots = nodes
    return generated


def _is_instantiated(draft: Draft) -> bool:
    return bool(draft.definition.values.get("instantiate", True))


def _without_instances(definition: Definition, *, is_instance: bool) -> Definition:
    values = {name: value for name, value in definition.values.items() if name != "instances"}
    return Definition(definition.path, definition.statements, values, definition.problems, is_instance)


def _refined(draft: Draft, refinement: Draft, scope: Scope) -> Draft:
    """An instance with what is written out for it alone merged in, all the way down."""
    children = dict(draft.children)
    for name, child in refinement.children.items():
        children[name] = _refined(children[name], child, scope) if name in children else child
    return Draft(draft.name, _refined_definition(draft.definition, refinement.definition, scope), children)


def _refined_definition(definition: Definition, refinement: Definition, scope: Scope) -> Definition:
    statements = definition.statements + refinement.statements
    values = refined_values(definition, refinement)
    refined = checked_definition(definition.path, statements, values, scope, definition.is_instance)
    return with_blame(refined, definition, scope) if refined.problems and refinement.statements else refined


def refined_values(definition: Definition, refinement: Definition) -> Mapping[str, Any]:
    """Empty values refine nothing. A refinement that is complete in itself brings the defaults of its attributes."""
    update = {name: value for name, value in refinement.values.items() if value is not None and value != []}
    if not any(problem.rule.severity == "error" for problem in refinement.problems):
        defaults = {**_FILLED_IN, **_FILLED_IN_BRANCH} if refinement.type == BRANCH else _FILLED_IN
        update = {**_where_present(defaults, definition.values), **update}
    return merged_values(definition.values, update)


def _where_present(defaults: Mapping[str, Any], values: Mapping[str, Any]) -> dict[str, Any]:
    return {name: value for name, value in defaults.items() if name in values}
