"""The signal of the catalogue that each input and output is; a path to be chosen where that is not certain."""

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from itertools import islice
from typing import Any, Literal, NamedTuple

from sigcat.asil import Level, level_of
from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.catalogue.model.datatypes import element_of, is_array
from sigcat.catalogue.near_signals import PLACEHOLDER, Near, NearSignals, is_to_be_chosen
from sigcat.function.c_project.code_values import Value
from sigcat.function.function_json.conversion import between
from sigcat.function.importing.start_values import factor_of, stored_ends, stored_range
from sigcat.function.importing.unique_names import unique_names
from sigcat.function.importing.units import unit_of
from sigcat.names import camel_case, words

Role = Literal["consumed", "provided"]


_COMPARED, _SHOWN = 10, 3
"""Numbers of signals that are compared, and of those that are proposed."""


class Signal(NamedTuple):
    """An input or an output, with the path that it has or may have."""

    value: Value
    role: Role
    name: str
    """Unique in the function."""
    path: str
    near: tuple[str, ...] = ()
    """Paths that may be meant, if it is not certain which."""
    unit: str = ""
    """Key of the unit that the code tells."""
    catalogue_unit: str = ""
    """Unit of the signal that was chosen."""
    values: Mapping[str, int] = {}
    """Numbers of an enumeration by the catalogue's names, or those of the code."""
    why: str = ""
    """Why the nearest signal was not chosen, although it has the name."""

    catalogue_asil: Level | None = None
    """ASIL of the signal that was chosen."""

    @property
    def is_chosen(self) -> bool:
        """Whether the path is one of the catalogue."""
        return not is_to_be_chosen(self.path)

    @property
    def unknown_unit(self) -> str:
        """The unit that the code names and the catalogue does not have; empty if there is none."""
        return "" if self.unit else self.value.remark.unit

    @property
    def keys(self) -> dict[str, Any]:
        """Keys of the entry besides its path."""
        value, remark = self.value, self.value.remark
        is_scaled = value.datatype not in (*_FLOATING, "boolean")
        least, most = self._limits()
        keys = {
            "role": self.role,
            "name": self.name,
            "variable": value.expression,
            "definedBy": "adapter" if value.defined_by == "adapter" else None,
            "cType": value.c_type or None,
            "datatype": f"{value.datatype}{'[]' if value.length else ''}",
            "unit": self.unit,
            "factor": remark.factor if is_scaled else None,
            "offset": remark.offset if is_scaled else None,
            "min": least,
            "max": most,
            "rangeErrorAction": "Init" if self._is_cut else None,
            "init": min(max(0, least or 0), 0 if most is None else most) if self._is_cut else None,
            "values": dict(self.values),
            "asil": None if self.catalogue_asil else "QM",
        }
        return {key: each for key, each in keys.items() if each not in (None, "", {})}

    @property
    def _is_cut(self) -> bool:
        """Whether the adapter writes a bit field, which would cut a number with too many bits."""
        return self.role == "consumed" and bool(self.value.bits)

    def _limits(self) -> tuple[float | int | None, float | int | None]:
        """The range that the comment tells, and within a bit field that the adapter writes."""
        least, most = self.value.remark.min, self.value.remark.max
        if not self._is_cut:
            return least, most
        low, high = stored_ends(self.value) if factor_of(self.value) is None else stored_range(self.value)
        return low if least is None else max(low, least), high if most is None else min(high, most)

    def to_be_chosen(self, path: str, near: tuple[str, ...], why: str) -> "Signal":
        """The same with a path to be chosen, signals near it, and why the nearest one was not chosen."""
        numbers = {each.name: each.value for each in self.value.constants}
        return self._replace(path=path, near=near, why=why, values=numbers, catalogue_unit="", catalogue_asil=None)

    def unchosen(self, why: str) -> "Signal":
        """The same with a path to be chosen; that which it had is near."""
        root = self.path.partition(".")[0]
        return self.to_be_chosen(placeholder(root, self.name), (self.path,), why)


def signals_of(
    values: Sequence[tuple[Role, Value]], catalogue: Catalogue, model: str, paths: Collection[str] = ()
) -> Iterator[Signal]:
    """A signal for each value, in order; `paths` are those of others."""
    known = NearSignals(catalogue)
    root = catalogue.roots[0].path if catalogue.roots else "Vehicle"
    used = set(paths)
    names = unique_names([value for _, value in values])
    for (role, value), name in zip(values, names, strict=True):
        near = known.near(_meant(value, model), _COMPARED)
        signal = Signal(value, role, name, "", unit=unit_of(value.remark.units, catalogue.vocabulary))
        node = near[0].node if _is_certain(near) else None
        why = _why_not(signal, node, used) if node else ""
        if node is not None and not why:
            used.add(node.path)
            yield _chosen(signal, node)
        else:
            path = _free(placeholder(root, _meant(value, model)), placeholder(root, name), used)
            yield signal.to_be_chosen(path, _proposed(near, signal.unit), why)


def _proposed(near: Sequence[Near], unit: str) -> tuple[str, ...]:
    """Signals that share a whole word with the name, or the unit with the code."""
    found = (one.node for one in near if one.shares_word or (unit and one.node.values.get("unit") == unit))
    return tuple(node.path for node in islice(found, _SHOWN))


def _chosen(signal: Signal, node: Node) -> Signal:
    unit, asil = str(node.values.get("unit") or ""), level_of(node.values.get("ASILlevel"))
    numbers = _numbers(signal.value, node) or {}
    return signal._replace(path=node.path, catalogue_unit=unit, catalogue_asil=asil, values=numbers)


def _free(path: str, other: str, used: set[str]) -> str:
    """The path, or the other one where the path is used already."""
    found = other if path in used else path
    used.add(found)
    return found


def placeholder(root: str, name: str) -> str:
    """A path that no tree has."""
    return f"{root}.{PLACEHOLDER}.{camel_case(name) if _ODD.search(name) else name}"


_ODD = re.compile(r"[^A-Za-z0-9_]")


def _meant(value: Value, model: str) -> str:
    """The name of the port, or that of the member, without what all names of the model begin with."""
    name = value.remark.port or value.name
    for prefix in (f"{model}_U_", f"{model}_Y_", f"{model}_", "rtu_", "rty_"):
        name = name.removeprefix(prefix)
    return name


def _is_certain(near: tuple[Near, ...]) -> bool:
    """Whether only one signal can be meant: it has all words of a name of two or more, and no other one has them too.

    One that has more words in its last name says more than the name; one without any other words says just that.
    """
    if not near or near[0].wanted < 2 or not near[0].has_all or near[0].beyond_last:
        return False
    rivals = [one for one in near[1:] if one.has_all and not one.beyond_last]
    return not rivals or (near[0].beyond == 0 and rivals[0].beyond > 0)


def _numbers(value: Value, node: Node) -> Mapping[str, int] | None:
    """Numbers of the code by the names that the catalogue allows; None if these are not the same names."""
    allowed = node.values.get("allowed")
    if not isinstance(allowed, list) or not value.constants:
        return None
    by_words = {_plain(each.name): each.value for each in value.constants}
    found = {
        str(name): next((by_words[key] for key in by_words if key.endswith(_plain(str(name)))), None)
        for name in allowed
    }
    numbers = {name: number for name, number in found.items() if number is not None}
    return numbers if len(numbers) == len(allowed) == len(set(numbers.values())) else None


def _plain(name: str) -> str:
    return "".join(words(name)).lower()


def _why_not(signal: Signal, node: Node, used: Collection[str]) -> str:
    """Why the code does not hold what the signal is, although the name is the same; empty if it does."""
    value, datatype = signal.value, str(node.values["datatype"])
    if node.path in used:
        return "another value is this signal already."
    if signal.role == "provided" and node.type == "attribute":
        return "functions do not provide attributes."
    if is_array(datatype) != bool(value.length):
        return f"{datatype} is not what {'an array' if value.length else 'one value'} can hold."
    if value.length and node.values.get("arraysize", value.length) != value.length:
        return f"the signal has {node.values['arraysize']} elements, the code {value.length}."
    return _why_not_element(signal, node, element_of(datatype))


def _why_not_element(signal: Signal, node: Node, datatype: str) -> str:
    value = signal.value
    if node.values.get("allowed") or value.constants:
        return "" if _numbers(value, node) else "the enumeration has other names."
    if datatype == "string" or (datatype == "boolean") != (value.datatype == "boolean"):
        return f"the signal is {datatype}, the code has {value.datatype}."
    if datatype in _FLOATING and value.datatype not in _FLOATING and value.remark.factor is None:
        return f"the signal is {datatype}; the code has {value.datatype}, and tells no scale."
    own = node.values.get("unit")
    if signal.unknown_unit:
        return f"the signal is in {own or 'no unit'}, the code in {signal.unknown_unit}, which is not a unit of the catalogue."
    if signal.unit and not (isinstance(own, str) and between(own, signal.unit)):
        return f"the signal is in {own or 'no unit'}, the code in {signal.unit}."
    return ""


_FLOATING = ("float", "double")
