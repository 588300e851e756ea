"""A call, from its snapshot to what it has given (sections 2 to 7, 10 and 12)."""

from tests.adapter.reference.call_state import CallState
from tests.adapter.reference.function import Call
from tests.adapter.reference.mode_out import read_mode_out
from tests.adapter.reference.outputs import OutputState
from tests.adapter.reference.parts.inputs import InputState
from tests.adapter.reference.parts.methods import Slot
from tests.adapter.reference.running import Running
from tests.adapter.reference.values.value import numbers_of
from tests.adapter.reference.writing import (
    write_errors,
    write_input,
    write_mode,
    write_parameters_of,
    write_reaction,
    write_status,
)


def set_input(running: Running, name: str, t: int) -> None:
    """Take the snapshot of a call that was due."""
    t = running.tick(t)
    running.close_windows(t)
    running.graph.report(name)
    running.calls[name].activations.take()
    for each in running.calls[name].inputs:
        each.evaluate(t)
        if not each.input.is_immediate:
            _take(running, each)
    write_parameters_of(running, name)
    write_mode(running)
    running.evaluate(running.diagnosis.of_call(name, late=False), t)
    _react(running, name, t)
    write_errors(running, running.calls[name].call.errors)
    for slot in _slots(running, name):
        _take_answer(running, slot, t)


def _take(running: Running, state: InputState) -> None:
    state.take()
    write_input(running, state)


def _react(running: Running, name: str, t: int) -> None:
    for state in running.diagnosis.reactions.values():
        if name in state.reaction.calls:
            before = state.is_active
            running.diagnosis.react(state, name, t)
            write_reaction(running, state)
            if state.is_active != before:
                running.publish.add(state.reaction.name)


def _slots(running: Running, call: str) -> list[Slot]:
    return [slot for slot in running.slots.values() if slot.method.call == call]


def _take_answer(running: Running, slot: Slot, t: int) -> None:
    results = slot.evaluate(t)
    if results is not None:
        pairs = zip(slot.method.outputs, results, strict=True)
        running.variables.update({argument.variable: value for argument, value in pairs})
    write_status(running, slot)


def begin(running: Running, name: str, t: int) -> None:
    """Right before the call."""
    t = running.tick(t)
    call = running.calls[name]
    for each in call.inputs:
        if each.input.is_immediate:
            _take(running, each)
    call.activations.begun = t
    if call.deadline:
        call.deadline.begin(t)


def get_output(running: Running, name: str, t: int) -> None:
    """The call has ended."""
    t = running.tick(t)
    running.close_windows(t)
    call = running.calls[name]
    if call.alive:
        call.alive.indicate(t)
    if call.deadline:
        call.deadline.end(t)
    _send(running, call)
    _read_errors(running, call.call)
    running.evaluate(running.diagnosis.of_call(name, late=True), t)
    for slot in _slots(running, name):
        _ask(running, slot, t)
    read_mode_out(running)
    call.has_ended, call.activations.is_active = True, False


def _send(running: Running, call: CallState) -> None:
    for name, state in call.outputs.items():
        state.give(running.variables[state.output.variable], _count(running, state))
        running.out[name] = state.sent
        if state.count:
            running.publish.add(name)
        else:
            running.publish.discard(name)


def _count(running: Running, state: OutputState) -> int:
    """Number of values that a call has given."""
    variable = state.output.queue.count_variable if state.output.queue else None
    return 1 if variable is None else int(numbers_of(running.variables[variable])[0]) % 2**32


def _read_errors(running: Running, call: Call) -> None:
    for error in running.function.errors:
        if error.variable is not None and running.function.owner(error.name) == call:
            numbers = numbers_of(running.variables[error.variable])
            running.diagnosis.read[error.name] = any(number != 0 for number in numbers)


def _ask(running: Running, slot: Slot, t: int) -> None:
    variable = slot.method.request_variable
    if variable is not None and slot.is_free and running.variables[variable] != 0:
        slot.ask(tuple(running.variables[argument.variable] for argument in slot.method.inputs), t)
        running.variables[variable] = 0
        running.publish.add(slot.method.name)


def supervise(running: Running, t: int) -> None:
    """Look after calls that hang or never come."""
    if running.follows_clock:
        running.tick(t)
    if not running.has_started:
        return
    t = running.tick(t)
    running.close_windows(t)
    for call in running.steps:
        if call.deadline:
            call.deadline.supervise(t)
    included = [call.call.name for call in running.steps if not call.is_excluded]
    running.evaluate(running.diagnosis.supervised(included), t)
