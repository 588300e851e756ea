"""Values from the core to the RTE; errors to the diagnosis."""

from collections.abc import Sequence
from typing import NamedTuple

from sigcat.adapter.autosar_classic.code.c_text import c_lines
from sigcat.adapter.autosar_classic.code.component.rte_values import Copy, CopyRow, by_value
from sigcat.adapter.autosar_classic.code.names import core_object
from sigcat.adapter.autosar_classic.code.plan import DataEnd, MethodEnd, SwcPlan
from sigcat.adapter.core.c.text.lines import Lines


class _Sent(NamedTuple):
    """An element that is sent: statements that copy its value, and the argument for the RTE.

    Of one that is kept, others would have an old value until it changes, if the RTE does not take it.
    """

    end: DataEnd
    is_kept: bool
    copied: Sequence[CopyRow]
    argument: str


class _Call(NamedTuple):
    """A call with its outputs; if `is_repeated`, each step of a cycle sends one of them again."""

    name: str
    outputs: Sequence[_Sent]
    is_repeated: bool
    has_queue: bool


class _Request(NamedTuple):
    """A request to a method: statements that copy its arguments, and what the RTE is given."""

    end: MethodEnd
    copied: Sequence[CopyRow]
    given: Sequence[str]


def functions(swc: SwcPlan) -> Lines:
    """Functions for what the core may say at any time, for outputs of each call, each request and each verdict."""
    return c_lines(
        "code/component/publishing.c.j2",
        swc=swc,
        core=core_object(swc),
        requests=[_request(each, swc) for each in swc.requests],
        calls=[_call(step.name, swc) for step in swc.core.steps if outputs(step.name, swc)],
        kept=[_sent(end, swc) for end in kept(swc)],
    )


def outputs(call: str, swc: SwcPlan) -> list[DataEnd]:
    """Elements that a call provides."""
    return [end for end in swc.sent if end.call == call]


def _call(name: str, swc: SwcPlan) -> _Call:
    ends = outputs(name, swc)
    is_repeated, has_queue = any(_is_repeated(each, swc) for each in ends), any(each.is_queue for each in ends)
    return _Call(name, [_sent(end, swc) for end in ends], is_repeated, has_queue)


def _sent(end: DataEnd, swc: SwcPlan) -> _Sent:
    copy = Copy(swc.core, to_core=False)
    place = f"{core_object(swc)}.out.{end.place}"
    source = f"{place}.values[k]" if end.has_count else place
    if end.type.is_number:
        return _Sent(end, _is_kept(end, swc), [], copy.number(source, end.type))
    copied = [*copy.of("value", source, end.type, end.wire.c)]
    return _Sent(end, _is_kept(end, swc), copied, by_value(end.type, "value"))


def _request(end: MethodEnd, swc: SwcPlan) -> _Request:
    copy, place = Copy(swc.core, to_core=False), f"{core_object(swc)}.method.{end.method.named.name}"
    copied = [
        row for each in end.arguments
        for row in copy.of(f"given_{each.name}", f"{place}.arguments.{each.place}", each.type, each.wire.c)
    ]  # fmt: skip
    given = [by_value(each.type, f"given_{each.name}") for each in end.arguments]
    return _Request(end, copied, given)


def _is_repeated(end: DataEnd, swc: SwcPlan) -> bool:
    """Whether each step of a cycle sends it again."""
    return not end.is_queue and any(step.name == end.call and step.cycle for step in swc.core.steps)


def _is_kept(end: DataEnd, swc: SwcPlan) -> bool:
    """Whether others would have an old value until it changes, if the RTE does not take it."""
    return not end.is_queue and not _is_repeated(end, swc)


def kept(swc: SwcPlan) -> list[DataEnd]:
    """Elements that are sent again until they are accepted."""
    return [end for end in swc.sent if _is_kept(end, swc)]
