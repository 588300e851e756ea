"""Changes of a YAML text by the positions of its nodes: everything else stays as it is, comments too."""

from collections.abc import Iterable, Iterator, Sequence
from typing import Any, NamedTuple

from yaml.nodes import MappingNode, Node, ScalarNode, SequenceNode

from sigcat.function.importing.yaml_text import inline


class Edit(NamedTuple):
    """A part of a text, and what takes its place."""

    start: int
    end: int
    text: str


def edited(text: str, edits: Iterable[Edit]) -> str:
    """The text with all changes. Of those at the same place the first one comes first."""
    for _, each in sorted(enumerate(edits), key=lambda one: (one[1].start, one[0]), reverse=True):
        text = text[: each.start] + each.text + text[each.end :]
    return text


def entries_of(node: Node | None) -> dict[str, tuple[ScalarNode, Node]]:
    """Keys and values of a mapping, by the text of the key."""
    pairs = node.value if isinstance(node, MappingNode) else ()
    return {key.value: (key, value) for key, value in pairs if isinstance(key, ScalarNode)}


def value_at(node: Node | None, *keys: str) -> Node | None:
    """The value below keys; None if there is none."""
    for key in keys:
        node = entries_of(node).get(key, (None, None))[1]
    return node


def items_of(node: Node | None) -> Sequence[Node]:
    """Items of a list."""
    return tuple(node.value) if isinstance(node, SequenceNode) else ()


def runnables_of(root: Node | None) -> Iterator[Node]:
    """The calls of every component of a function file."""
    for component in items_of(value_at(root, "components")):
        yield from items_of(value_at(component, "runnables"))


def text_of(node: Node | None) -> str | None:
    """The text of a scalar."""
    return node.value if isinstance(node, ScalarNode) else None


class Text:
    """A text of YAML that is changed at its nodes."""

    def __init__(self, text: str) -> None:
        self._text = text

    def end_of(self, node: Node) -> int:
        """Return the end of a node, without the space and the comments behind it."""
        if isinstance(node, SequenceNode | MappingNode) and not node.flow_style and node.value:
            last = node.value[-1]
            return self.end_of(last[1] if isinstance(last, tuple) else last)
        end = int(node.end_mark.index)
        return len(self._text[:end].rstrip()) if isinstance(node, ScalarNode) and node.style in ("|", ">") else end

    def set_value(self, mapping: Node, key: str, value: Any, after: str) -> Iterator[Edit]:
        """The value of a key, which is added behind another key if it is not there; None removes it."""
        assert isinstance(mapping, MappingNode)
        entries = entries_of(mapping)
        if key in entries:
            name, node = entries[key]
            start = int(name.end_mark.index)
            if value is None:
                yield self.without_key(mapping, key)
            else:
                yield Edit(start, self.end_of(node), f": {inline(value)}")
        elif value is not None:
            name, node = entries.get(after, next(reversed(entries.values())))
            at = self.end_of(node)
            if not mapping.flow_style:
                at = self._end_of_line(at)
            before = ", " if mapping.flow_style else f"\n{' ' * name.start_mark.column}"
            yield Edit(at, at, f"{before}{key}: {inline(value)}")

    def without_key(self, mapping: Node, key: str) -> Edit:
        """A mapping without a key and what it holds."""
        assert isinstance(mapping, MappingNode)
        names = list(entries_of(mapping))
        index, (name, node) = names.index(key), entries_of(mapping)[key]
        start = self._start_of_line(name.start_mark.index)
        is_behind_dash = self._text[start : name.start_mark.index].strip() != ""
        if not index and len(names) > 1 and (mapping.flow_style or is_behind_dash):
            return Edit(name.start_mark.index, entries_of(mapping)[names[1]][0].start_mark.index, "")
        if mapping.flow_style:
            start = self.end_of(entries_of(mapping)[names[index - 1]][1]) if index else name.start_mark.index
            return Edit(start, self.end_of(node), "")
        return Edit(start, min(self._end_of_line(self.end_of(node)) + 1, len(self._text)), "")

    def add_lines(self, node: Node, lines: Sequence[str]) -> Edit:
        """Lines behind a block, at the indentation of its items or keys."""
        first = node.value[0]
        column = (first[0] if isinstance(first, tuple) else node).start_mark.column
        at = self._end_of_line(self.end_of(node))
        return Edit(at, at, "".join(f"\n{' ' * column}{line}" if line else "\n" for line in lines))

    def add_item(self, node: SequenceNode, value: Any) -> Edit:
        """An item of a list that is written in brackets."""
        at = self.end_of(node.value[-1]) if node.value else int(node.end_mark.index) - 1
        return Edit(at, at, f"{', ' if node.value else ''}{inline(value)}")

    def without_item(self, node: SequenceNode, index: int) -> Edit:
        """A list without one of its items, and without the comments directly above it."""
        item = node.value[index]
        if node.flow_style:
            start = self.end_of(node.value[index - 1]) if index else item.start_mark.index
            is_first_of_more = not index and len(node.value) > 1
            end = node.value[1].start_mark.index if is_first_of_more else self.end_of(item)
            return Edit(start, end, "")
        comments = (at for at, _ in self.comments_above(item))
        start = min(comments, default=self._start_of_line(item.start_mark.index))
        return Edit(start, min(self._end_of_line(self.end_of(item)) + 1, len(self._text)), "")

    def as_mapping(self, node: Node, name: str, key: str, value: Any) -> Edit:
        """A scalar as the value of a key in a mapping that has another key."""
        return Edit(node.start_mark.index, self.end_of(node), inline({name: node.value, key: value}))

    def comments_above(self, node: Node) -> Iterator[tuple[int, str]]:
        """The lines of comments directly above a node, from the last one up, and where they start."""
        start = self._start_of_line(node.start_mark.index)
        while (above := self._line_before(start)).lstrip().startswith("#"):
            start -= len(above) + 1
            yield start, above

    def _line_before(self, start: int) -> str:
        return self._text[self._start_of_line(start - 1) : start - 1] if start > 0 else ""

    def _start_of_line(self, at: int) -> int:
        return self._text.rfind("\n", 0, max(at, 0)) + 1

    def _end_of_line(self, at: int) -> int:
        end = self._text.find("\n", at)
        return len(self._text) if end < 0 else end
