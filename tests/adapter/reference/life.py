"""Init, Start and Terminate (section 1)."""

from tests.adapter.reference.call_state import CallState
from tests.adapter.reference.function import Call
from tests.adapter.reference.mode_out import read_mode_out
from tests.adapter.reference.parts.errors import in_new_cycle
from tests.adapter.reference.running import Running, Stored
from tests.adapter.reference.writing import (
    write_errors,
    write_input,
    write_mode,
    write_parameters,
    write_reaction,
    write_status,
)


def in_cycle(stored: Stored | None, ignition_cycle: int) -> Stored:
    """Take stored values, when Init gets the number of the ignition cycle."""
    if stored is None:
        return Stored(ignition_cycle)
    if stored.ignition_cycle == ignition_cycle:
        return stored
    counts = {name: in_new_cycle(each) for name, each in stored.errors.items()}
    return Stored(ignition_cycle, stored.parameters, counts)


def init(running: Running) -> bool:
    """Begin; whether that was good."""
    for name, state in running.parameters.items():
        if name in running.stored.parameters:
            state.take(running.stored.parameters[name])
    _fill(running)
    write_parameters(running)
    _write_all(running)
    running.is_good = all(_is_successful(running, call) for call in running.function.init)
    if running.is_good:
        write_parameters(running)
        read_mode_out(running)
    else:
        running.out.update({name: each.reaction.active for name, each in running.diagnosis.reactions.items()})
    return running.is_good


def _fill(running: Running) -> None:
    """Give each output its initial value."""
    for call in running.steps:
        running.out.update({name: output.sent for name, output in call.outputs.items()})
    for error in running.function.errors:
        running.out[error.name] = error.passed


def _write_all(running: Running) -> None:
    for call in running.calls.values():
        for state in call.inputs:
            write_input(running, state)
        write_errors(running, call.call.errors)
    for reaction in running.diagnosis.reactions.values():
        write_reaction(running, reaction)
    for slot in running.slots.values():
        running.write(slot.method.request_variable, 0)
        write_status(running, slot)
    write_mode(running)


def _is_successful(running: Running, call: Call) -> bool:
    running.graph.report(call.name)
    result = running.execute(call)
    return call.success is None or result == call.success


def start(running: Running, t: int) -> None:
    """The platform lets the function run."""
    if not running.is_good:
        return
    t = running.tick(t)
    running.close_windows(t)
    for call in running.steps:
        if running.has_started:
            call.drop(t - 1)
            restart(running, call, t)
        else:
            call.start(t)
            running.diagnosis.restart(call.call.name, t)
    if not running.has_started:
        _publish_all(running)
    running.has_started = True


def restart(running: Running, call: CallState, t: int) -> None:
    """A call is included again: its clocks and windows restart."""
    call.restart(t)
    running.diagnosis.restart(call.call.name, t)


def _publish_all(running: Running) -> None:
    running.publish.update(running.diagnosis.reactions)
    if running.function.mode_out and running.mode_out is not None:
        running.publish.add(running.function.mode_out.name)


def terminate(running: Running, t: int) -> None:
    """End, once."""
    running.tick(t)
    if not running.is_good:
        return
    for call in running.function.terminate:
        running.graph.report(call.name)
        running.execute(call)
    for name, state in running.parameters.items():
        learned = state.learned(running.variables[state.parameter.variable]) if state.parameter.is_learned else None
        if learned is not None:
            running.stored.parameters[name] = learned
    running.is_good = running.has_started = False
