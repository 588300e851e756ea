"""Due calls, and the time to ask again (sections 8 and 9)."""

from tests.adapter.reference.call_state import CallState
from tests.adapter.reference.life import restart
from tests.adapter.reference.order import in_order
from tests.adapter.reference.parts.schedule import NEVER
from tests.adapter.reference.running import Running


def next_call(running: Running, t: int) -> str | None:
    """The call that is due, in the mode that was received last; None if none is."""
    if running.follows_clock:
        running.tick(t)
    if not running.has_started:
        return None
    t = running.tick(t)
    running.close_windows(t)
    running.mode.take()
    for call in running.steps:
        _apply_mode(running, call, t)
    for step in in_order(running.function.steps):
        call = running.calls[step.name]
        if not call.is_excluded and not _waits(running, call) and call.activations.is_due(t):
            call.activations.answer(t)
            return step.name
    return None


def _apply_mode(running: Running, call: CallState, t: int) -> None:
    if running.mode.current in call.call.excluding_modes:
        call.exclude(t)
        running.diagnosis.exclude(call.call.name)
    elif call.is_excluded:
        call.is_excluded = False
        restart(running, call, t)


def _waits(running: Running, call: CallState) -> bool:
    """Whether a previous call has to end first, or one that may not run at the same time."""
    previous = [each for each in running.steps if each.call.name in call.call.previous]
    active = [each for each in running.steps if each is not call and each.activations.is_active]
    return any(not (each.has_ended or each.is_excluded) for each in previous) or any(
        call.call.is_alone or each.call.is_alone for each in active
    )


def next_time(running: Running) -> int:
    """When to ask again."""
    if not running.has_started:
        return NEVER
    times = [time for call in running.steps for time in (_release(running, call), _end_of_window(call))]
    return min(times, default=NEVER)


def _release(running: Running, call: CallState) -> int:
    if call.activations.is_active:
        return NEVER
    if call.is_excluded:
        return 0 if call.activations.events else call.activations.next_release
    return NEVER if _waits(running, call) else call.activations.time()


def _end_of_window(call: CallState) -> int:
    end = call.alive.end if call.alive else None
    return NEVER if end is None else end
