"""New entries of a function.yaml, at the end of the lists that it has."""

import textwrap
from collections.abc import Iterator, Sequence
from typing import Any

from yaml.nodes import MappingNode, Node, SequenceNode

from sigcat.catalogue.reading.yaml_document import read_document
from sigcat.function.c_project.project import Call
from sigcat.function.importing.function_text import (
    Draft,
    data_definition,
    data_lines,
    is_of,
    parameter_definition,
    parameter_lines,
)
from sigcat.function.importing.parameters import ParameterEntry
from sigcat.function.importing.signals import Signal
from sigcat.function.importing.yaml_edits import Text, edited, entries_of, runnables_of, text_of, value_at


def added(text: str, draft: Draft) -> str:
    """The text with the signals and parameters of a draft, each at the call that uses it, and what they define."""
    steps = draft.project.steps
    for step in steps:
        signals = [each for each in draft.signals if is_of(each.value.key, step, steps)]
        parameters = [each for each in draft.parameters if is_of(each.value.key, step, steps)]
        text = _listed(text, step, "data", signals, draft)
        text = _listed(text, step, "parameters", parameters, draft)
    for path, definition in draft.data.items():
        text = _defined(text, "data", path, tuple(data_definition(path, definition)), definition)
    for each in draft.parameters:
        if each.definition:
            lines = tuple(parameter_definition(each, draft))
            text = _defined(text, "parameters", each.name, lines, each.definition)
    return text


def _listed(text: str, step: Call, kind: str, new: Sequence[Signal] | Sequence[ParameterEntry], draft: Draft) -> str:
    for each in new:
        runnable = _runnable(root_of(text), step)
        if isinstance(each, Signal):
            _, *lines = data_lines([each], draft)
            keys: dict[str, Any] = {"path": each.path, **each.keys}
        else:
            _, *lines = parameter_lines([each])
            keys = each.keys
        text = _with_item(text, runnable, kind, textwrap.dedent("\n".join(lines)).split("\n"), keys)
    return text


def root_of(text: str) -> Node | None:
    """The outermost node of a function file."""
    return read_document(text.encode(), "function.yaml").root


def _runnable(root: Node | None, step: Call) -> Node:
    """The call of the file that is this one; else the first one that has data, or the last one."""
    runnables, keys = list(runnables_of(root)), ("symbol", "interface")
    named = [each for each in runnables if step.symbol in [text_of(value_at(each, key)) for key in keys]]
    using = [each for each in runnables if value_at(each, "data") is not None]
    return (*named, *using, *reversed(runnables))[0]


def _with_item(text: str, runnable: Node, kind: str, lines: Sequence[str], keys: dict[str, Any]) -> str:
    whole, listed = Text(text), value_at(runnable, kind)
    if isinstance(listed, SequenceNode) and listed.flow_style:
        return edited(text, [whole.add_item(listed, keys)])
    if isinstance(listed, SequenceNode):
        return edited(text, [whole.add_lines(listed, lines)])
    if isinstance(runnable, MappingNode) and not runnable.flow_style:
        return edited(text, [whole.add_lines(runnable, [f"{kind}:", *(f"  {line}" for line in lines)])])
    if isinstance(runnable, MappingNode):
        last = next(reversed(entries_of(runnable)))
        return edited(text, whole.set_value(runnable, kind, [keys], last))
    return edited(text, [whole.as_mapping(runnable, "interface", kind, [keys])])


def _defined(text: str, kind: str, name: str, lines: Sequence[str], definition: Any) -> str:
    """A definition, at the end of those of its kind; one that is there stays."""
    root, whole = root_of(text), Text(text)
    define, known = value_at(root, "define"), value_at(root, "define", kind)
    if name in entries_of(known):
        return text
    own = textwrap.dedent("\n".join(lines)).split("\n")
    if isinstance(known, MappingNode) and known.value:
        if known.flow_style:
            return edited(text, whole.set_value(known, name, definition, next(reversed(entries_of(known)))))
        return edited(text, [whole.add_lines(known, own)])
    section = [f"{kind}:", *_indented(own)]
    if isinstance(define, MappingNode) and define.value:
        if define.flow_style:
            return edited(text, whole.set_value(define, kind, {name: definition}, next(reversed(entries_of(define)))))
        return edited(text, [whole.add_lines(define, section)])
    assert root is not None
    return edited(text, [whole.add_lines(root, ["", "define:", *_indented(section)])])


def _indented(lines: Sequence[str]) -> Iterator[str]:
    yield from (f"  {line}" for line in lines)
