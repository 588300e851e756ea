"""Errors and safety reactions (sections 6 and 7)."""

from collections.abc import Sequence
from typing import NamedTuple

from sigcat.adapter.core.c.layout import c_functions, c_lines
from sigcat.adapter.core.c.lines import Lines, joined, lines
from sigcat.adapter.core.c.scope import Scope
from sigcat.adapter.core.plan import Error, Reaction


class _Evaluated(NamedTuple):
    """An error: calls whose windows are judged for it, its verdicts, and the conditions that decide its state."""

    error: Error
    windows: Sequence[str]
    first: str
    others: Sequence[str]
    any_failed: str
    heals: str
    confirmed: str


class _Condition(NamedTuple):
    """The condition that activates a reaction, of one call if there is a time-out."""

    call: str
    any_of: str


class _Reaction(NamedTuple):
    reaction: Reaction
    head: str
    conditions: Sequence[_Condition]


class _Plan(NamedTuple):
    p: str
    m: str
    evaluated: Sequence[_Evaluated]
    reactions: Sequence[_Reaction]


def error_functions(scope: Scope) -> list[Lines]:
    """The table of states, what makes each error present, and what activates each reaction."""
    plan = _Plan(
        p=scope.prefix,
        m=scope.macro,
        evaluated=[_evaluated(error, scope) for error in scope.plan.errors if error.call],
        reactions=[_reaction(each, scope) for each in scope.plan.reactions],
    )
    states = [c_lines("error_states.c.j2", plan)] if scope.plan.errors else []
    return [*states, *c_functions("errors.c.j2", plan)]


def _evaluated(error: Error, scope: Scope) -> _Evaluated:
    verdicts = [f"self->{cause.place}" for cause in error.causes] + _tested(error, scope)
    first, *others = verdicts or [scope.constant("NOT_JUDGED")]
    return _Evaluated(
        error=error,
        windows=[cause.place.split(".")[0] for cause in error.causes if cause.place.endswith(".alive.verdict")],
        first=first,
        others=others,
        any_failed=_any_failed(error.dependencies, error.foreign, scope),
        heals="false" if error.waits_for_restart else f"self->{error.reset_input}" if error.reset_input else "true",
        confirmed=confirmed(error)[0].text,
    )


def _tested(error: Error, scope: Scope) -> list[str]:
    """Dependencies that have been tested: the error was evaluated with them."""
    own = (f"self->error.{name}.state != {scope.constant('NOT_TESTED')}" for name in error.dependencies)
    foreign = (f"self->received.{name}.reception.is_there" for name in error.foreign)
    return [f"({test}) ? {scope.absent} : {scope.constant('NOT_JUDGED')}" for test in (*own, *foreign)]


def _any_failed(own: tuple[str, ...], foreign: tuple[str, ...], scope: Scope) -> str:
    """The condition that any of some errors has failed."""
    conditions = [
        *(f"{scope.prefix}_HasFailed(&self->error.{name})" for name in own),
        *(f"(self->received.{name}.value != 0U)" for name in foreign),
    ]
    return " || ".join(conditions)


def confirmed(error: Error) -> Lines:
    """Whether an error has failed as often, and in as many ignition cycles, as it takes."""
    name = error.named.name
    least = f">= {error.occurrence_limit}U" if error.occurrence_limit else "> 0U"
    limits = [f"(self->stored.{name}.occurrences {least})"]
    if error.ignition_limit:
        limits.append(f"(self->stored.{name}.ignition_cycles >= {error.ignition_limit}U)")
    return lines(f"self->error.{name}.is_confirmed = {' && '.join(limits)};")


def evaluated(errors: tuple[Error, ...], scope: Scope) -> Lines:
    """Errors evaluated, each after those that it depends on."""
    return joined(lines(f"{scope.prefix}_Evaluate_{error.named.name}(self, t);") for error in errors)


# -- safety reactions ---------------------------------------------------------------------------------------------


def reaction_head(reaction: Reaction, scope: Scope) -> str:
    """The head of the function that hears the outside."""
    return (
        f"void {scope.prefix}_Receive_{reaction.named.name}({scope.self_argument}, {reaction.wire.c} value, uint64_t t)"
    )


def _reaction(reaction: Reaction, scope: Scope) -> _Reaction:
    """With a time-out each call checks by itself, as its clocks start by themselves."""
    calls = reaction.calls if reaction.time_out is not None else ("",) if reaction.calls else ()
    return _Reaction(reaction, reaction_head(reaction, scope), [_condition(reaction, call, scope) for call in calls])


def _condition(reaction: Reaction, call: str, scope: Scope) -> _Condition:
    name = reaction.named.name
    conditions = [
        _any_failed(reaction.errors, reaction.foreign, scope),
        f"(self->reaction.{name}.outside == {scope.present})",
        f"self->{call}.reaction.{name}.is_late" if call else "",
        f"(self->reaction.{name}.outside == {scope.constant('NOT_JUDGED')})" if _is_active_first(reaction) else "",
    ]
    return _Condition(call, " || ".join(filter(None, conditions)))


def _is_active_first(reaction: Reaction) -> bool:
    """Whether it is active until the outside has said something: nothing else decides it."""
    return reaction.initial == reaction.active and not reaction.errors and not reaction.foreign


def reacted(call: str, scope: Scope) -> Lines:
    """Reactions that a call lists, evaluated and written to their variables."""
    found = []
    for reaction in scope.plan.reactions:
        if call in reaction.calls:
            name = reaction.named.name
            timed = f"_{call}(self, t)" if reaction.time_out is not None else "(self)"
            found.append(lines(f"{scope.prefix}_React_{name}{timed};"))
            found.append(reaction_written(reaction, scope))
    return joined(found)


def reaction_written(reaction: Reaction, scope: Scope) -> Lines:
    """A reaction in its variable, if it has one."""
    if reaction.variable is None:
        return ()
    return lines(scope.assigned(reaction.variable, f"self->out.{reaction.named.name}"), reaction.named.pointer)


def status_written(error: Error, scope: Scope) -> Lines:
    """Write the sent status of an error to its variable, if it has one."""
    if error.status_variable is None:
        return ()
    return lines(scope.assigned(error.status_variable, f"self->out.{error.named.name}"), error.named.pointer)
