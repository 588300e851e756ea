"""Chains of drawn trees: each tree differs from the one before it by one to three changes."""

from collections.abc import Callable, Iterator, Mapping
from random import Random
from typing import Any

Tree = dict[str, dict[str, Any]]
"""Attributes by path; the order is that of the file."""

_UNITS = ("km", "m", "km/h", "m/s", "celsius", "percent", "s")
_NUMBERS = ("uint8", "int8", "uint16", "int16", "uint32", "int32", "uint64", "int64", "float", "double")
_DATATYPES = (*_NUMBERS, "boolean", "string")
_TEXTS = ("ECO", "SPORT", "NORMAL", "SNOW", "OFF")


class Drawer:
    """Draws trees and changes. Names are unique in a chain, except a few shared names of branches."""

    def __init__(self, seed: int) -> None:
        self._random = Random(seed)
        self._count = 0

    def chain(self, length: int) -> Iterator[str]:
        """Texts of neighbouring trees."""
        tree: Tree = {"Vehicle": {"type": "branch", "description": "A vehicle."}}
        for _ in range(4):
            self._add_branch(tree)
        for _ in range(8):
            self._add_signal(tree)
        for _ in range(length):
            yield text_of(tree)
            for _ in range(self._random.choice((1, 1, 1, 2, 3))):
                self._random.choice(self._changes())(tree)

    def _changes(self) -> tuple[Callable[[Tree], None], ...]:
        return (
            self._add_signal, self._add_signal, self._add_branch, self._remove, self._rename, self._datatype, self._datatype,
            self._array, self._unit, self._range, self._allowed, self._allowed, self._text, self._reorder, self._instances, self._kind,
        )  # fmt: skip

    # -- nodes

    def _name(self, prefix: str) -> str:
        self._count += 1
        return f"{prefix}{self._count}"

    def _any(self, tree: Tree, fits: Callable[[dict[str, Any]], bool]) -> str | None:
        """A path whose attributes fit, if there is one."""
        paths = [path for path, values in tree.items() if fits(values) and path != "Vehicle"]
        return self._random.choice(paths) if paths else None

    def _signal(self, tree: Tree) -> dict[str, Any] | None:
        path = self._any(tree, lambda values: values["type"] != "branch")
        return tree[path] if path else None

    def _branches(self, tree: Tree) -> list[str]:
        return [path for path, values in tree.items() if values["type"] == "branch"]

    def _insert(self, tree: Tree, path: str, values: dict[str, Any]) -> None:
        """Put a node behind its parent, anywhere."""
        entries = list(tree.items())
        first = list(tree).index(path.rpartition(".")[0]) + 1
        entries.insert(self._random.choice((len(entries), self._random.randint(first, len(entries)))), (path, values))
        tree.clear()
        tree.update(entries)

    # -- changes

    def _add_signal(self, tree: Tree) -> None:
        values: dict[str, Any] = {
            "type": self._random.choice(("sensor", "actuator", "attribute")),
            "datatype": self._random.choice(_DATATYPES),
            "description": "A value.",
        }
        name = self._name("Signal")
        if values["datatype"] == "string" and self._random.random() < 0.6:
            values["allowed"] = self._random.sample(_labels(name), 3)
        if values["datatype"] in _NUMBERS and self._random.random() < 0.4:
            values["unit"] = self._random.choice(_UNITS)
        self._insert(tree, f"{self._random.choice(self._branches(tree))}.{name}", values)

    def _add_branch(self, tree: Tree) -> None:
        name = self._random.choice((self._name("Part"), self._name("Part"), "Door"))
        path = f"{self._random.choice(self._branches(tree))}.{name}"
        if path not in tree and not path.endswith(
            ".Door.Door"
        ):  # IDL takes no module with the name of the one around it
            self._insert(tree, path, {"type": "branch", "description": "A part."})
            self._insert(
                tree,
                f"{path}.{self._name('Signal')}",
                {"type": "sensor", "datatype": "float", "description": "A value."},
            )

    def _remove(self, tree: Tree) -> None:
        path = self._any(tree, lambda values: True)
        parents = [each.rpartition(".")[0] for each in tree]
        is_only = path is not None and parents.count(path.rpartition(".")[0]) == 1  # IDL takes no empty module
        if path and len(tree) > 6 and not is_only:  # a schema of an empty vehicle has no type for it
            for each in [each for each in tree if f"{each}.".startswith(f"{path}.")]:
                del tree[each]

    def _rename(self, tree: Tree) -> None:
        path = self._any(tree, lambda values: values["type"] != "branch")
        if path is None:
            return
        new = f"{path.rpartition('.')[0]}.{self._name('Signal')}"
        entries = [
            (new, {**values, **self._former(tree, path)}) if each == path else (each, values)
            for each, values in tree.items()
        ]
        tree.clear()
        tree.update(entries)

    def _former(self, tree: Tree, path: str) -> Mapping[str, Any]:
        is_single = not any("instances" in values for each, values in tree.items() if path.startswith(f"{each}."))
        return {"fka": [path]} if is_single and self._random.random() < 0.5 else {}

    def _datatype(self, tree: Tree) -> None:
        values = self._signal(tree)
        if values and not {"allowed", "min", "max", "unit"} & values.keys():
            values["datatype"] = self._random.choice(_DATATYPES)
            values.pop("arraysize", None)

    def _array(self, tree: Tree) -> None:
        values = self._signal(tree)
        if values and "allowed" not in values and "min" not in values:
            element = values["datatype"].removesuffix("[]")
            values.pop("arraysize", None)
            values["datatype"] = self._random.choice((element, f"{element}[]"))
            if values["datatype"].endswith("[]") and self._random.random() < 0.5:
                values["arraysize"] = self._random.randint(2, 4)

    def _unit(self, tree: Tree) -> None:
        values = self._signal(tree)
        if values and values["datatype"].removesuffix("[]") in _NUMBERS:
            values.pop("unit", None)
            if self._random.random() < 0.7:
                values["unit"] = self._random.choice(_UNITS)

    def _range(self, tree: Tree) -> None:
        values = self._signal(tree)
        if values and values["datatype"] in _NUMBERS:
            values["min"], values["max"] = self._random.randint(0, 9), self._random.randint(10, 99)

    def _allowed(self, tree: Tree) -> None:
        path = self._any(tree, lambda values: values.get("datatype") == "string")
        if path:
            texts = self._random.sample(_labels(path.rpartition(".")[2]), self._random.randint(1, 5))
            old = tree[path].get("allowed", texts)
            longer = [*old, *(text for text in texts if text not in old)]
            tree[path]["allowed"] = self._random.choice((texts, longer, old[:2]))
            if self._random.random() < 0.2:
                del tree[path]["allowed"]

    def _text(self, tree: Tree) -> None:
        if values := self._signal(tree):
            values[self._random.choice(("comment", "deprecation"))] = self._name("Text ")

    def _kind(self, tree: Tree) -> None:
        if values := self._signal(tree):
            values["type"] = self._random.choice(("sensor", "actuator", "attribute"))

    def _reorder(self, tree: Tree) -> None:
        parent = self._random.choice(self._branches(tree))
        children = [path for path in tree if path.rpartition(".")[0] == parent]
        if len(children) > 1:
            moved = self._random.choice(children[1:])
            parts = [each for each in tree if f"{each}.".startswith(f"{moved}.")]
            entries = [(each, tree[each]) for each in (*parts, *(each for each in tree if each not in parts))]
            head = [entry for entry in entries if f"{moved}.".startswith(f"{entry[0]}.") and entry[0] != moved]
            rest = [entry for entry in entries if entry not in head]
            tree.clear()
            tree.update([*head, *rest])

    def _instances(self, tree: Tree) -> None:
        path = self._any(tree, lambda values: values["type"] == "branch")
        inside = path and any(
            "instances" in values
            for each, values in tree.items()
            if path.startswith(f"{each}.") or each.startswith(f"{path}.")
        )
        if (
            path
            and not inside
            and not any(each.startswith(f"{path}.") and "fka" in values for each, values in tree.items())
        ):
            tree[path]["instances"] = ["Left", "Right", "Middle"][: self._random.randint(1, 3)]


def _labels(name: str) -> list[str]:
    """Texts of a signal: the exported enumerations of a message must not share any."""
    return [f"{name.upper()}_{text}" for text in _TEXTS]


def text_of(tree: Tree) -> str:
    """The tree as vspec."""
    return "".join(
        f"{path}:\n" + "".join(f"  {name}: {value}\n" for name, value in values.items())
        for path, values in tree.items()
    )
