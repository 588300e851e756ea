"""Clocks of the cores of a program: ticks of 32 bits if all declared times allow it, else nanoseconds."""

from collections.abc import Iterator, Sequence

from sigcat.adapter.core.plan import LONGEST, MICROSECONDS, MILLISECONDS, NANOSECONDS, Call, Clock, CorePlan
from sigcat.function.document.text_filters import milliseconds


def with_common_clock(plans: Sequence[CorePlan]) -> tuple[CorePlan, ...]:
    """The plans, with the coarsest clock that all of them can have: they share the files that count time."""
    clock = _common_clock(plans)
    return tuple(plan._replace(clock=clock) for plan in plans)


def _common_clock(plans: Sequence[CorePlan]) -> Clock:
    reasons: list[str] = []
    for clock in (MILLISECONDS, MICROSECONDS):
        obstacle = next(_obstacles(plans, clock), None)
        if obstacle is None:
            reason = reasons[0] if reasons else "the declared ones are whole milliseconds"
            return clock._replace(
                reason=f"All times are in {clock.unit.lower()}, in 32 bits that wrap around: {reason}."
            )
        reasons.append(obstacle)
    both = ", and ".join(dict.fromkeys(reasons))
    return NANOSECONDS._replace(reason=f"All times are in nanoseconds, in 64 bits: {both}.")


def _obstacles(plans: Sequence[CorePlan], clock: Clock) -> Iterator[str]:
    """Reasons against a clock."""
    for plan in plans:
        for call in plan.steps:
            if call.deadline and clock == MILLISECONDS:
                yield f"the deadline supervision of {call.name} in {plan.function} needs them"
        for what, nanoseconds in _declared_times(plan):
            text = f"{what} in {plan.function} is {milliseconds(nanoseconds)}"
            if nanoseconds % clock.tick:
                yield text
            if nanoseconds > LONGEST * clock.tick:
                yield f"{text}, too long for {clock.unit.lower()} in 32 bits"


def _declared_times(plan: CorePlan) -> Iterator[tuple[str, int]]:
    """Declared times in nanoseconds, each behind what it is."""
    for call in plan.steps:
        yield from _of_call(call)
    for error in plan.errors:
        yield (f"the maturation time of {error.named.name}", error.maturation)
        yield (f"the reset time of {error.named.name}", error.reset)
    for reaction in plan.reactions:
        yield (f"the time-out of {reaction.named.name}", reaction.time_out or 0)
    for request in plan.requests:
        yield (f"the time-out of {request.named.name}", request.time_out or 0)


def _of_call(call: Call) -> Iterator[tuple[str, int]]:
    yield (f"the cycle of {call.name}", call.cycle or 0)
    yield (f"the offset of {call.name}", call.offset)
    yield (f"the debounce time of {call.name}", call.debounce)
    for item in call.inputs:
        if item.time_out:
            yield (f"the time-out of {item.named.name}", item.time_out.nanoseconds)
    if call.alive:
        yield (f"the window of {call.name}", call.alive.window)
    if call.deadline:
        yield (f"the shortest duration of {call.name}", call.deadline.least)
        yield (f"the longest duration of {call.name}", call.deadline.most)
