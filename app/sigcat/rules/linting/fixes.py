"""Repair files: change the bytes of the values that findings are about, and no others.

The position of a finding leads to a scalar of the YAML document; its end is known only from composing the file again,
which happens for files with something to repair alone. Every repaired text is read again: a repair that changes
anything but its own values is not made.
"""

import difflib
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any, NamedTuple

from yaml.nodes import MappingNode, Node, ScalarNode

from sigcat.catalogue.reading.yaml_document import Builder, Unbuildable, read_document
from sigcat.findings import Finding
from sigcat.rules.linting.line_breaks import Edit, Settling, broken_lines, scalars_of
from sigcat.rules.linting.options import Identity, identity_of
from sigcat.rules.linting.suppression import without_codes
from sigcat.rules.problem import Repair
from sigcat.text_lines import lines_of

_NOT_OF_VALUES = ("remove suppression", "break line")
_PLAIN_ENDINGS = ("'", '"')
_BOM = "\ufeff"


class Fixed(NamedTuple):
    """The text of a file after repairs, and the findings that these settle."""

    file: str
    before: str
    after: str
    settled: tuple[Finding, ...]

    @property
    def diff(self) -> str:
        """The change as a unified diff."""
        lines = difflib.unified_diff(
            lines_of(self.before, keepends=True), lines_of(self.after, keepends=True), self.file, self.file
        )
        return "".join(line if line.endswith("\n") else f"{line}\n\\ No newline at end of file\n" for line in lines)


def fixed_files(
    findings: Sequence[Finding], repairs: Mapping[Identity, Repair], sources: Mapping[str, str], *, unsafe: bool = False
) -> tuple[Fixed, ...]:
    """Every file of `sources` in which something is repaired; nothing is written. `unsafe` adds changes of meaning."""
    wanted: dict[str, list[tuple[Finding, Repair]]] = {}
    for finding in findings:
        repair = repairs.get(identity_of(finding))
        if repair is not None and (repair.safe or unsafe) and finding.file in sources:
            wanted.setdefault(finding.file, []).append((finding, repair))
    fixed = (_fixed(name, sources[name], pairs) for name, pairs in wanted.items())
    return tuple(result for result in fixed if result is not None and result.settled)


def _fixed(name: str, content: str, pairs: Sequence[tuple[Finding, Repair]]) -> Fixed | None:
    """Values and comments are repaired; if a comment turns out to be part of a text, values alone."""
    text = content.removeprefix(_BOM)
    document = read_document(text.encode("utf-8", "surrogatepass"), name)
    if document.root is None:
        return None
    values = list(_value_edits(text, document.root, pairs))
    comments = list(_comment_edits(text, pairs))
    lines = list(broken_lines(text, document.root, pairs))
    for edits in (values + comments + lines, values + comments, values):
        after, settled = _applied(text, edits)
        if after != text and _reads_alike(text, after, len(values)):
            return Fixed(name, content, content[: len(content) - len(text)] + after, settled)
    return None


def _value_edits(text: str, root: Node, pairs: Iterable[tuple[Finding, Repair]]) -> Iterator[Settling]:
    scalars = {(node.start_mark.line, node.start_mark.column): (node, above) for node, above in scalars_of(root)}
    for finding, repair in pairs:
        found = scalars.get((finding.line - 1, finding.column - 1))
        edit = _edit(text, repair, *found) if found is not None and repair.kind not in _NOT_OF_VALUES else None
        if edit is not None:
            yield edit, (finding,)


def _comment_edits(text: str, pairs: Iterable[tuple[Finding, Repair]]) -> Iterator[Settling]:
    """Codes that suppress nothing go, all those of one comment at once; a line that said nothing else goes with it."""
    comments: dict[tuple[int, int], list[tuple[Finding, Repair]]] = {}
    for finding, repair in pairs:
        if repair.kind == "remove suppression":
            comments.setdefault((finding.line, finding.column), []).append((finding, repair))
    lines = lines_of(text, keepends=True)
    for (number, column), unused in comments.items():
        line = lines[number - 1]
        start = sum(map(len, lines[: number - 1]))
        after = without_codes(line, column, [repair.text for _, repair in unused])
        edit = _narrowed(Edit(start, start + len(line), after if after.strip() else ""), line)
        yield edit, tuple(finding for finding, _ in unused)


def _narrowed(edit: Edit, before: str) -> Edit:
    """The edit without what stays at its start and its end."""
    start = _alike(before, edit.text)
    end = _alike(before[:start:-1], edit.text[:start:-1])
    return Edit(edit.start + start, edit.end - end, edit.text[start : len(edit.text) - end])


def _alike(one: str, other: str) -> int:
    """Return the number of characters that both begin with."""
    return next((i for i, (a, b) in enumerate(zip(one, other, strict=False)) if a != b), min(len(one), len(other)))


def _edit(text: str, repair: Repair, node: ScalarNode, above: MappingNode | None) -> Edit | None:
    start, end = node.start_mark.index, _end(text, node)
    if repair.kind == "remove attribute":
        return _removal(text, node, above)
    if repair.kind in ("replace", "rename attribute"):
        return (
            Edit(start, end, repair.text)
            if not node.style and _is_plain(repair.text)
            else _quoted(node, repair, start, end)
        )
    if node.style in ("|", ">"):
        start, end = _within_block(text, start, end)
    elif node.style in _PLAIN_ENDINGS:
        start, end = start + 1, end - 1
    if start >= end:
        return None
    if repair.kind == "capitalize":
        return Edit(start, start + 1, text[start].upper())
    if repair.kind == "rewrite":
        return _rewriting(text, repair, node, start)
    return Edit(end, end, repair.text)


def _rewriting(text: str, repair: Repair, node: ScalarNode, start: int) -> Edit | None:
    """The beginning of a text in other words, where it stands as it reads: on one line and without escapes."""
    value, written = node.value.strip(), repair.text.strip()
    stays = _alike(value[::-1], written[::-1])
    before, after = value[: len(value) - stays], written[: len(written) - stays]
    is_there = text.startswith(before, start)
    return Edit(start, start + len(before), after) if is_there and set(after).isdisjoint("\"'#:") else None


def _within_block(text: str, start: int, end: int) -> tuple[int, int]:
    """Return the start and the end of the text of a block scalar, without the indicators in its first line."""
    body = text.find("\n", start, end) + 1 or end
    content = text[body:end]
    return body + len(content) - len(content.lstrip()), body + len(content.rstrip())


def _quoted(node: ScalarNode, repair: Repair, start: int, end: int) -> Edit | None:
    return Edit(start, end, f"{node.style}{repair.text}{node.style}") if node.style in _PLAIN_ENDINGS else None


def _removal(text: str, key: ScalarNode, above: MappingNode | None) -> Edit | None:
    """The whole line of an attribute in block style; an attribute within braces is left to a person."""
    if above is None or above.flow_style:
        return None
    value = next((v for k, v in above.value if k is key), None)
    if not isinstance(value, ScalarNode) or len(above.value) < 2:
        return None
    start = text.rfind("\n", 0, key.start_mark.index) + 1
    stop = text.find("\n", _end(text, value))
    return Edit(start, stop + 1 if stop >= 0 else len(text), "")


def _end(text: str, node: ScalarNode) -> int:
    """Return the end of a scalar; libyaml lets some plain scalars end after the space or line break behind them."""
    end: int = node.end_mark.index
    return end if node.style else node.start_mark.index + len(text[node.start_mark.index : end].rstrip())


def _is_plain(text: str) -> bool:
    return text.replace("_", "").replace("/", "").isalnum() and not text[0].isdigit()


def _applied(text: str, edits: Iterable[Settling]) -> tuple[str, tuple[Finding, ...]]:
    """Edits from the last to the first; one that overlaps another waits for the next run."""
    settled: list[Finding] = []
    limit = len(text) + 1
    for edit, findings in sorted(edits, key=lambda pair: (pair[0].start, pair[0].end), reverse=True):
        if edit.end > limit or (edit.end == limit and edit.start == edit.end):
            continue
        text = text[: edit.start] + edit.text + text[edit.end :]
        limit = edit.start
        settled.extend(findings)
    return text, tuple(reversed(settled))


def _reads_alike(before: str, after: str, changes: int) -> bool:
    """Whether the repaired text still reads, and differs only in the values to change."""
    values = [list(_leaves(text)) for text in (before, after)]
    if not values[1]:
        return False
    gone = _difference(values[0], values[1])
    come = _difference(values[1], values[0])
    return len(gone) <= changes and len(come) <= changes


def _leaves(text: str) -> Iterator[tuple[str, str]]:
    root = read_document(text.encode("utf-8", "surrogatepass"), "").root
    try:
        data = Builder().value(root) if root is not None else {}
    except Unbuildable:
        return
    for path, values in data.items() if isinstance(data, dict) else ():
        for name, value in values.items() if isinstance(values, dict) else ():
            yield str(path), f"{name}: {value!r}"


def _difference(some: list[Any], others: list[Any]) -> list[Any]:
    known = set(others)
    return [item for item in some if item not in known]
