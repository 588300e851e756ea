"""Causes of errors (section 6): for each error, the conditions that name it."""

from collections.abc import Callable, Iterator
from functools import partial
from typing import NamedTuple

from tests.adapter.reference.call_state import CallState
from tests.adapter.reference.outputs import OutputState
from tests.adapter.reference.parts.inputs import InputState
from tests.adapter.reference.parts.modes import Mode
from tests.adapter.reference.parts.parameters import ParameterState
from tests.adapter.reference.parts.supervision import Graph

Verdict = bool | None
"""Whether a condition holds; None while it has not been tested."""


class Cause(NamedTuple):
    """A condition that makes an error present."""

    error: str | None
    evaluate: Callable[[], Verdict]
    call: str | None = None
    """The call that tests it."""
    is_late: bool = False
    """Whether that is when the call has ended."""
    is_supervised: bool = False
    """Whether time alone can change it."""


def causes_of_call(state: CallState) -> Iterator[Cause]:
    """Causes in a call, its inputs and its outputs."""
    name, alive, deadline = state.call.name, state.alive, state.deadline
    yield Cause(state.call.overrun_error, lambda: state.activations.overrun, name)
    for each in state.inputs:
        yield from _causes_of_input(each, name)
    for output in state.outputs.values():
        yield from _causes_of_output(output, name)
    if alive:
        yield Cause(alive.limits.error, alive.evaluate, name, is_late=True, is_supervised=True)
    if deadline:
        yield Cause(deadline.limits.error, lambda: deadline.verdict, name, is_late=True, is_supervised=True)


def _causes_of_input(state: InputState, call: str) -> Iterator[Cause]:
    for field, error in state.input.errors.items():
        is_late = field == "range_error" and state.input.is_immediate
        yield Cause(error, partial(state.verdict, field), call, is_late)


def _causes_of_output(state: OutputState, call: str) -> Iterator[Cause]:
    yield Cause(state.output.range_error, lambda: state.is_outside, call, is_late=True)
    if state.output.queue:
        yield Cause(state.output.queue.overflow_error, lambda: state.overflow, call, is_late=True)


def causes_of_mode(mode: Mode) -> Iterator[Cause]:
    """Causes in the mode."""
    if mode.declared:
        yield Cause(mode.declared.unknown_error, lambda: mode.is_unknown)


def cause_of_parameter(state: ParameterState) -> Cause:
    """Causes in a parameter."""
    return Cause(state.parameter.range_error, lambda: state.is_outside)


def causes_of_graph(graph: Graph) -> Iterator[Cause]:
    """Causes in the order of calls."""
    for error in dict.fromkeys(checkpoint.error for checkpoint in graph.checkpoints.values()):
        if error is not None:
            yield _cause_of_order(error, graph)


def _cause_of_order(error: str, graph: Graph) -> Cause:
    return Cause(error, lambda: graph.verdicts.get(error))
