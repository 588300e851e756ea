"""Triggers of an event-triggered call: the events that it lists are signals that it consumes."""

from sigcat.function.function_json.interfaces.data_interfaces import DataQueue, Signal
from sigcat.function.function_json.interfaces.role import CONSUMER
from sigcat.function.function_json.runnable import Runnable
from sigcat.function.function_json.walk import absent_of, data_of

EVENT_TRIGGERED = "EventTriggered"
"""Run type of a call that events trigger."""


def events_of(call: Runnable) -> tuple[str, ...]:
    """Names or paths of the events that a call lists."""
    return tuple(filter(None, (event.strip() for event in (call.events or "").split(","))))


def consumed_by(call: Runnable) -> tuple[Signal | DataQueue, ...]:
    """Signals and queues that a call reads."""
    return tuple(item for contract in call.contracts or () for item in data_of(contract) if item.role == CONSUMER)


def absent_in(call: Runnable) -> tuple[Signal | DataQueue, ...]:
    """Optional signals and queues that a call would read, and the vehicle does not have."""
    return tuple(item for contract in call.contracts or () for item in absent_of(contract) if item.role == CONSUMER)


def triggers(call: Runnable) -> tuple[Signal | DataQueue, ...]:
    """Signals whose values trigger an event-triggered call: those that it lists as events, or else all that it reads.

    A call of which all listed events are absent has no triggers.
    """
    events, consumed = events_of(call), consumed_by(call)
    listed = [item for item in (*consumed, *absent_in(call)) if item.name in events or item.vss_path in events]
    return tuple(item for item in consumed if item in listed) if listed else consumed
