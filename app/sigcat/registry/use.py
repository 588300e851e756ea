"""Uses of the catalogue and of other functions by one version of a function: resolved once, when it is published."""

import json
from collections.abc import Iterable, Iterator, Mapping
from types import MappingProxyType
from typing import Any, NamedTuple

from sigcat.catalogue.comparing.diff_report import plain
from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.catalogue.model.datatypes import element_of
from sigcat.function.exchange import Side, causes, exchange_of, parts_of
from sigcat.function.function_json.error_fields import errors_set_by
from sigcat.function.function_json.interfaces.data_interfaces import DataQueue, Signal
from sigcat.function.function_json.interfaces.role import CONSUMER
from sigcat.function.function_json.interfaces.status_interfaces import SafetyReaction
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.walk import absent, parameters, runnables
from sigcat.function.sets.check_set import needs_provider

RELIED_ON = ("type", "datatype", "arraysize", "unit", "min", "max", "allowed", "enum")
"""Attributes of a node that the code of a function relies on."""
_VERBS: Mapping[tuple[str, bool], str] = {
    ("data", True): "provides", ("data", False): "consumes", ("method", True): "offers", ("method", False): "calls",
    ("error", True): "reports", ("error", False): "depends on", ("reaction", False): "reacts to",
    ("mode out", True): "sends", ("mode in", False): "receives",
}  # fmt: skip
PROVIDING = frozenset(("provides", "offers", "reports", "sends"))
"""Verbs of uses on which other functions may rely."""
_BY_NAME = frozenset(("offers", "calls", "reports", "depends on", "reacts to", "sends", "receives"))
_NOTHING: Mapping[str, Any] = MappingProxyType({})


class Use(NamedTuple):
    """A use of a node, or of an interface without one."""

    verb: str
    path: str
    """Path of the node; empty if it has none."""
    name: str
    """Name that all functions use: of data without a path its name, of a status the name of its interface."""
    call: str = ""
    variable: str = ""
    """Expression of the C code that holds the value."""
    via: str = ""
    """Path of the signal whose struct type the node belongs to."""
    values: Mapping[str, Any] = _NOTHING
    """Attributes of the node that the function relies on."""
    is_in_catalogue: bool = False
    """Whether the catalogue defines the node, and not a function."""
    is_needed: bool = False
    """Whether another function must provide it."""
    is_optional: bool = False
    """Whether the function runs without it."""
    leads_to: tuple[str, ...] = ()
    """Names of errors, reactions and modes that follow from it in this function."""

    @property
    def element(self) -> str:
        """Identity of the element: of a status or a method its name, of all else the path, if there is one."""
        return self.name if self.verb in _BY_NAME else self.path or self.name

    @property
    def relied(self) -> str:
        """The attributes of a node of the catalogue as stable text; empty if a function defines it, or nothing."""
        return json.dumps(dict(self.values), sort_keys=True) if self.is_in_catalogue and self.path else ""

    @property
    def provides(self) -> bool:
        """Whether others may rely on it."""
        return self.verb in PROVIDING


def uses_of(function: FunctionJson, catalogue: Catalogue, over: Catalogue) -> tuple[Use, ...]:
    """Every use. `over` is the catalogue with everything that functions define."""
    exchange = exchange_of(parts_of([function]))
    found = [_of_side(side, function, exchange.sides, over) for side in exchange.sides]
    found += [
        Use("is set by", item.vss_path or "", item.name, located.runnable.name, item.variable or "")
        for _, located, item in parameters(function)
    ]
    found += [
        Use("consumes", item.vss_path or "", item.name, located.runnable.name, item.variable or "", is_optional=True,
            leads_to=(item.absent_error,) if item.absent_error else ())
        for _, located, item in absent(function)
        if item.role == CONSUMER
    ]  # fmt: skip
    found += [Use("runs", each.runnable.vss_path or "", each.runnable.name) for each in runnables(function)]
    with_nodes = (_with_node(use, catalogue, over) for use in found)
    parts = (part for use in with_nodes for part in (use, *_struct_uses(use, catalogue, over)))
    return tuple({part[: Use._fields.index("values")]: part for part in parts}.values())


def _of_side(side: Side, function: FunctionJson, sides: Iterable[Side], over: Catalogue) -> Use:
    verb = _VERBS[side.kind, side.provides]
    needed = verb == "consumes" and needs_provider(side, over)
    name = side.data.name if side.kind == "data" and side.path else side.identity
    variable = getattr(side.interface, "variable", None) or ""
    call = side.call.name if side.call else ""
    consequences = tuple(dict.fromkeys(_consequences(side, function, sides)))
    is_optional = side.kind == "data" and bool(side.data.is_optional)
    return Use(verb, side.path, name, call, variable, is_needed=needed, is_optional=is_optional, leads_to=consequences)


def _consequences(side: Side, function: FunctionJson, sides: Iterable[Side]) -> Iterator[str]:
    """Names of consequences: a time-out sets its error, an error its reactions, a reaction changes the mode."""
    interface = side.interface
    if isinstance(interface, Signal | DataQueue):
        yield from (each.error for each in errors_set_by(interface))
    elif isinstance(interface, SafetyReaction):
        yield from (mode.name for mode in function.mode_interfaces or () if mode.direction == "Out")
    elif side.kind == "error":
        yield from (other.identity for other in sides if side.identity in causes(other.interface))


def _with_node(use: Use, catalogue: Catalogue, over: Catalogue) -> Use:
    node = over.get(use.path)
    return use if node is None else use._replace(values=_relied(node), is_in_catalogue=use.path in catalogue.nodes)


def _relied(node: Node) -> Mapping[str, Any]:
    values: Mapping[str, Any] = plain({key: node.values[key] for key in RELIED_ON if node.values.get(key) is not None})
    return values


def _struct_uses(use: Use, catalogue: Catalogue, over: Catalogue) -> Iterator[Use]:
    """The struct type of a signal with its properties, and the types of these."""
    waiting, seen = [element_of(str(use.values.get("datatype", "")))], set[str]()
    while waiting:
        path = waiting.pop()
        struct = over.get(path)
        if path in seen or struct is None or struct.type != "struct":
            continue
        seen.add(path)
        for node in struct.walk():
            yield _with_node(Use(use.verb, node.path, node.name, use.call, use.variable, use.path), catalogue, over)
            waiting.append(element_of(str(node.values.get("datatype", ""))))


def to_json(uses: Iterable[Use]) -> bytes:
    """The uses as stable text."""
    return json.dumps(
        [{**use._asdict(), "values": dict(use.values)} for use in uses], sort_keys=True, ensure_ascii=False
    ).encode()


def row_text(use: Use, relied: str) -> str:
    """A use as the text of a row, without what is usual, and without the attributes that `relied` has."""
    row = {**use._asdict(), "values": {} if relied else dict(use.values)}
    kept = {key: value for key, value in row.items() if value != Use._field_defaults.get(key)}
    return json.dumps(kept, sort_keys=True, separators=(",", ":"), ensure_ascii=False)


def from_row(text: str, relied: str | None) -> Use:
    """The use of a row."""
    row = {**json.loads(text), **({"values": json.loads(relied)} if relied else {})}
    return Use(**{**row, "leads_to": tuple(row.get("leads_to", ()))})


def from_json(data: bytes) -> tuple[Use, ...]:
    """The uses of a text that `to_json` wrote."""
    return tuple(Use(**{**each, "leads_to": tuple(each["leads_to"])}) for each in json.loads(data))
