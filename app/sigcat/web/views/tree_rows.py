"""Rows of the tree: those that are visible with certain branches open, and those below a branch for the browser."""

from collections.abc import Iterable, Mapping, Sequence
from typing import Any, NamedTuple

from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.catalogue.model.interfaces import category_of
from sigcat.names import parent_path
from sigcat.web.template_filters import number, unit

EVERYTHING = "*"
_NO_COUNTS: Mapping[str, int] = {}
_NO_USERS: Mapping[str, Sequence[str]] = {}


class Row(NamedTuple):
    """A visible row. Levels and positions count from 1, as in the W3C tree pattern."""

    node: Node
    level: int
    position: int
    siblings: int
    is_open: bool


class OpenBranches:
    """Open branches: those named, those above the selected node, and with `*` all."""

    def __init__(self, named: Iterable[str], selected: str) -> None:
        self.named = tuple(dict.fromkeys(path for path in named if path))
        self.selected = selected
        self._is_everything = EVERYTHING in self.named
        self._open = set(self.named) | set(_above(selected))

    def __contains__(self, path: str) -> bool:
        return self._is_everything or path in self._open

    def with_(self, path: str) -> str:
        """The `open` parameter with one more branch."""
        return ",".join(dict.fromkeys((*self.named, path)))

    def without(self, path: str) -> str:
        """The `open` parameter with one branch less."""
        return ",".join(each for each in self.named if each not in (path, EVERYTHING))

    def selected_after_closing(self, path: str) -> str:
        """Return the selected node once a branch is closed: the branch, if the selected node was below it."""
        return path if self.selected.startswith(f"{path}.") else self.selected


def visible_rows(catalogue: Catalogue, opened: OpenBranches, start: int, limit: int) -> tuple[list[Row], int]:
    """Visible rows from `start` on, at most `limit`, and how many there are in all."""
    rows: list[Row] = []
    total = 0
    waiting = [Row(n, 1, i + 1, len(catalogue.roots), n.path in opened) for i, n in enumerate(catalogue.roots)][::-1]
    while waiting:
        row = waiting.pop()
        if start <= total < start + limit:
            rows.append(row)
        total += 1
        if row.is_open:
            children = row.node.children
            below = [Row(n, row.level + 1, i + 1, len(children), n.path in opened) for i, n in enumerate(children)]
            waiting.extend(reversed(below))
    return rows, total


def rows_below(
    nodes: Iterable[Node],
    depth: int,
    instances: Mapping[str, int] = _NO_COUNTS,
    functions: Mapping[str, Sequence[str]] = _NO_USERS,
) -> dict[str, Any]:
    """Compact rows for the browser, parents first: `[level, name, kind, children]`, with the distinct kinds apart.

    A row ends with the number of functions that use the node or one below it, if there are any. 100,000 nodes have a few hundred kinds, so a row is a few dozen bytes.
    """
    kinds: dict[tuple[str, ...], int] = {}
    by_definition: dict[int, int] = {}
    rows: list[tuple[int | str, ...]] = []
    waiting = [(node, 0) for node in reversed(tuple(nodes))]
    while waiting:
        node, level = waiting.pop()
        key = id(node.definition)
        kind = by_definition.get(key)
        if kind is None:
            kind = by_definition[key] = kinds.setdefault(_kind(node, instances), len(kinds))
        users = (len(functions[node.path]),) if node.path in functions else ()
        rows.append((level, node.name, kind, len(node.children), *users))
        if level < depth:
            waiting.extend((child, level + 1) for child in reversed(node.children))
    return {"kinds": list(kinds), "rows": rows}


def _kind(node: Node, instances: Mapping[str, int]) -> tuple[str, ...]:
    """Type, datatype or number of folded instances, unit, category other than data, and whether it is deprecated."""
    category = category_of(node.path) or ""
    return (
        node.type,
        f"×{number(instances[node.path])}" if node.path in instances else str(node.values.get("datatype") or ""),
        unit(str(node.values.get("unit") or "")),
        "" if category == "data" else category,
        "deprecated" if node.values.get("deprecation") else "",
    )


def _above(path: str) -> Iterable[str]:
    above = parent_path(path)
    while above:
        yield above
        above = parent_path(above)
