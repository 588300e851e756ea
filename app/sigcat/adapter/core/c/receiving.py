"""Functions that receive values, and those that are told of values which were rejected or lost."""

from collections.abc import Sequence
from typing import NamedTuple

from sigcat.adapter.core.c.header import status_head
from sigcat.adapter.core.c.inputs import holds_init, lose_head, receive_head, reject_head
from sigcat.adapter.core.c.layout import c_functions
from sigcat.adapter.core.c.lines import Lines
from sigcat.adapter.core.c.scope import Scope
from sigcat.adapter.core.plan import Call, ForeignError, Port


class _Port(NamedTuple):
    """A signal: the heads of its functions, and the calls that it triggers."""

    port: Port
    head: str
    reject_head: str
    lose_head: str
    holds_init: bool
    triggers: Sequence[Call]


class _Status(NamedTuple):
    status: ForeignError
    head: str


class _Plan(NamedTuple):
    p: str
    m: str
    ports: Sequence[_Port]
    statuses: Sequence[_Status]


def receive_functions(scope: Scope) -> list[Lines]:
    """Functions for each signal, for what of it is not accepted or lost before, for errors of others and for the mode."""
    plan = _Plan(
        p=scope.prefix,
        m=scope.macro,
        ports=[_port(port, scope) for port in scope.plan.ports],
        statuses=[_Status(each, status_head(each, scope)) for each in scope.plan.received_statuses],
    )
    return c_functions("receiving.c.j2", plan)


def _port(port: Port, scope: Scope) -> _Port:
    steps = {step.name: step for step in scope.plan.steps}
    heads = receive_head(port, scope), reject_head(port, scope), lose_head(port, scope)
    return _Port(port, *heads, holds_init(port), [steps[name] for name in port.triggers])
