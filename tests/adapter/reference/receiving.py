"""Values received from outside between the calls (sections 2, 11 and 12)."""

from collections.abc import Mapping

from tests.adapter.reference.parts.methods import Reply
from tests.adapter.reference.running import Running
from tests.adapter.reference.values.value import Value, numbers_of


def receive(running: Running, port: str, value: Value, t: int) -> None:
    """A signal, an error of others, a reaction or a mode has come."""
    t = running.tick(t)
    if port in running.function.ports.values():
        for call in running.steps:
            call.receive(port, value, t)
    elif port in running.diagnosis.reactions:
        running.diagnosis.reactions[port].receive(_number(value), t)
    elif running.function.mode_in and port == running.function.mode_in.name:
        running.mode.received = _number(value)
    else:
        running.diagnosis.foreign[port] = _number(value) != 0


def reject(running: Running, port: str, t: int) -> None:
    """A message of a signal has come that is not accepted (section 15)."""
    running.tick(t)
    for call in running.steps:
        call.reject(port)


def lose(running: Running, port: str, t: int) -> None:
    """The platform has lost values of a queue (section 2)."""
    running.tick(t)
    for call in running.steps:
        call.lose(port)


def _number(value: Value) -> int:
    return int(numbers_of(value)[0])


def set_parameters(running: Running, values: Mapping[str, Value]) -> bool:
    """Take new values, all or none."""
    if any(running.parameters[name].taken(value).is_outside for name, value in values.items()):
        return False
    for name, value in values.items():
        running.parameters[name].take(value)
    return True


def method(running: Running, name: str, arguments: tuple[Value, ...]) -> tuple[Reply, tuple[Value, ...]]:
    """A request to the function: what became of it, and the results."""
    asked = next(each for each in running.function.methods if each.name == name and each.is_offered)
    if not running.is_good or running.calls[asked.call].is_excluded:
        return Reply.EXCLUDED, ()
    pairs = list(zip(asked.inputs, arguments, strict=True))
    if not all(argument.holds(value) for argument, value in pairs):
        return Reply.BAD_ARGUMENT, ()
    running.variables.update({argument.variable: value for argument, value in pairs})
    running.code(asked.symbol or name, running.variables)
    return Reply.OK, tuple(running.variables[argument.variable] for argument in asked.outputs)
