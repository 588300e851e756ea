"""Errors and safety reactions (sections 6 and 7)."""

from collections.abc import Sequence
from typing import NamedTuple

from sigcat.adapter.core.plan import Cause, Error, Reaction


class ErrorPlan(NamedTuple):
    """An error: calls whose windows are evaluated for it, its verdicts, and the conditions that decide its state."""

    error: Error
    windows: Sequence[str]
    first: str
    others: Sequence[str]
    any_failed: str
    heals: str


def error_plan(error: Error) -> ErrorPlan:
    """An error, as it is evaluated."""
    verdicts = [_verdict(cause) for cause in error.causes] + _tested(error)
    first, *others = verdicts or ["SIGCAT_NOT_JUDGED"]
    return ErrorPlan(
        error=error,
        windows=[cause.place.split(".")[0] for cause in error.causes if cause.place.endswith(".alive.verdict")],
        first=first,
        others=others,
        any_failed=_any_failed(error.dependencies, error.foreign),
        heals="false" if error.waits_for_restart else f"self->{error.reset_input}" if error.reset_input else "true",
    )


def _verdict(cause: Cause) -> str:
    return f"SIGCAT_{cause.verdict}" if cause.verdict else f"self->{cause.place}"


def _tested(error: Error) -> list[str]:
    """Dependencies that have been tested: the error was evaluated with them."""
    own = (f"self->error.{name}.state != SIGCAT_NOT_TESTED" for name in error.dependencies)
    foreign = (f"self->received.{name}.reception.is_there" for name in error.foreign)
    return [f"({test}) ? SIGCAT_ABSENT : SIGCAT_NOT_JUDGED" for test in (*own, *foreign)]


def _any_failed(own: tuple[str, ...], foreign: tuple[str, ...]) -> str:
    """The condition that any of some errors has failed."""
    conditions = [
        *(f"Sigcat_HasFailed(&self->error.{name})" for name in own),
        *(f"(self->received.{name}.value != 0U)" for name in foreign),
    ]
    return " || ".join(conditions)


def activations(reaction: Reaction) -> list[tuple[str, str]]:
    """Conditions that activate a reaction, by call: with a time-out each call checks by itself, as its clocks start by
    themselves; without one there is one condition of no call."""
    calls = reaction.calls if reaction.time_out is not None else ("",) if reaction.calls else ()
    return [(call, _condition(reaction, call)) for call in calls]


def _condition(reaction: Reaction, call: str) -> str:
    name = reaction.named.name
    conditions = [
        _any_failed(reaction.errors, reaction.foreign),
        f"(self->reaction.{name}.outside == SIGCAT_PRESENT)",
        f"self->{call}.reaction.{name}.is_late" if call else "",
        f"(self->reaction.{name}.outside == SIGCAT_NOT_JUDGED)" if _is_active_first(reaction) else "",
    ]
    return " || ".join(filter(None, conditions))


def _is_active_first(reaction: Reaction) -> bool:
    """Whether it is active until the outside has said something: nothing else decides it."""
    return reaction.initial == reaction.active and not reaction.errors and not reaction.foreign
