"""Compatibility of changes: the class table, and the row of an attribute's change.

The point of view is that of software written against the old tree. It reads sensors, reads and sets actuators, and
relies on attributes (parameters) that were set for a vehicle.
"""

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

from sigcat.catalogue.comparing.changes import AttributeChange, Class, same, worst
from sigcat.catalogue.model.datatypes import INTEGER_RANGES, element_of
from sigcat.catalogue.model.definition import BRANCH, COMMON_ATTRIBUTES, CORE_ATTRIBUTES, SIGNALS, STRUCT
from sigcat.catalogue.model.vocabulary import EMPTY, Vocabulary


class Row(NamedTuple):
    """A row of the class table: what changed, the class for each type of signal, and why."""

    rule: str
    what: str
    actuator: Class
    sensor: Class
    attribute: Class
    why: str

    def for_type(self, node_type: str) -> Class:
        """The class for a node; other nodes (branch, struct, property) get the worst."""
        by_type: dict[str, Class] = {"actuator": self.actuator, "sensor": self.sensor, "attribute": self.attribute}
        return by_type.get(node_type) or worst(by_type.values())


def _row(rule: str, what: str, compatibility: Class, why: str) -> Row:
    return Row(rule, what, compatibility, compatibility, compatibility, why)


TABLE: tuple[Row, ...] = (
    _row("removed", "a node is gone", "breaking", "Lookups by its path fail."),
    _row("moved", "a node has another path", "breaking", "Lookups by the old path fail."),
    _row("added", "a node is new", "compatible", "Nothing knew of it."),
    _row("property-added", "a struct has a new property", "breaking", "The struct is laid out differently."),
    _row("reordered", "nodes of a branch or struct are in another order", "compatible", "Lookups do not depend on the order."),
    _row("instances-removed", "`instances`: nodes went", "breaking", "As for nodes that are gone."),
    _row("instances-added", "`instances`: nodes came, none went", "compatible", "As for nodes that are new."),
    _row("instances-respelled", "`instances`: written differently, same nodes", "text", "The tree is the same."),
    _row("type-structure", "`type`: to or from branch or struct", "breaking", "It held a value, or now does."),
    _row("type-not-settable", "`type`: no longer actuator", "breaking", "It cannot be set any more."),
    _row("type", "`type`: otherwise", "risky", "It can still be read; who provides it, and when, has changed."),
    _row("datatype", "`datatype`", "breaking", "Values are encoded differently, even if all still fit."),
    _row("arraysize", "`arraysize`", "breaking", "Buffers and messages have a fixed length."),
    _row("constUID", "`constUID`", "breaking", "Lookups by identifier fail."),
    _row("unit", "`unit`: another one", "breaking", "The same number means something else."),
    _row(
        "unit-respelled", "`unit`: another key or case for the same unit", "risky",
        "Values mean the same; code that compares keys as text fails.",
    ),
    _row("unit-presence", "`unit`: added or removed", "risky", "Only people know whether the meaning changed."),
    Row(
        "range-narrowed", "`min`, `max`: less is allowed", "breaking", "compatible", "risky",
        "Values set until now are refused; a parameter may hold one; a reader gets only what it knows.",
    ),
    _row(
        "range-widened", "`min`, `max`: more is allowed", "risky",
        "Readers get values that they never got; an actuator is read too, after someone else has set it.",
    ),
    _row(
        "range-respelled", "`min`, `max`: a bound that the datatype has anyway", "text", "The values are the same.",
    ),
    Row(
        "values-limited", "`allowed`, `enum`: given where every value was allowed", "breaking", "compatible", "risky",
        "As for a range that is narrowed.",
    ),
    _row("values-unlimited", "`allowed`, `enum`: gone, every value is allowed", "risky", "As for a widened range."),
    Row(
        "values-removed", "`allowed`, `enum`: values gone", "breaking", "risky", "risky",
        "A setter is refused; a reader waits for what never comes.",
    ),
    _row("values-added", "`allowed`, `enum`: values new", "risky", "A reader gets a value that it does not know."),
    _row(
        "values-reordered", "`allowed`: same values, other order, or new ones before old ones", "risky",
        "Code generators number the values by their position.",
    ),
    _row("number-changed", "`enum`: another number for a name", "breaking", "The same number means something else."),
    _row("value-renamed", "`enum`: another name for a number", "risky", "Data stay valid; code that has the name fails."),
    _row("default", "`default`", "risky", "A system that never sets the value behaves differently."),
    _row("pattern", "`pattern`", "risky", "What was a valid text may not be one, and the other way round."),
    _row("extended", "an attribute that VSS does not define", "risky", "What it means is agreed elsewhere."),
    _row("deprecation-added", "`deprecation`: new", "compatible", "A warning; the node is still there."),
    _row("deprecation-changed", "`deprecation`: reworded or withdrawn", "text", "Only the advice is another one."),
    _row("text", "`description`, `comment`, `fka`", "text", "Only people read it."),
)  # fmt: skip
ROWS: Mapping[str, Row] = {row.rule: row for row in TABLE}


class Vocabularies(NamedTuple):
    """The units of both sides, by which a renamed unit is recognized."""

    old: Vocabulary = EMPTY
    new: Vocabulary = EMPTY

    def are_one_unit(self, old: str, new: str) -> bool:
        """Whether two keys or names mean one unit."""
        if old.lower() == new.lower():
            return True
        before, after, before_now = self.old.unit(old), self.new.unit(new), self.new.unit(old)
        if after is None:
            return False
        return after is before_now or (before is not None and before.name.lower() == after.name.lower() != "")


NO_VOCABULARIES = Vocabularies()
STRUCTURAL = frozenset(("delete", "instantiate", "instances", "instances_relation", "is_instance", "fqn"))
"""Attributes that act on which nodes there are, and show in the nodes that come and go."""


def attribute_changes(
    old: Mapping[str, Any],
    new: Mapping[str, Any],
    vocabularies: Vocabularies = NO_VOCABULARIES,
    ignored: frozenset[str] = frozenset(),
) -> tuple[AttributeChange, ...]:
    """The attributes that differ, each with its class.

    Of a signal that became a branch, or the other way round, only what both can have. Values may be of any type:
    an overlay that is only tried out has errors.
    """
    turned = _rules_of_type(_Difference(old.get("type"), new.get("type"), old, new, vocabularies)) == ["type-structure"]
    found = []
    for name in {**old, **new}:
        before, after = _value_that_says_something(old, name), _value_that_says_something(new, name)
        if name in STRUCTURAL or name in ignored or same(before, after):
            continue
        if turned and name in CORE_ATTRIBUTES and name not in COMMON_ATTRIBUTES:
            continue
        rules = _rules(name, _Difference(before, after, old, new, vocabularies))
        found.append(_worst_change(name, before, after, rules, str(old.get("type"))))
    return tuple(found)


def attribute_change(name: str, old: Any, new: Any, rule: str, node_type: str = "") -> AttributeChange:
    """A change of an attribute under a row of the table."""
    return AttributeChange(name, old, new, rule, ROWS[rule].for_type(node_type), (rule,))


class _Difference(NamedTuple):
    """A value on both sides, and what it depends on."""

    before: Any
    after: Any
    old: Mapping[str, Any]
    new: Mapping[str, Any]
    vocabularies: Vocabularies

    @property
    def is_presence(self) -> bool:
        return self.before is None or self.after is None


def _value_that_says_something(values: Mapping[str, Any], name: str) -> Any:
    """A value, or None where it says nothing: exports leave these out."""
    value = values.get(name)
    return None if value == [] or (name == "aggregate" and value is False) else value


def _rules(name: str, difference: _Difference) -> list[str]:
    """Every row of the table that the difference falls under."""
    if name in _ALWAYS:
        return [_ALWAYS[name]]
    decide = _DECISIONS.get(name)
    return decide(difference) if decide else ["extended"]


def _worst_change(name: str, before: Any, after: Any, rules: list[str], node_type: str) -> AttributeChange:
    changes = [attribute_change(name, before, after, rule, node_type) for rule in rules]
    decisive = worst(change.compatibility for change in changes)
    return next(change for change in changes if change.compatibility == decisive)._replace(rules=tuple(rules))


def _rules_of_type(difference: _Difference) -> list[str]:
    before, after = str(difference.before), str(difference.after)
    if before != after and {before, after} & {BRANCH, STRUCT, "property"}:
        return ["type-structure"]
    return ["type-not-settable" if before == "actuator" and after in SIGNALS else "type"]


def _rules_of_unit(difference: _Difference) -> list[str]:
    if difference.is_presence:
        return ["unit-presence"]
    is_one = difference.vocabularies.are_one_unit(str(difference.before), str(difference.after))
    return ["unit-respelled" if is_one else "unit"]


def _rules_of_min(difference: _Difference) -> list[str]:
    return _rules_of_bound(difference, 0, 1)


def _rules_of_max(difference: _Difference) -> list[str]:
    return _rules_of_bound(difference, 1, -1)


def _rules_of_bound(difference: _Difference, end: int, inwards: int) -> list[str]:
    before, after = _bound(difference.before, difference.old, end), _bound(difference.after, difference.new, end)
    if same(before, after):
        return ["range-respelled"]
    if before is None or after is None:
        return ["range-narrowed" if before is None else "range-widened"]
    if not (isinstance(before, int | float) and isinstance(after, int | float)):
        return ["range-narrowed", "range-widened"]
    return ["range-narrowed" if (after - before) * inwards > 0 else "range-widened"]


def _bound(value: Any, values: Mapping[str, Any], end: int) -> Any:
    """The bound that applies: the one given, or that of the datatype; None without either."""
    limits = INTEGER_RANGES.get(element_of(str(values.get("datatype"))))
    return limits[end] if value is None and limits else value


def _rules_of_allowed(difference: _Difference) -> list[str]:
    if difference.is_presence:
        return ["values-limited" if difference.before is None else "values-unlimited"]
    old, new = _keys(difference.before), _keys(difference.after)
    kept = [value for value in old if value in new]
    found = {
        "values-removed": len(kept) < len(old),
        "values-added": len(kept) < len(new),
        "values-reordered": list(new)[: len(kept)] != kept or len(kept) == len(old) == len(new),
    }
    return [rule for rule, is_so in found.items() if is_so]


def _keys(values: Any) -> dict[tuple[str, Any], None]:
    """Values to look up: true is not 1, and what cannot be hashed is compared as text."""
    return dict.fromkeys(map(_key, values if isinstance(values, list) else [values]))


def _key(value: Any) -> tuple[str, Any]:
    is_number = isinstance(value, int | float) and not isinstance(value, bool)
    return ("number", value) if is_number else (type(value).__name__, repr(value))


def _rules_of_enum(difference: _Difference) -> list[str]:
    if difference.is_presence:
        return ["values-limited" if difference.before is None else "values-unlimited"]
    before, after = difference.before, difference.after
    if not (isinstance(before, dict) and isinstance(after, dict)):
        return ["number-changed"]
    gone = _keys([number for name, number in before.items() if name not in after]).keys()
    new = _keys([number for name, number in after.items() if name not in before]).keys()
    found = {
        "number-changed": any(name in after and not same(after[name], number) for name, number in before.items()),
        "values-removed": gone - new,
        "values-added": new - gone,
        "value-renamed": gone & new,
    }
    return [rule for rule, is_so in found.items() if is_so]


def _rules_of_deprecation(difference: _Difference) -> list[str]:
    return ["deprecation-added" if difference.before is None else "deprecation-changed"]


_DECISIONS: Mapping[str, Callable[[_Difference], list[str]]] = {
    "type": _rules_of_type,
    "unit": _rules_of_unit,
    "min": _rules_of_min,
    "max": _rules_of_max,
    "allowed": _rules_of_allowed,
    "enum": _rules_of_enum,
    "deprecation": _rules_of_deprecation,
}
_ALWAYS: Mapping[str, str] = {
    "datatype": "datatype", "arraysize": "arraysize", "constUID": "constUID", "default": "default",
    "pattern": "pattern", "description": "text", "comment": "text", "fka": "text",
}  # fmt: skip
