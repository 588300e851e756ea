"""Lines of C from the templates: indented by their braces if not further, without the empty lines that empty parts leave behind."""

import re
from collections.abc import Iterable, Iterator

from sigcat.adapter.core.c.lines import Line, Lines, code_of, function
from sigcat.adapter.core.c.scope import MARK
from sigcat.adapter.origins import marked_lines, origin
from sigcat.adapter.templates import Plan, rendered

_INDENT = "    "


def c_lines(template: str, plan: Plan) -> Lines:
    """Lines of a template of this folder."""
    made = rendered(f"adapter/core/c/{template}", plan)
    return _indented([Line(*each) for each in marked_lines(made)])


def c_functions(template: str, plan: Plan) -> list[Lines]:
    """Functions of a template of this folder, each with its comment."""
    return list(_functions(c_lines(template, plan)))


def text_of(part: Lines) -> str:
    """Lines that a template takes, with their origins."""
    return "\n".join(line.text + (origin(line.source) if line.source is not None else "") for line in part)


def _functions(part: Lines) -> Iterator[Lines]:
    before: list[Line] = []
    for line in part:
        before.append(line)
        if line.text == "}":
            while not before[0].text:
                before.pop(0)
            at = next(number for number, each in enumerate(before) if each.text == "{")
            body = tuple(each._replace(text=each.text.removeprefix(_INDENT)) for each in before[at + 1 : -1])
            yield (*before[: at - 1], *function(before[at - 1].text, [_without_unused_time(_spaced(body))]))
            before = []


_DECLARATION = re.compile(r"const \w+ (?!now )\w+ = .*;$")


def _spaced(body: Lines) -> Lines:
    """Statements, with an empty line only after a constant other than the time."""
    pairs = zip((Line(""), *body), body, strict=False)
    return tuple(line for before, line in pairs if line.text or _DECLARATION.search(before.text))


_NOW = re.compile(r"( *)const uint64_t now = (\w+_Now\(self, t\);)")


def _without_unused_time(body: Lines) -> Lines:
    """Statements, without the variable for a time that none of them uses: the clock goes on even so."""
    for number, line in enumerate(body):
        if found := _NOW.fullmatch(line.text):
            rest = body[number + 1 :]
            is_used = re.search(rf"(?<![\w.>{MARK}])now\b", code_of(rest))
            return body if is_used else (*body[:number], Line(f"{found[1]}(void){found[2]}"), *rest)
    return body


def _indented(part: Iterable[Line]) -> Lines:
    found: list[Line] = []
    depth = 0
    for line in part:
        text = line.text.lstrip()
        if not text:
            if found and found[-1].text and not found[-1].text.endswith("{"):
                found.append(Line(""))
            continue
        if text.startswith("}"):
            depth = max(0, depth - 1)
        indent = max(_INDENT * depth, line.text[: -len(text)], key=len)
        found.append(line._replace(text=indent + text))
        if text.endswith("{") and not text.startswith('extern "C"'):
            depth += 1
    return tuple(found[:-1] if found and not found[-1].text else found)
