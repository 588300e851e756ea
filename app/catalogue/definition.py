"""A node's definition: the statements of all layers folded into one, normalized and checked.

The checks are those that decide whether vss-tools would take the node; style is the linter's matter. A definition
with problems is kept, so that everything wrong with a tree can be told at once.
"""

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, NamedTuple

from app.catalogue.datatypes import DATATYPES, belongs_to, element_of, holds, is_array
from app.catalogue.patterns import Matching
from app.catalogue.vocabulary import Vocabulary
from app.catalogue.vspec_file import Origin, Statement
from app.findings import Finding, Severity
from app.names import did_you_mean, last_name, parent_path, screaming_snake_case

BRANCH = "branch"
STRUCT = "struct"
SIGNALS = ("sensor", "actuator", "attribute")
TYPES = (BRANCH, *SIGNALS, STRUCT, "property")

COMMON_ATTRIBUTES = frozenset(
    ("type", "description", "comment", "delete", "deprecation", "constUID", "fka", "instantiate")
)
BRANCH_ATTRIBUTES = COMMON_ATTRIBUTES | {"instances", "instances_relation", "aggregate", "is_instance"}
DATA_ATTRIBUTES = COMMON_ATTRIBUTES | {
    "datatype", "arraysize", "min", "max", "pattern", "unit", "enum", "allowed", "default"
}  # fmt: skip
CORE_ATTRIBUTES = BRANCH_ATTRIBUTES | DATA_ATTRIBUTES
_EPSILON = 1e-6
_INTO_RANGE = "Change the default, or the range."
_QUOTE = "Quote it: YAML reads words such as ON, OFF, YES and NO as true and false."


class Problem(NamedTuple):
    """What is wrong with a definition, and at which attribute (empty: the node itself)."""

    rule: str
    attribute: str
    message: str
    fix: str = ""
    severity: Severity = "error"
    within: tuple[int, ...] = ()
    """Steps from the attribute to the item that the problem is about; of a mapping, to its key."""


class Scope(NamedTuple):
    """What definitions refer to: units, and struct datatypes with their definitions; and the time for their patterns."""

    vocabulary: Vocabulary
    matching: Matching
    structs: Mapping[str, "Mapping[str, Definition]"] = {}
    """Properties by name, for each struct by path."""


class Definition:
    """What all layers together say of one node. Frozen; shared by every instance of the node."""

    __slots__ = ("is_instance", "path", "problems", "statements", "values")

    def __init__(
        self,
        path: str,
        statements: tuple[Statement, ...],
        values: Mapping[str, Any],
        problems: tuple[Problem, ...] = (),
        is_instance: bool = False,
    ) -> None:
        self.path = path
        self.statements = statements
        self.values = values
        self.problems = problems
        self.is_instance = is_instance

    def __repr__(self) -> str:
        return f"<Definition {self.path}: {self.type}>"

    @property
    def type(self) -> str:
        """Node type: branch, sensor, actuator, attribute, struct or property; empty if undefined."""
        value = self.values.get("type")
        return value if isinstance(value, str) else ""

    def origin(self, attribute: str = "") -> Origin:
        """Where the value of an attribute was written last; without one, where the node was first."""
        if attribute:
            for statement in reversed(self.statements):
                if attribute in statement.values:
                    return statement.origin(attribute)
        return self.statements[0].origin() if self.statements else Origin("", 0, 0)

    def origin_within(self, attribute: str, steps: Sequence[int | str], *, at_key: bool = False) -> Origin:
        """Where an item of a list or mapping was written last; where the attribute was, if that is not known."""
        if steps:
            for statement in reversed(self.statements):
                place = statement.origin_within(attribute, steps, at_key=at_key)
                if place is not None:
                    return place
        return self.origin(attribute)

    def history(self, attribute: str) -> tuple[tuple[Any, Origin], ...]:
        """Every value that the layers gave an attribute, first to last, with its origin."""
        return tuple(
            (statement.values[attribute], statement.origin(attribute))
            for statement in self.statements
            if attribute in statement.values
        )

    @property
    def extended(self) -> dict[str, Any]:
        """Attributes that VSS does not define, such as `ASILlevel`."""
        return {name: value for name, value in self.values.items() if name not in CORE_ATTRIBUTES}

    def finding(self, problem: Problem, path: str = "") -> Finding:
        """A problem as a finding at the place where it was written."""
        place = self.origin_within(problem.attribute, problem.within, at_key=True)[:3]
        return Finding(problem.rule, problem.severity, problem.message, *place, path or self.path, fix=problem.fix)


def define(path: str, statements: tuple[Statement, ...], scope: Scope) -> Definition:
    """Fold statements, first to last, into a checked definition."""
    values = statements[0].values
    for statement in statements[1:]:
        values = overlaid(values, statement.values)
    return checked(path, statements, values, scope)


def checked(
    path: str,
    statements: tuple[Statement, ...],
    values: Mapping[str, Any],
    scope: Scope,
    is_instance: bool = False,
) -> Definition:
    """A definition of normalized values and all problems of them."""
    problems: list[Problem] = []
    values = _normalized(path, values, scope, problems)
    node_type = values.get("type")
    if node_type not in TYPES:
        problems.append(_wrong_type(node_type))
    elif node_type == BRANCH:
        _check_branch(values, problems)
    elif node_type != STRUCT:
        _check_data(path, values, scope, problems)
    if node_type in TYPES:
        _check_core_attributes(values, problems)
    return Definition(path, statements, values, tuple(problems), is_instance)


def overlaid(base: Mapping[str, Any], update: Mapping[str, Any]) -> dict[str, Any]:
    """`base` with the values of `update`; mappings inside are merged, everything else is replaced."""
    merged = dict(base)
    for name, value in update.items():
        before = merged.get(name)
        merged[name] = overlaid(before, value) if isinstance(value, dict) and isinstance(before, dict) else value
    return merged


def instances_of(values: Mapping[str, Any]) -> list[Any]:
    """The instances of a branch as a list, whatever form they were written in."""
    instances = values.get("instances")
    if instances is None:
        return []
    return [instances] if isinstance(instances, str) else list(instances) if isinstance(instances, list) else []


def labels_of(values: Mapping[str, Any]) -> Iterator[tuple[tuple[int, ...], Any]]:
    """Every label of the instances, ranges unexpanded, with the steps that lead to it."""
    is_list = isinstance(values.get("instances"), list)
    for i, entry in enumerate(instances_of(values)):
        if isinstance(entry, list):
            yield from (((i, j), item) for j, item in enumerate(entry))
        else:
            yield (i,) if is_list else (), entry


def resolved_datatype(datatype: str, path: str, structs: Mapping[str, Any]) -> str | None:
    """The datatype with a struct's name made a full path, or None if there is no such datatype."""
    if datatype in DATATYPES:
        return datatype
    name, suffix = (element_of(datatype), "[]") if is_array(datatype) else (datatype, "")
    near = {last_name(s): s for s in structs if not path.startswith(s) and path.startswith(parent_path(s))}
    full = near.get(name, name if name in structs else None)
    return full + suffix if full else None


# -- normalization ------------------------------------------------------------------------------------------------


def _normalized(path: str, values: Mapping[str, Any], scope: Scope, problems: list[Problem]) -> Mapping[str, Any]:
    """The values as vss-tools holds them: units by canonical key, datatypes by full path, numbers as numbers."""
    changed: dict[str, Any] = {}
    for name, value in values.items():
        convert = _CONVERSIONS.get(name)
        if convert is None or value is None or (convert is _text and type(value) is str):
            continue
        converted = convert(value)
        if converted is _NO_VALUE:
            problems.append(Problem("V004", name, f"{_shown(value)} is no value for `{name}`: {_EXPECTED[name]}."))
        elif converted is not value:
            changed[name] = converted
    unit = values.get("unit")
    if isinstance(unit, str):
        known = scope.vocabulary.units.get(unit.lower())
        if known is not None and known.key != unit:
            changed["unit"] = known.key
    datatype = values.get("datatype")
    if isinstance(datatype, str) and datatype not in DATATYPES:
        resolved = resolved_datatype(datatype, path, scope.structs)
        if resolved is not None and resolved != datatype:
            changed["datatype"] = resolved
    return {**values, **changed} if changed else values


_NO_VALUE: Any = object()


def _text(value: Any) -> Any:
    return value if isinstance(value, str) else _NO_VALUE


def _flag(value: Any) -> Any:
    if isinstance(value, bool):
        return value
    known = {"true": True, "yes": True, "on": True, "1": True, "false": False, "no": False, "off": False, "0": False}
    return known.get(str(value).lower(), _NO_VALUE)


def _number(value: Any) -> Any:
    if isinstance(value, bool):
        return int(value)
    if isinstance(value, int | float):
        return value
    if isinstance(value, str):
        for convert in (int, float):
            try:
                return convert(value)
            except ValueError:
                continue
    return _NO_VALUE


def _whole(value: Any) -> Any:
    number = _number(value)
    return int(number) if number is not _NO_VALUE and number == number // 1 else _NO_VALUE


def _texts(value: Any) -> Any:
    return value if isinstance(value, list) and all(isinstance(item, str) for item in value) else _NO_VALUE


def _scalars(value: Any) -> Any:
    is_list = isinstance(value, list) and all(isinstance(item, str | int | float) for item in value)
    return value if is_list else _NO_VALUE


def _numbered(value: Any) -> Any:
    if not isinstance(value, dict):
        return _NO_VALUE
    numbers = {key: _whole(item) for key, item in value.items()}
    return _NO_VALUE if _NO_VALUE in numbers.values() else value if numbers == value else numbers


def _instances(value: Any) -> Any:
    return value if isinstance(value, str | list) else _NO_VALUE


def _relation(value: Any) -> Any:
    return value if value in ("child", "sibling") else _NO_VALUE


_CONVERSIONS: Mapping[str, Callable[[Any], Any]] = {
    "description": _text, "comment": _text, "deprecation": _text, "constUID": _text, "pattern": _text,
    "unit": _text, "datatype": _text, "delete": _flag, "instantiate": _flag, "aggregate": _flag,
    "is_instance": _flag, "fka": _texts, "arraysize": _whole, "min": _number, "max": _number,
    "allowed": _scalars, "enum": _numbered, "instances": _instances, "instances_relation": _relation,
}  # fmt: skip
_EXPECTED: Mapping[str, str] = {
    "description": "a text belongs here", "comment": "a text belongs here", "deprecation": "a text belongs here",
    "constUID": "a text such as '0x0123ABCD' belongs here", "pattern": "a regular expression belongs here",
    "unit": "the key of a unit belongs here", "datatype": "the name of a datatype belongs here",
    "delete": "true or false belongs here", "instantiate": "true or false belongs here",
    "aggregate": "true or false belongs here", "is_instance": "true or false belongs here",
    "fka": "a list of former paths belongs here", "arraysize": "a whole number belongs here",
    "min": "a number belongs here", "max": "a number belongs here", "allowed": "a list of values belongs here",
    "enum": "a mapping of names to whole numbers belongs here", "instances": "a text or a list belongs here",
    "instances_relation": "'child' or 'sibling' belongs here",
}  # fmt: skip


# -- checks -------------------------------------------------------------------------------------------------------


def _wrong_type(node_type: Any) -> Problem:
    if node_type is None:
        return Problem("V001", "", "The node has no `type`.", f"Add one of {', '.join(TYPES)}.")
    fix = did_you_mean(str(node_type), TYPES) or f"Use one of {', '.join(TYPES)}."
    return Problem("V001", "type", f"{_shown(node_type)} is no node type.", fix)


def _check_branch(values: Mapping[str, Any], problems: list[Problem]) -> None:
    for steps, entry in labels_of(values):
        match = re.search(r"\[(\d+),(\d+)\](?!.*\[\d+,\d+\])", str(entry))
        if match and int(match[1]) > int(match[2]):
            message = f"Range {match[0]} of {entry!r} runs backwards."
            fix = f"Write [{match[2]},{match[1]}]."
            problems.append(Problem("V018", "instances", message, fix, within=steps))


def _check_core_attributes(values: Mapping[str, Any], problems: list[Problem]) -> None:
    node_type = values["type"]
    own = BRANCH_ATTRIBUTES if node_type == BRANCH else COMMON_ATTRIBUTES if node_type == STRUCT else DATA_ATTRIBUTES
    if not own.issuperset(values):
        for name in values:
            if name in CORE_ATTRIBUTES and name not in own:
                message = f"`{name}` has no meaning for the node type {node_type}."
                problems.append(Problem("V005", name, message, "Remove it."))
    uid = values.get("constUID")
    if isinstance(uid, str) and not re.fullmatch(r"0x[0-9A-Fa-f]{8}\n?", uid):
        problems.append(Problem("V017", "constUID", f"{uid!r} is not 0x and eight hexadecimal digits."))


def _check_data(path: str, values: Mapping[str, Any], scope: Scope, problems: list[Problem]) -> None:
    unusable = {problem.attribute for problem in problems if problem.rule == "V004"}
    if "datatype" in unusable:
        return
    values = {name: value for name, value in values.items() if name not in unusable} if unusable else values
    datatype = values.get("datatype")
    if not isinstance(datatype, str):
        problems.append(Problem("V002", "", "The node has no `datatype`.", "Add one, such as uint8, float or string."))
        return
    resolved = resolved_datatype(datatype, path, scope.structs)
    if resolved is None:
        fix = did_you_mean(datatype, (*sorted(DATATYPES), *scope.structs))
        problems.append(Problem("V003", "datatype", f"{datatype!r} is no datatype.", fix))
        return
    for attributes, check in _DATA_CHECKS:
        if not attributes.isdisjoint(values):
            problems.extend(check(values, resolved, scope))


def _unit_problems(values: Mapping[str, Any], datatype: str, scope: Scope) -> Iterator[Problem]:
    name = values.get("unit")
    if name is None:
        return
    unit = scope.vocabulary.unit(name)
    if unit is None:
        known = dict.fromkeys(unit.key for unit in scope.vocabulary.distinct_units)
        yield Problem("V006", "unit", f"{name!r} is no unit.", did_you_mean(name, known))
    elif datatype not in DATATYPES:
        yield Problem("V007", "unit", f"A struct such as {datatype} has no unit.", "Remove it.")
    elif not any(belongs_to(element_of(datatype), allowed) for allowed in unit.allowed_datatypes):
        allowed = ", ".join(unit.allowed_datatypes)
        message = f"Unit {unit.key!r} is not for {datatype}; it allows {allowed or 'none'}."
        fix = (
            "Change one of the two." if allowed else f"Give {unit.key!r} its `allowed-datatypes`, in the file of units."
        )
        yield Problem("V007", "unit", message, fix)


def _conflicts(values: Mapping[str, Any], datatype: str, scope: Scope) -> Iterator[Problem]:
    bounded = values.get("min") is not None or values.get("max") is not None
    if values.get("allowed") and values.get("enum"):
        yield Problem("V013", "enum", "`allowed` and `enum` exclude each other.", "Keep one of them.")
    if bounded and values.get("allowed") is not None:
        yield Problem("V013", "allowed", "`allowed` and `min`/`max` exclude each other.", "Keep one of them.")
    if bounded and values.get("enum") is not None:
        yield Problem("V013", "enum", "`enum` and `min`/`max` exclude each other.", "Keep one of them.")
    if values.get("arraysize") is not None and not is_array(datatype):
        yield Problem(
            "V015", "arraysize", f"`arraysize` is for arrays; {datatype} is none.", f"Remove it, or write {datatype}[]."
        )


def _range_problems(values: Mapping[str, Any], datatype: str, scope: Scope) -> Iterator[Problem]:
    for name in ("min", "max"):
        bound = values.get(name)
        if bound is None:
            continue
        if datatype not in DATATYPES:
            yield Problem("V008", name, f"A struct such as {datatype} has no `{name}`.", "Remove it.")
        elif not holds(datatype, bound):
            yield Problem(
                "V008", name, f"`{name}` {bound} is no value of {datatype}.", "Change the limit, or the datatype."
            )


def _enum_problems(values: Mapping[str, Any], datatype: str, scope: Scope) -> Iterator[Problem]:
    enum = values.get("enum")
    if not enum:
        return
    if datatype not in DATATYPES or not belongs_to(element_of(datatype), "int"):
        yield Problem("V014", "enum", f"`enum` needs an integer datatype, not {datatype}.", "Use one such as uint8.")
        return
    if len(set(enum.values())) < len(enum):
        yield Problem("V014", "enum", "Two names of the `enum` have the same number.", "Give each its own.")
    for i, (key, number) in enumerate(enum.items()):
        if not isinstance(key, str):
            fix = _QUOTE if isinstance(key, bool) else "Quote it."
            yield Problem("V014", "enum", f"Name {key!r} of the `enum` is no text.", fix, within=(i,))
        elif not re.match(r"[A-Z]", key):
            message = f"Name {key!r} of the `enum` does not start with a capital letter."
            proposal = screaming_snake_case(key)
            fix = f"Write {proposal!r}." if re.match(r"[A-Z]", proposal) else "Start it with a capital letter."
            yield Problem("V014", "enum", message, fix, within=(i,))
        if not holds(element_of(datatype), number):
            message = f"Number {number} of the `enum` is no value of {datatype}."
            yield Problem("V014", "enum", message, within=(i,))


def _allowed_problems(values: Mapping[str, Any], datatype: str, scope: Scope) -> Iterator[Problem]:
    allowed = values.get("allowed")
    if not allowed:
        return
    if datatype not in DATATYPES:
        yield Problem("V012", "allowed", f"A struct such as {datatype} has no `allowed` values.", "Remove them.")
        return
    for i, value in enumerate(allowed):
        if not holds(datatype, value):
            fix = _QUOTE if isinstance(value, bool) else ""
            message = f"Allowed value {_shown(value)} is no value of {datatype}."
            yield Problem("V012", "allowed", message, fix, within=(i,))


def _default_problems(values: Mapping[str, Any], datatype: str, scope: Scope) -> Iterator[Problem]:
    default = values.get("default")
    if default is None:
        return
    if isinstance(default, list) != is_array(datatype):
        needed = "a list" if is_array(datatype) else "a single value"
        yield Problem("V009", "default", f"Default {_shown(default)} does not fit {datatype}, which takes {needed}.")
        return
    size = values.get("arraysize")
    if is_array(datatype) and size and len(default) != size:
        yield Problem("V009", "default", f"The default has {len(default)} elements, `arraysize` says {size}.")
    items = default if isinstance(default, list) else [default]
    wrong = next((item for item in items if not _fits(item, datatype, scope)), None)
    if wrong is not None:
        yield Problem(
            "V009", "default", f"Default {_shown(wrong)} is no value of {datatype}.", _number_of(wrong, values)
        )
        return
    yield from _default_bounds(values, items)


def _default_bounds(values: Mapping[str, Any], items: list[Any]) -> Iterator[Problem]:
    low, high = values.get("min"), values.get("max")
    allowed, enum = values.get("allowed"), values.get("enum")
    for item in items:
        if isinstance(item, int | float):
            if low is not None and item < low - _EPSILON:
                yield Problem("V010", "default", f"Default {item} is below `min` {low}.", _INTO_RANGE)
            if high is not None and item > high + _EPSILON:
                yield Problem("V010", "default", f"Default {item} is above `max` {high}.", _INTO_RANGE)
        if values["default"] and allowed and item not in allowed:
            fix = did_you_mean(str(item), [str(value) for value in allowed]) or f"Use one of {_shown(allowed)[1:-1]}."
            yield Problem("V011", "default", f"Default {_shown(item)} is not among the `allowed` values.", fix)
        if values["default"] and enum and item not in enum.values():
            yield Problem(
                "V011", "default", f"Default {_shown(item)} is no number of the `enum`.", _number_of(item, values)
            )


def _number_of(default: Any, values: Mapping[str, Any]) -> str:
    """What to write in place of a default that is a name of the enumeration, or none of its numbers."""
    enum = values.get("enum")
    if not isinstance(enum, Mapping) or not enum:
        return ""
    return (
        f"Write the number, {enum[default]}."
        if default in enum
        else f"Use one of {_shown(list(dict.fromkeys(enum.values())))[1:-1]}."
    )


def _fits(value: Any, datatype: str, scope: Scope) -> bool:
    """Whether a default fits its datatype; of a struct, whether it has every property with a fitting value."""
    if datatype in DATATYPES:
        return holds(datatype, value)
    properties = scope.structs.get(element_of(datatype), {})
    items = value if isinstance(value, list) else [value]
    return all(
        isinstance(item, dict) and all(name in item and _json_fits(item[name], d, scope) for name, d in properties.items())
        for item in items
    )  # fmt: skip


def _json_fits(value: Any, definition: Definition, scope: Scope) -> bool:
    datatype = str(definition.values.get("datatype", ""))
    items = value if isinstance(value, list) else [value]
    if is_array(datatype) and not isinstance(value, list):
        return False
    name = element_of(datatype)
    if name not in DATATYPES:
        return _fits(items, name, scope)
    expected: Any = bool if name == "boolean" else str if name == "string" else int | float
    return all(isinstance(item, expected) and (name == "boolean" or not isinstance(item, bool)) for item in items)


def _pattern_problems(values: Mapping[str, Any], datatype: str, scope: Scope) -> Iterator[Problem]:
    pattern = values.get("pattern")
    if not pattern:
        return
    if datatype not in ("string", "string[]"):
        yield Problem("V016", "pattern", f"`pattern` is for strings, not for {datatype}.", "Remove it.")
        return
    if values.get("enum") is not None:
        yield Problem("V016", "pattern", "`pattern` and `enum` exclude each other.", "Keep one of them.")
    for name in ("default", "allowed"):
        given = values.get(name)
        for item in given if isinstance(given, list) else [given] if given else []:
            reason = scope.matching.mismatch(pattern, item) if isinstance(item, str) else ""
            if reason:
                yield Problem("V016", name, f"{_shown(item)} {reason} `pattern` {pattern!r}.", "Change one of the two.")


_DATA_CHECKS = (
    (frozenset(("unit",)), _unit_problems),
    (frozenset(("min", "max", "allowed", "enum", "arraysize")), _conflicts),
    (frozenset(("min", "max")), _range_problems),
    (frozenset(("enum",)), _enum_problems),
    (frozenset(("allowed",)), _allowed_problems),
    (frozenset(("default",)), _default_problems),
    (frozenset(("pattern",)), _pattern_problems),
)
"""Each check, and the attributes without which it has nothing to say."""


def _shown(value: Any) -> str:
    text = repr(value)
    return text if len(text) <= 60 else f"{text[:57]}..."
