"""Checks: named functions that a rule's options turn into a test of a node, of the tree or of a text."""

from collections.abc import Callable, Collection, Iterable, Mapping
from math import isfinite
from typing import Any, Literal, NamedTuple

from sigcat.catalogue.model.definition import Definition
from sigcat.findings import shown
from sigcat.names import did_you_mean, either
from sigcat.rules.problem import LineProblem, Problem
from sigcat.rules.record import Rule
from sigcat.rules.tree import Tree


class BadOption(Exception):
    """The options of a rule are not those of its check."""

    def __init__(self, message: str, fix: str = "", option: str = "") -> None:
        super().__init__(message)
        self.fix = fix
        self.option = option
        """Name of the option, where it is there."""


NodeTest = Callable[[Definition], Iterable[Problem]]
TreeTest = Callable[[], Iterable[Problem]]
LineTest = Callable[[str], Iterable[LineProblem]]


class Kind(NamedTuple):
    """The type of an option's value."""

    name: str
    """As the reference calls it."""
    check: Callable[[str, Any], None]
    """Given what the option is called, and its value: raises BadOption if it is of another kind."""


def _kind(name: str, expected: str, fits: Callable[[Any], bool]) -> Kind:
    def check(option: str, value: Any) -> None:
        if not fits(value):
            raise BadOption(f"{option} must be {expected}, not {shown(value)}.")

    return Kind(name, check)


def one_of(values: Collection[str], *, is_list: bool = False) -> Kind:
    """One of these texts, or a list of such."""

    def check(option: str, value: Any) -> None:
        (TEXTS if is_list else TEXT).check(option, value)
        if not value:
            raise BadOption(f"{option} must be {either(values)}, not {shown(value)}.")
        for item in value if is_list else [value]:
            if item not in values:
                fix = did_you_mean(item, values)
                raise BadOption(f"{option} must be {either(values)}, not {shown(item)}.", fix)

    return Kind(f"{'list of ' if is_list else ''}{', '.join(f'`{value}`' for value in values)}", check)


def _is_text(value: Any) -> bool:
    return isinstance(value, str)


def _is_name(value: Any) -> bool:
    return isinstance(value, str) and bool(value.strip())


def _is_list_of(fits: Callable[[Any], bool]) -> Callable[[Any], bool]:
    return lambda value: isinstance(value, list) and all(map(fits, value))


_HIGHEST_COUNT = 1_000_000


def _is_attribute(value: Any) -> bool:
    return _is_name(value) and not set(value) & set(".|")


TEXT = _kind("text", "a text", _is_text)
NAME = _kind("name", "a name", _is_name)
ATTRIBUTE = _kind("attribute", "the name of an attribute, none within it", _is_attribute)
COUNT = _kind(
    "whole number",
    f"a whole number from 0 to {_HIGHEST_COUNT:,}",
    lambda value: isinstance(value, int) and not isinstance(value, bool) and 0 <= value <= _HIGHEST_COUNT,
)
TEXTS = _kind("list of texts", "a list of texts", _is_list_of(_is_text))
NAMES = _kind("list of names", "a list of names", _is_list_of(_is_name))
ATTRIBUTES = _kind("list of attributes", "a list of names of attributes, none within them", _is_list_of(_is_attribute))
VALUES = _kind(
    "list of values",
    "a list of texts, numbers or booleans",
    _is_list_of(lambda value: isinstance(value, str | int | float)),
)

Options = Mapping[str, Kind]
"""The options of a check by name, each with its kind."""


class NodeCheck(NamedTuple):
    """A check of one node at a time. `needs` names the option with the attribute without which there is nothing to check."""

    prepare: Callable[[Rule, Tree], NodeTest]
    options: Options
    required: tuple[str, ...] = ()
    needs: str = ""
    of_overlays: bool = False
    """Whether it looks at what overlays do: there is nothing for it in a tree without any."""
    needs_whole_tree: bool = False
    """Whether a part of a tree alone shows nothing: another part may have the node."""
    of_stacks: bool = False
    """Whether it is about overlays that are declared to apply together: of alternatives it would say what is not so."""


class TreeCheck(NamedTuple):
    """A check of the tree as a whole."""

    prepare: Callable[[Rule, Tree], TreeTest]
    options: Options
    required: tuple[str, ...] = ()
    needs_whole_tree: bool = False
    of_stacks: bool = False


class LineCheck(NamedTuple):
    """A check of the text of a file."""

    prepare: Callable[[Rule], LineTest]
    options: Options
    required: tuple[str, ...] = ()
    needs_whole_tree: Literal[False] = False
    of_stacks: Literal[False] = False


Check = NodeCheck | TreeCheck | LineCheck


def check_options(rule: Rule, check: Check) -> None:
    """Raises BadOption if the rule's options are not those that its check takes."""
    for name, value in rule.options.items():
        kind = check.options.get(name)
        if kind is None:
            options = f"Its options are {', '.join(check.options)}." if check.options else "It has none."
            fix = f"{did_you_mean(str(name), check.options)} {options}".lstrip()
            raise BadOption(f"Unknown option {name!r} of check {rule.check!r}.", fix, name)
        try:
            kind.check(f"Option {name!r} of rule {rule.id}", value)
        except BadOption as error:
            error.option = name
            raise
    for name in check.required:
        if name not in rule.options:
            raise BadOption(f"Rule {rule.id} must have the option {name!r}.")


def listed(names: Iterable[str], last: str = "and") -> str:
    """Names as an enumeration: `a`, `b` and `c`."""
    quoted = [f"`{name}`" for name in names]
    return " ".join(part for part in (", ".join(quoted[:-1]), last if len(quoted) > 1 else "", quoted[-1]) if part)


def nested(values: Mapping[str, Any], dotted: str) -> Any:
    """A value inside mappings: `aliveSupervision.minIndications`; None if there is none."""
    found: Any = values
    for name in dotted.split("."):
        found = found.get(name) if isinstance(found, dict | Mapping) else None
    return found


def is_number(value: Any) -> bool:
    """Whether a value is a number; true and false are none."""
    return isinstance(value, int | float) and not isinstance(value, bool)


def is_bound(value: Any) -> bool:
    """Whether a value is a number that others are compared with. `.nan` and `.inf` are none: composing refuses them."""
    return is_number(value) and isfinite(value)
