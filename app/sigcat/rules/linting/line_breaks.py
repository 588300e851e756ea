"""Break lines that are too long: a text in YAML reads the same where one of its spaces is a line break."""

from collections.abc import Iterable, Iterator
from typing import NamedTuple

from yaml.nodes import MappingNode, Node, ScalarNode, SequenceNode

from sigcat.findings import Finding
from sigcat.rules.problem import Repair
from sigcat.text_lines import lines_of


class Edit(NamedTuple):
    """Characters from `start` to `end` of a text become `text`."""

    start: int
    end: int
    text: str


Settling = tuple[Edit, tuple[Finding, ...]]
"""An edit, and the findings that it settles."""


def broken_lines(text: str, root: Node, pairs: Iterable[tuple[Finding, Repair]]) -> Iterator[Settling]:
    """The edits that break long lines within values; comments and texts that keep their lines (`|`) stay as they are."""
    too_long = {finding.line - 1: finding for finding, repair in pairs if repair.kind == "break line"}
    if not too_long:
        return
    lines = lines_of(text, keepends=True)
    for node, above in scalars_of(root):
        if above is None or above.flow_style or node.style == "|":
            continue
        for number in range(node.start_mark.line, min(node.end_mark.line + 1, len(lines))):
            if number in too_long:
                finding = too_long[number]
                indent = _indent(node, above, number, lines)
                edits = list(_breaks(text, sum(map(len, lines[:number])), node, indent, finding.column - 1))
                yield from ((edit, (finding,) if i == 0 else ()) for i, edit in enumerate(edits))


def _indent(node: ScalarNode, above: MappingNode, number: int, lines: list[str]) -> int:
    """Return the indentation of the rest of a broken line: as the line, or below the name of the attribute; 0: none."""
    own = len(lines[number]) - len(lines[number].lstrip(" "))
    first = node.start_mark.line
    if node.style != ">":
        return above.start_mark.column + 2 if number == first else own
    return own if number > first and lines[first + 1].startswith(" " * own) and lines[first + 1][own] != " " else 0


def _breaks(text: str, start: int, node: ScalarNode, indent: int, most: int) -> Iterator[Edit]:
    end = text.find("\n", start) if "\n" in text[start:] else len(text)
    break_of_line = "\r\n" if text[:end].endswith("\r") else "\n"
    first, last = max(start, node.start_mark.index) + 1, min(end, node.end_mark.index) - 1
    before = 0
    while indent and end - start + before > most:
        places = range(min(last, start + most - before), max(first, start), -1)
        cut = next((i for i in places if text[i] == " " and text[i - 1] != " " and text[i + 1].isalnum()), None)
        if cut is None:
            return
        yield Edit(cut, cut + 1, break_of_line + " " * indent)
        start, before = cut + 1, indent


def scalars_of(root: Node) -> Iterator[tuple[ScalarNode, MappingNode | None]]:
    """Every scalar of a document once, with the mapping that it is a part of."""
    waiting: list[tuple[Node, MappingNode | None]] = [(root, None)]
    seen: set[int] = set()
    while waiting:
        node, above = waiting.pop()
        if isinstance(node, ScalarNode):
            yield node, above
        elif id(node) not in seen:
            seen.add(id(node))
            if isinstance(node, MappingNode):
                waiting.extend((part, node) for pair in node.value for part in pair)
            elif isinstance(node, SequenceNode):
                waiting.extend((part, None) for part in node.value)
