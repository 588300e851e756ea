"""Proposals for a path that leads nowhere."""

from sigcat.names import did_you_mean, last_name, nearest, parent_path
from sigcat.rules.tree import Tree


def near_path(path: str, tree: Tree) -> str:
    """Return a proposal: a child of the same branch, or else a node of that name, or one with a similar path."""
    by_branch = with_another_branch(path, tree)
    if by_branch:
        return by_branch
    if _leads_below_instances(path, tree):
        return did_you_mean(path, (other for other, known in tree.expanded.items() if known.type))
    own = last_name(path)
    beside = {name: other for name, other in tree.typed.get(parent_path(path), {}).items() if other != path}
    near = nearest(own, beside)
    if near:
        return did_you_mean(path, [beside[name] for name in near])
    if beside:
        return did_you_mean(path, (c[own] for c in tree.typed.values() if c.get(own, path) != path))
    others = (other for children in tree.typed.values() for other in children.values())
    return did_you_mean(path, (other for other in others if other != path))


def with_another_branch(path: str, tree: Tree) -> str:
    """A proposal of paths that differ from one in the first branch or instance that is not there: `Row1` where it has `Row3`."""
    names = path.split(".")
    paths = (".".join(names[:count]) for count in range(1, len(names)))
    wrong = next((above for above in paths if above not in tree.expanded and above not in tree.definitions), "")
    if not wrong:
        return ""
    prefix, rest = f"{parent_path(wrong)}.", path[len(wrong) :]
    beside = {
        last_name(known) for known in tree.expanded if known.startswith(prefix) and "." not in known[len(prefix) :]
    }
    meant = {name: f"{prefix}{name}{rest}" for name in sorted(beside)}
    known_beside = {name: other for name, other in meant.items() if other in tree.expanded or other in tree.definitions}
    near = nearest(last_name(wrong), known_beside) or (known_beside if len(known_beside) <= _FEW else ())
    return did_you_mean(path, [meant[name] for name in near])


_FEW = 3
"""So many branches with the same below them are proposed, however they are called: the instances of a row, say."""


def _leads_below_instances(path: str, tree: Tree) -> bool:
    """Whether a part of a path names an instance: what was meant is then below one too."""
    above = parent_path(path)
    while above and not tree.is_instance(above):
        above = parent_path(above)
    return bool(above)
