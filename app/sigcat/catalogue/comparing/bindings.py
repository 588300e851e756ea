"""Bindings: the forms in which consumers find and decode signals, and the class of a change for each of them.

Two things can break a consumer. The meaning of values is the same in every binding: its classes are in
`compatibility.py`. The form depends on the binding: a path, a field number, a message hash. Its classes are here.
"""

from collections.abc import Collection, Iterable, Mapping, Sequence
from typing import Literal, NamedTuple, get_args

from sigcat.catalogue.comparing.changes import ORDER, AttributeChange, Change, Class, worst
from sigcat.catalogue.comparing.compatibility import ROWS

Binding = Literal["path", "json", "protobuf", "ros2", "someip", "c", "graphql", "dds", "ids"]
BINDINGS: tuple[Binding, ...] = get_args(Binding)
TITLES: Mapping[Binding, str] = {
    "path": "lookup by path, as in VISS and KUKSA",
    "json": "exported JSON",
    "protobuf": "Protocol Buffers (`sigcat export protobuf`)",
    "ros2": "ROS 2 messages (`sigcat export ros2interface`)",
    "someip": "SOME/IP events and fields of AUTOSAR adaptive",
    "c": "C adapter of a function that uses the signal",
    "graphql": "GraphQL schema (`sigcat export s2dm`)",
    "dds": "DDS IDL (`sigcat export ddsidl`)",
    "ids": "static ids (`sigcat export id`)",
}


class Effect(NamedTuple):
    """A row of the table of bindings: the class of a rule, or of a further effect of a change, for each binding."""

    rule: str
    what: str
    """Empty for a rule of the table of classes."""
    cells: Mapping[Binding, Class]
    """A binding that is absent has the class of the rule in the table of classes."""
    why: str
    attributes: frozenset[str] = frozenset()
    """Attributes whose changes have the effect; empty: the change as a whole has it."""


def _cells(others: Class | None, **classes: str) -> Mapping[Binding, Class]:
    """Return a class by binding. `breaking="ros2 c"` names the bindings of a class; `others` is that of the rest."""
    named = {binding: name for name, bindings in classes.items() for binding in bindings.split()}
    given = {binding: named.get(binding, others) for binding in BINDINGS}
    return {binding: compatibility for binding, compatibility in given.items() if compatibility}  # type: ignore[misc]


_RETYPED = frozenset(("datatype", "arraysize", "allowed"))
_HASHED = frozenset(("unit", "datatype", "type", "allowed", "min", "max", "fka", "constUID"))

EFFECTS: tuple[Effect, ...] = (
    Effect("removed", "", _cells("breaking"), "Nothing is generated for it any more."),
    Effect("moved", "", _cells("breaking", compatible="ids"), "Names of generated types and fields come from the path."),
    Effect("added", "", _cells("compatible"), "What is generated for other nodes stays the same, except as below."),
    Effect(
        "property-added", "", _cells("breaking", risky="path", compatible="json protobuf graphql ids"),
        "A struct is sent as a whole. Readers of named and numbered members skip unknown ones.",
    ),
    Effect("instances-removed", "", _cells("breaking"), "As for nodes that are gone."),
    Effect("instances-added", "", _cells("compatible"), "As for nodes that are new."),
    Effect("instances-respelled", "", _cells("text", risky="graphql"), "A schema has an enumeration for each dimension."),
    Effect("type-structure", "", _cells("breaking"), "A branch and a signal are generated differently."),
    Effect(
        "datatype", "", _cells("risky", breaking="path json"),
        "Some datatypes share a type of the binding. A value may not fit any more.",
    ),
    Effect("arraysize", "", _cells("compatible", risky="path"), "Most bindings have no length."),
    Effect("constUID", "", _cells("compatible", breaking="json"), "Only lookups by identifier use it."),
    Effect("values-removed", "", _cells(None, breaking="graphql"), "Each allowed value is a value of an enumeration."),
    Effect(
        "values-reordered", "", _cells("compatible"), "The order has an effect only where values are numbered.",
    ),
    Effect(
        "fields-renumbered", "nodes of a branch or struct are in another order", _cells("compatible", breaking="protobuf"),
        "Fields are numbered by position.", frozenset((ORDER,)),
    ),
    Effect(
        "added-before", "the new node is before nodes that the branch had", _cells("compatible", breaking="protobuf"),
        "The numbers of the fields after it change.",
    ),
    Effect(
        "position-unknown", "the position of the new node is not known", _cells("compatible", risky="protobuf"),
        "An exported JSON has no order. Compare the trees themselves.",
    ),
    Effect(
        "added-beside", "the new signal is in a branch that had signals", _cells("compatible", breaking="ros2"),
        "The message of the branch has another field, so another hash.",
    ),
    Effect(
        "properties-reordered", "properties of a struct are in another order",
        _cells("compatible", breaking="ros2 someip c dds"), "Members are sent in their order.",
    ),
    Effect(
        "name-shared", "a new branch has the name of another one", _cells("compatible", risky="graphql"),
        "Types have short names; the exporter may rename the other type.",
    ),
    Effect(
        "retyped-protobuf", "another type in Protocol Buffers", _cells("compatible", breaking="protobuf"),
        "Integers of at most 32 bits read each other, as do those of 64 bits. Texts with `allowed` are an enumeration.", _RETYPED,
    ),
    Effect(
        "retyped-ros2", "another type in ROS 2", _cells("compatible", breaking="ros2"),
        "Each datatype has its own type; `arraysize` makes a fixed array. The type is in the hash of the message.", _RETYPED,
    ),
    Effect(
        "retyped-member", "another type in C", _cells("compatible", breaking="someip c"),
        "Each datatype and length has its own type. Texts with `allowed` are numbers.", _RETYPED,
    ),
    Effect(
        "retyped-graphql", "another type in GraphQL", _cells("compatible", breaking="graphql"),
        "`float` and `double` are one type. Signals with `allowed` have an enumeration.", _RETYPED,
    ),
    Effect(
        "retyped-dds", "another type in DDS IDL", _cells("compatible", breaking="dds"),
        "`uint8` and `int8` are one type. Texts with `allowed` are an enumeration.", _RETYPED,
    ),
    Effect(
        "label-removed", "`allowed`: a text is gone", _cells("compatible", breaking="dds"),
        "The value of the enumeration is gone.", frozenset(("allowed",)),
    ),
    Effect(
        "label-renumbered", "`allowed`: a text has another position", _cells("compatible", breaking="someip c dds"),
        "Texts are numbered by position.", frozenset(("allowed",)),
    ),
    Effect(
        "enumeration-renumbered", "`allowed`: a text is gone, or has another position",
        _cells("compatible", breaking="protobuf"), "The values of the enumeration are numbered by position.",
        frozenset(("allowed",)),
    ),
    Effect(
        "unit-dropped", "`unit`: no longer given", _cells("compatible", breaking="graphql"),
        "The field has no argument `unit` any more.", frozenset(("unit",)),
    ),
    Effect(
        "unit-quantity", "`unit`: one of another quantity", _cells("compatible", breaking="graphql"),
        "The argument `unit` has another type.", frozenset(("unit",)),
    ),
    Effect(
        "id-changed", "the static id is another one", _cells("compatible", breaking="ids"),
        "The id is a hash of path, unit, datatype, type, allowed values and range.", _HASHED,
    ),
)  # fmt: skip
BY_RULE: Mapping[str, Effect] = {effect.rule: effect for effect in EFFECTS}


_STRUCTURAL: Mapping[tuple[str, str], str] = {("added", "property"): "property-added"}
"""Rules of whole nodes that do not have the name of their kind."""


class BindingClass(NamedTuple):
    """The class of a change for consumers by one binding."""

    binding: Binding
    compatibility: Class
    rule: str
    """Row that decided, of the table of bindings or else of the table of classes."""


_Verdict = tuple[Class, str]


def chosen(names: Collection[str]) -> Sequence[Binding]:
    """Return the bindings with these names."""
    return [binding for binding in BINDINGS if binding in names]


def classes_of(change: Change) -> tuple[BindingClass, ...]:
    """Return the class of a change for each binding."""
    return tuple(BindingClass(binding, *_verdict(change, (binding,))) for binding in BINDINGS)


def for_bindings(changes: Iterable[Change], bindings: Collection[Binding]) -> Sequence[Change]:
    """Return the changes with their classes for consumers by these bindings; without bindings, as they are."""
    return [_for(change, bindings) if bindings else change for change in changes]


def form_of(change: Change, binding: Binding) -> Class:
    """Return the class of the form alone: whether signals are found and decoded, whatever their values mean."""
    rules = (*_own_rules(change), *(rule for each in change.attributes for rule in each.rules), *change.effects)
    return worst(BY_RULE[rule].cells[binding] for rule in rules if rule in BY_RULE and binding in BY_RULE[rule].cells)


def reason(rule: str) -> str:
    """Return the sentence of a row."""
    return ROWS[rule].why if rule in ROWS else BY_RULE[rule].why


def _for(change: Change, bindings: Collection[Binding]) -> Change:
    compatibility, rule = _verdict(change, bindings)
    attributes = tuple(_attribute_for(each, change, bindings) for each in change.attributes)
    return change._replace(compatibility=compatibility, rule=rule, attributes=attributes)


def _attribute_for(attribute: AttributeChange, change: Change, bindings: Collection[Binding]) -> AttributeChange:
    compatibility, rule = _decisive(_of_attribute(attribute, change, bindings))
    return attribute._replace(compatibility=compatibility, rule=rule)


def _verdict(change: Change, bindings: Collection[Binding]) -> _Verdict:
    """Return the worst class, and the row that decided it."""
    names = {attribute.name for attribute in change.attributes}
    whole = [effect for effect in change.effects if not BY_RULE[effect].attributes & names]
    verdicts = [_cell(rule, change.type, binding) for rule in (*_own_rules(change), *whole) for binding in bindings]
    for attribute in change.attributes:
        verdicts += _of_attribute(attribute, change, bindings)
    return _decisive(verdicts)


def _of_attribute(attribute: AttributeChange, change: Change, bindings: Collection[Binding]) -> list[_Verdict]:
    effects = [effect for effect in change.effects if attribute.name in BY_RULE[effect].attributes]
    return [_cell(rule, change.type, binding) for rule in (*attribute.rules, *effects) for binding in bindings]


def _own_rules(change: Change) -> tuple[str, ...]:
    """The rule of a node that was added, removed or moved; a changed node has those of its attributes."""
    return () if change.kind == "changed" else (_STRUCTURAL.get((change.kind, change.type), change.kind),)


def _cell(rule: str, node_type: str, binding: Binding) -> _Verdict:
    effect = BY_RULE.get(rule)
    if effect and binding in effect.cells:
        return effect.cells[binding], rule
    return ROWS[rule].for_type(node_type), rule


def _decisive(verdicts: Sequence[_Verdict]) -> _Verdict:
    compatibility = worst(each for each, _ in verdicts)
    return next((verdict for verdict in verdicts if verdict[0] == compatibility), (compatibility, ""))
