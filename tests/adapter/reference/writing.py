"""Values that the adapter writes to the variables of the code."""

from tests.adapter.reference.parts.inputs import InputState
from tests.adapter.reference.parts.methods import Slot
from tests.adapter.reference.parts.reactions import ReactionState
from tests.adapter.reference.running import Running


def write_input(running: Running, state: InputState) -> None:
    """Return the values of an input that a call sees."""
    running.write(state.input.variable, state.seen)
    if state.input.queue:
        running.write(state.input.queue.count_variable, state.count)


def write_parameters(running: Running) -> None:
    """All parameters."""
    for state in running.parameters.values():
        running.write(state.parameter.variable, state.value)


def write_parameters_of(running: Running, call: str) -> None:
    """The parameters that a call lists and the function does not learn."""
    for state in running.parameters.values():
        if call in state.parameter.calls and not state.parameter.is_learned:
            running.write(state.parameter.variable, state.value)


def write_mode(running: Running) -> None:
    """The mode, as a number of the code."""
    declared, current = running.mode.declared, running.mode.current
    if declared is not None and current is not None:
        running.write(declared.variable, declared.codes[current])


def write_reaction(running: Running, state: ReactionState) -> None:
    """Whether the function has to react; it is sent too."""
    reaction = state.reaction
    running.out[reaction.name] = reaction.active if state.is_active else reaction.inactive
    running.write(reaction.variable, running.out[reaction.name])


def write_errors(running: Running, errors: tuple[str, ...]) -> None:
    """Return the sent values of errors."""
    for error in running.function.errors:
        if error.name in errors:
            running.write(error.status_variable, running.diagnosis.sent.get(error.name, error.passed))


def write_status(running: Running, slot: Slot) -> None:
    """Return the outcome of a request."""
    running.write(slot.method.status_variable, int(slot.status))
