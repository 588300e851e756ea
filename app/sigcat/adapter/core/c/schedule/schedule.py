"""When calls run: modes that exclude them (section 8), and when they are due (section 9)."""

from collections.abc import Iterator, Sequence

from sigcat.adapter.core.c.names.scope import Scope
from sigcat.adapter.core.plan import CLASS, Call


def statement(symbol: str | None, arguments: Sequence[str], scope: Scope) -> str:
    """A call of the code, with the objects that it works on."""
    at = "self->object." if scope.plan.code.signature == CLASS else ""
    return f"{at}{symbol}({', '.join(f'&self->code.{name}' for name in arguments)})"


def runs(call: Call, scope: Scope) -> str:
    """The condition that the mode lets a call run; empty if every mode does."""
    return f"{scope.prefix}_Runs_{call.name}(self->mode.now)" if scope.plan.is_moded(call) else ""


def is_due(call: Call, scope: Scope) -> str:
    """The condition that a call is due."""
    return " && ".join(_conditions(call, scope))


def _conditions(call: Call, scope: Scope) -> Iterator[str]:
    place = f"self->{call.name}"
    if scope.plan.is_moded(call):
        yield runs(call, scope)
    yield (
        f"({scope.plan.clock.is_reached(f'{place}.release', 't')})"
        if call.cycle is not None
        else f"({place}.events > 0U)"
    )
    yield f"!{place}.is_active"
    if call.debounce:
        yield f"(!{place}.has_begun || ((t - {place}.begun) >= {scope.macro}_DEBOUNCE_{call.name}))"
    if waits(call, scope):
        yield f"!{scope.prefix}_Waits_{call.name}(self)"


def waits(call: Call, scope: Scope) -> str:
    """The condition that a call has to wait for others; empty if it never has to."""
    others = [step for step in scope.plan.steps if step.name != call.name]
    excluding = [f"self->{step.name}.is_active" for step in others if call.is_exclusive or step.is_exclusive]
    previous = [_has_not_ended(step, scope) for step in others if step.name in call.previous]
    return " || ".join([*excluding, *previous])


def _has_not_ended(call: Call, scope: Scope) -> str:
    ended = f"!self->{call.name}.has_ended"
    return f"({ended} && {runs(call, scope)})" if scope.plan.is_moded(call) else ended
