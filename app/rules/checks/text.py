"""Checks of texts: of the values of attributes, and of the lines of a file."""

import re
from collections.abc import Iterator
from typing import Any

from app.catalogue.definition import Definition
from app.rules.checks.kind import LineFlaw, LineTest, NodeTest, shown
from app.rules.flaw import Flaw, Repair
from app.rules.patterns import compile_pattern
from app.rules.record import Rule
from app.rules.tree import Tree

_REPAIRS = {
    "capitalize": Repair("capitalize"),
    "period": Repair("append", "."),
}


def text(rule: Rule, _tree: Tree) -> NodeTest:
    """The text of `attribute` holds a match of `pattern` and none of `forbidden`.

    Of a list every item is looked at, of a mapping every key (`each: key`) or every value.
    """
    attribute = rule.options["attribute"]
    pattern = compile_pattern(rule.options.get("pattern", ""), trusted=rule.trusted)
    forbidden = rule.options.get("forbidden")
    bad = compile_pattern(forbidden, trusted=rule.trusted) if forbidden is not None else None
    repair = _REPAIRS.get(str(rule.options.get("repair")))

    def test(definition: Definition) -> Iterator[Flaw]:
        for item in _texts(definition.values[attribute], rule):
            if not pattern.found(item):
                message = f"`{attribute}` {shown(item)} does not match {pattern.text}."
            elif bad is not None and bad.found(item):
                message = f"`{attribute}` {shown(item)} holds what {bad.text} forbids."
            else:
                continue
            yield Flaw(definition, message, attribute, facts={"value": item, "attribute": attribute}, repair=repair)

    return test


def line_length(rule: Rule) -> LineTest:
    """No line is longer than `most` characters, unless it cannot be broken (one word, such as an address)."""
    most = rule.options["most"]
    too_long = re.compile(rf"^.{{{most + 1},}}$", re.MULTILINE)

    def test(content: str) -> Iterator[LineFlaw]:
        for match in too_long.finditer(content):
            line = match.group().rstrip("\r")
            longest = max(map(len, line.split()), default=0)
            if len(line) > most and longest < most - len(line) + len(line.lstrip()):
                number = content.count("\n", 0, match.start()) + 1
                message = f"The line has {len(line)} characters; the limit is {most}."
                yield LineFlaw(number, most + 1, message, "Break it; YAML folds the lines of a text into one.")

    return test


def _texts(value: Any, rule: Rule) -> Iterator[str]:
    if isinstance(value, str):
        yield value
    elif isinstance(value, list):
        yield from (item for item in value if isinstance(item, str))
    elif isinstance(value, dict):
        items = value.keys() if rule.options.get("each") == "key" else value.values()
        yield from (item for item in items if isinstance(item, str))
