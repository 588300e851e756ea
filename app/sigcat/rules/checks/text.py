"""Checks of texts: of the values of attributes, and of the lines of a file."""

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any

from sigcat.catalogue.model.definition import Definition
from sigcat.findings import shown
from sigcat.line_numbers import numbered
from sigcat.names import screaming_snake_case
from sigcat.rules.checks.kind import LineTest, NodeTest
from sigcat.rules.patterns import compile_exception, compile_pattern
from sigcat.rules.problem import LineProblem, Problem, Repair
from sigcat.rules.record import Rule
from sigcat.rules.tree import Tree

# Texts: compiled patterns would cost each start time, and few trees need them.
_VERSION = r"(?i)\s*v(?:ersion|ss)?\s*(\d+\.\d+(?:\.\d+)?)[\s:;,.–—-]*"
_SUCCESSOR = r"(?i)(?:(?:is|was|has been|got)\s+)?(?:moved|renamed)\s+(?:in)?to:?\s+"
_REMOVAL = r"(?i)(?:(?:is|was|has been|got|to be)\s+)?(?:removed|deleted)\b"


def _deprecation(item: str) -> Repair:
    """The same successor or removal, in the words of VSS."""
    version = re.match(_VERSION, item)
    if not version:
        return Repair("capitalize")
    rest = item[version.end() :]
    rest = re.sub(_REMOVAL, "removed", re.sub(_SUCCESSOR, "moved to ", rest, count=1), count=1)
    return Repair("rewrite", f"V{version[1]} {rest}")


REPAIRS: Mapping[str, Callable[[str], Repair]] = {
    "capitalize": lambda _: Repair("capitalize"),
    "period": lambda _: Repair("append", "."),
    "deprecation": _deprecation,
}


def text(rule: Rule, _tree: Tree) -> NodeTest:
    """The text of `attribute` holds a match of `pattern` and none of `forbidden`, unless it holds one of `except`.

    Of a list every item is looked at, of a mapping every key (`each: key`) or every value. With `case: screaming` the
    spelling in UPPER_SNAKE_CASE is proposed, where that is right.
    """
    attribute = rule.options["attribute"]
    pattern = compile_pattern(rule.options.get("pattern", ""), trusted=rule.trusted)
    forbidden = rule.options.get("forbidden")
    bad = compile_pattern(forbidden, trusted=rule.trusted) if forbidden is not None else None
    is_exempt = compile_exception(rule.options.get("except"), trusted=rule.trusted)
    by_key = rule.options.get("each") == "key"

    def wrong(item: str) -> str:
        if not pattern.found(item):
            return f"`{attribute}` must match {pattern.text}; {shown(item)} does not."
        return f"`{attribute}` must not match {bad.text}; {shown(item)} does." if bad and bad.found(item) else ""

    def test(definition: Definition) -> Iterator[Problem]:
        for within, item in _texts(definition.values[attribute], by_key=by_key):
            message = wrong(item)
            if message and not is_exempt(item):
                proposal = screaming_snake_case(item) if rule.options.get("case") == "screaming" else ""
                fix = f"Write {proposal!r}." if proposal and not wrong(proposal) else ""
                facts = {"value": item, "attribute": attribute}
                repair = _repair(rule, item, wrong)
                yield Problem(definition, message, attribute, fix, facts, repair, at_name=by_key, within=within)

    return test


def _repair(rule: Rule, item: str, wrong: Callable[[str], str]) -> Repair | None:
    """The repair that the rule names, if it leaves nothing wrong."""
    repair = REPAIRS.get(rule.options.get("repair", ""))
    made = repair(item) if repair else None
    return made if made is not None and not wrong(made.of(item)) else None


def line_length(rule: Rule) -> LineTest:
    """No line is longer than `most` characters, unless it cannot be broken (one word, such as an address)."""
    most = rule.options["most"]
    too_long = re.compile(rf"^.{{{most + 1},}}$", re.MULTILINE)

    def test(content: str) -> Iterator[LineProblem]:
        for number, match in numbered(content, too_long.finditer(content)):
            line = match.group().rstrip("\r")
            longest = max(map(len, line.split()), default=0)
            if len(line) > most and longest < most - len(line) + len(line.lstrip()):
                message = f"The line must have at most {most} characters, not {len(line)}."
                fix = "Break it: YAML joins the lines of a text."
                yield LineProblem(number, most + 1, message, fix, Repair("break line"))

    return test


def _texts(value: Any, *, by_key: bool) -> Iterator[tuple[tuple[int, ...], str]]:
    """The texts of a value, with the steps that lead to them."""
    if isinstance(value, str):
        yield (), value
        return
    items: Iterable[Any] = ()
    if isinstance(value, list):
        items = value
    elif isinstance(value, dict):
        items = value.keys() if by_key else value.values()
    yield from (((i,), item) for i, item in enumerate(items) if isinstance(item, str))
